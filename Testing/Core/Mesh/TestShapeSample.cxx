// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Samples of points that moving, turning and scaling a mesh do not change.

#include "Mesh/ShapeSample.h"

#include "Fixtures/TestFields.h"
#include "TestMeshes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>

using namespace ridges;
using namespace ridges::testing;

namespace
{

std::vector<Id> SampleOf(const Mesh& mesh, double wanted)
{
  const MeshedSurface surface(mesh);
  std::vector<Id> sample = ShapeSample(surface.Triangles(), wanted);
  std::sort(sample.begin(), sample.end());
  return sample;
}

TEST(ShapeSample, StaysTheSameWhereTheMeshMoves)
{
  const Mesh mesh = AddNormalNoise(EllipsoidMesh(20, 1.4, 1.0, 0.6), 0.01, 5);
  const std::vector<Id> expected = SampleOf(mesh, 300.0);
  EXPECT_GT(expected.size(), 200u);
  EXPECT_LT(expected.size(), 400u);
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  EXPECT_EQ(SampleOf(Transform(mesh, turn, Eigen::Vector3d(3.0, -2.0, 1.0)), 300.0), expected);
  EXPECT_EQ(SampleOf(Transform(mesh, turn, Eigen::Vector3d::Zero(), 1e-9), 300.0), expected);

  std::vector<std::int32_t> newToOld;
  std::vector<Id> permuted = SampleOf(Permute(mesh, 3, &newToOld), 300.0);
  for (Id& p : permuted)
  {
    p = newToOld[p];
  }
  std::sort(permuted.begin(), permuted.end());
  EXPECT_EQ(permuted, expected);
}

TEST(ShapeSample, HasEnoughPointsOfRoundSurfaces)
{
  for (const double b : { 1.0, 0.5 })
  {
    const Mesh mesh = EllipsoidMesh(20, 1.0, 1.0, b);
    const std::vector<Id> sample = SampleOf(mesh, 300.0);
    EXPECT_GT(sample.size(), 150u) << b;
    EXPECT_LT(sample.size(), 600u) << b;
  }
}

TEST(ShapeSample, IsAllOfASmallMesh)
{
  const Mesh mesh = EllipsoidMesh(3, 1.4, 1.0, 0.6);
  EXPECT_EQ(SampleOf(mesh, 300.0).size(), static_cast<std::size_t>(mesh.PointCount()));
}

} // namespace
