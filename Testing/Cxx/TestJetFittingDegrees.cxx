// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// vtkJetFitting in degrees above 4: orders of convergence, borders, and how many points are taken.

#include "FilterTestTools.h"

#include "vtkFieldData.h"
#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRidgesArrayNames.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

using Eigen::Vector3d;

vtkSmartPointer<vtkPolyData> Fit(vtkPolyData* mesh, int degree)
{
  vtkNew<vtkJetFitting> jets;
  jets->SetNeighborhoodToPointCount();
  jets->SetDegree(degree);
  jets->SetInputData(mesh);
  jets->Update();
  return jets->GetOutput();
}

/// Mean errors of k, b, c and P over the points that are no umbilics, and of no border.
using MeanErrors = std::array<double, 4>;

MeanErrors Measure(vtkPolyData* fitted, const AnalyticSurface& surface)
{
  MeanErrors sums{};
  int compared = 0;
  vtkPointData* data = fitted->GetPointData();
  for (vtkIdType p = 0; p < fitted->GetNumberOfPoints(); ++p)
  {
    EXPECT_EQ(Value(data, names::FitStatus, p), 0.0) << p;
    const ExactMonge exact = surface.Monge(PointAt(fitted, p));
    if (exact.k1 - exact.k2 < 0.3)
    {
      continue;
    }
    ++compared;
    const double sign = VectorAt(data, names::MaximumDirection, p).dot(exact.d1) > 0.0 ? 1.0 : -1.0;
    sums[0] += std::abs(Value(data, names::MaximumCurvature, p) - exact.k1) +
      std::abs(Value(data, names::MinimumCurvature, p) - exact.k2);
    for (int i = 0; i < 4; ++i)
    {
      sums[1] += std::abs(Value(data, names::ThirdOrder, p, i) - sign * exact.b[i]);
    }
    for (int i = 0; i < 5; ++i)
    {
      sums[2] += std::abs(Value(data, names::FourthOrder, p, i) - exact.c[i]);
    }
    sums[3] += std::abs(Value(data, names::P1, p) - exact.P1) +
      std::abs(Value(data, names::P2, p) - exact.P2);
  }
  for (double& sum : sums)
  {
    sum /= compared;
  }
  return sums;
}

Mesh Jittered(Mesh mesh, const AnalyticSurface& surface, double size)
{
  std::mt19937_64 generator(51);
  const auto random = [&generator] { return 2.0 * Uniform(generator) - 1.0; };
  for (std::size_t p = 0; p < mesh.PointCount(); ++p)
  {
    Vector3d move;
    move << random(), random(), random();
    mesh.SetPoint(p, surface.Project(mesh.Point(p) + size * move));
  }
  return mesh;
}

/// Halving the edges has to lower the mean errors of k, b and c by 2 to the powers degree - 1,
/// degree - 2 and degree - 3, up to a tenth of an order.
void ExpectOrders(const char* name, int degree, const MeanErrors& coarse, const MeanErrors& fine)
{
  std::printf("%s, degree %d:", name, degree);
  for (int i = 0; i < 4; ++i)
  {
    std::printf(" %s %.1e -> %.1e (order %.2f)", std::array{ "k", "b", "c", "P" }[i], coarse[i],
      fine[i], std::log2(coarse[i] / fine[i]));
  }
  std::printf("\n");
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_GT(std::log2(coarse[i] / fine[i]), degree - 1 - i - 0.1) << name << degree << " " << i;
  }
}

} // namespace

//------------------------------------------------------------------------------
TEST(JetFittingDegrees, ConvergeAtTheirOrdersOnTheEllipsoid)
{
  const AnalyticSurface surface = MakeEllipsoid(1.4, 1.0, 0.6);
  const auto mesh = [&surface](int frequency) {
    return ToPolyData(Jittered(EllipsoidMesh(frequency, 1.4, 1.0, 0.6), surface, 0.2 / frequency));
  };
  for (const auto& [degree, frequency] : { std::pair(6, 20), std::pair(8, 20) })
  {
    ExpectOrders("ellipsoid", degree, Measure(Fit(mesh(frequency), degree), surface),
      Measure(Fit(mesh(2 * frequency), degree), surface));
  }
}

//------------------------------------------------------------------------------
TEST(JetFittingDegrees, ConvergeAtTheirOrdersOnTheTorus)
{
  const AnalyticSurface surface = MakeTorus(2.0, 0.8);
  const auto mesh = [&surface](int n)
  { return ToPolyData(Jittered(TorusMesh(2.0, 0.8, 5 * n / 2, n), surface, 1.0 / n)); };
  for (const auto& [degree, n] : { std::pair(6, 40), std::pair(8, 40) })
  {
    ExpectOrders("torus", degree, Measure(Fit(mesh(n), degree), surface),
      Measure(Fit(mesh(2 * n), degree), surface));
  }
}

//------------------------------------------------------------------------------
// The factors are half of what was found.
TEST(JetFittingDegrees, HigherDegreesAreMoreExactOnACleanMesh)
{
  const AnalyticSurface surface = MakeEllipsoid(1.4, 1.0, 0.6);
  const auto mesh = EllipsoidData(45);
  std::array<MeanErrors, 9> errors;
  for (const int degree : { 4, 6, 8 })
  {
    errors[degree] = Measure(Fit(mesh, degree), surface);
    std::printf("degree %d: k %.1e, b %.1e, c %.1e, P %.1e\n", degree, errors[degree][0],
      errors[degree][1], errors[degree][2], errors[degree][3]);
  }
  EXPECT_LT(errors[6][3], errors[4][3] / 12.0);
  EXPECT_LT(errors[8][3], errors[6][3] / 8.0);
}

//------------------------------------------------------------------------------
TEST(JetFittingDegrees, BordersAreRight)
{
  const auto height = [](double x, double y)
  { return 0.3 * x * x - 0.2 * y * y + 0.1 * x * y * y; };
  const AnalyticSurface surface(
    [](auto x, auto y, auto z) { return z - (0.3 * x * x - 0.2 * y * y + 0.1 * x * y * y); });
  for (const int degree : { 5, 6, 7, 8 })
  {
    for (const double jitter : { 0.0, 0.2 })
    {
      const auto fitted = Fit(ToPolyData(GraphPatch(height, 0.5, 24, jitter, 5)), degree);
      vtkPointData* data = fitted->GetPointData();
      int border = 0;
      for (vtkIdType p = 0; p < fitted->GetNumberOfPoints(); ++p)
      {
        const Vector3d point = PointAt(fitted, p);
        const bool onBorder = std::max(std::abs(point[0]), std::abs(point[1])) > 0.5 - 1e-9;
        const int status = static_cast<int>(Value(data, names::FitStatus, p));
        ASSERT_EQ((status & vtkJetFitting::FIT_BOUNDARY) != 0, onBorder);
        ASSERT_EQ(status & vtkJetFitting::FIT_INVALID, 0);
        border += onBorder ? 1 : 0;
        // A cubic graph over a plane that is hardly tilted: what is left is of that tilt.
        const ExactMonge exact = surface.Monge(point);
        ASSERT_NEAR(Value(data, names::MaximumCurvature, p), exact.k1, 1e-3) << degree << " " << p;
        ASSERT_NEAR(Value(data, names::MinimumCurvature, p), exact.k2, 1e-3) << degree << " " << p;
      }
      EXPECT_EQ(border, 4 * 24);
    }
  }
}

//------------------------------------------------------------------------------
TEST(JetFittingDegrees, TakeMorePointsThanCoefficients)
{
  const auto mesh = EllipsoidData(16);
  for (int degree = 1; degree <= 8; ++degree)
  {
    const auto fitted = Fit(mesh, degree);
    for (vtkIdType p = 0; p < fitted->GetNumberOfPoints(); ++p)
    {
      ASSERT_EQ(Value(fitted->GetPointData(), names::FitStatus, p), 0.0) << degree << " " << p;
      // Well below what takes another ring, from 2000 on.
      ASSERT_LT(Value(fitted->GetPointData(), names::FitConditionNumber, p), 1000.0) << degree;
    }
  }
}

//------------------------------------------------------------------------------
// A degree that is set is taken, on rings that suit it.
TEST(JetFittingDegrees, AutomaticNeighborhoodsTakeTheDegreeThatIsSet)
{
  const auto mesh = EllipsoidData(20);
  for (int degree = 1; degree <= 8; ++degree)
  {
    vtkNew<vtkJetFitting> jets;
    jets->SetDegree(degree);
    jets->SetInputData(mesh);
    jets->Update();
    vtkFieldData* field = jets->GetOutput()->GetFieldData();
    EXPECT_EQ(field->GetArray(names::SelectedDegree)->GetTuple1(0), degree);
    EXPECT_GE(2.0 * field->GetArray(names::SelectedNumberOfRings)->GetTuple1(0), degree);
    EXPECT_LE(field->GetArray(names::SelectedNumberOfRings)->GetTuple1(0), 6.0);
    EXPECT_EQ(jets->GetOutput()->GetPointData()->HasArray(names::ThirdOrder), degree >= 3);
    EXPECT_EQ(jets->GetOutput()->GetPointData()->HasArray(names::FourthOrder), degree >= 4);
    const std::string text =
      vtkStringArray::SafeDownCast(field->GetAbstractArray(names::SelectedFit))->GetValue(0);
    EXPECT_EQ(text.find("degree " + std::to_string(degree) + " on "), 0u) << text;
  }
}

//------------------------------------------------------------------------------
TEST(JetFittingDegrees, AutomaticNeighborhoodsHaveEnoughPoints)
{
  const Mesh noisy = AddNormalNoise(EllipsoidMesh(28, 1.4, 1.0, 0.6), 1e-3, 3);
  vtkNew<vtkJetFitting> jets;
  jets->SetNeighborhoodToAutomatic();
  jets->SetInputData(ToPolyData(noisy));
  jets->Update();
  vtkPolyData* fitted = jets->GetOutput();
  // Noise of 3 % of an edge asks for more rings than any degree does.
  EXPECT_GE(fitted->GetFieldData()->GetArray(names::SelectedNumberOfRings)->GetTuple1(0), 6.0);
  for (vtkIdType p = 0; p < fitted->GetNumberOfPoints(); ++p)
  {
    ASSERT_EQ(Value(fitted->GetPointData(), names::FitStatus, p), 0.0) << p;
  }
}
