// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesJetBlend_h
#define vtkRidgesJetBlend_h

#include "vtkRidgesFitPoints.h"
#include "vtkRidgesMongeOutput.h"

#include <vector>

class vtkJetFitting;

/// A mesh, and what is fitted to its first `count` points.
struct vtkRidgesJets
{
  const ridges::TriangleMesh& mesh;
  const ridges::OrderedRings& rings;
  vtkIdType count;
  int order;
  std::vector<vtkRidgesFitPoints::Settings> fits; ///< One, or several to be blended.
  double noise = 0.0;                             ///< In the blend; 0: hardly any.
};

/// Fits, and blends (see JetBlend.h), while progress goes from `from` to `to`. False if the user
/// aborted. `reach`, if it is not null: see vtkRidgesFitPoints.
bool vtkRidgesFitJets(vtkJetFitting* filter, const vtkRidgesJets& jets, double from, double to,
  vtkRidgesMongeOutput& output, std::vector<int>* reach = nullptr);

#endif
