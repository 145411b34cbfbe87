// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// The fans of triangles around points.

#include "Fixtures/TestFields.h"

#include "Mesh/OrderedRings.h"
#include "Mesh/PositionOrder.h"
#include "Mesh/RingNeighborhood.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>

namespace
{

using namespace ridges;
using namespace ridges::testing;
using Eigen::Vector3d;

// Whether some triangle has the corners p, q, r in this order.
bool HasTriangle(const TriangleMesh& mesh, Id p, Id q, Id r)
{
  const Span<Id> triangles = mesh.TrianglesAround(p);
  return std::any_of(triangles.begin(), triangles.end(),
    [&](Id t)
    {
      const Triangle& c = mesh.Corners(t);
      return (c[0] == p && c[1] == q && c[2] == r) || (c[1] == p && c[2] == q && c[0] == r) ||
        (c[2] == p && c[0] == q && c[1] == r);
    });
}

void CheckFans(const Mesh& input)
{
  const MeshedSurface surface(input);
  const TriangleMesh& mesh = surface.Triangles();
  const OrderedRings rings = RingsOf(mesh);
  EXPECT_FALSE(rings.HasIrregular());
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    const Span<Id> ring = rings.Around(p);
    const bool open = rings.OnBorder(p);
    ASSERT_TRUE(rings.IsRegular(p));
    ASSERT_EQ(open, mesh.OnBorder(p));
    ASSERT_EQ(ring.size(), mesh.TrianglesAround(p).size() + (open ? 1 : 0));
    ASSERT_EQ(std::set<Id>(ring.begin(), ring.end()).size(), static_cast<std::size_t>(ring.size()));
    for (Id i = 0; i + 1 < ring.size(); ++i)
    {
      ASSERT_TRUE(HasTriangle(mesh, p, ring[i], ring[i + 1]));
    }
    if (!open)
    {
      ASSERT_TRUE(HasTriangle(mesh, p, ring[ring.size() - 1], ring[0]));
      for (const Id q : ring)
      {
        ASSERT_FALSE(ComesBefore(mesh.Point(q), mesh.Point(ring[0])));
      }
    }
  }
}

// Points in general position and these triangles.
Mesh SmallMesh(int points, const std::vector<Triangle>& triangles)
{
  Mesh mesh;
  for (int i = 0; i < points; ++i)
  {
    mesh.AddPoint(Vector3d(i, i * i % 7, i * i * i % 11));
  }
  for (const Triangle& t : triangles)
  {
    mesh.AddTriangle(t[0], t[1], t[2]);
  }
  return mesh;
}

} // namespace

//------------------------------------------------------------------------------
TEST(OrderedRings, FollowTheTrianglesAroundThePoint)
{
  CheckFans(Permute(Icosphere(5), 3));
  CheckFans(Permute(TorusMesh(1.0, 0.4, 14, 8), 4));
  CheckFans(Permute(CylinderPatch(1.0, 2.0, 1.0, 12, 7), 5));
  CheckFans(Permute(GraphPatch([](double x, double y) { return x * y; }, 1.0, 9, 0.2), 6));
  // Neighbours with the same x.
  CheckFans(Permute(GraphPatch([](double, double) { return 0.0; }, 1.0, 9), 7));
}

//------------------------------------------------------------------------------
TEST(OrderedRings, DoNotExistWhereTheTrianglesMakeNoFan)
{
  struct Case
  {
    const char* what;
    Mesh mesh;
    bool onBorder;
  };
  const Case cases[] = {
    { "three triangles in one edge", SmallMesh(5, { { 0, 1, 2 }, { 0, 1, 3 }, { 0, 1, 4 } }),
      true },
    { "opposite orientations", SmallMesh(4, { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 1, 3 } }), false },
    { "two open fans", SmallMesh(5, { { 0, 1, 2 }, { 0, 3, 4 } }), true },
    { "two closed fans",
      SmallMesh(
        7, { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 0, 4, 5 }, { 0, 5, 6 }, { 0, 6, 4 } }),
      false },
  };
  for (const Case& c : cases)
  {
    const MeshedSurface surface(c.mesh);
    const OrderedRings rings = RingsOf(surface.Triangles());
    EXPECT_FALSE(rings.IsRegular(0)) << c.what;
    EXPECT_TRUE(rings.HasIrregular()) << c.what;
    EXPECT_EQ(rings.OnBorder(0), c.onBorder) << c.what;
    EXPECT_EQ(rings.Around(0).size(), 0) << c.what;
  }
}

//------------------------------------------------------------------------------
TEST(OrderedRings, AreEmptyForPointsWithoutTriangles)
{
  const MeshedSurface surface(SmallMesh(4, { { 0, 1, 2 } }));
  const OrderedRings rings = RingsOf(surface.Triangles());
  EXPECT_EQ(rings.Around(3).size(), 0);
  EXPECT_FALSE(rings.OnBorder(3));
  EXPECT_FALSE(rings.HasIrregular());
  EXPECT_EQ(rings.Around(0).size(), 2);
}

//------------------------------------------------------------------------------
// A disk whose points crowd together on one side: the neighbours that stand for all are spread over
// all directions none the less, and are the same points whatever the numbering.
TEST(OrderedRings, OfVeryManyTrianglesSomeNeighborsStandForAll)
{
  const int count = 1000;
  Mesh fan;
  fan.AddPoint(Vector3d::Zero());
  for (int i = 0; i < count; ++i)
  {
    const double part = static_cast<double>(i) / count;
    const double angle = 2.0 * std::acos(-1.0) * part * part;
    fan.AddPoint(Vector3d(std::cos(angle), std::sin(angle), 0.0));
  }
  for (int i = 0; i < count; ++i)
  {
    fan.AddTriangle(0, 1 + i, 1 + (i + 1) % count);
  }
  std::set<std::array<double, 2>> expected;
  for (const std::uint64_t seed : { 0, 1, 2 })
  {
    std::vector<std::int32_t> newToOld(fan.PointCount(), 0);
    const MeshedSurface surface(seed == 0 ? fan : Permute(fan, seed, &newToOld));
    const OrderedRings rings = RingsOf(surface.Triangles());
    const Id center = seed == 0
      ? 0
      : static_cast<Id>(std::find(newToOld.begin(), newToOld.end(), 0) - newToOld.begin());
    EXPECT_FALSE(rings.IsRegular(center));
    EXPECT_FALSE(rings.OnBorder(center));
    std::set<std::array<double, 2>> found;
    std::set<double> angles;
    for (const Id p : rings.Around(center))
    {
      const Vector3d at = surface.Triangles().Point(p);
      found.insert({ at.x(), at.y() });
      angles.insert(std::atan2(at.y(), at.x()));
    }
    EXPECT_EQ(found.size(), static_cast<std::size_t>(OrderedRings::NeighborsOfLargeFan));
    for (auto angle = angles.begin(); std::next(angle) != angles.end(); ++angle)
    {
      // Of 16, each the farthest from those before, neighbours are less than an eighth apart.
      EXPECT_LT(*std::next(angle) - *angle, 2.0 * std::acos(-1.0) / 8.0 + 0.01);
    }
    expected = seed == 0 ? found : expected;
    EXPECT_EQ(found, expected);

    RingNeighborhood neighborhood(surface.Triangles(), rings);
    NeighborhoodRule rule;
    rule.minimumNumberOfPoints = 10;
    EXPECT_EQ(neighborhood.Gather(center, rule).size(), 1 + OrderedRings::NeighborsOfLargeFan);
  }
}
