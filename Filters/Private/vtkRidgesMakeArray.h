// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesMakeArray_h
#define vtkRidgesMakeArray_h

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

/// An empty array of an output.
template <typename Array>
vtkNew<Array> vtkRidgesMakeArray(const char* name, int components = 1)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  return array;
}

/// An empty array of the type, the name and the components of another.
inline vtkSmartPointer<vtkDataArray> vtkRidgesMakeArrayLike(vtkDataArray* other)
{
  auto array = vtk::TakeSmartPointer(other->NewInstance());
  array->SetName(other->GetName());
  array->SetNumberOfComponents(other->GetNumberOfComponents());
  array->CopyComponentNames(other);
  return array;
}

#endif
