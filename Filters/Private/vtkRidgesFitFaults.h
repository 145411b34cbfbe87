// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesFitFaults_h
#define vtkRidgesFitFaults_h

#include "Core/Mesh/OrderedRings.h"
#include "vtkRidgesCompatibility.h"

#include "vtkType.h"

#include <cstdint>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkIntArray;
VTK_ABI_NAMESPACE_END

class vtkRidgesMesh;

/// What is wrong with a mesh or the fits to it, counted; private to the module.
struct vtkRidgesFitFaults
{
  std::int64_t triangulatedCells = 0;
  std::int64_t unusableTriangles = 0;
  std::int64_t nonManifoldEdges = 0;
  std::int64_t inconsistentEdges = 0;
  std::int64_t invalid = 0;
  std::int64_t tooFew = 0;
  std::int64_t folded = 0;
  std::int64_t illConditioned = 0;
  std::int64_t coincident = 0;
  std::int64_t points = 0;
  std::int64_t triangles = 0;

  vtkRidgesFitFaults& operator+=(const vtkRidgesFitFaults& other);

  /// Counts points by FitStatus, but for those that are hidden in a mesh.
  void CountPoints(vtkIntArray* status, const vtkRidgesMesh* hiddenPoints = nullptr);

  /// Whether coincident points may be the cause.
  bool MayBeFromCoincidentPoints() const { return invalid > 0 || tooFew > 0 || folded > 0; }

  /// One text for all; empty if all is well.
  std::string GetText() const;
};

/// Of a whole mesh.
vtkRidgesFitFaults vtkRidgesCountFitFaults(
  vtkRidgesMesh& mesh, const ridges::OrderedRings& rings, vtkIntArray* status);

#endif
