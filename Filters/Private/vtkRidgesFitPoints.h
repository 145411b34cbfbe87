// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesFitPoints_h
#define vtkRidgesFitPoints_h

#include "vtkRidgesMongeOutput.h"
#include "vtkRidgesPerThread.h"

#include "Core/Fit/Batch/JetBatchFiller.h"
#include "Core/Fit/PointFitter.h"
#include "Core/Mesh/OrderedRings.h"

#include <memory>
#include <vector>

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
    bool exactGain = false; ///< See JetBatch.
  };

  vtkRidgesFitPoints(const ridges::TriangleMesh& mesh, const ridges::OrderedRings& rings,
    const Settings& settings, vtkRidgesMongeOutput& output);

  /// Notes how many rings each fit has looked at: for a mesh that ends somewhere, though the
  /// surface does not. `reach` has 0 for each point at the start.
  void NoteReach(std::vector<int>& reach) { this->Reach = &reach; }

  /// Only these points are wanted.
  void Select(const std::vector<ridges::Id>& points) { this->Selected = &points; }

  /// Points that take some tenths of a second: see vtkRidgesForBatches.
  vtkIdType BatchSize() const { return this->Wanted.degree > 4 ? 1 << 13 : 1 << 17; }

  /// Of all points, or the places of those that are wanted.
  void operator()(vtkIdType begin, vtkIdType end);

  enum class Verdict
  {
    Good,
    IllConditioned,
    Odd ///< Whatever else is wrong.
  };

  /// Of the fit in a lane of a batch; the normal, and what knows of the mesh, where it is doubtful.
  static Verdict Judge(const ridges::JetBatch& batch, int lane, const Eigen::Vector3d& normal,
    ridges::PointFitter& fitter);

private:
  struct IllConditioned
  {
    ridges::Id id;
    bool isNearlyGood; ///< With as many rings as it had last.
  };
  struct Scratch
  {
    explicit Scratch(const vtkRidgesFitPoints& fit);

    ridges::PointFitter fitter;
    ridges::JetBatchFiller batches;
    std::vector<IllConditioned> illConditioned;
  };

  void Take(ridges::Id p, int ringsAdded, Scratch& scratch);
  void Note(ridges::Id p, Scratch& scratch);
  void FitBatches(Scratch& scratch);
  void GrowIllConditioned(Scratch& scratch);
  void FitAlone(ridges::Id p, ridges::PointFitter::Growth growth, Scratch& scratch);
  void Store(
    ridges::Id p, const ridges::MongeForm& form, const vtkRidgesMongeOutput::Quality& quality);

  const ridges::TriangleMesh& Mesh;
  const ridges::OrderedRings& Rings;
  Settings Wanted;
  vtkRidgesMongeOutput& Output;
  const ridges::JetBatchKernel* Kernel = nullptr;
  std::vector<int>* Reach = nullptr;
  const std::vector<ridges::Id>* Selected = nullptr;
  vtkRidgesPerThread<Scratch> PerThread;
};

#endif
