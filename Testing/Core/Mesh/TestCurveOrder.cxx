// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/CurveOrder.h"

#include "Fixtures/TestFields.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <random>

namespace
{

using namespace ridges;
using namespace ridges::testing;

// Numbers points at random.
Mesh Shuffled(const Mesh& mesh)
{
  std::vector<Id> newId(mesh.PointCount());
  std::iota(newId.begin(), newId.end(), 0);
  std::shuffle(newId.begin(), newId.end(), std::mt19937_64(7));
  Mesh shuffled = mesh;
  for (std::size_t p = 0; p < mesh.PointCount(); ++p)
  {
    shuffled.SetPoint(newId[p], mesh.Point(p));
  }
  std::transform(mesh.triangles.begin(), mesh.triangles.end(), shuffled.triangles.begin(),
    [&newId](Id p) { return newId[p]; });
  return shuffled;
}

} // namespace

TEST(CurveOrder, HasEachPointOnceAndNeighborsNearEachOther)
{
  const MeshedSurface surface(Shuffled(Icosphere(32)));
  const TriangleMesh& mesh = surface.Triangles();
  const std::vector<Id> points = PointsAlongCurve(mesh);
  ASSERT_EQ(static_cast<Id>(points.size()), mesh.NumberOfPoints());
  std::vector<Id> places(points.size(), -1);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    ASSERT_EQ(places[points[i]], -1);
    places[points[i]] = static_cast<Id>(i);
  }
  // Of the 10,242 points half of all neighbours are within 50 places; numbered at random, 1 %.
  Id near = 0;
  for (Id e = 0; e < mesh.NumberOfEdges(); ++e)
  {
    const Edge& edge = mesh.EdgeAt(e);
    near += std::abs(places[edge.v0] - places[edge.v1]) <= 50 ? 1 : 0;
  }
  EXPECT_GT(near, mesh.NumberOfEdges() / 2);
}

TEST(CurveOrder, TakesPointsOfNoTriangleAnywhere)
{
  Mesh mesh = Icosphere(1);
  mesh.points.insert(
    mesh.points.end(), { 1e300, -1e300, std::numeric_limits<double>::quiet_NaN() });
  const MeshedSurface surface(mesh);
  std::vector<Id> points = PointsAlongCurve(surface.Triangles());
  std::sort(points.begin(), points.end());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_EQ(points[i], static_cast<Id>(i));
  }
}
