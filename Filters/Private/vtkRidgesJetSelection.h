// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesJetSelection_h
#define vtkRidgesJetSelection_h

#include "Core/Fit/JetSelection.h"
#include "Core/Shares/SharedMesh.h"

class vtkAlgorithm;
class vtkPolyData;
class vtkRidgesMesh;

/// The degree and the rings that a selection chooses by trials on a sample of the points. False if
/// the user aborted.
bool vtkRidgesSelectJets(vtkAlgorithm* filter, const ridges::TriangleMesh& mesh,
  const ridges::OrderedRings& rings, ridges::JetSelection selection, double from, double to,
  ridges::JetChoice& choice);

/// The same choice of a mesh that is shared between ranks, on all of them.
bool vtkRidgesSelectJets(vtkAlgorithm* filter, ridges::Ranks& ranks, ridges::SharedMesh& shared,
  ridges::JetSelection selection, double from, double to, ridges::JetChoice& choice);

/// Replaces the fitted arrays by their averages. `mesh` is that of `fitted`.
void vtkRidgesAverageJets(
  const vtkRidgesMesh& mesh, vtkPolyData* fitted, const ridges::JetChoice& choice);

/// Into field data; what an earlier fit left is removed. Null: there was no choice.
void vtkRidgesStoreJetChoice(vtkPolyData* mesh, const ridges::JetChoice* choice);

#endif
