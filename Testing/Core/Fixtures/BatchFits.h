// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// All points of a mesh, fitted in batches.

#ifndef RIDGES_TESTING_BATCH_FITS_H
#define RIDGES_TESTING_BATCH_FITS_H

#include "Fit/Batch/JetBatch.h"
#include "Fit/Batch/JetBatchFiller.h"
#include "Mesh/RingNeighborhood.h"
#include "Monge/MongeForm.h"
#include "TestMeshes.h"

#include "Formula/ExampleSurface.h"

#include <array>
#include <vector>

namespace ridges
{
namespace testing
{

struct BatchFit
{
  MongeForm form;
  double P1 = 0.0;
  double P2 = 0.0;
  double conditionNumber = 0.0;
  double residual = 0.0;
  double radius = 0.0;
  double noiseGain = 0.0;
  bool good = false;
  bool doubtful = false;
  std::array<double, JetBatch::NumberOfErrors> errors{};
};

// Fits what has been added.
void FitAdded(JetBatchFiller& filler, const JetBatchKernel& kernel, std::vector<BatchFit>& fits);

// All points of a mesh, from `first` on.
std::vector<BatchFit> FitAll(const TriangleMesh& mesh, const JetBatchKernel& kernel, int degree,
  int minimumNumberOfPoints, Id first = 0, Weighting weighting = Weighting::Uniform,
  bool standardErrors = false, bool exactGain = false);

// With the default number of points of a degree.
NeighborhoodRule RuleFor(int degree);

Mesh ToMesh(const PointsAndTriangles& input);

} // namespace testing
} // namespace ridges

#endif
