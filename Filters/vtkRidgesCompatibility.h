// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRidgesCompatibility.h
 * The differences between VTK 9.1 and later versions, all in one place.
 */
#ifndef vtkRidgesCompatibility_h
#define vtkRidgesCompatibility_h

#include "vtkAlgorithm.h"

// VTK can be built with its classes in an inline namespace, which forward declarations have to
// repeat. The macros came after 9.1; vtkType.h has them where VTK does.
#ifndef VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_END
#endif

namespace vtkRidgesCompatibility
{

// CheckAbort also looks at the filters upstream, and marks the output as aborted. It came after
// 9.1, which has AbortExecute only.
template <typename Algorithm>
auto IsAborted(Algorithm* algorithm, int) -> decltype(algorithm->CheckAbort())
{
  return algorithm->CheckAbort();
}

template <typename Algorithm>
bool IsAborted(Algorithm* algorithm, long)
{
  return algorithm->GetAbortExecute() != 0;
}

/// Whether the user asked to abort the algorithm.
inline bool IsAborted(vtkAlgorithm* algorithm)
{
  return IsAborted(algorithm, 0);
}

} // namespace vtkRidgesCompatibility

#endif
// VTK-HeaderTest-Exclude: vtkRidgesCompatibility.h
