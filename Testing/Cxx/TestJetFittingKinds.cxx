// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Meshes of whole kinds that a polynomial hardly fits: curvatures are right, or flagged.

#include "FilterTestTools.h"

#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkPointData.h"
#include "vtkRidgesArrayNames.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

using Eigen::Vector3d;

const double Pi = std::acos(-1.0);

struct Range
{
  double least;
  double most;
};

/// Fits the mesh in several orientations. Of each, curvatures of points that are not flagged, but
/// for the border, have to be in the range; the result is the least share of such points.
double ShareInRange(
  const Mesh& mesh, const Range& range, int neighborhood = vtkJetFitting::AUTOMATIC)
{
  double share = 1.0;
  for (int turn = 0; turn < 3; ++turn)
  {
    const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(0.9 * turn, Vector3d(1.0, 0.7 * turn - 1.0, 0.5).normalized())
        .toRotationMatrix();
    vtkNew<vtkJetFitting> jets;
    const auto input = ToPolyData(Transform(mesh, rotation, Vector3d::Zero()));
    jets->SetNeighborhood(neighborhood);
    jets->SetInputData(input);
    const auto display = vtkObject::GetGlobalWarningDisplay();
    vtkObject::GlobalWarningDisplayOff();
    jets->Update();
    vtkObject::SetGlobalWarningDisplay(display);
    vtkPointData* data = jets->GetOutput()->GetPointData();
    int good = 0;
    for (vtkIdType p = 0; p < input->GetNumberOfPoints(); ++p)
    {
      const int status = static_cast<int>(Value(data, names::FitStatus, p));
      if ((status & ~vtkJetFitting::FIT_BOUNDARY) == 0)
      {
        ++good;
        EXPECT_LE(Value(data, names::MaximumCurvature, p), range.most) << turn << " " << p;
        EXPECT_GE(Value(data, names::MinimumCurvature, p), range.least) << turn << " " << p;
      }
    }
    share = std::min(share, static_cast<double>(good) / input->GetNumberOfPoints());
  }
  return share;
}

/// A profile of radii and heights, turned around the z axis; closed by a point where it ends at the
/// radius 0.
Mesh Revolve(const std::vector<std::array<double, 2>>& profile, int sides)
{
  Mesh mesh;
  std::vector<std::vector<std::int32_t>> rings;
  for (const auto& [radius, height] : profile)
  {
    std::vector<std::int32_t> ring(sides);
    for (int j = 0; j < sides; ++j)
    {
      const double angle = 2.0 * Pi * j / sides;
      if (j == 0 || radius > 0.0)
      {
        mesh.AddPoint(Vector3d(radius * std::cos(angle), radius * std::sin(angle), height));
      }
      ring[j] = static_cast<std::int32_t>(mesh.PointCount()) - 1;
    }
    rings.push_back(ring);
  }
  for (std::size_t i = 0; i + 1 < rings.size(); ++i)
  {
    for (int j = 0; j < sides; ++j)
    {
      const int next = (j + 1) % sides;
      if (profile[i][0] > 0.0)
      {
        mesh.AddTriangle(rings[i][j], rings[i][next], rings[i + 1][next]);
      }
      if (profile[i + 1][0] > 0.0)
      {
        mesh.AddTriangle(rings[i][j], rings[i + 1][next], rings[i + 1][j]);
      }
    }
  }
  return mesh;
}

Mesh Capsule(int sides, int ringsOfCap, double length, int ringsBetween)
{
  std::vector<std::array<double, 2>> profile{ { 0.0, -1.0 - length / 2.0 } };
  for (int i = 1; i <= ringsOfCap; ++i)
  {
    const double angle = 0.5 * Pi * i / ringsOfCap;
    profile.push_back({ std::sin(angle), -std::cos(angle) - length / 2.0 });
  }
  for (int i = 1; i < ringsBetween; ++i)
  {
    profile.push_back({ 1.0, length * (static_cast<double>(i) / ringsBetween - 0.5) });
  }
  for (int i = static_cast<int>(profile.size()) - 1; i >= 0; --i)
  {
    if (profile[i][1] < 0.0)
    {
      profile.push_back({ profile[i][0], -profile[i][1] });
    }
  }
  return Revolve(profile, sides);
}

/// Part of a cylinder of radius 1: so many cells of such sizes around and along, sheared.
Mesh ShearedCylinder(int around, int along, double cellAround, double cellAlong, double shear)
{
  Mesh mesh;
  for (int i = 0; i <= around; ++i)
  {
    for (int j = 0; j <= along; ++j)
    {
      const double angle = i * cellAround + shear * j * cellAlong;
      mesh.AddPoint(Vector3d(std::cos(angle), std::sin(angle), j * cellAlong));
    }
  }
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < along; ++j)
    {
      const std::int32_t a = i * (along + 1) + j;
      const std::int32_t b = a + along + 1;
      mesh.AddTriangle(a, b, b + 1);
      mesh.AddTriangle(a, b + 1, a + 1);
    }
  }
  return mesh;
}

} // namespace

//------------------------------------------------------------------------------
// A quartic over a cap of the unit sphere is off by a few percent as long as it ends well before
// the equator. Of 0.4 nothing is left for a wrong sign.
TEST(JetFittingKinds, CoarseSpheresAreRightOrFlagged)
{
  const Range range{ -1.4, -0.6 };
  for (const int frequency : { 1, 2, 3, 4 })
  {
    SCOPED_TRACE(frequency);
    const double share = ShareInRange(Icosphere(frequency), range);
    EXPECT_TRUE(frequency < 4 || share == 1.0) << share;
  }
  for (const auto& [sides, bands] : { std::pair(4, 2), std::pair(4, 4), std::pair(4, 20),
         std::pair(6, 5), std::pair(8, 6), std::pair(12, 3), std::pair(20, 4), std::pair(30, 3) })
  {
    SCOPED_TRACE(::testing::Message() << sides << " x " << bands);
    std::vector<std::array<double, 2>> profile;
    for (int i = 0; i <= bands; ++i)
    {
      const double angle = Pi * i / bands;
      profile.push_back({ i % bands == 0 ? 0.0 : std::sin(angle), -std::cos(angle) });
    }
    ShareInRange(Revolve(profile, sides), range);
  }
}

//------------------------------------------------------------------------------
// A parabola through the points of a ring at an angle of a has a curvature of 1 / cos^2(a / 2); at
// the ends of a rod, half of the neighbourhood is missing.
TEST(JetFittingKinds, ThinRodsAreRightOrFlagged)
{
  const Range range{ -1.4, 0.3 };
  for (const int sides : { 3, 4, 5, 6, 8, 10, 12, 16, 24 })
  {
    for (const int length : { 1, 5, 20, 80 })
    {
      SCOPED_TRACE(::testing::Message() << sides << " sides, " << length << " along");
      std::vector<std::array<double, 2>> profile;
      for (int i = 0; i <= length; ++i)
      {
        profile.push_back({ 1.0, 10.0 * i / length });
      }
      const double share = ShareInRange(Revolve(profile, sides), range);
      EXPECT_TRUE(sides < 24 || length < 20 || share > 0.9) << share;
    }
    SCOPED_TRACE(::testing::Message() << "capsule of " << sides << " sides");
    ShareInRange(Capsule(sides, std::max(1, sides / 4), 4.0, std::max(1, 2 * sides / 3)), range);
  }
}

//------------------------------------------------------------------------------
// Both sides of a plate are within the neighbourhoods of its rim, which turns by 180 degrees there.
TEST(JetFittingKinds, TheRimOfAThinPlateIsFlagged)
{
  for (const double thickness : { 0.2, 0.05, 0.01, 0.001 })
  {
    SCOPED_TRACE(thickness);
    std::vector<std::array<double, 2>> profile;
    for (int i = 0; i <= 8; ++i)
    {
      profile.push_back({ i / 8.0, -thickness / 2.0 });
    }
    for (int i = 8; i >= 0; --i)
    {
      profile.push_back({ i / 8.0, thickness / 2.0 });
    }
    const auto input = ToPolyData(Revolve(profile, 40));
    vtkNew<vtkJetFitting> jets;
    jets->SetInputData(input);
    const auto display = vtkObject::GetGlobalWarningDisplay();
    vtkObject::GlobalWarningDisplayOff();
    jets->Update();
    vtkObject::SetGlobalWarningDisplay(display);
    int good = 0;
    for (vtkIdType p = 0; p < input->GetNumberOfPoints(); ++p)
    {
      const Vector3d at = PointAt(input, p);
      const double status = Value(jets->GetOutput()->GetPointData(), names::FitStatus, p);
      if (std::hypot(at[0], at[1]) > 0.99)
      {
        EXPECT_EQ(static_cast<int>(status) & vtkJetFitting::FIT_FOLDED, vtkJetFitting::FIT_FOLDED)
          << at.transpose();
      }
      good += status == 0.0 ? 1 : 0;
    }
    EXPECT_GT(good, input->GetNumberOfPoints() / 4);
  }
}

//------------------------------------------------------------------------------
// Noise of 1e-5 of the smaller spacing. Strips of few rows leave curvatures undetermined that are
// across them, and those of one or two rows most others. On few points: a high degree needs more.
TEST(JetFittingKinds, StripsAndAnisotropicGridsAreRightOrFlagged)
{
  const Range range{ -1.5, 0.5 };
  constexpr int fewPoints = vtkJetFitting::BY_POINT_COUNT;
  for (const double ratio : { 1.0, 10.0, 50.0 })
  {
    for (const double shear : { 0.0, 1.0 })
    {
      SCOPED_TRACE(::testing::Message() << "1 : " << ratio << ", shear " << shear);
      const double fine = 0.05 / ratio;
      const auto noisy = [fine](const Mesh& mesh) { return AddNormalNoise(mesh, 1e-5 * fine, 7); };
      EXPECT_GT(
        ShareInRange(noisy(ShearedCylinder(24, 24, 0.05, fine, shear)), range, fewPoints), 0.8);
      EXPECT_GT(
        ShareInRange(noisy(ShearedCylinder(24, 24, fine, 0.05, shear)), range, fewPoints), 0.8);
    }
  }
  for (int rows = 1; rows <= 4; ++rows)
  {
    for (const double noise : { 0.0, 5e-8, 5e-6 })
    {
      SCOPED_TRACE(::testing::Message() << rows << " rows, noise " << noise);
      const Mesh around = ShearedCylinder(50, rows, 0.05, 0.05, 0.0);
      const Mesh along = ShearedCylinder(rows, 50, 0.05, 0.05, 0.0);
      ShareInRange(AddNormalNoise(around, noise, 5), range, fewPoints);
      ShareInRange(AddNormalNoise(along, noise, 5), range, fewPoints);
    }
  }
}
