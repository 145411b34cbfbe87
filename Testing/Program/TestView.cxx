// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "View.h"

#include "vtkMath.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

using program::FindView;
using program::Vector3;
using program::View;

std::vector<Vector3> Box(double x, double y, double z)
{
  std::vector<Vector3> corners;
  corners.reserve(8);
  for (int i = 0; i < 8; ++i)
  {
    corners.push_back(
      { 100.0 + (i & 1 ? x : -x), (i & 2 ? y : -y) - 50.0, (i & 4 ? z : -z) + 7.0 });
  }
  return corners;
}

// Round-off of coordinates around 100.
constexpr double Tolerance = 1e-12;

TEST(View, IsAnOrthonormalFrame)
{
  const std::vector<Vector3> points = Box(1.0, 2.0, 3.0);
  const Vector3 directions[] = { { 0, 0, 5 }, { 0, 1, 0 }, { 1, 0, 0 }, { -1, 2, 1e-9 } };
  for (const Vector3& direction : directions)
  {
    for (const Vector3& up : directions)
    {
      const View view = FindView(points, direction, up, 1.5, 0.0);
      EXPECT_NEAR(vtkMath::Norm(view.right.data()), 1.0, Tolerance);
      EXPECT_NEAR(vtkMath::Norm(view.up.data()), 1.0, Tolerance);
      EXPECT_NEAR(vtkMath::Norm(view.back.data()), 1.0, Tolerance);
      EXPECT_NEAR(vtkMath::Determinant3x3(view.right.data(), view.up.data(), view.back.data()), 1.0,
        Tolerance);
      EXPECT_GT(vtkMath::Dot(view.back.data(), direction.data()), 0.0);
    }
  }
}

TEST(View, FillsThePicture)
{
  for (const double aspect : { 0.5, 1.0, 3.0 })
  {
    const std::vector<Vector3> points = Box(2.0, 1.0, 0.5);
    const double margin = 0.1;
    const View view = FindView(points, std::nullopt, std::nullopt, aspect, margin);
    double width = 0.0;
    double height = 0.0;
    for (const Vector3& point : points)
    {
      const std::array<double, 2> projected = view.Project(point);
      width = std::max(width, std::abs(projected[0]) / aspect);
      height = std::max(height, std::abs(projected[1]));
    }
    EXPECT_NEAR(std::max(width, height), 1.0 - 2.0 * margin, Tolerance) << "aspect " << aspect;
  }
}

TEST(View, StandsUprightAndLooksAtTheBroadSide)
{
  const View tall = FindView(Box(1.0, 2.0, 3.0), std::nullopt, std::nullopt, 1.0, 0.0);
  EXPECT_GT(tall.up[2], 0.9);
  EXPECT_GT(tall.back[0], 0.8);
  const View wide = FindView(Box(3.0, 2.0, 1.0), std::nullopt, std::nullopt, 1.0, 0.0);
  EXPECT_GT(wide.up[1], 0.9);
  EXPECT_GT(wide.back[2], 0.8);
}

TEST(View, IsDefinedForPointsWithoutExtent)
{
  for (const std::vector<Vector3>& points : { std::vector<Vector3>{}, { { 1.0, 1.0, 1.0 } } })
  {
    const View view = FindView(points, std::nullopt, std::nullopt, 1.0, 0.0);
    EXPECT_GT(view.scale, 0.0);
    EXPECT_TRUE(std::isfinite(view.center[0]));
  }
}

TEST(View, IgnoresUnusedAndNonFinitePoints)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 0.0, 0.0);
  points->InsertNextPoint(0.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
  points->InsertNextPoint(1e9, 0.0, 0.0);
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  vtkNew<vtkCellArray> triangles;
  const vtkIdType corners[3] = { 0, 1, 2 };
  triangles->InsertNextCell(3, corners);
  mesh->SetPolys(triangles);
  EXPECT_EQ(program::PointsOfSurface(mesh).size(), 2U);
}

} // namespace
