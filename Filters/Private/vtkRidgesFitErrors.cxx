// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesFitErrors.h"

#include "vtkRidgesArrayNames.h"

#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace names = vtkRidgesArrayNames;

ridges::FitErrorSource vtkRidgesFetchFitErrors(vtkPolyData* mesh)
{
  const auto fetch = [mesh](const char* name, int components) -> const double*
  {
    auto* array = vtkDoubleArray::SafeDownCast(mesh->GetPointData()->GetArray(name));
    return array && array->GetNumberOfComponents() == components ? array->GetPointer(0) : nullptr;
  };
  ridges::FitErrorSource source;
  source.maximumCurvatureError = fetch(names::MaximumCurvatureError, 1);
  source.minimumCurvatureError = fetch(names::MinimumCurvatureError, 1);
  source.thirdOrderError = fetch(names::ThirdOrderError, 4);
  source.fitResidual = fetch(names::FitResidual, 1);
  source.fitScale = fetch(names::FitScale, 1);
  return source;
}
