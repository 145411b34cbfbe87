// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The ridges are the surface's, not those of its numbering, its place or the signs of its frames.

#include "FilterTestTools.h"
#include "RidgeGraph.h"
#include "RidgePaths.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRidgeExtraction.h"
#include "vtkRidgesArrayNames.h"
#include "vtkUmbilicDetection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

/// Every umbilic is found again, with all it has. Their order is that of their positions, which
/// motions change: each is looked for where it should be.
void ExpectSameUmbilics(vtkPolyData* expected, vtkPolyData* actual,
  const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& move, double tolerance)
{
  ASSERT_EQ(expected->GetNumberOfPoints(), actual->GetNumberOfPoints());
  for (vtkIdType i = 0; i < expected->GetNumberOfPoints(); ++i)
  {
    const Eigen::Vector3d moved = move(PointAt(expected, i));
    vtkIdType found = 0;
    for (vtkIdType j = 1; j < actual->GetNumberOfPoints(); ++j)
    {
      const double distance = (PointAt(actual, j) - moved).norm();
      found = distance < (PointAt(actual, found) - moved).norm() ? j : found;
    }
    EXPECT_LE((PointAt(actual, found) - moved).norm(), tolerance * (moved.norm() + 1e-300)) << i;
    for (const char* name :
      { names::Index, names::RidgeCount, names::ThirdOrderIndex, names::Pattern })
    {
      EXPECT_EQ(
        Value(actual->GetPointData(), name, found), Value(expected->GetPointData(), name, i));
    }
  }
}

Eigen::Vector3d Stay(const Eigen::Vector3d& x)
{
  return x;
}

void ExpectInvariantUnder(
  const Mesh& mesh, const Eigen::Matrix3d& R, const Eigen::Vector3d& t, double s)
{
  const Outputs expected = RunFilters(ToPolyData(mesh));
  const Outputs actual = RunFilters(ToPolyData(Transform(mesh, R, t, s)));
  // Round-off of the coordinates, relative to an edge of 0.02, to the fourth power in c: 1e-16 /
  // 0.02^4 = 1e-9, and some for the shift that lengthens the coordinates.
  const double tolerance = 1e-6;
  ExpectSameUmbilics(
    expected.umbilics, actual.umbilics,
    [&](const Eigen::Vector3d& x) { return Eigen::Vector3d(s * (R * x) + t); }, tolerance);
  ExpectSameRidges(RidgesByPath(expected.ridges), RidgesByPath(actual.ridges), tolerance, s);
}

/// Turns the frames of random points by half a turn.
void FlipFrames(vtkPolyData* fitted, std::uint64_t seed)
{
  std::mt19937_64 generator(seed);
  for (vtkIdType p = 0; p < fitted->GetNumberOfPoints(); ++p)
  {
    if (Uniform(generator) < 0.5)
    {
      for (const char* name :
        { names::MaximumDirection, names::MinimumDirection, names::ThirdOrder })
      {
        vtkDataArray* array = fitted->GetPointData()->GetArray(name);
        for (int i = 0; i < array->GetNumberOfComponents(); ++i)
        {
          array->SetComponent(p, i, -array->GetComponent(p, i));
        }
      }
    }
  }
}

} // namespace

TEST(Invariance, UnderRenumberingOfPointsAndCells)
{
  const auto original = BlendData(32);
  const Outputs expected = RunFilters(original);
  for (const std::uint64_t seed : { 1u, 2u })
  {
    std::vector<std::int32_t> newToOld;
    const Mesh permuted = Permute(ToMesh(original), seed, &newToOld);
    const Outputs actual = RunFilters(ToPolyData(permuted));
    ExpectSameUmbilics(expected.umbilics, actual.umbilics, Stay, 1e-12);
    // The fits are the same to the bit; the measures are sums in another order.
    ExpectSameRidges(RidgesByPath(expected.ridges),
      RidgesByPath(actual.ridges, [&](vtkIdType p) { return newToOld[p]; }), 1e-12);
    for (std::size_t p = 0; p < newToOld.size(); ++p)
    {
      const auto id = static_cast<vtkIdType>(p);
      ASSERT_EQ(Value(actual.fitted->GetPointData(), names::P1, id),
        Value(expected.fitted->GetPointData(), names::P1, newToOld[p]));
    }
  }
}

TEST(Invariance, UnderRigidMotion)
{
  ExpectInvariantUnder(ToMesh(BlendData(32)), GenericRotation(), { 1.0, -2.0, 3.0 }, 1.0);
  ExpectInvariantUnder(ToMesh(EllipsoidData(32)), GenericRotation(), { 1.0, -2.0, 3.0 }, 1.0);
}

TEST(Invariance, UnderScale)
{
  const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  for (const double scale : { 1e-12, 1e-3, 1e3, 1e12 })
  {
    SCOPED_TRACE(scale);
    ExpectInvariantUnder(ToMesh(BlendData(24)), Eigen::Matrix3d::Identity(), origin, scale);
  }
}

TEST(Invariance, UnderFlipsOfTheFrames)
{
  const Outputs expected = RunFilters(BlendData(32));
  for (const std::uint64_t seed : { 1u, 2u, 3u })
  {
    const auto flipped = vtkSmartPointer<vtkPolyData>::New();
    flipped->DeepCopy(expected.fitted);
    FlipFrames(flipped, seed);
    vtkNew<vtkUmbilicDetection> umbilics;
    umbilics->SetInputData(flipped);
    vtkNew<vtkRidgeExtraction> ridges;
    ridges->SetInputConnection(umbilics->GetOutputPort());
    ridges->SetLoopSignificance(0.0);
    ridges->SetTypeSignificance(0.0);
    ridges->Update();
    // Nothing but signs has changed, which angles between frames turn into round-off.
    ExpectSameUmbilics(expected.umbilics, umbilics->GetOutput(1), Stay, 1e-12);
    ExpectSameRidges(RidgesByPath(expected.ridges), RidgesByPath(ridges->GetOutput()), 1e-10);
    ExpectCompleteRidgeGraph(umbilics->GetOutput(0), ridges->GetOutput());
  }
}

// A mirror turns the mesh inside out; with its triangles turned back it is a surface of the same
// shape, whose maximum stays the maximum.
TEST(Invariance, UnderReflection)
{
  Eigen::Matrix3d mirror = Eigen::Matrix3d::Identity();
  mirror(0, 0) = -1.0;
  ExpectInvariantUnder(ToMesh(BlendData(24)), mirror, Eigen::Vector3d::Zero(), 1.0);
}

TEST(Invariance, ReversedOrientationSwapsTheColors)
{
  const Mesh mesh = ToMesh(BlendData(24));
  const Outputs outward = RunFilters(ToPolyData(mesh));
  const Outputs inward = RunFilters(ToPolyData(Flip(mesh)));
  RidgeMap expected = RidgesByPath(outward.ridges);
  for (auto& entry : expected)
  {
    entry.second.type += entry.second.type <= 2 ? 2 : -2;
  }
  ExpectSameRidges(expected, RidgesByPath(inward.ridges), 1e-6);
}
