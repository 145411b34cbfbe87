// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// What ranks find by walking over their pieces, against the whole mesh: no tolerance.

#include "Base/RankGathering.h"
#include "Fixtures/TestFields.h"
#include "Mesh/BorderStrip.h"
#include "Shares/PieceWalks.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <functional>
#include <numeric>
#include <string>
#include <vector>

using namespace ridges;
using namespace ridges::testing;

namespace
{

/// A rank's piece and what it shares with others.
struct PieceOfRanks
{
  PieceOfRanks(Ranks& ranks, const Mesh& mesh, const std::vector<int>& parts)
    : piece(PieceOf(mesh, parts, ranks.Rank()))
    , triangles(TrianglesOf(piece.mesh))
    , surface(piece.mesh.points.data(), static_cast<Id>(piece.mesh.PointCount()), triangles)
  {
    MeshPiece view;
    view.points = this->piece.mesh.points.data();
    view.numberOfPoints = static_cast<Id>(this->piece.mesh.PointCount());
    view.triangles = { this->triangles.data(), this->triangles.data() + this->triangles.size() };
    EXPECT_EQ(this->points.Share(ranks, view), "");
    this->seams = PieceSeams(ranks, this->points);
  }

  PieceOfMesh piece;
  std::vector<Triangle> triangles;
  TriangleMesh surface;
  SharedPoints points;
  PieceSeams seams;
};

void OnAllPartitions(
  const Mesh& mesh, const std::function<void(Ranks&, const PieceOfRanks&)>& check)
{
  for (const Partition partition : AllPartitions)
  {
    for (const int count : { 1, 2, 4, 7 })
    {
      SCOPED_TRACE(std::to_string(static_cast<int>(partition)) + " on " + std::to_string(count));
      const std::vector<int> parts = PartsOf(mesh, partition, count);
      OnThreadRanks(count, [&](Ranks& ranks) { check(ranks, PieceOfRanks(ranks, mesh, parts)); });
    }
  }
}

Mesh Patch()
{
  return GraphPatch([](double x, double y) { return x * x - 0.5 * y * y; }, 1.0, 24, 0.2);
}

} // namespace

TEST(PieceWalks, NumberPointsOnePieceAfterTheOther)
{
  const Mesh mesh = EllipsoidMesh(6, 1.0, 0.8, 0.6);
  OnAllPartitions(mesh,
    [&mesh](Ranks& ranks, const PieceOfRanks& own)
    {
      const std::vector<std::int64_t> numbers = NumbersByPieces(ranks, own.points);
      // As they come first, over all pieces.
      std::vector<std::int64_t> expected(mesh.PointCount(), -1);
      std::int64_t next = 0;
      const std::vector<std::vector<std::int32_t>> all = GatherAllValues(ranks, own.piece.points);
      for (const std::vector<std::int32_t>& points : all)
      {
        for (const std::int32_t p : points)
        {
          expected[p] = expected[p] < 0 ? next++ : expected[p];
        }
      }
      for (std::size_t p = 0; p < numbers.size(); ++p)
      {
        EXPECT_EQ(numbers[p], expected[own.piece.points[p]]);
      }
    });
}

TEST(PieceWalks, SpreadLevelsIntoOtherPieces)
{
  const Mesh mesh = EllipsoidMesh(8, 1.0, 0.8, 0.6);
  constexpr std::uint8_t highest = 6;
  const auto startOf = [](std::int32_t p)
  { return static_cast<std::uint8_t>(p == 0 ? 0 : (p == 300 ? 3 : 255)); };
  // On one rank.
  std::vector<std::uint8_t> expected(mesh.PointCount());
  for (std::size_t p = 0; p < expected.size(); ++p)
  {
    expected[p] = startOf(static_cast<std::int32_t>(p));
  }
  for (int round = 0; round < highest; ++round)
  {
    for (const Triangle& c : TrianglesOf(mesh))
    {
      for (const Id p : c)
      {
        const int least = std::min({ expected[c[0]], expected[c[1]], expected[c[2]] });
        expected[p] =
          static_cast<std::uint8_t>(std::min<int>(expected[p], least < highest ? least + 1 : 255));
      }
    }
  }
  OnAllPartitions(mesh,
    [&expected, &startOf](Ranks& ranks, const PieceOfRanks& own)
    {
      std::vector<std::uint8_t> levels;
      for (const std::int32_t p : own.piece.points)
      {
        levels.push_back(startOf(p));
      }
      SpreadLevels(ranks, own.surface, own.seams, highest, levels);
      for (std::size_t p = 0; p < levels.size(); ++p)
      {
        const std::uint8_t there = expected[own.piece.points[p]];
        EXPECT_TRUE(levels[p] == there || (there >= highest && levels[p] >= highest));
      }
    });
}

TEST(PieceWalks, FindTheStripAlongTheBorder)
{
  const Mesh mesh = Patch();
  const MeshedSurface whole(mesh);
  std::vector<double> radii(mesh.PointCount());
  for (std::size_t p = 0; p < radii.size(); ++p)
  {
    radii[p] = 0.1 + 0.3 * static_cast<double>(p % 7) / 7.0;
  }
  const std::vector<std::uint8_t> expected = BorderStrip(whole.Triangles(), radii.data());
  EXPECT_GT(std::accumulate(expected.begin(), expected.end(), 0), 200);
  EXPECT_LT(std::accumulate(expected.begin(), expected.end(), 0), 400);
  OnAllPartitions(mesh,
    [&](Ranks& ranks, const PieceOfRanks& own)
    {
      std::vector<std::uint8_t> onBorder;
      std::vector<double> ownRadii;
      for (const std::int32_t p : own.piece.points)
      {
        onBorder.push_back(whole.Triangles().OnBorder(p) ? 1 : 0);
        ownRadii.push_back(radii[p]);
      }
      const std::vector<std::uint8_t> strip =
        BorderStripOfPiece(ranks, own.surface, own.seams, onBorder, ownRadii.data());
      for (std::size_t p = 0; p < strip.size(); ++p)
      {
        EXPECT_EQ(strip[p], expected[own.piece.points[p]]);
      }
    });
  const Mesh closed = EllipsoidMesh(3, 1.0, 0.8, 0.6);
  OnAllPartitions(closed,
    [](Ranks& ranks, const PieceOfRanks& own)
    {
      const std::vector<std::uint8_t> none(own.piece.points.size(), 0);
      EXPECT_TRUE(BorderStripOfPiece(ranks, own.surface, own.seams, none, nullptr).empty());
    });
}

TEST(PieceWalks, FindTheSmallestEnclosingSphere)
{
  for (const Mesh& mesh :
    { Patch(), EllipsoidMesh(8, 1.4, 1.0, 0.6), Icosphere(5), TorusMesh(2.0, 0.7, 21, 11) })
  {
    const MeshedSurface whole(mesh);
    const double expected = SmallestEnclosingSphere(whole.Triangles()).radius;
    OnAllPartitions(mesh,
      [expected](Ranks& ranks, const PieceOfRanks& own)
      { EXPECT_EQ(EnclosingRadiusOfPieces(ranks, own.surface), expected); });
  }
}
