// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesRangeLoop_h
#define vtkRidgesRangeLoop_h

#include "Core/Mesh/TriangleMesh.h"

#include "vtkSMPTools.h"

#include <functional>

/// A ridges::RangeLoop over VTK's threads: how the filters lend them to the numerics.
inline void vtkRidgesRangeLoop(
  ridges::Id count, const std::function<void(ridges::Id, ridges::Id)>& body)
{
  const auto run = [&body](vtkIdType begin, vtkIdType end)
  { body(static_cast<ridges::Id>(begin), static_cast<ridges::Id>(end)); };
  vtkSMPTools::For(0, count, run);
}

#endif
