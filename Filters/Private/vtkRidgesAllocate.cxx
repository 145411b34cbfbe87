// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesAllocate.h"

#include "Core/Base/LargeMemory.h"
#include "Core/Base/SharedMemory.h"

#include "vtkDataArray.h"

void vtkRidgesAllocate(const std::vector<vtkDataArray*>& arrays, vtkIdType numberOfTuples)
{
  constexpr std::size_t enough = 4 * ridges::LargeMemorySize;
  const auto sizeOf = [=](vtkDataArray* array)
  { return numberOfTuples * array->GetNumberOfComponents(); };
  const auto bytesOf = [=](vtkDataArray* array)
  { return static_cast<std::size_t>(sizeOf(array)) * array->GetDataTypeSize(); };

  std::size_t shared = 0;
  for (vtkDataArray* array : arrays)
  {
    shared += bytesOf(array) < enough ? bytesOf(array) : 0;
  }
  ridges::SharedMemory memory(arrays.size(), shared);
  for (vtkDataArray* array : arrays)
  {
    const std::size_t bytes = bytesOf(array);
    const bool shares = bytes < enough;
    array->SetVoidArray(shares ? memory.Take(bytes) : ridges::AllocateLarge(bytes), sizeOf(array),
      0, vtkAbstractArray::VTK_DATA_ARRAY_USER_DEFINED);
    array->SetArrayFreeFunction(shares ? ridges::SharedMemory::Free : ridges::FreeLarge);
  }
}
