// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesFieldData_h
#define vtkRidgesFieldData_h

#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

/// The field data of an output, to be changed: that of a shallow copy is still the input's, which
/// is not ours to change.
inline vtkFieldData* vtkRidgesOwnFieldData(vtkPolyData* output)
{
  vtkNew<vtkFieldData> field;
  field->ShallowCopy(output->GetFieldData());
  output->SetFieldData(field);
  return output->GetFieldData();
}

#endif
