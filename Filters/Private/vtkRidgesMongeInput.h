// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesMongeInput_h
#define vtkRidgesMongeInput_h

#include "vtkRidgesMesh.h"
#include "vtkRidgesMongeArrays.h"

#include <string>

/**
 * A mesh with Monge arrays, as the filters behind vtkJetFitting take it in, private to the module.
 */
class vtkRidgesMongeInput
{
public:
  /// Whether triangles stay that have points without a fit, or without finite values.
  enum class Unusable
  {
    LeftOut,
    Kept
  };

  /// False, after one error in the name of the filter, where the input cannot be used.
  bool Fetch(vtkAlgorithm* filter, vtkPolyData* input, bool needsFourthOrder,
    Unusable unusable = Unusable::LeftOut);

  /// The same for curvatures and directions alone, without triangles that duplicate others.
  bool FetchSecondOrder(vtkAlgorithm* filter, vtkPolyData* input);

  vtkRidgesMongeArrays arrays;
  vtkRidgesMesh mesh;

private:
  bool Build(vtkAlgorithm* filter, vtkPolyData* input, const std::string& faultsOfArrays,
    Unusable unusable, vtkRidgesMesh::Duplicates duplicates);
};

#endif
