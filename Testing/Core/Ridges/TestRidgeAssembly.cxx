// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// Ridges put together: on noise what holds of any data, on the ellipsoid the known ridges.

#include "Fixtures/EllipsoidFixture.h"

#include "Monge/AcuteRule.h"
#include "Ridges/RidgeAssembly.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <map>
#include <random>

namespace
{

using namespace ridges;
using namespace ridges::testing;
using Eigen::Vector3d;

// Two sheets and a third in one line of non-manifold edges, n cells long.
Mesh ThreeSheets(int n)
{
  Mesh mesh;
  const Vector3d ways[3] = { Vector3d(1, 0, 0), Vector3d(-1, 0.1, 0), Vector3d(0, 0.2, 1) };
  for (int j = 0; j <= n; ++j)
  {
    mesh.AddPoint(Vector3d(0, j, 0));
  }
  for (int sheet = 0; sheet < 3; ++sheet)
  {
    const auto id = [&](int i, int j)
    { return i == 0 ? j : (n + 1) * (1 + sheet * n + i - 1) + j; };
    for (int i = 1; i <= n; ++i)
    {
      for (int j = 0; j <= n; ++j)
      {
        mesh.AddPoint(i * ways[sheet] + Vector3d(0, j, 0));
      }
    }
    for (int i = 0; i < n; ++i)
    {
      for (int j = 0; j < n; ++j)
      {
        mesh.AddTriangle(id(i, j), id(i + 1, j), id(i + 1, j + 1));
        mesh.AddTriangle(id(i, j), id(i + 1, j + 1), id(i, j + 1));
      }
    }
  }
  return mesh;
}

bool EndsIn(const RidgeSegment& segment, Id node)
{
  return Ridge::IsUmbilic(node)
    ? segment.edge1 == RidgeSegment::ToUmbilic && segment.triangle == Ridge::TriangleOfUmbilic(node)
    : segment.edge0 == node || segment.edge1 == node;
}

struct Tally
{
  int loops = 0;
  int atUmbilic = 0;
  int onBorder = 0;
  int onNonManifold = 0;
};

void CheckRidges(const TriangleMesh& mesh, const MongeField& field,
  const std::vector<RidgeSegment>& segments, const std::vector<Ridge>& ridges, Tally& tally)
{
  std::vector<int> used(segments.size(), 0);
  for (const Ridge& ridge : ridges)
  {
    ASSERT_FALSE(ridge.segments.empty());
    ASSERT_EQ(ridge.nodes.size(), ridge.segments.size() + 1);
    for (std::size_t i = 0; i < ridge.segments.size(); ++i)
    {
      ++used[ridge.segments[i]];
      const RidgeSegment& segment = segments[ridge.segments[i]];
      ASSERT_TRUE(EndsIn(segment, ridge.nodes[i]) && EndsIn(segment, ridge.nodes[i + 1]));
      ASSERT_NE(ridge.nodes[i], ridge.nodes[i + 1]);
      if (i > 0)
      {
        ASSERT_FALSE(Ridge::IsUmbilic(ridge.nodes[i]));
        ASSERT_GE(mesh.EdgeAt(ridge.nodes[i]).t1, 0);
      }
    }
    if (ridge.closed)
    {
      ++tally.loops;
      ASSERT_EQ(ridge.nodes.front(), ridge.nodes.back());
      ASSERT_FALSE(Ridge::IsUmbilic(ridge.nodes.front()));
      continue;
    }
    for (const Id end : { ridge.nodes.front(), ridge.nodes.back() })
    {
      if (Ridge::IsUmbilic(end))
      {
        ++tally.atUmbilic;
        ASSERT_FALSE(IsRegular(mesh, field, Ridge::TriangleOfUmbilic(end)));
      }
      else
      {
        ASSERT_LT(mesh.EdgeAt(end).t1, 0);
        ++(mesh.EdgeAt(end).t1 == TriangleMesh::Border ? tally.onBorder : tally.onNonManifold);
      }
    }
  }
  for (const int times : used)
  {
    ASSERT_EQ(times, 1);
  }
}

// The ridges of the ellipsoid by type, with their distances to the coordinate planes.
struct EllipsoidCount
{
  std::map<RidgeType, int> loops;
  std::map<RidgeType, int> open;
  std::map<RidgeType, double> offPlane;
  double mean = 0.0;
  double largest = 0.0;
};

EllipsoidCount ExtractEllipsoid(int frequency)
{
  const FittedEllipsoid& ellipsoid = FittedEllipsoid::OfFrequency(frequency);
  const MongeField field = ellipsoid.field.View();
  // Fig. 2, by the coordinate that vanishes: k1, the flattest, is greatest in the plane across the
  // longest axis, k2 is least in that across the shortest; umbilics lie in the third plane.
  const std::map<RidgeType, int> planes = { { RidgeType::MaximumElliptic, 0 },
    { RidgeType::MinimumElliptic, 2 }, { RidgeType::MaximumHyperbolic, 1 },
    { RidgeType::MinimumHyperbolic, 1 } };
  EllipsoidCount count;
  int points = 0;
  for (const Color color : { Color::Blue, Color::Red })
  {
    const auto segments = MarchMesh(ellipsoid.Triangles(), field, color, TypeRule::FourthOrder);
    for (const Ridge& ridge : AssembleMesh(ellipsoid.Triangles(), field, color, segments))
    {
      // By its middle: a run near an umbilic with a wrong sign of P does not make another ridge.
      const RidgeType type = segments[ridge.segments[ridge.segments.size() / 2]].type;
      if (ridge.closed)
      {
        for (const Id segment : ridge.segments)
        {
          EXPECT_EQ(segments[segment].type, type);
        }
      }
      else
      {
        // Blue arcs go around the tips of the longest axis, red ones around those of the shortest.
        const RidgePoint middle = RidgePointOnEdge(ellipsoid.Triangles(), field, color,
          CrossingRule::Form, ridge.nodes[ridge.nodes.size() / 2]);
        const int axis = color == Color::Blue ? 0 : 2;
        EXPECT_GT(std::abs(middle.position[axis]), 0.95 * EllipsoidAxes[axis]);
      }
      ++(ridge.closed ? count.loops : count.open)[type];
      for (const RidgePoint& point : PointsOf(ellipsoid.Triangles(), field, color, ridge))
      {
        const double distance = std::abs(point.position[planes.at(type)]) / ellipsoid.meanEdge;
        count.offPlane[type] = std::max(count.offPlane[type], distance);
        count.largest = std::max(count.largest, distance);
        count.mean += distance;
        ++points;
      }
    }
  }
  count.mean /= points;
  std::cout << "ellipsoid, frequency " << frequency << ": ridges off their planes by mean "
            << count.mean << ", max " << count.largest << " mean edges\n";
  return count;
}

} // namespace

//------------------------------------------------------------------------------
TEST(RidgeAssembly, UsesEverySegmentOnceAndEndsOnlyWhereItMay)
{
  const std::vector<Mesh> meshes = { Icosphere(6), TorusMesh(2.0, 0.7, 21, 11),
    CylinderPatch(1.0, 2.0, 1.0, 13, 9), ThreeSheets(9), Icosphere(1) };
  Tally tally;
  for (const Mesh& mesh : meshes)
  {
    const MeshedSurface surface(mesh);
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
    {
      FieldArrays arrays = RandomField(surface.Triangles(), seed, 4);
      if (seed > 3)
      {
        // One direction everywhere: no umbilics, so many loops.
        for (std::size_t i = 0; i < arrays.d1.size(); ++i)
        {
          arrays.d1[i] = i % 3 == 0 ? 1.0 : 0.0;
        }
      }
      for (const Color color : { Color::Blue, Color::Red })
      {
        const auto segments =
          MarchMesh(surface.Triangles(), arrays.View(), color, TypeRule::FourthOrder);
        const auto ridges = AssembleMesh(surface.Triangles(), arrays.View(), color, segments);
        CheckRidges(surface.Triangles(), arrays.View(), segments, ridges, tally);
      }
    }
  }
  EXPECT_GT(tally.loops, 50);
  EXPECT_GT(tally.atUmbilic, 50);
  EXPECT_GT(tally.onBorder, 50);
  EXPECT_GT(tally.onNonManifold, 10);
}

//------------------------------------------------------------------------------
TEST(RidgeAssembly, OfNoSegmentsIsEmpty)
{
  const MeshedSurface surface(Icosphere(2));
  const FieldArrays arrays = RandomField(surface.Triangles(), 1, 4);
  EXPECT_TRUE(AssembleMesh(surface.Triangles(), arrays.View(), Color::Blue, {}).empty());
}

//------------------------------------------------------------------------------
TEST(RidgeAssembly, FindsTheRidgesOfTheEllipsoid)
{
  const EllipsoidCount at10k = ExtractEllipsoid(32);
  const EllipsoidCount at40k = ExtractEllipsoid(63);
  for (const EllipsoidCount& count : { at10k, at40k })
  {
    EXPECT_EQ(count.loops,
      (std::map<RidgeType, int>{
        { RidgeType::MaximumElliptic, 1 }, { RidgeType::MinimumElliptic, 1 } }));
    EXPECT_EQ(count.open,
      (std::map<RidgeType, int>{
        { RidgeType::MaximumHyperbolic, 2 }, { RidgeType::MinimumHyperbolic, 2 } }));
    // Where b is interpolated linearly between points within an edge of the plane, the error is a
    // fraction of an edge; it is greatest next to umbilics, where b turns with the frame.
    EXPECT_LT(count.mean, 0.1);
    EXPECT_LT(count.largest, 0.7);
  }
  EXPECT_LE(at40k.mean, at10k.mean);
  EXPECT_LE(at40k.largest, at10k.largest);
}
