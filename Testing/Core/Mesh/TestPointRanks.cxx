// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The order of points at one place.

#include "Fixtures/TestFields.h"

#include "Mesh/PositionOrder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace ridges;
using namespace ridges::testing;

namespace
{

Mesh Rounded(Mesh mesh, double grain)
{
  for (double& x : mesh.points)
  {
    x = grain * std::round(x / grain);
  }
  return mesh;
}

std::set<std::uint64_t> RanksOf(const TriangleMesh& mesh)
{
  std::set<std::uint64_t> ranks;
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    ranks.insert(mesh.RankAtPlace(p));
  }
  return ranks;
}

} // namespace

TEST(PointRanks, AreZeroForPointsAlone)
{
  const MeshedSurface surface(Icosphere(4));
  EXPECT_EQ(RanksOf(surface.Triangles()), std::set<std::uint64_t>{ 0 });
}

TEST(PointRanks, DistinguishPointsThatRoundingJoined)
{
  const auto mesh = Rounded(EllipsoidMesh(8, 1.0, 0.8, 0.6, false), 0.2);
  const MeshedSurface surface(mesh);
  const TriangleMesh& triangles = surface.Triangles();
  int joined = 0;
  for (Id p = 0; p < triangles.NumberOfPoints(); ++p)
  {
    for (Id q = 0; q < p; ++q)
    {
      EXPECT_NE(PointComesBefore(triangles, p, q), PointComesBefore(triangles, q, p));
      joined += triangles.Point(p) == triangles.Point(q) ? 1 : 0;
    }
  }
  EXPECT_GT(joined, 100);
}

TEST(PointRanks, DoNotDependOnTheNumbering)
{
  const auto mesh = Rounded(EllipsoidMesh(8, 1.0, 0.8, 0.6, false), 0.2);
  const MeshedSurface surface(mesh);
  const TriangleMesh& triangles = surface.Triangles();
  std::vector<std::int32_t> oldNames;
  const auto other = Permute(mesh, 3, &oldNames);
  const MeshedSurface otherSurface(other);
  const TriangleMesh& permuted = otherSurface.Triangles();
  for (Id p = 0; p < permuted.NumberOfPoints(); ++p)
  {
    ASSERT_EQ(permuted.RankAtPlace(p), triangles.RankAtPlace(oldNames[p]));
  }
}

// To exchange the two spheres changes nothing, so that nothing can tell their points apart.
TEST(PointRanks, AreEqualForPointsThatAreAlike)
{
  auto mesh = Icosphere(2);
  const auto count = static_cast<std::int32_t>(mesh.PointCount());
  const std::vector<std::int32_t> corners = mesh.triangles;
  for (std::int32_t p = 0; p < count; ++p)
  {
    mesh.AddPoint(mesh.Point(p));
  }
  for (const std::int32_t corner : corners)
  {
    mesh.triangles.push_back(count + corner);
  }
  const MeshedSurface surface(mesh);
  const TriangleMesh& triangles = surface.Triangles();
  for (Id p = 0; p < count; ++p)
  {
    EXPECT_NE(triangles.RankAtPlace(p), 0U);
    EXPECT_EQ(triangles.RankAtPlace(p), triangles.RankAtPlace(p + count));
  }
}
