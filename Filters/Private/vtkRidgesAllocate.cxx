// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesAllocate.h"

#include "Core/Base/LargeMemory.h"

#include "vtkDataArray.h"

void vtkRidgesAllocate(const std::vector<vtkDataArray*>& arrays, vtkIdType numberOfTuples)
{
  for (vtkDataArray* array : arrays)
  {
    const vtkIdType size = numberOfTuples * array->GetNumberOfComponents();
    const std::size_t bytes = static_cast<std::size_t>(size) * array->GetDataTypeSize();
    array->SetVoidArray(
      ridges::AllocateLarge(bytes), size, 0, vtkAbstractArray::VTK_DATA_ARRAY_USER_DEFINED);
    array->SetArrayFreeFunction(ridges::FreeLarge);
  }
}
