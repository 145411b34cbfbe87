// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Shares of a mesh that several ranks hold, against the whole mesh: points by their positions, no
// tolerance.

#include "Fixtures/TestFields.h"
#include "Mesh/RingNeighborhood.h"
#include "Shares/PositionBisection.h"
#include "Shares/SharedMesh.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

using namespace ridges;
using namespace ridges::testing;

namespace
{

using Place = std::array<double, 3>;

Place PlaceOf(const TriangleMesh& mesh, Id p)
{
  return { mesh.Point(p)[0], mesh.Point(p)[1], mesh.Point(p)[2] };
}

/// The points of neighbourhoods in their order, by place.
using Neighborhoods = std::map<Place, std::vector<Place>>;

/// Of the first points of a mesh.
Neighborhoods NeighborhoodsOf(const TriangleMesh& mesh, Id count, int rings)
{
  OrderedRings ordered(mesh);
  ordered.Build(0, mesh.NumberOfPoints());
  RingNeighborhood neighborhood(mesh, ordered);
  NeighborhoodRule rule;
  rule.kind = NeighborhoodRule::Kind::Rings;
  rule.numberOfRings = rings;
  Neighborhoods all;
  for (Id p = 0; p < count; ++p)
  {
    std::vector<Place>& places = all[PlaceOf(mesh, p)];
    for (const Id q : neighborhood.Gather(p, rule))
    {
      places.push_back(PlaceOf(mesh, q));
    }
  }
  return all;
}

MeshPiece ViewOf(const Mesh& mesh, const std::vector<Triangle>& triangles)
{
  MeshPiece piece;
  piece.points = mesh.points.data();
  piece.numberOfPoints = static_cast<Id>(mesh.PointCount());
  piece.triangles = { triangles.data(), triangles.data() + triangles.size() };
  return piece;
}

/// Those of all ranks together, each point on one of them only.
Neighborhoods SharedNeighborhoods(const Mesh& mesh, Partition partition, int count, int rings)
{
  const std::vector<int> parts = PartsOf(mesh, partition, count);
  std::vector<Neighborhoods> found(count);
  OnThreadRanks(count,
    [&](Ranks& ranks)
    {
      const PieceOfMesh piece = PieceOf(mesh, parts, ranks.Rank());
      const std::vector<Triangle> triangles = TrianglesOf(piece.mesh);
      SharedMesh shared;
      const std::string faults = shared.Share(ranks, ViewOf(piece.mesh, triangles));
      if (!faults.empty())
      {
        throw std::runtime_error(faults);
      }
      std::vector<Id> owned(shared.NumberOfOwned());
      std::iota(owned.begin(), owned.end(), 0);
      const MeshShare share(ranks, shared, owned, rings);
      found[ranks.Rank()] = NeighborhoodsOf(share.Mesh(), share.NumberOfInner(), rings);
    });
  Neighborhoods all;
  for (const Neighborhoods& part : found)
  {
    for (const auto& neighborhood : part)
    {
      EXPECT_TRUE(all.insert(neighborhood).second) << "a point has two owners";
    }
  }
  return all;
}

void ExpectTheSameRings(const Mesh& mesh, int rings)
{
  const std::vector<Triangle> triangles = TrianglesOf(mesh);
  const auto count = static_cast<Id>(mesh.PointCount());
  const TriangleMesh whole(mesh.points.data(), count, triangles);
  const Neighborhoods expected = NeighborhoodsOf(whole, count, rings);
  for (const Partition partition : AllPartitions)
  {
    for (const int ranks : { 1, 2, 3, 4, 7 })
    {
      SCOPED_TRACE(std::to_string(static_cast<int>(partition)) + " on " + std::to_string(ranks));
      ASSERT_TRUE(SharedNeighborhoods(mesh, partition, ranks, rings) == expected);
    }
  }
}

} // namespace

TEST(SharedMesh, GivesTheRingsOfAClosedMesh)
{
  ExpectTheSameRings(EllipsoidMesh(8, 1.0, 0.8, 0.6), 5);
}

TEST(SharedMesh, GivesTheRingsOfAnOpenMesh)
{
  ExpectTheSameRings(
    GraphPatch([](double x, double y) { return x * x - 0.5 * y * y; }, 1.0, 20, 0.2), 4);
}

// Regular: many points have the same coordinates.
TEST(SharedMesh, GivesTheRingsOfAGrid)
{
  ExpectTheSameRings(GraphPatch([](double, double) { return 0.0; }, 1.0, 16), 3);
}

TEST(SharedMesh, GivesRowsOfPointsToPiecesAndShares)
{
  const Mesh mesh = EllipsoidMesh(6, 1.0, 0.8, 0.6);
  const std::vector<int> parts = PartsOf(mesh, Partition::Random, 3);
  OnThreadRanks(3,
    [&](Ranks& ranks)
    {
      const PieceOfMesh piece = PieceOf(mesh, parts, ranks.Rank());
      const std::vector<Triangle> triangles = TrianglesOf(piece.mesh);
      SharedMesh shared;
      ASSERT_EQ(shared.Share(ranks, ViewOf(piece.mesh, triangles)), "");
      EXPECT_EQ(shared.Points().NumberOfAll(), static_cast<std::int64_t>(mesh.PointCount()));
      EXPECT_EQ(shared.NumberOfTriangles(), static_cast<std::int64_t>(mesh.TriangleCount()));
      const std::vector<double>& owned = shared.Points().Owned();
      EXPECT_EQ(shared.Points().ToPiece(ranks, owned.data(), 3), piece.mesh.points);
      const std::vector<Id> some(shared.NumberOfOwned() > 2 ? 1 : 0, 2);
      const MeshShare share(ranks, shared, some, 2);
      const std::vector<double> rows = share.Rows(ranks, owned.data(), 3);
      for (Id p = 0; p < share.Mesh().NumberOfPoints(); ++p)
      {
        EXPECT_EQ(share.Mesh().Point(p)[1], rows[3 * p + 1]);
      }
    });
}

// Two spheres at one place, one of them upside down: that is known on one rank, but not on more.
TEST(SharedMesh, NamesPlacesWhereItCannotKnowWhichPointsAreTheSame)
{
  Mesh mesh = EllipsoidMesh(3, 1.0, 0.8, 0.6);
  Append(mesh, Flip(mesh));
  const auto share = [&mesh](Partition partition, bool hasIds)
  {
    const std::vector<int> parts = PartsOf(mesh, partition, 3);
    std::string text;
    std::int64_t points = 0;
    OnThreadRanks(3,
      [&](Ranks& ranks)
      {
        const PieceOfMesh piece = PieceOf(mesh, parts, ranks.Rank());
        const std::vector<Triangle> triangles = TrianglesOf(piece.mesh);
        MeshPiece view = ViewOf(piece.mesh, triangles);
        const std::vector<std::int64_t> ids(piece.points.begin(), piece.points.end());
        view.globalIds = hasIds ? ids.data() : nullptr;
        SharedMesh shared;
        const std::string faults = shared.Share(ranks, view);
        if (ranks.Rank() == 1)
        {
          text = faults;
          points = faults.empty() ? shared.Points().NumberOfAll() : 0;
        }
      });
    return text.empty() ? std::to_string(points) : text;
  };
  const std::string all = std::to_string(mesh.PointCount());
  EXPECT_EQ(share(Partition::AllOnFirst, false), all);
  EXPECT_EQ(share(Partition::Random, true), all);
  EXPECT_NE(
    share(Partition::Random, false).find("which are the same cannot be known"), std::string::npos);
}

// Points that share their places are told apart as on one rank.
TEST(SharedMesh, RanksCoincidentPointsAsTheWholeMesh)
{
  Mesh mesh = EllipsoidMesh(7, 1.0, 0.8, 0.6, false);
  for (double& x : mesh.points)
  {
    x = 0.2 * std::round(x / 0.2);
  }
  const std::vector<Triangle> triangles = TrianglesOf(mesh);
  const TriangleMesh whole(mesh.points.data(), static_cast<Id>(mesh.PointCount()), triangles);
  std::multiset<std::uint64_t> expected;
  for (Id p = 0; p < whole.NumberOfPoints(); ++p)
  {
    expected.insert(whole.RankAtPlace(p));
  }
  ASSERT_GT(expected.size() - expected.count(0), 20U);
  const std::vector<int> parts = PartsOf(mesh, Partition::Random, 3);
  std::vector<std::multiset<std::uint64_t>> found(3);
  OnThreadRanks(3,
    [&](Ranks& ranks)
    {
      const PieceOfMesh piece = PieceOf(mesh, parts, ranks.Rank());
      const std::vector<Triangle> own = TrianglesOf(piece.mesh);
      const std::vector<std::int64_t> ids(piece.points.begin(), piece.points.end());
      MeshPiece view = ViewOf(piece.mesh, own);
      view.globalIds = ids.data();
      SharedMesh shared;
      ASSERT_EQ(shared.Share(ranks, view), "");
      std::vector<Id> owned(shared.NumberOfOwned());
      std::iota(owned.begin(), owned.end(), 0);
      const MeshShare share(ranks, shared, owned, 1);
      for (Id p = 0; p < share.NumberOfInner(); ++p)
      {
        found[ranks.Rank()].insert(share.Mesh().RankAtPlace(p));
      }
    });
  std::multiset<std::uint64_t> all;
  for (const auto& part : found)
  {
    all.insert(part.begin(), part.end());
  }
  EXPECT_EQ(all, expected);
}

TEST(PositionBisection, CutsIntoPartsOfAboutOneSize)
{
  std::mt19937_64 generator(3);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 7000; ++i)
  {
    // Half of them in a plane, and many at the same x.
    const double x = i % 2 == 0 ? 0.0 : 1e-3 * static_cast<double>(generator() % 1000);
    points.emplace_back(x, 1e-9 * static_cast<double>(generator() % 1000000000), 0.0);
  }
  const PositionBisection bisection(points, 7);
  std::vector<int> sizes(7, 0);
  for (const Eigen::Vector3d& x : points)
  {
    ++sizes.at(bisection.PartOf(x));
  }
  for (const int size : sizes)
  {
    EXPECT_NEAR(size, 1000, 2); // cut at points of this very sample
  }
}
