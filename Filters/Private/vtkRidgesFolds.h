// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesFolds_h
#define vtkRidgesFolds_h

#include "Core/Ridges/RidgeTrace.h"
#include "Core/Salience/FoldAngle.h"
#include "vtkRidgesCompatibility.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
VTK_ABI_NAMESPACE_END

/**
 * Measures the folds at the vertices of ridges, in parallel, private to the module; with
 * `crestOnly` only of ridges that are crest lines somewhere, the others have none. False if the
 * user aborted the filter, whose progress runs from `from` to `to`.
 */
bool vtkRidgesMeasureFolds(vtkAlgorithm* filter, double from, double to,
  const ridges::TriangleMesh& mesh, const ridges::MongeField& field, const ridges::FoldRule& rule,
  bool crestOnly, const std::vector<ridges::RidgeTrace>& ridges,
  std::vector<ridges::RidgeFolds>& folds);

#endif
