// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Pieces that come one after the other make the mesh that they were cut from.

#include "Fixtures/TestFields.h"
#include "Shares/MergedPieces.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>
#include <vector>

using namespace ridges;
using namespace ridges::testing;

namespace
{

using Place = std::array<double, 3>;
using Triangles = std::multiset<std::array<Place, 3>>;

Place PlaceAt(const std::vector<double>& positions, Id p)
{
  const double* x = positions.data() + 3 * static_cast<std::size_t>(p);
  return { x[0], x[1], x[2] };
}

void Add(MergedPieces& pieces, const Mesh& mesh)
{
  const std::vector<Triangle> triangles = TrianglesOf(mesh);
  MeshPiece piece;
  piece.points = mesh.points.data();
  piece.numberOfPoints = static_cast<Id>(mesh.PointCount());
  piece.triangles = { triangles.data(), triangles.data() + triangles.size() };
  pieces.Add(piece);
}

/// Two triangles with an edge from (0, 0, 0) to (1, 0, 0), of points of their own.
Mesh TwoTriangles()
{
  Mesh mesh;
  mesh.points = { 0, 0, 0, 1, 0, 0, 0, 1, 0, -0.0, 0, 0, 1, 0, 0, 0, -1, 0 };
  mesh.triangles = { 0, 1, 2, 4, 3, 5 };
  return mesh;
}

Mesh OneTriangle(double height)
{
  Mesh mesh;
  mesh.points = { 1, 0, 0, 0, -0.0, 0, 0, 0, height };
  mesh.triangles = { 0, 1, 2 };
  return mesh;
}

} // namespace

TEST(MergedPieces, MakesTheMeshThatWasCut)
{
  const Mesh mesh = EllipsoidMesh(6, 1.0, 0.8, 0.6);
  Triangles expected;
  for (const Triangle& c : TrianglesOf(mesh))
  {
    expected.insert(
      { PlaceAt(mesh.points, c[0]), PlaceAt(mesh.points, c[1]), PlaceAt(mesh.points, c[2]) });
  }
  for (const Partition partition : AllPartitions)
  {
    constexpr int count = 5;
    const std::vector<int> parts = PartsOf(mesh, partition, count);
    MergedPieces pieces(count);
    for (int part = 0; part < count; ++part)
    {
      Add(pieces, PieceOf(mesh, parts, part).mesh);
    }
    ASSERT_EQ(pieces.Finish(), "");
    ASSERT_EQ(pieces.NumberOfPoints(), static_cast<Id>(mesh.PointCount()));
    Triangles found;
    for (const Triangle& c : pieces.Triangles())
    {
      found.insert({ PlaceAt(pieces.Positions(), c[0]), PlaceAt(pieces.Positions(), c[1]),
        PlaceAt(pieces.Positions(), c[2]) });
    }
    EXPECT_TRUE(found == expected);
    EXPECT_TRUE(pieces.Coincident().empty());
    for (int part = 0; part < count; ++part)
    {
      const PieceOfMesh piece = PieceOf(mesh, parts, part);
      EXPECT_EQ(pieces.FirstTriangle(part + 1) - pieces.FirstTriangle(part),
        static_cast<Id>(piece.triangles.size()));
      for (std::size_t p = 0; p < piece.points.size(); ++p)
      {
        EXPECT_EQ(PlaceAt(pieces.Positions(), pieces.PointsOf(part)[p]),
          PlaceAt(mesh.points, piece.points[p]));
      }
    }
  }
}

TEST(MergedPieces, KeepsPointsOfOnePieceApart)
{
  MergedPieces pieces(1);
  Add(pieces, TwoTriangles());
  EXPECT_EQ(pieces.Finish(), "");
  EXPECT_EQ(pieces.NumberOfPoints(), 6);
  EXPECT_EQ(pieces.Coincident(), (std::vector<Id>{ 0, 1, 3, 4 }));
}

// Whichever piece comes first; 0 and -0 are one place.
TEST(MergedPieces, DoesNotGuessWhichPointsAreTheSame)
{
  for (const bool isFirst : { true, false })
  {
    MergedPieces pieces(2);
    Add(pieces, isFirst ? TwoTriangles() : OneTriangle(1.0));
    Add(pieces, isFirst ? OneTriangle(1.0) : TwoTriangles());
    const std::string fault = pieces.Finish();
    EXPECT_EQ(fault.find("2 places have several points in one piece"), 0U) << fault;
  }
}

TEST(MergedPieces, RefusesAPieceThatComesTwice)
{
  MergedPieces pieces(3);
  Add(pieces, OneTriangle(2.0));
  Add(pieces, OneTriangle(1.0));
  Add(pieces, OneTriangle(1.0));
  EXPECT_NE(pieces.Finish().find("are the same"), std::string::npos);
}

// A point that no triangle of its piece has is what other pieces have there, or one of its own.
TEST(MergedPieces, FindsPointsOfNoTriangle)
{
  MergedPieces pieces(2);
  Mesh first = OneTriangle(1.0);
  first.points.insert(first.points.end(), { 0, 0, 2, 5, 5, 5, 1, 0, 0 });
  Add(pieces, first);
  Add(pieces, OneTriangle(2.0));
  EXPECT_EQ(pieces.Finish(), "");
  // (0, 0, 2) is the tip of the other piece; (1, 0, 0) is a second point of the first.
  EXPECT_EQ(pieces.PointsOf(0), (std::vector<Id>{ 0, 1, 2, 3, 4, 5 }));
  EXPECT_EQ(pieces.PointsOf(1), (std::vector<Id>{ 0, 1, 3 }));
  EXPECT_EQ(pieces.Coincident(), (std::vector<Id>{ 0, 5 }));
}
