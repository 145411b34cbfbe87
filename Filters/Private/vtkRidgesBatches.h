// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesBatches_h
#define vtkRidgesBatches_h

#include "vtkRidgesCompatibility.h"

#include "vtkSMPTools.h"

/**
 * Runs body(begin, end) over [0, count) in parallel, batch after batch, each of which ends when the
 * sizes of its items are `most` together. Between two batches the calling thread reports progress,
 * from `from` to `to`, and looks whether the user asked to abort: then the result is false.
 *
 * Threads wait for each other at the end of a batch, so it should be as long as `most` of the
 * slowest kind may keep a user who aborts waiting: some tenths of a second.
 */
template <typename Body, typename SizeOf>
bool vtkRidgesForSizedBatches(vtkAlgorithm* algorithm, vtkIdType count, double from, double to,
  Body& body, const SizeOf& sizeOf, vtkIdType most = 1 << 11)
{
  vtkIdType begin = 0;
  vtkIdType size = 0;
  for (vtkIdType end = 1; end <= count; ++end)
  {
    size += sizeOf(end - 1);
    if (size < most && end < count)
    {
      continue;
    }
    vtkSMPTools::For(begin, end, body);
    begin = end;
    size = 0;
    algorithm->UpdateProgress(from + (to - from) * static_cast<double>(end) / count);
    if (vtkRidgesCompatibility::IsAborted(algorithm))
    {
      return false;
    }
  }
  return true;
}

/// The same in batches of so many items.
template <typename Body>
bool vtkRidgesForBatches(vtkAlgorithm* algorithm, vtkIdType count, double from, double to,
  Body& body, vtkIdType batch = 1 << 17)
{
  const auto one = [](vtkIdType) -> vtkIdType { return 1; };
  return vtkRidgesForSizedBatches(algorithm, count, from, to, body, one, batch);
}

#endif
