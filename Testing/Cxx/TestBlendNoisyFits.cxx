// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Automatic fits that are blended where there is noise, too, against a single fit.

#include "ClosedSurfaces.h"
#include "EvenMesh.h"
#include "FilterTestTools.h"

#include "Base/SymmetricTensor.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRidgesArrayNames.h"
#include "vtkSMPTools.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <sstream>
#include <string>

namespace
{

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

using Properties = std::function<void(vtkJetFitting*)>;

vtkSmartPointer<vtkPolyData> Fit(vtkPolyData* mesh, bool blend, const Properties& set = {})
{
  vtkNew<vtkJetFitting> jets;
  jets->SetBlendNoisyFits(blend);
  if (set)
  {
    set(jets);
  }
  jets->SetInputData(mesh);
  jets->Update();
  return jets->GetOutput();
}

std::string TextOf(vtkPolyData* fitted)
{
  vtkAbstractArray* text = fitted->GetFieldData()->GetAbstractArray(names::SelectedFit);
  return vtkStringArray::SafeDownCast(text)->GetValue(0);
}

/// Of the cubic forms of third derivatives, as tensors, in the mean over all points.
double ErrorOf(vtkPolyData* fitted, const AnalyticSurface& surface, const Mesh& clean)
{
  double sum = 0.0;
  vtkPointData* data = fitted->GetPointData();
  for (std::size_t i = 0; i < clean.PointCount(); ++i)
  {
    const ExactMonge exact = surface.Monge(clean.Point(i));
    const auto p = static_cast<vtkIdType>(i);
    const Eigen::Vector3d d1 = VectorAt(data, names::MaximumDirection, p);
    const Eigen::Vector2d e = Eigen::Vector2d(d1.dot(exact.d1), d1.dot(exact.d2)).normalized();
    std::array<double, 4> b{};
    data->GetArray(names::ThirdOrder)->GetTuple(p, b.data());
    // In the axes of the exact form.
    b = ridges::InBasis(b, Eigen::Vector2d(e[0], -e[1]), Eigen::Vector2d(e[1], e[0]));
    const double times[] = { 1.0, 3.0, 3.0, 1.0 };
    double square = 0.0;
    for (int k = 0; k < 4; ++k)
    {
      square += times[k] * (b[k] - exact.b[k]) * (b[k] - exact.b[k]);
    }
    sum += std::sqrt(square);
  }
  return sum / static_cast<double>(clean.PointCount());
}

Mesh NoisyEllipsoid(double noise)
{
  const Mesh mesh = EllipsoidMesh(24, 1.4, 1.0, 0.6);
  return AddNormalNoise(mesh, noise * MeanEdgeLength(mesh), 3);
}

} // namespace

//------------------------------------------------------------------------------
// The width of the torus varies: rings that are best where it is wide are too many where it is
// narrow. The errors of b are 0.749 and 0.566 for the first noise, 0.749 and 0.575 for the second:
// a share of 0.76 and 0.77. It changes by about 0.01 from noise to noise; the limit is 3 times that
// above the worse one.
TEST(BlendNoisyFits, IsMoreExactWhereCurvatureVaries)
{
  const ClosedSurface closed = ClosedSurfaceByName("torus:2");
  const Mesh clean = EvenMesh(closed.surface, closed.halfSize, 10000);
  for (const std::uint64_t seed : { 1, 2 })
  {
    const auto mesh = ToPolyData(AddNormalNoise(clean, 0.01 * MeanEdgeLength(clean), seed));
    const auto single = Fit(mesh, false);
    const auto blend = Fit(mesh, true);
    EXPECT_EQ(TextOf(single).find("blended"), std::string::npos) << TextOf(single);
    EXPECT_NE(TextOf(blend).find("; blended with degree 4 on "), std::string::npos)
      << TextOf(blend);
    const double before = ErrorOf(single, closed.surface, clean);
    const double after = ErrorOf(blend, closed.surface, clean);
    EXPECT_LT(after, 0.8 * before);
    ExpectAllFinite(blend);
  }
}

//------------------------------------------------------------------------------
TEST(BlendNoisyFits, ReportsTheLastFit)
{
  const auto single = Fit(ToPolyData(NoisyEllipsoid(0.05)), false);
  const auto blend = Fit(ToPolyData(NoisyEllipsoid(0.05)), true);
  vtkFieldData* field = blend->GetFieldData();
  ASSERT_EQ(Value(single->GetFieldData(), names::SelectedDegree, 0), 4.0) << TextOf(single);
  EXPECT_EQ(Value(field, names::SelectedDegree, 0), 6.0);
  const double rings = Value(single->GetFieldData(), names::SelectedNumberOfRings, 0);
  EXPECT_EQ(Value(field, names::SelectedNumberOfRings, 0), std::round(1.67 * rings));
  for (const char* name :
    { names::EstimatedNoise, names::NoiseCorrelation, names::SelectedNumberOfAverages })
  {
    EXPECT_EQ(Value(field, name, 0), Value(single->GetFieldData(), name, 0)) << name;
  }
}

//------------------------------------------------------------------------------
TEST(BlendNoisyFits, DoesNotDependOnTheThreads)
{
  const auto mesh = ToPolyData(NoisyEllipsoid(0.05));
  vtkSMPTools::Initialize(1);
  const auto one = Fit(mesh, true);
  vtkSMPTools::Initialize(3);
  const auto three = Fit(mesh, true);
  vtkSMPTools::Initialize(0);
  EXPECT_NE(TextOf(one).find("blended"), std::string::npos);
  EXPECT_EQ(FirstDifference(one, three), "");
}

//------------------------------------------------------------------------------
// Where there is hardly any noise, a degree that is set, no third order, or no automatic choice.
TEST(BlendNoisyFits, ChangesNothingElsewhere)
{
  const auto clean = ToPolyData(NoisyEllipsoid(0.0));
  EXPECT_EQ(FirstDifference(Fit(clean, false), Fit(clean, true)), "");
  const auto noisy = ToPolyData(NoisyEllipsoid(0.05));
  EXPECT_NE(FirstDifference(Fit(noisy, false), Fit(noisy, true)), "");
  const Properties properties[] = {
    [](vtkJetFitting* jets) { jets->SetDegree(4); },
    [](vtkJetFitting* jets) { jets->SetMongeOrder(2); },
    [](vtkJetFitting* jets) { jets->SetNeighborhoodToPointCount(); },
    [](vtkJetFitting* jets) { jets->SetNeighborhoodToRings(); },
  };
  for (const Properties& set : properties)
  {
    EXPECT_EQ(FirstDifference(Fit(noisy, false, set), Fit(noisy, true, set)), "")
      << &set - properties;
  }
}

//------------------------------------------------------------------------------
TEST(BlendNoisyFits, IsOnByDefaultAndPrinted)
{
  vtkNew<vtkJetFitting> jets;
  EXPECT_TRUE(jets->GetBlendNoisyFits());
  jets->BlendNoisyFitsOff();
  std::ostringstream text;
  jets->Print(text);
  EXPECT_NE(text.str().find("BlendNoisyFits: Off"), std::string::npos);
}
