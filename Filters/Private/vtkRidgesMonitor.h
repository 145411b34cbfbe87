// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesMonitor_h
#define vtkRidgesMonitor_h

#include "Core/Base/Monitor.h"
#include "vtkRidgesCompatibility.h"

/// A monitor of the numerics that reports progress, from `from` to `to`, and stops them if the user
/// asked the filter to abort. Private to the module.
inline ridges::Monitor vtkRidgesMonitor(vtkAlgorithm* filter, double from, double to)
{
  return [filter, from, to](double done)
  {
    filter->UpdateProgress(from + (to - from) * done);
    return !vtkRidgesCompatibility::IsAborted(filter);
  };
}

#endif
