// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesNestedFits_h
#define vtkRidgesNestedFits_h

#include "vtkRidgesFitPoints.h"
#include "vtkRidgesMongeOutput.h"
#include "vtkRidgesPerThread.h"

#include "Core/Fit/Batch/NestedJetFiller.h"
#include "Core/Fit/PointFitter.h"
#include "Core/Mesh/OrderedRings.h"

#include <array>
#include <vector>

/**
 * Fits that are blended where there is noise, all three at once: a functor for vtkSMPTools, private
 * to the module. Points that are anything but plain are left to vtkRidgesFitPoints.
 */
class vtkRidgesNestedFits
{
public:
  using Settings = std::vector<vtkRidgesFitPoints::Settings>;

  /// Whether there are kernels for such fits.
  static bool Can(const Settings& fits);

  vtkRidgesNestedFits(const ridges::TriangleMesh& mesh, const ridges::OrderedRings& rings,
    const Settings& fits, double noise, vtkRidgesMongeOutput& output);

  /// See vtkRidgesFitPoints.
  void NoteReach(std::vector<int>& reach) { this->Reach = &reach; }
  vtkIdType BatchSize() const { return 1 << 13; }

  void operator()(vtkIdType begin, vtkIdType end);

  /// The points that are left, in order.
  std::vector<ridges::Id> GetOthers();

private:
  static constexpr int Fits = ridges::NestedJetFiller::Fits;
  struct Scratch
  {
    explicit Scratch(const vtkRidgesNestedFits& fit);

    ridges::PointFitter fitter;
    ridges::NestedJetFiller batches;
    std::vector<ridges::Id> others;
  };
  using Vertices = ridges::Span<ridges::Id>;

  void Take(ridges::Id p, Scratch& scratch);
  void FitBatches(Scratch& scratch);
  void SetShares(ridges::NestedJetBatch& batch) const;
  vtkRidgesMongeOutput::Quality QualityOf(const ridges::NestedJetBatch& batch, int lane) const;
  bool IsPlain(const ridges::NestedJetBatch& batch, int lane, Scratch& scratch) const;

  const ridges::TriangleMesh& Mesh;
  const ridges::OrderedRings& Rings;
  const ridges::NestedJetKernel& Kernel;
  std::array<int, Fits> NumberOfRings;
  std::array<int, Fits> FewestPoints;
  double Noise;
  vtkRidgesMongeOutput& Output;
  std::vector<int>* Reach = nullptr;
  vtkRidgesPerThread<Scratch> PerThread;
};

#endif
