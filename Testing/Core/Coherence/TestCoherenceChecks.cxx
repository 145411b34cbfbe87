// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The combinatorics of coherence on meshes small enough to count on fingers.

#include "Coherence/EdgeChecks.h"
#include "Coherence/LostCrossings.h"
#include "Coherence/PatchChecks.h"
#include "Coherence/RidgeChecks.h"
#include "Coherence/Severity.h"
#include "Coherence/UmbilicChecks.h"
#include "Fixtures/TestFields.h"
#include "Ridges/Patch/PatchPaths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <set>

namespace ridges
{
namespace testing
{
namespace
{

/// n x n points in the plane, each square cut from its lower left to its upper right. All d1 are
/// along x, and b0 is what a function of the point says.
class Grid
{
public:
  explicit Grid(
    int n, const std::function<double(int x, int y)>& b0 = [](int, int) { return 1.0; })
    : N_(n)
    , Surface_(MakeMesh(n))
    , Field_(n * n)
  {
    for (Id p = 0; p < n * n; ++p)
    {
      this->Field_.d1[3 * p] = 1.0;
      this->Field_.d2[3 * p + 1] = 1.0;
      this->Field_.b[4 * p] = b0(p % n, p / n);
      this->Field_.b[4 * p + 3] = 1.0;
    }
    const Id triangles = this->Surface_.Triangles().NumberOfTriangles();
    this->picture.mesh = &this->Surface_.Triangles();
    this->picture.field = this->Field_.View();
    this->picture.isUsable.assign(triangles, 1);
    this->picture.patchOf.assign(triangles, -1);
    this->picture.cancelledIn.assign(triangles, -1);
  }

  Id At(int x, int y) const { return x + this->N_ * y; }

  /// A point of a ridge on the edge between two points of the grid.
  Id OnEdge(Id p, Id q, double parameter = 0.5)
  {
    PicturePoint point;
    point.edge = FindEdge(*this->picture.mesh, p, q);
    point.parameter = parameter;
    point.position = (1.0 - parameter) * this->picture.mesh->Point(std::min(p, q)) +
      parameter * this->picture.mesh->Point(std::max(p, q));
    return this->Insert(point);
  }

  Id AtUmbilic(Id umbilic, Id triangle)
  {
    PicturePoint point;
    point.umbilic = umbilic;
    point.position = this->picture.mesh->Centroid(triangle);
    return this->Insert(point);
  }

  void AddUmbilic(Id id, Id triangle, int ridgeCount)
  {
    this->picture.umbilics.push_back(
      { id, triangle, this->picture.mesh->Centroid(triangle), ridgeCount, 0.5 });
  }

  void AddLine(Id ridge, std::vector<Id> points, RidgeType type = RidgeType::MaximumHyperbolic)
  {
    this->picture.lines.push_back({ type, ridge, false, std::move(points) });
  }

  std::vector<WholeRidge> Ridges() const { return FindWholeRidges(this->picture); }

  RidgePicture picture;

private:
  static Mesh MakeMesh(int n)
  {
    Mesh mesh;
    for (int y = 0; y < n; ++y)
    {
      for (int x = 0; x < n; ++x)
      {
        mesh.points.insert(mesh.points.end(), { double(x), double(y), 0.0 });
        if (x + 1 < n && y + 1 < n)
        {
          const int p = x + n * y;
          mesh.triangles.insert(mesh.triangles.end(), { p, p + 1, p + n + 1 });
          mesh.triangles.insert(mesh.triangles.end(), { p, p + n + 1, p + n });
        }
      }
    }
    return mesh;
  }

  Id Insert(const PicturePoint& point)
  {
    this->picture.points.push_back(point);
    return static_cast<Id>(this->picture.points.size()) - 1;
  }

  int N_;
  MeshedSurface Surface_;
  FieldArrays Field_;
};

} // namespace

TEST(CoherenceChecks, PolylinesAreJoinedWhereTheyShareAnEnd)
{
  Grid grid(3);
  for (int i = 0; i < 6; ++i)
  {
    grid.OnEdge(grid.At(0, 0), grid.At(1, 0));
  }
  grid.AddLine(4, { 2, 3, 4 });
  grid.AddLine(4, { 4, 5 });
  grid.AddLine(2, { 0, 1 });
  grid.AddLine(2, { 1, 0 });
  grid.AddLine(7, { 0, 1 });
  grid.AddLine(7, { 2, 3 });
  const std::vector<WholeRidge> ridges = grid.Ridges();
  ASSERT_EQ(ridges.size(), 3u);
  EXPECT_EQ(ridges[0].id, 2);
  ASSERT_EQ(ridges[0].chains.size(), 1u);
  EXPECT_TRUE(ridges[0].chains[0].closed);
  ASSERT_EQ(ridges[1].chains.size(), 1u);
  EXPECT_FALSE(ridges[1].chains[0].closed);
  EXPECT_EQ(ridges[1].chains[0].points, (std::vector<Id>{ 2, 3, 4, 5 }));
  EXPECT_EQ(ridges[2].chains.size(), 2u);
}

TEST(CoherenceChecks, LoopWithAMissingPartIsOneChain)
{
  Grid grid(3);
  for (int i = 0; i < 6; ++i)
  {
    grid.OnEdge(grid.At(0, 0), grid.At(1, 0));
  }
  grid.AddLine(0, { 0, 1, 2 });
  grid.AddLine(0, { 4, 5, 0 });
  const std::vector<WholeRidge> ridges = grid.Ridges();
  ASSERT_EQ(ridges[0].chains.size(), 1u);
  EXPECT_EQ(ridges[0].chains[0].points, (std::vector<Id>{ 4, 5, 0, 1, 2 }));
}

TEST(CoherenceChecks, RidgeBackToItsUmbilicCountsTwice)
{
  Grid grid(4);
  const Id umbilic = grid.AtUmbilic(5, 0);
  const Id across = grid.OnEdge(grid.At(0, 0), grid.At(1, 1));
  grid.AddUmbilic(5, 0, 3);
  grid.AddLine(0, { umbilic, across, umbilic });
  grid.AddLine(1, { umbilic, across });
  const CoherenceCheck check = CheckRidgesAtUmbilics(grid.picture, grid.Ridges());
  ASSERT_EQ(check.offenders.size(), 1u); // as there are no red ones
  EXPECT_EQ(check.offenders[0].ids[0], 5);
  const auto& counts = std::get<RidgeCounts>(check.numbers);
  EXPECT_EQ(counts.blue, 3);
  EXPECT_EQ(counts.red, 0);
  EXPECT_EQ(counts.expected, 3);
}

TEST(CoherenceChecks, BordersAndUmbilicsEndRidges)
{
  Grid grid(3);
  const auto passes = [&](const std::vector<Id>& points)
  {
    grid.picture.lines.clear();
    grid.AddLine(0, points);
    return CheckRidgeEnds(grid.picture, grid.Ridges()).Passed();
  };
  grid.AddUmbilic(0, 1, 1); // the second triangle of the first square
  const Id bottom = grid.OnEdge(grid.At(0, 0), grid.At(1, 0));
  const Id diagonal = grid.OnEdge(grid.At(0, 0), grid.At(1, 1));
  const Id left = grid.OnEdge(grid.At(0, 0), grid.At(0, 1));
  const Id umbilic = grid.AtUmbilic(0, 1);
  const Id unknown = grid.AtUmbilic(8, 1);
  const Id unmarked = grid.AtUmbilic(-1, 1);
  EXPECT_TRUE(passes({ bottom, diagonal, left }));
  EXPECT_TRUE(passes({ bottom, diagonal, umbilic }));
  EXPECT_FALSE(passes({ bottom, diagonal }));
  EXPECT_FALSE(passes({ bottom, left })); // not in one triangle
  EXPECT_FALSE(passes({ bottom, diagonal, unknown }));
  EXPECT_FALSE(passes({ bottom, diagonal, unmarked }));
  EXPECT_FALSE(passes({ bottom, umbilic })); // not in the umbilic's triangle
}

TEST(CoherenceChecks, ChordsCrossWhereTheirEndsAlternate)
{
  const auto cross = [](double a, double b, double c, double d)
  {
    Grid grid(2);
    // Both from the bottom to the right side of the lower triangle.
    grid.AddLine(0, { grid.OnEdge(0, 1, a), grid.OnEdge(1, 3, b) });
    grid.AddLine(1, { grid.OnEdge(0, 1, c), grid.OnEdge(1, 3, d) });
    return !CheckNoIntersections(grid.picture, grid.Ridges()).Passed();
  };
  EXPECT_FALSE(cross(0.4, 0.6, 0.6, 0.4));
  EXPECT_TRUE(cross(0.4, 0.6, 0.6, 0.7));
  EXPECT_TRUE(cross(0.6, 0.4, 0.4, 0.3));
  EXPECT_FALSE(cross(0.4, 0.6, 0.4, 0.7)); // touching
}

TEST(CoherenceChecks, IntersectionsAreUncertainInsideRegionsOnly)
{
  Grid grid(2);
  grid.AddLine(0, { grid.OnEdge(0, 1, 0.4), grid.OnEdge(1, 3, 0.6) });
  const auto severity = [&grid]()
  { return SeverityOf(CheckNoIntersections(grid.picture, grid.Ridges()), grid.picture); };
  EXPECT_EQ(severity(), Severity::None);
  grid.AddLine(1, { grid.OnEdge(0, 1, 0.6), grid.OnEdge(1, 3, 0.7) });
  EXPECT_EQ(severity(), Severity::Wrong);
  grid.picture.patchOf[0] = 3;
  EXPECT_EQ(severity(), Severity::Uncertain);
  grid.picture.patchOf[0] = -1;
  grid.picture.cancelledIn[0] = 0;
  EXPECT_EQ(severity(), Severity::Uncertain);
}

TEST(CoherenceChecks, OnlyRulesThatHoldWithAnyNoiseCanBeWrong)
{
  const Grid grid(2);
  const auto severity = [&grid](CheckKind kind)
  {
    CoherenceCheck check(kind, OffenderKind::Triangle);
    check.offenders.push_back({ { 0, -1 }, Eigen::Vector3d::Zero() });
    return SeverityOf(check, grid.picture);
  };
  for (const CheckKind kind : { CheckKind::IndexSum, CheckKind::TypesAtUmbilics,
         CheckKind::RidgeEnds, CheckKind::TurningPoints, CheckKind::Intersections,
         CheckKind::DoubleCrossings, CheckKind::PointsOnEdges, CheckKind::Crossings })
  {
    EXPECT_EQ(severity(kind), Severity::Wrong) << static_cast<int>(kind);
  }
  for (const CheckKind kind :
    { CheckKind::UmbilicsPerTriangle, CheckKind::RidgesAtUmbilics, CheckKind::Patches,
      CheckKind::RidgesInPatches, CheckKind::PatchContours, CheckKind::RightAngles })
  {
    EXPECT_EQ(severity(kind), Severity::Uncertain) << static_cast<int>(kind);
  }
}

TEST(CoherenceChecks, RidgesToAnUmbilicMayNotCrossOthers)
{
  Grid grid(2);
  grid.AddUmbilic(0, 0, 1);
  const Id umbilic = grid.AtUmbilic(0, 0);
  const auto passes = [&]() { return CheckNoIntersections(grid.picture, grid.Ridges()).Passed(); };
  // One cuts off the corner 1 of the triangle 0 1 3; the umbilic is at the centroid.
  grid.AddLine(0, { grid.OnEdge(0, 1, 0.9), grid.OnEdge(1, 3, 0.1) });
  EXPECT_TRUE(passes());
  grid.AddLine(1, { grid.OnEdge(0, 1, 0.8), umbilic });
  EXPECT_TRUE(passes());
  grid.AddLine(2, { umbilic, grid.OnEdge(1, 3, 0.05) });
  EXPECT_FALSE(passes());
  grid.picture.lines.back().type = RidgeType::MinimumHyperbolic; // other colours may
  EXPECT_TRUE(passes());
}

TEST(CoherenceChecks, IndexSumIsOfEachClosedPart)
{
  // Two tetrahedra that touch in a point, and an open triangle.
  Mesh mesh;
  mesh.points = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, -1, 0, 0, 0, -1, 0, 0, 0, -1, 5, 0, 0, 6, 0,
    0, 5, 1, 0 };
  mesh.triangles = { 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3, 0, 4, 5, 0, 6, 4, 0, 5, 6, 4, 6, 5, 7, 8,
    9 };
  const MeshedSurface surface(mesh);
  RidgePicture picture;
  picture.mesh = &surface.Triangles();
  const auto add = [&](Id triangle, double index)
  {
    const Id id = static_cast<Id>(picture.umbilics.size());
    picture.umbilics.push_back({ id, triangle, surface.Triangles().Centroid(triangle), 1, index });
  };
  for (const Id t : { 0, 1, 2, 3, 4, 5, 6 })
  {
    add(t, 0.5);
  }
  add(8, -0.5); // the open part has any index
  CoherenceCheck check = CheckIndexSum(picture);
  EXPECT_TRUE(check.applies);
  ASSERT_EQ(check.offenders.size(), 1u);
  EXPECT_EQ(check.offenders[0].ids[0], 4);
  const auto& sums = std::get<IndexSums>(check.numbers);
  EXPECT_EQ(sums.characteristic, 4);
  EXPECT_EQ(sums.index, 3.5);
  EXPECT_EQ(sums.closedParts, 2u);
  EXPECT_EQ(sums.parts, 3u);
  add(7, 0.5);
  EXPECT_TRUE(CheckIndexSum(picture).Passed());
}

TEST(CoherenceChecks, PatchesAreDisks)
{
  Grid grid(6);
  const auto passes = [&](const std::vector<Id>& triangles, Id umbilic)
  {
    std::fill(grid.picture.patchOf.begin(), grid.picture.patchOf.end(), -1);
    grid.picture.umbilics.clear();
    grid.AddUmbilic(3, umbilic, 1);
    for (const Id t : triangles)
    {
      grid.picture.patchOf[t] = 3;
    }
    return CheckPatches(grid.picture).Passed();
  };
  EXPECT_TRUE(passes({ 0 }, 0));
  EXPECT_TRUE(passes({ 0, 1, 2, 3 }, 2));
  EXPECT_FALSE(passes({ 0, 1, 2, 3 }, 9)); // its umbilic is elsewhere
  EXPECT_FALSE(passes({ 0, 9 }, 0));       // in two pieces
  EXPECT_FALSE(passes({}, 0));
  // All around a square.
  EXPECT_FALSE(passes({ 0, 1, 2, 3, 4, 5, 10, 11, 14, 15, 20, 21, 22, 23, 24, 25 }, 0));
}

TEST(CoherenceChecks, SmallLoopsMayBeMissing)
{
  const auto lostAround = [](int radius)
  {
    const Grid grid(24,
      [radius](int x, int y)
      { return std::max(std::abs(x - 11), std::abs(y - 11)) <= radius ? -1.0 : 1.0; });
    return FindLostCrossings(grid.picture, {}, Color::Blue);
  };
  const LostCrossings small = lostAround(3); // 49 points
  EXPECT_EQ(small.smallLoops, 1u);
  EXPECT_TRUE(small.edges.empty());
  const LostCrossings large = lostAround(4); // 81 points
  EXPECT_EQ(large.smallLoops, 0u);
  EXPECT_EQ(large.edges.size(), large.crossed);
  // A ridge that ends on the border is no loop, however short.
  const Grid corner(5, [](int x, int y) { return x + y == 0 ? -1.0 : 1.0; });
  EXPECT_EQ(FindLostCrossings(corner.picture, {}, Color::Blue).edges.size(), 3u);
  EXPECT_EQ(FindLostCrossings(corner.picture, {}, Color::Red).crossed, 0u);
}

TEST(CoherenceChecks, IgnoresCrossingsInsideRegions)
{
  Grid grid(5, [](int x, int y) { return x == 2 && y == 2 ? -1.0 : 1.0; });
  EXPECT_EQ(FindLostCrossings(grid.picture, {}, Color::Blue).crossed, 6u);
  std::fill(grid.picture.cancelledIn.begin(), grid.picture.cancelledIn.end(), 0);
  EXPECT_EQ(FindLostCrossings(grid.picture, {}, Color::Blue).crossed, 0u);
  std::fill(grid.picture.cancelledIn.begin(), grid.picture.cancelledIn.begin() + 16, 1);
  // The border between two regions is outside: two of the edges are on it.
  EXPECT_EQ(FindLostCrossings(grid.picture, {}, Color::Blue).crossed, 2u);
}

// Random connected patches, folded as they may be: three ways lead to a point in the middle, and
// one runs along the contour between two of its sides with none of the three between them.
TEST(PatchPaths, DoNotCross)
{
  std::mt19937_64 generator(11);
  const auto below = [&generator](std::size_t n)
  { return static_cast<std::size_t>(n * Uniform(generator)); };
  int looked = 0;
  for (int round = 0; round < 3000; ++round)
  {
    Grid grid(9);
    const TriangleMesh& mesh = *grid.picture.mesh;
    const Id target = 60;
    std::vector<Id> patch{ target };
    for (int side = 0; side < 3; ++side) // so that the target has no side on the contour
    {
      patch.push_back(mesh.Neighbor(target, side));
    }
    const std::size_t size = 8 + below(40);
    while (patch.size() < size)
    {
      const Id next = mesh.Neighbor(patch[below(patch.size())], static_cast<int>(below(3)));
      if (next >= 0 && std::find(patch.begin(), patch.end(), next) == patch.end())
      {
        patch.push_back(next);
      }
    }
    std::sort(patch.begin(), patch.end());
    const PatchContour contour(mesh, patch);
    std::set<Id> edges;
    for (const PatchContour::Side& side : contour.Sides())
    {
      edges.insert(side.edge);
    }
    if (edges.size() != contour.Sides().size())
    {
      continue; // cut open: an edge is there twice
    }
    std::set<std::size_t> drawn;
    while (drawn.size() < 5)
    {
      drawn.insert(below(contour.Sides().size()));
    }
    std::vector<std::size_t> sides(drawn.begin(), drawn.end());
    const std::size_t apart = below(5);
    const std::size_t first = sides[apart];
    const std::size_t last = sides[(apart + 1) % 5];
    sides.erase(std::remove_if(sides.begin(), sides.end(),
                  [&](std::size_t side) { return side == first || side == last; }),
      sides.end());

    const Triangle& corners = mesh.Corners(target);
    const double weights[] = { 0.02 + Uniform(generator), 0.02 + Uniform(generator),
      0.02 + Uniform(generator) };
    const Eigen::Vector3d position =
      (weights[0] * mesh.Point(corners[0]) + weights[1] * mesh.Point(corners[1]) +
        weights[2] * mesh.Point(corners[2])) /
      (weights[0] + weights[1] + weights[2]);
    const auto pointOn = [&](std::size_t side)
    {
      const Edge& edge = mesh.EdgeAt(contour.Sides()[side].edge);
      return grid.OnEdge(edge.v0, edge.v1);
    };
    const auto follow = [&](std::vector<Id>& line, const std::vector<EdgeCrossing>& path)
    {
      for (const EdgeCrossing& crossing : path)
      {
        const Edge& edge = mesh.EdgeAt(crossing.edge);
        line.push_back(grid.OnEdge(edge.v0, edge.v1, crossing.parameter));
      }
    };
    PatchPaths paths(mesh, MongeField(), contour);
    std::vector<Eigen::Vector3d> starts;
    std::vector<std::vector<Id>> lines;
    for (const std::size_t side : sides)
    {
      lines.push_back({ pointOn(side) });
      starts.push_back(grid.picture.points.back().position);
    }
    grid.AddUmbilic(0, target, 3);
    const Id umbilic = grid.AtUmbilic(0, target);
    grid.picture.points[umbilic].position = position;
    const auto ways = paths.ToPoint(sides, starts, target, position);
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      follow(lines[i], ways[i]);
      lines[i].push_back(umbilic);
    }
    lines.push_back({ pointOn(first) });
    follow(lines.back(), paths.AlongContour(first, last));
    lines.back().push_back(pointOn(last));
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
      grid.AddLine(static_cast<Id>(i), lines[i]);
    }
    const std::vector<WholeRidge> ridges = grid.Ridges();
    ASSERT_TRUE(CheckNoIntersections(grid.picture, ridges).Passed()) << "round " << round;
    ++looked;
  }
  EXPECT_GT(looked, 300);
}

} // namespace testing
} // namespace ridges
