// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// Adjacency of triangle meshes, by hand and by counting. All values are integers or exact.

#include "Fixtures/TestFields.h"

#include "Mesh/TriangleMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using namespace ridges;
using namespace ridges::testing;
using Eigen::Vector3d;

// A unit square, a point above its centre, and a point that no triangle uses.
const std::vector<double> SquarePoints = { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5, 0.5, 1, 9, 9,
  9 };

TriangleMesh SquareMesh(const std::vector<Triangle>& triangles)
{
  return TriangleMesh(SquarePoints.data(), 6, triangles);
}

std::vector<Id> ToVector(Span<Id> span)
{
  return { span.begin(), span.end() };
}

Id CountBorderEdges(const TriangleMesh& mesh)
{
  Id count = 0;
  for (Id e = 0; e < mesh.NumberOfEdges(); ++e)
  {
    count += mesh.EdgeAt(e).t1 == TriangleMesh::Border ? 1 : 0;
  }
  return count;
}

// What has to hold of the adjacency of any mesh.
void CheckAdjacency(const TriangleMesh& mesh)
{
  std::vector<int> sides(mesh.NumberOfEdges(), 0);
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Id a = mesh.Corners(t)[i];
      const Id b = mesh.Corners(t)[(i + 1) % 3];
      const Id e = mesh.EdgeOf(t, i);
      const Edge& edge = mesh.EdgeAt(e);
      ASSERT_EQ(edge.v0, std::min(a, b));
      ASSERT_EQ(edge.v1, std::max(a, b));
      ++sides[e];
      const Id neighbor = mesh.Neighbor(t, i);
      if (neighbor >= 0)
      {
        ASSERT_NE(neighbor, t);
        ASSERT_TRUE((edge.t0 == t && edge.t1 == neighbor) || (edge.t1 == t && edge.t0 == neighbor));
      }
      const std::vector<Id> around = ToVector(mesh.TrianglesAround(a));
      ASSERT_TRUE(std::binary_search(around.begin(), around.end(), t));
    }
  }
  for (Id e = 0; e < mesh.NumberOfEdges(); ++e)
  {
    const Edge& edge = mesh.EdgeAt(e);
    ASSERT_EQ(sides[e], edge.t1 == TriangleMesh::Border ? 1 : std::max(2, sides[e]));
    ASSERT_EQ(sides[e] > 2, edge.t1 == TriangleMesh::NonManifold);
    if (edge.t1 < 0)
    {
      ASSERT_TRUE(mesh.OnBorder(edge.v0) && mesh.OnBorder(edge.v1));
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
TEST(TriangleMesh, OfASquareIsAsByHand)
{
  const TriangleMesh mesh = SquareMesh({ { 0, 1, 2 }, { 2, 3, 0 } });
  EXPECT_EQ(mesh.NumberOfPoints(), 6);
  EXPECT_EQ(mesh.NumberOfTriangles(), 2);
  EXPECT_EQ(mesh.NumberOfEdges(), 5);
  EXPECT_EQ(CountBorderEdges(mesh), 4);
  EXPECT_EQ(ToVector(mesh.TrianglesAround(0)), (std::vector<Id>{ 0, 1 }));
  EXPECT_EQ(ToVector(mesh.TrianglesAround(1)), (std::vector<Id>{ 0 }));
  EXPECT_EQ(ToVector(mesh.TrianglesAround(4)), std::vector<Id>{});
  EXPECT_EQ(mesh.Neighbor(0, 0), TriangleMesh::Border);
  EXPECT_EQ(mesh.Neighbor(0, 1), TriangleMesh::Border);
  EXPECT_EQ(mesh.Neighbor(0, 2), 1);
  EXPECT_EQ(mesh.Neighbor(1, 2), 0);
  EXPECT_EQ(mesh.EdgeOf(0, 2), mesh.EdgeOf(1, 2));
  const Edge& diagonal = mesh.EdgeAt(mesh.EdgeOf(0, 2));
  EXPECT_EQ(diagonal.v0, 0);
  EXPECT_EQ(diagonal.v1, 2);
  for (Id p = 0; p < 6; ++p)
  {
    EXPECT_EQ(mesh.OnBorder(p), p < 4) << p; // Points 4 and 5 have no edge.
  }
  EXPECT_EQ(mesh.AreaNormal(0), Vector3d(0, 0, 1));
  EXPECT_EQ(mesh.PointNormal(0), Vector3d(0, 0, 2));
  EXPECT_EQ(mesh.PointNormal(5), Vector3d::Zero());
  EXPECT_LT((mesh.Centroid(0) - Vector3d(2.0 / 3.0, 1.0 / 3.0, 0)).norm(), 1e-15); // Round-off.
  EXPECT_EQ(mesh.NumberOfInconsistentEdges(), 0);
  EXPECT_EQ(mesh.NumberOfNonManifoldEdges(), 0);
  EXPECT_EQ(mesh.EulerCharacteristic(), 1);
  CheckAdjacency(mesh);
}

//------------------------------------------------------------------------------
TEST(TriangleMesh, SeparatesTrianglesAtANonManifoldEdge)
{
  const TriangleMesh mesh = SquareMesh({ { 0, 1, 2 }, { 2, 3, 0 }, { 0, 2, 4 } });
  EXPECT_EQ(mesh.NumberOfNonManifoldEdges(), 1);
  EXPECT_EQ(mesh.NumberOfEdges(), 7);
  EXPECT_EQ(mesh.Neighbor(0, 2), TriangleMesh::NonManifold);
  EXPECT_EQ(mesh.Neighbor(1, 2), TriangleMesh::NonManifold);
  EXPECT_EQ(mesh.Neighbor(2, 0), TriangleMesh::NonManifold);
  EXPECT_EQ(mesh.EdgeOf(0, 2), mesh.EdgeOf(2, 0));
  // Cut apart, as the edge separates them.
  EXPECT_EQ(mesh.EulerCharacteristic(), 3);
  CheckAdjacency(mesh);
}

//------------------------------------------------------------------------------
TEST(TriangleMesh, CountsEdgesBetweenOppositeOrientations)
{
  EXPECT_EQ(SquareMesh({ { 0, 1, 2 }, { 0, 2, 3 } }).NumberOfInconsistentEdges(), 0);
  EXPECT_EQ(SquareMesh({ { 0, 1, 2 }, { 0, 3, 2 } }).NumberOfInconsistentEdges(), 1);

  // Every second triangle of a closed mesh reversed: edges between one of them and another.
  Mesh sphere = Icosphere(3);
  for (std::size_t t = 0; t < sphere.TriangleCount(); t += 2)
  {
    std::swap(sphere.triangles[3 * t], sphere.triangles[3 * t + 1]);
  }
  const MeshedSurface surface(sphere);
  const TriangleMesh& mesh = surface.Triangles();
  Id expected = 0;
  for (Id e = 0; e < mesh.NumberOfEdges(); ++e)
  {
    expected += (mesh.EdgeAt(e).t0 + mesh.EdgeAt(e).t1) % 2 != 0 ? 1 : 0;
  }
  EXPECT_GT(expected, 0);
  EXPECT_EQ(mesh.NumberOfInconsistentEdges(), expected);
}

//------------------------------------------------------------------------------
TEST(TriangleMesh, HasTheEulerCharacteristicOfItsSurface)
{
  const auto characteristic = [](const Mesh& mesh)
  {
    const MeshedSurface surface(mesh);
    CheckAdjacency(surface.Triangles());
    EXPECT_EQ(surface.Triangles().NumberOfEdges(), Topology(mesh).edges);
    EXPECT_EQ(CountBorderEdges(surface.Triangles()), Topology(mesh).borderEdges);
    EXPECT_EQ(surface.Triangles().NumberOfInconsistentEdges(), 0);
    return surface.Triangles().EulerCharacteristic();
  };
  EXPECT_EQ(characteristic(Icosphere(1)), 2);
  EXPECT_EQ(characteristic(Icosphere(7)), 2);
  EXPECT_EQ(characteristic(TorusMesh(2.0, 0.7, 12, 7)), 0);
  EXPECT_EQ(characteristic(CylinderPatch(1.0, 2.0, 1.0, 5, 4)), 1);
  EXPECT_EQ(characteristic(ClosedMesh(MakeDoubleTorus(), DoubleTorusHalfSize(), 45)), -2);

  Mesh two = Icosphere(2);
  const auto offset = static_cast<std::int32_t>(two.PointCount());
  const Mesh torus = TorusMesh(2.0, 0.7, 9, 6);
  for (std::size_t i = 0; i < torus.PointCount(); ++i)
  {
    two.AddPoint(torus.Point(i) + Vector3d(5, 0, 0));
  }
  for (std::size_t t = 0; t < torus.TriangleCount(); ++t)
  {
    two.AddTriangle(torus.triangles[3 * t] + offset, torus.triangles[3 * t + 1] + offset,
      torus.triangles[3 * t + 2] + offset);
  }
  two.AddPoint(Vector3d(7, 7, 7)); // Points of no triangle are not part of the surface.
  EXPECT_EQ(characteristic(two), 2);
  EXPECT_EQ(characteristic(Mesh()), 0);
}

//------------------------------------------------------------------------------
TEST(TriangleMesh, OfAFanOfManyTrianglesIsComplete)
{
  Mesh fan;
  const std::int32_t count = 5000;
  fan.AddPoint(Vector3d::Zero());
  for (std::int32_t i = 0; i < count; ++i)
  {
    const double angle = 2.0 * std::acos(-1.0) * i / count;
    fan.AddPoint(Vector3d(std::cos(angle), std::sin(angle), 0.0));
  }
  for (std::int32_t i = 0; i < count; ++i)
  {
    fan.AddTriangle(0, 1 + i, 1 + (i + 1) % count);
  }
  const MeshedSurface surface(fan);
  const TriangleMesh& mesh = surface.Triangles();
  CheckAdjacency(mesh);
  EXPECT_EQ(mesh.TrianglesAround(0).size(), count);
  EXPECT_EQ(mesh.NumberOfEdges(), 2 * count);
  EXPECT_EQ(mesh.EulerCharacteristic(), 1);
  EXPECT_FALSE(mesh.OnBorder(0));
  EXPECT_TRUE(mesh.OnBorder(1));
}

//------------------------------------------------------------------------------
TEST(TriangleMesh, DoesNotDependOnTheNumbering)
{
  const Mesh mesh = CylinderPatch(1.0, 2.0, 1.0, 9, 8);
  std::vector<std::int32_t> newToOld;
  const MeshedSurface before(mesh);
  const MeshedSurface after(Permute(mesh, 5, &newToOld));
  CheckAdjacency(after.Triangles());
  EXPECT_EQ(after.Triangles().NumberOfEdges(), before.Triangles().NumberOfEdges());
  for (Id p = 0; p < after.Triangles().NumberOfPoints(); ++p)
  {
    EXPECT_EQ(after.Triangles().OnBorder(p), before.Triangles().OnBorder(newToOld[p]));
    EXPECT_EQ(after.Triangles().TrianglesAround(p).size(),
      before.Triangles().TrianglesAround(newToOld[p]).size());
  }
}
