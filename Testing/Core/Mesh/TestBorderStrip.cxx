// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The strip along the border of a mesh in which fits are one-sided.

#include "Mesh/BorderStrip.h"

#include "Fixtures/TestFields.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace ridges;
using namespace ridges::testing;

namespace
{

TEST(BorderStrip, IsAsWideAsTheRadius)
{
  // A square from -1 to 1, 20 cells wide, in which edges are 0.1 long along both axes.
  const MeshedSurface surface(GraphPatch([](double, double) { return 0.0; }, 1.0, 20, 0.0, 1));
  const TriangleMesh& mesh = surface.Triangles();
  const std::vector<double> radii(static_cast<std::size_t>(mesh.NumberOfPoints()), 0.25);
  const std::vector<std::uint8_t> strip = BorderStrip(mesh, radii.data());
  const std::vector<std::uint8_t> border = BorderStrip(mesh, nullptr);
  ASSERT_EQ(strip.size(), radii.size());
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    const double inside = 1.0 - mesh.Point(p).head<2>().cwiseAbs().maxCoeff();
    EXPECT_EQ(strip[p] != 0, inside < 0.25) << mesh.Point(p).transpose();
    EXPECT_EQ(border[p] != 0, inside < 1e-9) << mesh.Point(p).transpose();
  }
}

TEST(BorderStrip, IsEmptyOnAClosedMesh)
{
  const MeshedSurface surface(EllipsoidMesh(4, 1.4, 1.0, 0.6));
  const std::vector<double> radii(
    static_cast<std::size_t>(surface.Triangles().NumberOfPoints()), 9.0);
  const std::vector<std::uint8_t> strip = BorderStrip(surface.Triangles(), radii.data());
  EXPECT_TRUE(strip.empty());
  EXPECT_FALSE(IsInStrip(surface.Triangles(), strip, 0));
}

} // namespace
