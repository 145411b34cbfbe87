// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesJetSelection_h
#define vtkRidgesJetSelection_h

#include "Core/Fit/JetSelection.h"
#include "Core/Shares/SharedMesh.h"

class vtkJetFitting;
class vtkPolyData;
class vtkRidgesMesh;

/// What the filter chooses, as far as its properties let it, by trials on a sample of the points.
/// False if the user aborted.
bool vtkRidgesSelectJets(vtkJetFitting* filter, const ridges::TriangleMesh& mesh,
  const ridges::OrderedRings& rings, double from, double to, ridges::JetChoice& choice);

/// The same choice of a mesh that is shared between ranks, on all of them.
bool vtkRidgesSelectJets(vtkJetFitting* filter, ridges::Ranks& ranks, ridges::SharedMesh& shared,
  double from, double to, ridges::JetChoice& choice);

/// Replaces the fitted arrays by their averages. `mesh` is that of `fitted`. False if the user
/// aborted the filter, which may be null: then nobody hears of progress.
bool vtkRidgesAverageJets(vtkJetFitting* filter, const vtkRidgesMesh& mesh, vtkPolyData* fitted,
  const ridges::JetChoice& choice, double from, double to);

/// Into field data; what an earlier fit left is removed. Null: there was no choice.
void vtkRidgesStoreJetChoice(vtkPolyData* mesh, const ridges::JetChoice* choice);

#endif
