// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Umbilics and the ridges that meet there on surfaces where both are known: numbers, whatever the
// place, the numbering, the fineness of the mesh and the size of the patches.

#include "EllipsoidRidges.h"
#include "FilterTestTools.h"
#include "RidgeGraph.h"
#include "WholeRidges.h"

#include "vtkFieldData.h"
#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRidgeExtraction.h"
#include "vtkRidgesArrayNames.h"
#include "vtkUmbilicDetection.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

Eigen::Matrix3d RandomRotation(std::mt19937_64& generator)
{
  Eigen::Vector4d q;
  do
  {
    for (double& value : q)
    {
      value = 2.0 * Uniform(generator) - 1.0;
    }
  } while (q.squaredNorm() > 1.0 || q.squaredNorm() < 0.01);
  return Eigen::Quaterniond(q.normalized()).toRotationMatrix();
}

class Ellipsoids : public ::testing::TestWithParam<std::array<double, 3>>
{
};

void ExpectRidgesOfEllipsoid(vtkPolyData* ridges)
{
  const std::vector<WholeRidge> whole = WholeRidges(ridges);
  EXPECT_EQ(whole.size(), 6u);
  EXPECT_EQ(CountLooseRidges(ridges, whole), 0);
  std::multiset<int> loops;
  for (const WholeRidge& ridge : whole)
  {
    ASSERT_EQ(ridge.types.size(), 1u);
    if (ridge.closed)
    {
      loops.insert(*ridge.types.begin());
    }
    else
    {
      EXPECT_EQ(*ridge.types.begin(), ridge.maximum ? MaximumHyperbolic : MinimumHyperbolic);
    }
  }
  EXPECT_EQ(loops, (std::multiset<int>{ MaximumElliptic, MinimumElliptic }));
  for (vtkIdType i = 0; i < 4; ++i)
  {
    EXPECT_EQ(CountEndsAt(ridges, whole, i, true), 1);
    EXPECT_EQ(CountEndsAt(ridges, whole, i, false), 1);
  }
}

/// Fits once and detects with patches of each size; checks what is counted.
void ExpectBlend(int frequency, const std::vector<double>& patchSizes)
{
  vtkNew<vtkJetFitting> jets;
  jets->SetInputData(BlendData(frequency));
  vtkNew<vtkUmbilicDetection> detection;
  detection->SetInputConnection(jets->GetOutputPort());
  vtkNew<vtkRidgeExtraction> extraction;
  extraction->SetInputConnection(detection->GetOutputPort());
  for (const double size : patchSizes)
  {
    SCOPED_TRACE(size);
    detection->SetPatchSize(size);
    extraction->Update();
    vtkPolyData* umbilics = detection->GetOutput(1);
    std::map<double, int> counts;
    for (vtkIdType i = 0; i < umbilics->GetNumberOfPoints(); ++i)
    {
      ++counts[Value(umbilics->GetPointData(), names::Index, i)];
    }
    EXPECT_EQ(counts, (std::map<double, int>{ { -0.5, 2 }, { 0.5, 6 } }));
    ExpectAllUmbilicsJoined(umbilics, extraction->GetOutput());
    EXPECT_EQ(CountLooseRidges(extraction->GetOutput(), WholeRidges(extraction->GetOutput())), 0);
  }
}

} // namespace

TEST_P(Ellipsoids, HaveFourUmbilicsAndSixRidges)
{
  const auto [a, b, c] = this->GetParam();
  std::mt19937_64 generator(17);
  for (const int frequency : { 22, 45 })
  {
    const Mesh straight = EllipsoidMesh(frequency, a, b, c);
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
    {
      SCOPED_TRACE(std::to_string(frequency) + ", seed " + std::to_string(seed));
      const Eigen::Matrix3d rotation = RandomRotation(generator);
      const Mesh mesh = Permute(Transform(straight, rotation, Eigen::Vector3d::Zero()), seed);
      const Outputs outputs = RunFilters(ToPolyData(mesh));
      vtkPointData* data = outputs.umbilics->GetPointData();
      ASSERT_EQ(outputs.umbilics->GetNumberOfPoints(), 4);
      const double edge = MeanEdgeLength(mesh);
      std::set<int> found;
      for (vtkIdType i = 0; i < 4; ++i)
      {
        EXPECT_EQ(Value(data, names::Index, i), 0.5);
        EXPECT_EQ(Value(data, names::RidgeCount, i), 1.0);
        EXPECT_EQ(Value(data, names::Pattern, i), 1.0);
        const auto exact = EllipsoidUmbilics(a, b, c);
        for (int j = 0; j < 4; ++j)
        {
          const Eigen::Vector3d expected = rotation * exact[j];
          if ((PointAt(outputs.umbilics, i) - expected).norm() < edge)
          {
            found.insert(j);
          }
        }
      }
      EXPECT_EQ(found.size(), 4u);
      ExpectRidgesOfEllipsoid(outputs.ridges);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Axes, Ellipsoids,
  ::testing::Values(std::array<double, 3>{ 1.4, 1.0, 0.6 }, std::array<double, 3>{ 1.0, 0.8, 0.6 },
    std::array<double, 3>{ 1.6, 1.3, 0.9 }));

TEST(Blend, HasItsUmbilicsOnACoarseMesh)
{
  ExpectBlend(22, { 2.0, 3.0 });
}

TEST(Blend, HasItsUmbilicsWithPatchesOfAnySize)
{
  ExpectBlend(45, { 1.5, 2.0, 3.0, 4.0, 5.0, 6.0 });
}

TEST(Blend, HasItsUmbilicsOnAFineMesh)
{
  ExpectBlend(63, { 1.5, 2.0, 3.0, 4.0, 5.0, 6.0 });
}
