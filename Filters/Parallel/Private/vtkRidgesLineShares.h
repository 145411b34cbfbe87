// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesLineShares_h
#define vtkRidgesLineShares_h

#include "vtkRidgesCompatibility.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkMultiProcessController;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

/// Gives each rank a share of the ridges, all of which rank 0 has before; all ranks have to call
/// it. Private to the module.
void vtkRidgesShareLines(vtkMultiProcessController* controller, vtkPolyData* ridges);

#endif
