// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesFoldOutput_h
#define vtkRidgesFoldOutput_h

#include "Core/Ridges/RidgeTrace.h"
#include "Core/Salience/FoldAngle.h"
#include "vtkRidgesCompatibility.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

class vtkRidgesMongeInput;

/**
 * The fold angles that vtkRidgeExtraction stores on request, private to the module.
 */
class vtkRidgesFoldOutput
{
public:
  /// `monge` has to outlive it.
  explicit vtkRidgesFoldOutput(const vtkRidgesMongeInput& monge)
    : Monge(monge)
  {
  }

  /// Measures the folds of these ridges. False if the user aborted the filter, whose progress runs
  /// from `from` to `to`.
  bool Measure(
    vtkAlgorithm* filter, double from, double to, const std::vector<ridges::RidgeTrace>& ridges);

  /// Those measured last.
  const std::vector<ridges::RidgeFolds>& Get() const { return this->Folds; }

  /// NoiseFloor: that of the mesh's field data, if it is there, else from the errors of the fits.
  void StoreNoiseFloor(vtkPolyData* output) const;

private:
  ridges::FoldRule MakeRule() const;

  const vtkRidgesMongeInput& Monge;
  std::vector<ridges::RidgeFolds> Folds;
};

#endif
