// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesMakeArray_h
#define vtkRidgesMakeArray_h

#include "vtkNew.h"

/// An empty array of an output.
template <typename Array>
vtkNew<Array> vtkRidgesMakeArray(const char* name, int components = 1)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  return array;
}

#endif
