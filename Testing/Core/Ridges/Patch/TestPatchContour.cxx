// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// The contour of any connected triangles is one closed walk. Counted: no tolerance.

#include "Fixtures/TriangleSets.h"

#include "Ridges/Patch/PatchContour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace
{

using namespace ridges;
using namespace ridges::testing;

// One closed walk that has each unglued side of each triangle once. The spokes at the end of a side
// are the glued edges there, by which one comes to the next side.
void CheckWalk(
  const TriangleMesh& mesh, const PatchContour& contour, const std::vector<Id>& triangles)
{
  std::multiset<std::pair<Id, Id>> unglued;
  for (const Id t : triangles)
  {
    ASSERT_TRUE(contour.Contains(t));
    for (int side = 0; side < 3; ++side)
    {
      const Id edge = mesh.EdgeOf(t, side);
      const Id across = contour.Across(t, edge);
      if (across < 0)
      {
        unglued.insert({ t, edge });
      }
      else
      {
        ASSERT_TRUE(contour.Contains(across));
        ASSERT_EQ(contour.Across(across, edge), t);
      }
    }
  }
  std::multiset<std::pair<Id, Id>> walked;
  const auto& sides = contour.Sides();
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    const PatchContour::Side& side = sides[i];
    const PatchContour::Side& next = sides[(i + 1) % sides.size()];
    walked.insert({ side.triangle, side.edge });
    const Edge& edge = mesh.EdgeAt(side.edge);
    const Edge& nextEdge = mesh.EdgeAt(next.edge);
    ASSERT_TRUE(edge.v0 == side.end || edge.v1 == side.end);
    ASSERT_TRUE(nextEdge.v0 == side.end || nextEdge.v1 == side.end);
    Id triangle = side.triangle;
    for (const Id spoke : side.spokes)
    {
      ASSERT_TRUE(mesh.EdgeAt(spoke).v0 == side.end || mesh.EdgeAt(spoke).v1 == side.end);
      triangle = contour.Across(triangle, spoke);
      ASSERT_GE(triangle, 0);
    }
    ASSERT_EQ(triangle, next.triangle);
  }
  ASSERT_EQ(walked, unglued);
}

std::size_t NumberOfGluedEdges(
  const TriangleMesh& mesh, const PatchContour& contour, const std::vector<Id>& triangles)
{
  std::size_t count = 0;
  for (const Id t : triangles)
  {
    for (int side = 0; side < 3; ++side)
    {
      count += contour.Across(t, mesh.EdgeOf(t, side)) >= 0 ? 1 : 0;
    }
  }
  return count / 2;
}

// Triangles whose centroid is in a shell around a place.
std::vector<Id> Shell(
  const TriangleMesh& mesh, const Eigen::Vector3d& center, double inner, double outer)
{
  std::vector<Id> triangles;
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const double distance = (mesh.Centroid(t) - center).norm();
    if (distance >= inner && distance <= outer)
    {
      triangles.push_back(t);
    }
  }
  return triangles;
}

std::vector<Id> All(const TriangleMesh& mesh)
{
  std::vector<Id> triangles(mesh.NumberOfTriangles());
  std::iota(triangles.begin(), triangles.end(), 0);
  return triangles;
}

void CheckCutIntoTree(const TriangleMesh& mesh, const std::vector<Id>& triangles)
{
  const PatchContour contour(mesh, triangles);
  ASSERT_NO_FATAL_FAILURE(CheckWalk(mesh, contour, triangles));
  EXPECT_EQ(NumberOfGluedEdges(mesh, contour, triangles), triangles.size() - 1);
  EXPECT_EQ(contour.Sides().size(), triangles.size() + 2); // As of any polygon's triangulation.
}

} // namespace

//------------------------------------------------------------------------------
TEST(PatchContour, OfADiskIsItsBorder)
{
  const MeshedSurface surface(Icosphere(8));
  const TriangleMesh& mesh = surface.Triangles();
  for (const double radius : { 0.0, 0.2, 0.5, 1.0, 1.7, 1.95 })
  {
    const auto triangles = Shell(mesh, mesh.Centroid(100), 0.0, radius);
    ASSERT_EQ(EulerCharacteristicOf(mesh, triangles), 1);
    const PatchContour contour(mesh, triangles);
    ASSERT_NO_FATAL_FAILURE(CheckWalk(mesh, contour, triangles));
    std::multiset<Id> edges;
    for (const PatchContour::Side& side : contour.Sides())
    {
      edges.insert(side.edge);
    }
    const auto expected = ContourEdges(mesh, triangles);
    EXPECT_EQ(edges, std::multiset<Id>(expected.begin(), expected.end()));
  }
}

//------------------------------------------------------------------------------
TEST(PatchContour, OfALoneTriangleHasThreeSidesWithoutSpokes)
{
  const MeshedSurface surface(Icosphere(2));
  const PatchContour contour(surface.Triangles(), { 17 });
  ASSERT_EQ(contour.Sides().size(), 3u);
  for (const PatchContour::Side& side : contour.Sides())
  {
    EXPECT_EQ(side.triangle, 17);
    EXPECT_TRUE(side.spokes.empty());
  }
  EXPECT_TRUE(PatchContour(surface.Triangles(), {}).Sides().empty());
}

//------------------------------------------------------------------------------
TEST(PatchContour, OfAnOpenMeshGoesAlongItsBorder)
{
  const MeshedSurface surface(GraphPatch([](double x, double y) { return x * y; }, 1.0, 9, 0.2));
  const TriangleMesh& mesh = surface.Triangles();
  const std::vector<Id> all = All(mesh);
  const PatchContour contour(mesh, all);
  ASSERT_NO_FATAL_FAILURE(CheckWalk(mesh, contour, all));
  EXPECT_EQ(contour.Sides().size(), 4u * 9u);
}

//------------------------------------------------------------------------------
TEST(PatchContour, CutsAnAnnulusATorusAndASphereIntoATree)
{
  const MeshedSurface sphere(Icosphere(8));
  CheckCutIntoTree(
    sphere.Triangles(), Shell(sphere.Triangles(), sphere.Triangles().Centroid(100), 0.5, 1.0));
  CheckCutIntoTree(sphere.Triangles(), All(sphere.Triangles()));
  const MeshedSurface tiny(Icosphere(1));
  CheckCutIntoTree(tiny.Triangles(), All(tiny.Triangles()));
  const MeshedSurface torus(TorusMesh(2.0, 0.7, 21, 11));
  CheckCutIntoTree(torus.Triangles(), All(torus.Triangles()));
}

//------------------------------------------------------------------------------
TEST(PatchContour, OfAnyConnectedTrianglesIsOneWalk)
{
  int disks = 0;
  int cut = 0;
  for (const Mesh& input : { Icosphere(6), TorusMesh(2.0, 0.7, 9, 4),
         CylinderPatch(1.0, 2.0, 1.0, 13, 9), FlipEdges(Icosphere(6), 1, 3) })
  {
    const MeshedSurface surface(input);
    const TriangleMesh& mesh = surface.Triangles();
    std::mt19937_64 generator(3);
    for (const std::size_t size : { 2, 5, 12, 30, 70, 200 })
    {
      for (int trial = 0; trial < 30; ++trial)
      {
        const std::vector<Id> triangles = RandomRegion(mesh, generator, size);
        const PatchContour contour(mesh, triangles);
        ASSERT_NO_FATAL_FAILURE(CheckWalk(mesh, contour, triangles));
        const bool isTree = NumberOfGluedEdges(mesh, contour, triangles) + 1 == triangles.size();
        const bool isDisk =
          EulerCharacteristicOf(mesh, triangles) == 1 && !ContourEdges(mesh, triangles).empty();
        // Disks stay whole, and whatever else has one contour, as a torus with a hole.
        const bool isWhole = contour.Sides().size() == ContourEdges(mesh, triangles).size();
        EXPECT_TRUE(isWhole || !isDisk);
        EXPECT_TRUE(isWhole || isTree);
        ++(isWhole ? disks : cut);
      }
    }
  }
  EXPECT_GT(disks, 50);
  EXPECT_GT(cut, 50);
}

//------------------------------------------------------------------------------
TEST(PatchContour, DoesNotDependOnTheOrderOfTheTriangles)
{
  const MeshedSurface surface(Icosphere(8));
  const TriangleMesh& mesh = surface.Triangles();
  std::vector<Id> triangles = Shell(mesh, mesh.Centroid(100), 0.0, 0.7);
  const PatchContour expected(mesh, triangles);
  std::reverse(triangles.begin(), triangles.end());
  const PatchContour contour(mesh, triangles);
  ASSERT_EQ(contour.Sides().size(), expected.Sides().size());
  for (std::size_t i = 0; i < contour.Sides().size(); ++i)
  {
    EXPECT_EQ(contour.Sides()[i].edge, expected.Sides()[i].edge);
    EXPECT_EQ(contour.Sides()[i].spokes, expected.Sides()[i].spokes);
  }
}
