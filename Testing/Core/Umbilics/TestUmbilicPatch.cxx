// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// Patches are disks, whatever the mesh: counted, so no tolerance.

#include "Fixtures/TestFields.h"

#include "Umbilics/UmbilicPatch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace
{

using namespace ridges;
using namespace ridges::testing;
using Eigen::Vector3d;

// A disk: connected across edges, of Euler characteristic 1, with one simple cycle around it.
void CheckDisk(const TriangleMesh& mesh, Id start, Span<Id> patch, const UmbilicPatch& grown)
{
  const std::set<Id> triangles(patch.begin(), patch.end());
  ASSERT_EQ(patch[0], start);
  ASSERT_EQ(static_cast<Id>(triangles.size()), patch.size());
  std::set<Id> points;
  std::map<Id, int> edges;
  std::set<Id> reached = { start };
  std::vector<Id> front = { start };
  for (const Id t : triangles)
  {
    ASSERT_TRUE(grown.Contains(t));
    for (int i = 0; i < 3; ++i)
    {
      points.insert(mesh.Corners(t)[i]);
      ++edges[mesh.EdgeOf(t, i)];
    }
  }
  while (!front.empty())
  {
    const Id t = front.back();
    front.pop_back();
    for (int i = 0; i < 3; ++i)
    {
      const Id neighbor = mesh.Neighbor(t, i);
      if (neighbor >= 0 && triangles.count(neighbor) && reached.insert(neighbor).second)
      {
        front.push_back(neighbor);
      }
    }
  }
  ASSERT_EQ(reached, triangles);
  ASSERT_EQ(static_cast<int>(points.size()) - static_cast<int>(edges.size()) +
      static_cast<int>(triangles.size()),
    1);

  const std::vector<Id> contour = grown.Contour();
  const std::set<Id> distinct(contour.begin(), contour.end());
  ASSERT_EQ(distinct.size(), contour.size());
  std::set<std::pair<Id, Id>> sides;
  std::size_t outer = 0;
  for (const Id t : triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      sides.insert({ mesh.Corners(t)[i], mesh.Corners(t)[(i + 1) % 3] });
      outer += edges[mesh.EdgeOf(t, i)] == 1 ? 1 : 0;
    }
  }
  ASSERT_EQ(contour.size(), outer);
  for (std::size_t i = 0; i < contour.size(); ++i)
  {
    const Id next = contour[(i + 1) % contour.size()];
    ASSERT_TRUE(sides.count({ contour[i], next }));  // In the patch's own orientation,
    ASSERT_FALSE(sides.count({ next, contour[i] })); // with nothing of it on the other side.
  }
}

void CheckAllPatches(const Mesh& input, const std::vector<double>& sizes)
{
  const MeshedSurface surface(input);
  const TriangleMesh& mesh = surface.Triangles();
  UmbilicPatch patch(mesh);
  for (const double size : sizes)
  {
    for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
    {
      CheckDisk(mesh, t, patch.Grow(t, size), patch);
      if (::testing::Test::HasFatalFailure())
      {
        FAIL() << "triangle " << t << " size " << size;
      }
    }
  }
}

const std::vector<double> Sizes = { 1.0, 2.0, 3.0, 4.0, 5.0, 6.0 };

} // namespace

//------------------------------------------------------------------------------
TEST(UmbilicPatch, IsADiskOnClosedMeshes)
{
  CheckAllPatches(EllipsoidMesh(6, 1.0, 0.8, 0.6), Sizes);
  CheckAllPatches(Icosphere(1), Sizes); // Stops before the sphere closes.
}

//------------------------------------------------------------------------------
TEST(UmbilicPatch, IsADiskOnOpenMeshes)
{
  CheckAllPatches(CylinderPatch(1.0, 2.0, 1.0, 12, 9), Sizes);
  CheckAllPatches(GraphPatch([](double x, double y) { return x * y; }, 1.0, 10, 0.2), Sizes);
}

//------------------------------------------------------------------------------
TEST(UmbilicPatch, IsADiskOnATorusThatItCouldWrapAround)
{
  CheckAllPatches(TorusMesh(2.0, 0.7, 9, 4), Sizes);
  CheckAllPatches(TorusMesh(2.0, 1.5, 5, 3), Sizes);
}

//------------------------------------------------------------------------------
TEST(UmbilicPatch, IsADiskOnNoisyMeshes)
{
  CheckAllPatches(AddNormalNoise(Icosphere(6), 0.1, 1), Sizes);
  CheckAllPatches(AddNormalNoise(Icosphere(6), 0.5, 2), Sizes);
  CheckAllPatches(AddNormalNoise(TorusMesh(2.0, 0.7, 15, 7), 0.3, 3), Sizes);
}

//------------------------------------------------------------------------------
TEST(UmbilicPatch, IsADiskWhereTrianglesDisagree)
{
  // Every seventh triangle reversed, and a fin of triangles on non-manifold edges.
  Mesh mesh = Icosphere(5);
  for (std::size_t t = 0; t < mesh.TriangleCount(); t += 7)
  {
    std::swap(mesh.triangles[3 * t], mesh.triangles[3 * t + 1]);
  }
  for (std::size_t t = 0; t < 30; ++t)
  {
    const auto p = static_cast<std::int32_t>(mesh.PointCount());
    mesh.AddPoint(1.2 * mesh.Point(mesh.triangles[3 * t]));
    mesh.AddTriangle(mesh.triangles[3 * t], mesh.triangles[3 * t + 1], p);
  }
  CheckAllPatches(mesh, Sizes);
}

//------------------------------------------------------------------------------
TEST(UmbilicPatch, OfSizeOneContainsTheOneRingOfARegularMesh)
{
  // On a sphere's even mesh the threshold, the farthest centroid of the one-ring, lets all of it
  // in.
  const MeshedSurface surface(Icosphere(8));
  const TriangleMesh& mesh = surface.Triangles();
  UmbilicPatch patch(mesh);
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    double farthest = 0.0;
    std::set<Id> ring;
    for (const Id corner : mesh.Corners(t))
    {
      for (const Id s : mesh.TrianglesAround(corner))
      {
        ring.insert(s);
        farthest = std::max(farthest, (mesh.Centroid(s) - mesh.Centroid(t)).norm());
      }
    }
    const Span<Id> grown = patch.Grow(t, 1.0);
    const std::set<Id> found(grown.begin(), grown.end());
    ASSERT_TRUE(std::includes(found.begin(), found.end(), ring.begin(), ring.end())) << t;
    for (const Id s : found)
    {
      ASSERT_LE(
        (mesh.Centroid(s) - mesh.Centroid(t)).norm(), farthest * (1.0 + 1e-14)); // Round-off.
    }
  }
}

//------------------------------------------------------------------------------
TEST(UmbilicPatch, GrowsByDistanceAndWithItsSize)
{
  const MeshedSurface surface(EllipsoidMesh(12, 1.0, 0.8, 0.6));
  const TriangleMesh& mesh = surface.Triangles();
  UmbilicPatch patch(mesh);
  for (Id t = 0; t < mesh.NumberOfTriangles(); t += 11)
  {
    std::set<Id> previous;
    for (const double size : Sizes)
    {
      const Span<Id> grown = patch.Grow(t, size);
      const std::set<Id> found(grown.begin(), grown.end());
      ASSERT_TRUE(std::includes(found.begin(), found.end(), previous.begin(), previous.end()));
      ASSERT_GT(found.size(), previous.size());
      previous = found;
    }
  }
}

//------------------------------------------------------------------------------
TEST(UmbilicPatch, OfALoneTriangleIsThatTriangle)
{
  Mesh mesh;
  mesh.AddPoint(Vector3d(0, 0, 0));
  mesh.AddPoint(Vector3d(1, 0, 0));
  mesh.AddPoint(Vector3d(0, 1, 0));
  mesh.AddTriangle(0, 1, 2);
  const MeshedSurface surface(mesh);
  UmbilicPatch patch(surface.Triangles());
  EXPECT_EQ(patch.Grow(0, 6.0).size(), 1);
  EXPECT_EQ(patch.Contour().size(), 3u);
}
