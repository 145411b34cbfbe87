// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesFoldOutput.h"

#include "Core/Mesh/EnclosingSphere.h"
#include "Core/Salience/NoiseFloor.h"
#include "Core/Salience/SmoothingPlan.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesFieldData.h"
#include "vtkRidgesFolds.h"
#include "vtkRidgesMongeInput.h"

#include "vtkDoubleArray.h"

#include <algorithm>

namespace names = vtkRidgesArrayNames;

/// Walks go a quarter of the model far: features are not larger, and slow bends of the whole body
/// do not count.
ridges::FoldRule vtkRidgesFoldOutput::MakeRule() const
{
  constexpr double reach = 0.25;
  const ridges::TriangleMesh& mesh = this->Monge.mesh.GetTriangles();
  ridges::FoldRule rule;
  rule.reach = reach * 2.0 * ridges::SmallestEnclosingSphere(mesh).radius;
  // Between points curvature is linear, and a fit smooths it: its peak and the zero of its
  // derivative lie within this distance of each other.
  rule.slack = std::max(mesh.MeanEdgeLength(),
    ridges::SmoothingPlan::MedianSigma(
      this->Monge.arrays.GetErrors().fitScale, mesh.NumberOfPoints()));
  return rule;
}

bool vtkRidgesFoldOutput::Measure(
  vtkAlgorithm* filter, double from, double to, const std::vector<ridges::RidgeTrace>& ridges)
{
  const ridges::FoldRule rule = this->MakeRule();
  return vtkRidgesMeasureFolds(filter, from, to, this->Monge.mesh.GetTriangles(),
    this->Monge.arrays.GetField(), rule, false, ridges, this->Folds);
}

void vtkRidgesFoldOutput::StoreNoiseFloor(vtkPolyData* output) const
{
  vtkDataArray* given = this->Monge.mesh.GetPolyData()->GetFieldData()->GetArray(names::NoiseFloor);
  const bool hasFloor =
    given && given->GetNumberOfTuples() == 1 && given->GetNumberOfComponents() == 1;
  const double floor = hasFloor
    ? given->GetComponent(0, 0)
    : ridges::MedianCurvatureError(this->Monge.mesh.GetTriangles(), this->Monge.arrays.GetErrors());
  vtkRidgesAddFieldValue<vtkDoubleArray>(vtkRidgesOwnFieldData(output), names::NoiseFloor, floor);
}
