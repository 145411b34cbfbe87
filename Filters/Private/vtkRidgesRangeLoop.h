// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesRangeLoop_h
#define vtkRidgesRangeLoop_h

#include "Core/Base/Types.h"
#include "vtkRidgesBatches.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <functional>

/// A ridges::RangeLoop over VTK's threads: how the filters lend them to the numerics.
inline void vtkRidgesRangeLoop(
  ridges::Id count, const std::function<void(ridges::Id, ridges::Id)>& body)
{
  const auto run = [&body](vtkIdType begin, vtkIdType end)
  { body(static_cast<ridges::Id>(begin), static_cast<ridges::Id>(end)); };
  vtkSMPTools::For(0, count, run);
}

/// The same, but reporting progress; after the user has asked the filter to abort it leaves out all
/// that is not done yet. Each of several loops gets half of the progress that is left. A batch has
/// no more items than `mostInBatch`, if there are many.
inline ridges::RangeLoop vtkRidgesAbortableLoop(
  vtkAlgorithm* filter, double from, double to, vtkIdType mostInBatch = VTK_ID_MAX)
{
  return [filter, from, to, mostInBatch](
           ridges::Id count, const std::function<void(ridges::Id, ridges::Id)>& body) mutable
  {
    const auto run = [&body](vtkIdType begin, vtkIdType end)
    { body(static_cast<ridges::Id>(begin), static_cast<ridges::Id>(end)); };
    constexpr vtkIdType few = 64; // each may take long
    const vtkIdType leastBatch = count < few ? vtkSMPTools::GetEstimatedNumberOfThreads() : 256;
    constexpr vtkIdType numberOfBatches = 16;
    const double middle = 0.5 * (from + to);
    if (!vtkRidgesCompatibility::IsAborted(filter))
    {
      vtkRidgesForBatches(filter, count, from, middle, run,
        std::min(mostInBatch, std::max(leastBatch, count / numberOfBatches)));
    }
    from = middle;
  };
}

#endif
