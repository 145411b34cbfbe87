// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesAllocate_h
#define vtkRidgesAllocate_h

#include "vtkRidgesCompatibility.h"

#include "vtkType.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
VTK_ABI_NAMESPACE_END

/**
 * Gives arrays of numbers, whose components are set, memory for so many tuples, in large pages
 * where it is large. Nothing is set to a value. Private to the module.
 */
void vtkRidgesAllocate(const std::vector<vtkDataArray*>& arrays, vtkIdType numberOfTuples);

#endif
