// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The meshes that the other tests rely on.

#include "TestMeshes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace
{

using namespace ridges::testing;
using Eigen::Vector3d;

const double Pi = 3.14159265358979323846;

//------------------------------------------------------------------------------
// The greatest distance of a point to the surface, to first order.
double Distance(const Mesh& mesh, const AnalyticSurface& surface)
{
  double worst = 0.0;
  for (std::size_t i = 0; i < mesh.PointCount(); ++i)
  {
    const Vector3d p = mesh.Point(i);
    worst = std::max(worst, std::abs(surface.Value(p)) / surface.Gradient(p).norm());
  }
  return worst;
}

//------------------------------------------------------------------------------
// The least cosine between normals of the mesh and of the surface: outward if positive.
double LeastNormalCosine(const Mesh& mesh, const AnalyticSurface& surface)
{
  const std::vector<Vector3d> normals = PointNormals(mesh);
  double least = 1.0;
  for (std::size_t i = 0; i < mesh.PointCount(); ++i)
  {
    least = std::min(least, normals[i].dot(surface.Gradient(mesh.Point(i)).normalized()));
  }
  return least;
}

//------------------------------------------------------------------------------
void ExpectOnSurface(const Mesh& mesh, const AnalyticSurface& surface, int euler, int borderEdges)
{
  const MeshTopology topology = Topology(mesh);
  EXPECT_TRUE(topology.oriented);
  EXPECT_EQ(topology.borderEdges, borderEdges);
  EXPECT_EQ(topology.EulerCharacteristic(), euler);
  EXPECT_EQ(topology.points, static_cast<int>(mesh.PointCount()));
  EXPECT_LT(Distance(mesh, surface), 1e-14); // round-off of sizes up to 2
  EXPECT_GT(LeastNormalCosine(mesh, surface), 0.8);
}

} // namespace

//------------------------------------------------------------------------------
TEST(TestMeshes, IcosphereIsClosedAndOffTheCoordinatePlanes)
{
  for (const int frequency : { 1, 2, 7, 20, 60 })
  {
    const Mesh mesh = Icosphere(frequency);
    EXPECT_EQ(mesh.PointCount(), 10u * frequency * frequency + 2u);
    EXPECT_EQ(mesh.TriangleCount(), 20u * frequency * frequency);
    EXPECT_EQ(EulerCharacteristic(mesh), 2);
    EXPECT_GT(SignedVolume(mesh), 2.5); // 4.19 in the limit, 2.54 for the icosahedron
    double closest = 1.0;
    for (const double coordinate : mesh.points)
    {
      closest = std::min(closest, std::abs(coordinate));
    }
    EXPECT_GT(closest, 1e-7);
  }
}

//------------------------------------------------------------------------------
TEST(TestMeshes, BuildersGiveOutwardMeshesOnTheirSurfaces)
{
  ExpectOnSurface(EllipsoidMesh(12, 1.0, 0.8, 0.6), MakeEllipsoid(1.0, 0.8, 0.6), 2, 0);
  ExpectOnSurface(StarShapedMesh(25, MakeBlend(), BlendCenter()), MakeBlend(), 2, 0);
  for (std::uint64_t seed = 1; seed <= 8; ++seed)
  {
    const AnalyticSurface surface = MakePerturbedSphere(0.1, seed);
    ExpectOnSurface(StarShapedMesh(12, surface, Vector3d::Zero()), surface, 2, 0);
  }
  ExpectOnSurface(TorusMesh(1.0, 0.4, 40, 20), MakeTorus(1.0, 0.4), 0, 0);
  ExpectOnSurface(CylinderPatch(1.0, 2.0, 1.5, 12, 8), MakeCylinder(1.0), 1, 40);
  ExpectOnSurface(
    ClosedMesh(MakeDoubleTorus(), DoubleTorusHalfSize(), 45), MakeDoubleTorus(), -2, 0);
  ExpectOnSurface(ClosedMesh(MakeBlend(), { 0.5, 0.5, 0.5 }, 30), MakeBlend(), 2, 0);
  const AnalyticSurface saddle([](auto x, auto y, auto z) { return z - x * y; });
  for (const double jitter : { 0.0, 0.24 })
  {
    const Mesh patch = GraphPatch([](double x, double y) { return x * y; }, 1.0, 15, jitter);
    ExpectOnSurface(patch, saddle, 1, 60);
    EXPECT_GT(SmallestAngle(patch), 0.2);
  }
}

//------------------------------------------------------------------------------
TEST(TestMeshes, ClosedMeshRefusesWhatItCannotMesh)
{
  EXPECT_THROW(ClosedMesh(MakeDoubleTorus(), DoubleTorusHalfSize(), 15), std::runtime_error);
  EXPECT_THROW(ClosedMesh(MakeCylinder(0.5), { 1.0, 1.0, 1.0 }, 10), std::runtime_error);
}

//------------------------------------------------------------------------------
TEST(TestMeshes, PermuteRenumbersTheSameMesh)
{
  const Mesh mesh = EllipsoidMesh(6, 1.0, 0.8, 0.6);
  std::vector<std::int32_t> newToOld;
  const Mesh permuted = Permute(mesh, 3, &newToOld);
  EXPECT_NE(permuted.points, mesh.points);
  ASSERT_EQ(permuted.TriangleCount(), mesh.TriangleCount());

  // Each triangle from its smallest old number on, sorted.
  const auto canonical = [](const Mesh& m, const std::vector<std::int32_t>& number)
  {
    std::vector<std::array<std::int32_t, 3>> triangles;
    for (std::size_t i = 0; i < m.TriangleCount(); ++i)
    {
      std::array<std::int32_t, 3> t;
      for (int j = 0; j < 3; ++j)
      {
        t[j] = number[m.triangles[3 * i + j]];
      }
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      triangles.push_back(t);
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
  };
  std::vector<std::int32_t> identity(mesh.PointCount());
  std::iota(identity.begin(), identity.end(), 0);
  EXPECT_EQ(canonical(permuted, newToOld), canonical(mesh, identity));
  for (std::size_t i = 0; i < mesh.PointCount(); ++i)
  {
    EXPECT_EQ(permuted.Point(i), mesh.Point(newToOld[i]));
  }
  EXPECT_EQ(Permute(mesh, 3).triangles, permuted.triangles);
  EXPECT_NE(Permute(mesh, 4).triangles, permuted.triangles);
}

//------------------------------------------------------------------------------
TEST(TestMeshes, TransformScalesAndStaysOutward)
{
  const Mesh mesh = EllipsoidMesh(6, 1.0, 0.8, 0.6);
  EXPECT_NEAR(GenericRotation().determinant(), 1.0, 1e-14);
  for (const double side : { 1.0, -1.0 })
  {
    const Mesh moved = Transform(mesh, side * GenericRotation(), Vector3d(5, -3, 2), 10.0);
    EXPECT_NEAR(SignedVolume(moved) / SignedVolume(mesh), 1000.0, 1e-9);
    EXPECT_NEAR(MeanEdgeLength(moved) / MeanEdgeLength(mesh), 10.0, 1e-12);
  }
  EXPECT_NEAR(SignedVolume(Flip(mesh)), -SignedVolume(mesh), 1e-14);
}

//------------------------------------------------------------------------------
TEST(TestMeshes, NoiseHasTheGivenDeviation)
{
  const Mesh mesh = Icosphere(30);
  const Mesh noisy = AddNormalNoise(mesh, 0.01, 5);
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < mesh.PointCount(); ++i)
  {
    const double height = noisy.Point(i).norm() - 1.0;
    sum += height;
    squares += height * height;
  }
  const double count = static_cast<double>(mesh.PointCount());
  EXPECT_NEAR(sum / count, 0.0, 0.01 * 4 / std::sqrt(count)); // 4 standard errors
  EXPECT_NEAR(std::sqrt(squares / count) / 0.01, 1.0, 4 / std::sqrt(2 * count));
}

//------------------------------------------------------------------------------
TEST(TestMeshes, RelaxImprovesAnglesOnTheSurface)
{
  const AnalyticSurface surface = MakeDoubleTorus();
  const Mesh mesh = ClosedMesh(surface, DoubleTorusHalfSize(), 60);
  const Mesh relaxed = Relax(mesh, surface, 10);
  ExpectOnSurface(relaxed, surface, -2, 0);
  EXPECT_GT(SmallestAngle(mesh), 15 * Pi / 180);
  EXPECT_GT(SmallestAngle(relaxed), 25 * Pi / 180);

  // The border stays.
  const Mesh patch = CylinderPatch(1.0, 2.0, 1.5, 12, 8);
  const Mesh relaxedPatch = Relax(patch, MakeCylinder(1.0), 5);
  ExpectOnSurface(relaxedPatch, MakeCylinder(1.0), 1, 40);
  for (std::size_t i = 0; i < 13; ++i)
  {
    EXPECT_EQ(relaxedPatch.Point(i), patch.Point(i));
  }
}
