// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// Neighbourhoods against breadth-first search over edges. Sets of points: no tolerance anywhere.

#include "Fixtures/TestFields.h"

#include "Mesh/RingNeighborhood.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace
{

using namespace ridges;
using namespace ridges::testing;
using Eigen::Vector3d;
using Kind = NeighborhoodRule::Kind;

NeighborhoodRule ByRings(int rings)
{
  NeighborhoodRule rule;
  rule.kind = Kind::Rings;
  rule.numberOfRings = rings;
  return rule;
}

NeighborhoodRule ByCount(int count)
{
  NeighborhoodRule rule;
  rule.minimumNumberOfPoints = count;
  return rule;
}

NeighborhoodRule ByRadius(double radius)
{
  NeighborhoodRule rule;
  rule.kind = Kind::Radius;
  rule.radius = radius;
  return rule;
}

// The neighbours of all points, from the edges alone.
std::vector<std::set<Id>> NeighborsOf(const TriangleMesh& mesh)
{
  std::vector<std::set<Id>> neighbors(mesh.NumberOfPoints());
  for (Id e = 0; e < mesh.NumberOfEdges(); ++e)
  {
    neighbors[mesh.EdgeAt(e).v0].insert(mesh.EdgeAt(e).v1);
    neighbors[mesh.EdgeAt(e).v1].insert(mesh.EdgeAt(e).v0);
  }
  return neighbors;
}

std::set<Id> BruteForce(const TriangleMesh& mesh, const std::vector<std::set<Id>>& neighbors,
  Id vertex, const NeighborhoodRule& rule, int& rings)
{
  const auto accepted = [&](Id p)
  {
    return rule.kind != Kind::Radius ||
      (mesh.Point(p) - mesh.Point(vertex)).norm() <= rule.radius * (1.0 + 1e-14);
  };
  std::set<Id> found = { vertex };
  for (rings = 0;; ++rings)
  {
    const bool enough = rule.kind == Kind::Rings ? rings == rule.numberOfRings
                                                 : rule.kind == Kind::PointCount &&
        static_cast<int>(found.size()) >= rule.minimumNumberOfPoints;
    std::set<Id> larger = found;
    for (const Id p : found)
    {
      for (const Id q : neighbors[p])
      {
        if (accepted(q))
        {
          larger.insert(q);
        }
      }
    }
    if (enough || larger.size() == found.size())
    {
      return found;
    }
    found = larger;
  }
}

void CheckAgainstBruteForce(const Mesh& input, const std::vector<NeighborhoodRule>& rules)
{
  const MeshedSurface surface(input);
  const TriangleMesh& mesh = surface.Triangles();
  const std::vector<std::set<Id>> neighbors = NeighborsOf(mesh);
  const OrderedRings orderedRings = RingsOf(mesh);
  // One for all: what is left of a call must not matter.
  RingNeighborhood neighborhood(mesh, orderedRings);
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    for (const NeighborhoodRule& rule : rules)
    {
      int rings = 0;
      const std::set<Id> expected = BruteForce(mesh, neighbors, p, rule, rings);
      const Span<Id> points = neighborhood.Gather(p, rule);
      ASSERT_EQ(points[0], p);
      ASSERT_EQ(points.size(), static_cast<Id>(expected.size())) << "point " << p;
      ASSERT_EQ(std::set<Id>(points.begin(), points.end()), expected) << "point " << p;
      ASSERT_EQ(neighborhood.NumberOfRings(), rule.kind == Kind::Radius ? 0 : rings);
    }
  }
}

// Two parallel sheets of n by n cells of size 1, `gap` apart, joined along one side.
Mesh ThinWall(int n, double gap)
{
  Mesh mesh;
  const auto columns = 2 * n + 2; // Along one sheet, around the joined side, and back.
  for (int i = 0; i < columns; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      const int x = i <= n ? i : columns - 1 - i;
      mesh.AddPoint(Vector3d(x, j, i <= n ? 0.0 : gap));
    }
  }
  for (int i = 0; i + 1 < columns; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      const int p = i * (n + 1) + j;
      mesh.AddTriangle(p, p + n + 1, p + n + 2);
      mesh.AddTriangle(p, p + n + 2, p + 1);
    }
  }
  return mesh;
}

// Two pyramids on a polygon with n corners, base to base.
Mesh DoublePyramid(int n)
{
  Mesh mesh;
  mesh.AddPoint(Vector3d(0, 0, 1));
  mesh.AddPoint(Vector3d(0, 0, -1));
  for (int i = 0; i < n; ++i)
  {
    const double angle = 2.0 * EIGEN_PI * i / n;
    mesh.AddPoint(Vector3d(std::cos(angle), std::sin(angle), 0.0));
  }
  for (int i = 0; i < n; ++i)
  {
    const int p = 2 + i;
    const int q = 2 + (i + 1) % n;
    mesh.AddTriangle(0, p, q);
    mesh.AddTriangle(1, q, p);
  }
  return mesh;
}

// Some triangles parted into three: fans of three triangles, beside fans of many.
Mesh PartTriangles(const Mesh& mesh, int every)
{
  Mesh parted;
  parted.points = mesh.points;
  for (std::size_t t = 0; t < mesh.TriangleCount(); ++t)
  {
    const std::int32_t* c = mesh.triangles.data() + 3 * t;
    if (t % every != 0)
    {
      parted.AddTriangle(c[0], c[1], c[2]);
      continue;
    }
    const auto center = static_cast<std::int32_t>(parted.PointCount());
    parted.AddPoint((mesh.Point(c[0]) + mesh.Point(c[1]) + mesh.Point(c[2])) / 3.0);
    parted.AddTriangle(c[0], c[1], center);
    parted.AddTriangle(c[1], c[2], center);
    parted.AddTriangle(c[2], c[0], center);
  }
  return parted;
}

/// A mesh in its own numbering and in another one, and what gathers its neighbourhoods.
struct BothNumberings
{
  explicit BothNumberings(const Mesh& mesh)
    : before(mesh)
    , after(Permute(mesh, 17, &newToOld))
    , ringsBefore(RingsOf(before.Triangles()))
    , ringsAfter(RingsOf(after.Triangles()))
    , ofBefore(before.Triangles(), ringsBefore)
    , ofAfter(after.Triangles(), ringsAfter)
  {
  }

  std::vector<std::int32_t> newToOld;
  MeshedSurface before;
  MeshedSurface after;
  OrderedRings ringsBefore;
  OrderedRings ringsAfter;
  RingNeighborhood ofBefore;
  RingNeighborhood ofAfter;
};

} // namespace

//------------------------------------------------------------------------------
TEST(RingNeighborhood, IsThatOfABreadthFirstSearch)
{
  const std::vector<NeighborhoodRule> rules = { ByRings(0), ByRings(1), ByRings(2), ByRings(4),
    ByCount(1), ByCount(7), ByCount(18), ByCount(40), ByCount(10000), ByRadius(0.0), ByRadius(0.3),
    ByRadius(0.7), ByRadius(100.0) };
  CheckAgainstBruteForce(EllipsoidMesh(5, 1.0, 0.8, 0.6), rules);
  CheckAgainstBruteForce(TorusMesh(1.0, 0.4, 14, 8), rules);
  CheckAgainstBruteForce(CylinderPatch(1.0, 2.0, 1.0, 12, 7), rules);
  CheckAgainstBruteForce(AddNormalNoise(Icosphere(4), 0.2, 3), rules);
}

//------------------------------------------------------------------------------
// Where two rings do not follow from the fans alone: fans of three, four, and more than eight
// triangles, and second rings that meet themselves or the first.
TEST(RingNeighborhood, IsThatOfABreadthFirstSearchOnOddFans)
{
  const std::vector<NeighborhoodRule> rules = { ByRings(1), ByRings(2), ByRings(3), ByCount(9),
    ByCount(18) };
  for (const int n : { 3, 4, 5, 8, 9, 12 })
  {
    CheckAgainstBruteForce(DoublePyramid(n), rules);
    CheckAgainstBruteForce(PartTriangles(DoublePyramid(n), 2), rules);
  }
  CheckAgainstBruteForce(Icosphere(1), rules);
  for (const int around : { 3, 4, 5, 6 })
  {
    CheckAgainstBruteForce(TorusMesh(1.0, 0.4, 12, around), rules);
    CheckAgainstBruteForce(TorusMesh(1.0, 0.4, 5, around), rules);
  }
  for (const int every : { 1, 2, 3, 7 })
  {
    CheckAgainstBruteForce(PartTriangles(Icosphere(5), every), rules);
  }
}

//------------------------------------------------------------------------------
TEST(RingNeighborhood, EndsWithTheComponent)
{
  // A tetrahedron, an isolated point and a triangle.
  Mesh mesh;
  for (const Vector3d& p :
    { Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, 1),
      Vector3d(0.1, 0.1, 0.1), Vector3d(2, 0, 0), Vector3d(2, 1, 0), Vector3d(2, 0, 1) })
  {
    mesh.AddPoint(p);
  }
  mesh.AddTriangle(0, 2, 1);
  mesh.AddTriangle(0, 1, 3);
  mesh.AddTriangle(1, 2, 3);
  mesh.AddTriangle(2, 0, 3);
  mesh.AddTriangle(5, 6, 7);
  const std::vector<NeighborhoodRule> rules = { ByRings(3), ByCount(18), ByRadius(100.0) };
  CheckAgainstBruteForce(mesh, rules);
  const MeshedSurface surface(mesh);
  const OrderedRings rings = RingsOf(surface.Triangles());
  RingNeighborhood neighborhood(surface.Triangles(), rings);
  for (const NeighborhoodRule& rule : rules)
  {
    EXPECT_EQ(neighborhood.Gather(0, rule).size(), 4);
    EXPECT_EQ(neighborhood.Gather(4, rule).size(), 1);
    EXPECT_EQ(neighborhood.Gather(5, rule).size(), 3);
  }
}

//------------------------------------------------------------------------------
TEST(RingNeighborhood, StaysOnItsSideOfAThinWall)
{
  const int n = 20;
  const MeshedSurface surface(ThinWall(n, 0.01));
  const TriangleMesh& mesh = surface.Triangles();
  const Id perSheet = (n + 1) * (n + 1);
  const OrderedRings rings = RingsOf(mesh);
  RingNeighborhood neighborhood(mesh, rings);
  for (const NeighborhoodRule& rule : { ByRings(4), ByCount(50), ByRadius(4.2) })
  {
    for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
    {
      if (mesh.Point(p).x() > n - 6.0)
      {
        continue; // Here the other sheet is within reach around the side.
      }
      for (const Id q : neighborhood.Gather(p, rule))
      {
        ASSERT_EQ(q < perSheet, p < perSheet) << "from " << p << " to " << q;
      }
    }
  }
  // And where it is within reach it is taken: the wall was not just out of range.
  const Span<Id> around = neighborhood.Gather(n * (n + 1) + n / 2, ByRadius(4.2));
  EXPECT_TRUE(std::any_of(around.begin(), around.end(), [&](Id q) { return q >= perSheet; }));
}

//------------------------------------------------------------------------------
TEST(RingNeighborhood, GoesOutwardRingByRingAndGrowsByOne)
{
  const MeshedSurface surface(AddNormalNoise(Icosphere(6), 0.05, 3));
  const TriangleMesh& mesh = surface.Triangles();
  const OrderedRings rings = RingsOf(mesh);
  RingNeighborhood neighborhood(mesh, rings);
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    const Span<Id> three = neighborhood.Gather(p, ByRings(3));
    const std::vector<Id> expected(three.begin(), three.end());
    const Span<Id> two = neighborhood.Gather(p, ByRings(2));
    ASSERT_TRUE(std::equal(two.begin(), two.end(), expected.begin()));
    const Span<Id> grown = neighborhood.Grow();
    ASSERT_EQ(std::vector<Id>(grown.begin(), grown.end()), expected);
    ASSERT_EQ(neighborhood.NumberOfRings(), 3);
  }
}

//------------------------------------------------------------------------------
TEST(RingNeighborhood, HasOneOrderForAnyNumbering)
{
  // Both meshes have many points at equal distances of a vertex.
  for (const Mesh& mesh :
    { Icosphere(4, false), GraphPatch([](double, double) { return 0.0; }, 1.0, 16) })
  {
    BothNumberings both(mesh);
    for (const NeighborhoodRule& rule : { ByRings(2), ByCount(18), ByRadius(0.4) })
    {
      for (Id p = 0; p < both.after.Triangles().NumberOfPoints(); ++p)
      {
        const Span<Id> expected = both.ofBefore.Gather(both.newToOld[p], rule);
        const Span<Id> found = both.ofAfter.Gather(p, rule);
        ASSERT_EQ(found.size(), expected.size());
        for (Id i = 0; i < found.size(); ++i)
        {
          ASSERT_EQ(both.newToOld[found[i]], expected[i]) << "point " << p << " place " << i;
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(RingNeighborhood, HasOneOrderOfPlacesForAnyNumbering)
{
  // So coarsely rounded that many points share a place: which of them comes first cannot be known.
  Mesh mesh = Icosphere(8);
  for (double& x : mesh.points)
  {
    x = 0.25 * std::round(4.0 * x);
  }
  BothNumberings both(mesh);
  int sorted = 0;
  for (Id p = 0; p < both.after.Triangles().NumberOfPoints(); ++p)
  {
    const Span<Id> expected = both.ofBefore.Gather(both.newToOld[p], ByCount(18));
    const Span<Id> found = both.ofAfter.Gather(p, ByCount(18));
    ASSERT_EQ(found.size(), expected.size());
    ASSERT_EQ(both.ofAfter.IsInRings(), both.ofBefore.IsInRings());
    sorted += both.ofAfter.IsInRings() ? 0 : 1;
    for (Id i = 0; i < found.size(); ++i)
    {
      ASSERT_EQ(both.after.Triangles().Point(found[i]), both.before.Triangles().Point(expected[i]))
        << "point " << p << " place " << i;
    }
  }
  EXPECT_GT(sorted, 0);
}

//------------------------------------------------------------------------------
TEST(RingNeighborhood, ByRingsAndPointCountHasBoth)
{
  const MeshedSurface surface(Icosphere(10));
  const TriangleMesh& mesh = surface.Triangles();
  const OrderedRings rings = RingsOf(mesh);
  RingNeighborhood neighborhood(mesh, rings);
  RingNeighborhood other(mesh, rings);
  NeighborhoodRule rule;
  rule.kind = Kind::RingsAndPointCount;
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    // Two rings have 16 points around the twelve points with five neighbours, else 17 to 19.
    rule.numberOfRings = 2;
    rule.minimumNumberOfPoints = 3;
    EXPECT_EQ(neighborhood.Gather(p, rule).size(), other.Gather(p, ByRings(2)).size());
    rule.minimumNumberOfPoints = 30;
    EXPECT_EQ(neighborhood.Gather(p, rule).size(), other.Gather(p, ByCount(30)).size());
    EXPECT_EQ(neighborhood.NumberOfRings(), 3);
  }
}
