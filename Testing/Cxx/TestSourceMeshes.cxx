// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The meshes of VTK's own sources, in single precision: spheres with poles, and a torus whose seam
// is joined only where coordinates agree to the last bit.

#include "FilterTestTools.h"

#include "vtkCleanPolyData.h"
#include "vtkNew.h"
#include "vtkParametricFunctionSource.h"
#include "vtkParametricTorus.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRidgesAndUmbilics.h"
#include "vtkRidgesArrayNames.h"
#include "vtkSphereSource.h"
#include "vtkTriangleFilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

} // namespace

//------------------------------------------------------------------------------
// Single precision is the only noise, and the same in each row: residuals hardly show it. What the
// Euler characteristic of 2 wants are four umbilics of index 1/2, wherever they are.
TEST(SourceMeshes, SpheresHaveNoRidgesAndNoMoreUmbilicsThanTheyMust)
{
  for (const int resolution : { 30, 60, 80, 100, 200 })
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetThetaResolution(resolution);
    sphere->SetPhiResolution(resolution);
    vtkNew<vtkRidgesAndUmbilics> ridges;
    ridges->SetInputConnection(sphere->GetOutputPort());
    ridges->Update();
    EXPECT_EQ(ridges->GetOutput(0)->GetNumberOfCells(), 0) << resolution;
    EXPECT_EQ(ridges->GetOutput(1)->GetNumberOfPoints(), 4) << resolution;

    // Of radius 1/2. Poles of 30 triangles are the worst; then errors are those of the grain.
    vtkPointData* points = ridges->GetOutput(2)->GetPointData();
    const double bound = resolution < 60 ? 5e-3 : 1e-3;
    double largest = 0.0;
    for (vtkIdType p = 0; p < ridges->GetOutput(2)->GetNumberOfPoints(); ++p)
    {
      largest = std::max({ largest, std::abs(Value(points, names::MaximumCurvature, p) + 2.0),
        std::abs(Value(points, names::MinimumCurvature, p) + 2.0) });
    }
    EXPECT_LT(largest, bound) << resolution;
  }
}

//------------------------------------------------------------------------------
// The ends of the parameters differ by 1e-16, which leaves slits, and triangles as thin that may be
// folded back.
TEST(SourceMeshes, ATorusWithAnOpenSeamHasNoUmbilics)
{
  vtkNew<vtkParametricTorus> torus;
  torus->SetRingRadius(1.0);
  torus->SetCrossSectionRadius(0.5);
  vtkNew<vtkParametricFunctionSource> source;
  source->SetParametricFunction(torus);
  source->SetUResolution(100);
  source->SetVResolution(100);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkCleanPolyData> cleaned;
  cleaned->SetInputConnection(triangles->GetOutputPort());
  vtkNew<vtkRidgesAndUmbilics> ridges;
  ridges->SetInputConnection(cleaned->GetOutputPort());
  ridges->Update();
  EXPECT_EQ(ridges->GetOutput(0)->GetNumberOfCells(), 0);
  EXPECT_EQ(ridges->GetOutput(1)->GetNumberOfPoints(), 0);
}
