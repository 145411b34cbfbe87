// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// Which lines of a mesh the program shows by default: of smooth surfaces all, of noise and of flat
// parts the main ones.

#include "LineChoice.h"

#include "vtkJetFitting.h"
#include "vtkMath.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRidgeExampleSource.h"
#include "vtkRidgesArrayNames.h"
#include "vtkTriangleFilter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace program;

vtkSmartPointer<vtkPolyData> Example(int surface, int frequency)
{
  vtkNew<vtkRidgeExampleSource> source;
  source->SetSurface(surface);
  source->SetFrequency(frequency);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkPolyData> Fit(vtkPolyData* mesh)
{
  vtkNew<vtkJetFitting> jets;
  jets->SetInputData(mesh);
  jets->Update();
  return jets->GetOutput();
}

/// Moves each point along its normal by up to so much of an edge either way.
vtkSmartPointer<vtkPolyData> WithNoise(vtkPolyData* mesh, double share)
{
  const auto fitted = Fit(mesh);
  vtkDataArray* normals = fitted->GetPointData()->GetArray(vtkRidgesArrayNames::Normals);
  double corners[3][3];
  mesh->GetPoint(mesh->GetCell(0)->GetPointId(0), corners[0]);
  mesh->GetPoint(mesh->GetCell(0)->GetPointId(1), corners[1]);
  const double edge = std::sqrt(vtkMath::Distance2BetweenPoints(corners[0], corners[1]));
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(7);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double x[3];
    double n[3];
    mesh->GetPoint(i, x);
    normals->GetTuple(i, n);
    const double step = share * edge * random->GetNextRangeValue(-1.0, 1.0);
    points->InsertNextPoint(x[0] + step * n[0], x[1] + step * n[1], x[2] + step * n[2]);
  }
  auto noisy = vtkSmartPointer<vtkPolyData>::New();
  noisy->SetPoints(points);
  noisy->SetPolys(mesh->GetPolys());
  return noisy;
}

TEST(LineChoice, IsTheCompletePictureOnSmoothSurfaces)
{
  for (const int surface : { vtkRidgeExampleSource::BLEND, vtkRidgeExampleSource::ELLIPSOID })
  {
    for (const int frequency : { 16, 30 })
    {
      const LineChoice choice = ChooseLines(Fit(Example(surface, frequency)));
      EXPECT_EQ(choice.lines, Lines::Complete) << choice.reason;
      EXPECT_EQ(choice.reason.find("complete: "), 0u) << choice.reason;
    }
  }
}

TEST(LineChoice, IsSalientLinesOnNoise)
{
  const auto choose = [](int surface, double noise)
  { return ChooseLines(Fit(WithNoise(Example(surface, 30), noise))); };
  const auto expectSalient = [&choose](int surface, double noise)
  {
    const LineChoice choice = choose(surface, noise);
    EXPECT_EQ(choice.lines, Lines::Salient) << choice.reason;
    EXPECT_NE(choice.reason.find("noise"), std::string::npos) << choice.reason;
  };
  expectSalient(vtkRidgeExampleSource::BLEND, 0.05);
  expectSalient(vtkRidgeExampleSource::BLEND, 0.2);
  // An ellipsoid has its six ridges and four umbilics with less noise.
  const LineChoice choice = choose(vtkRidgeExampleSource::ELLIPSOID, 0.05);
  EXPECT_EQ(choice.lines, Lines::Complete) << choice.reason;
  expectSalient(vtkRidgeExampleSource::ELLIPSOID, 0.1);
  expectSalient(vtkRidgeExampleSource::ELLIPSOID, 0.2);
}

TEST(LineChoice, IsSalientLinesOnPlanes)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(10, 10);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(plane->GetOutputPort());
  triangles->Update();
  const LineChoice choice = ChooseLines(Fit(triangles->GetOutput()));
  EXPECT_EQ(choice.lines, Lines::Salient) << choice.reason;
}

TEST(LineChoice, UncertaintyGrowsWithTheNoise)
{
  const auto clean = Example(vtkRidgeExampleSource::ELLIPSOID, 20);
  double before = ThirdOrderUncertainty(Fit(clean));
  EXPECT_LT(before, 0.01);
  for (const double noise : { 1e-4, 1e-3, 1e-2 })
  {
    const double uncertainty = ThirdOrderUncertainty(Fit(WithNoise(clean, noise)));
    EXPECT_GT(uncertainty, 1.2 * before) << noise;
    before = uncertainty;
  }
}

} // namespace
