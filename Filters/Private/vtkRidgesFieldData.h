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

/// Adds an array of one value, in the place of one of this name.
template <typename Array, typename Value>
void vtkRidgesAddFieldValue(vtkFieldData* field, const char* name, const Value& value)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->InsertNextValue(value);
  field->AddArray(array);
}

#endif
