// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesFitPoints_h
#define vtkRidgesFitPoints_h

#include "vtkRidgesMongeOutput.h"

#include "Core/Fit/Batch/JetBatchFiller.h"
#include "Core/Fit/JetFit.h"
#include "Core/Mesh/OrderedRings.h"
#include "Core/Mesh/RingNeighborhood.h"

#include "vtkSMPThreadLocal.h"

#include <memory>

/**
 * Fits jets to a range of points and stores their Monge forms: a functor for vtkSMPTools, private
 * to the module. Points are fitted in batches; those that batches cannot do, one by one.
 */
class vtkRidgesFitPoints
{
public:
  struct Settings
  {
    ridges::NeighborhoodRule rule;
    int degree = 4;
    ridges::Weighting weighting = ridges::Weighting::Uniform;
    bool standardErrors = false;
  };

  vtkRidgesFitPoints(const ridges::TriangleMesh& mesh, const ridges::OrderedRings& rings,
    const Settings& settings, vtkRidgesMongeOutput& output);

  void operator()(vtkIdType begin, vtkIdType end);

private:
  struct Scratch
  {
    explicit Scratch(const vtkRidgesFitPoints& fit)
      : neighborhood(fit.Mesh, fit.Rings)
      , batches(fit.Mesh, fit.Rings, fit.Wanted.degree, fit.Wanted.weighting)
    {
    }
    ridges::RingNeighborhood neighborhood;
    ridges::JetFitter fitter;
    ridges::JetBatchFiller batches;
    Eigen::Matrix3Xd offsets;
  };

  void Take(ridges::Id p, Scratch& scratch);
  void FitBatches(Scratch& scratch);
  ridges::JetFit Fit(ridges::Id p, ridges::Span<ridges::Id> points, Scratch& scratch) const;
  void FitAlone(ridges::Id p, Scratch& scratch);
  void Store(
    ridges::Id p, const ridges::MongeForm& form, const vtkRidgesMongeOutput::Quality& quality);

  const ridges::TriangleMesh& Mesh;
  const ridges::OrderedRings& Rings;
  Settings Wanted;
  vtkRidgesMongeOutput& Output;
  const ridges::JetBatchKernel* Kernel = nullptr;
  // Shared, as vtkSMPThreadLocal copies the (empty) value it starts from.
  vtkSMPThreadLocal<std::shared_ptr<Scratch>> PerThread;
};

#endif
