// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesArrayMessages_h
#define vtkRidgesArrayMessages_h

#include "Core/Base/RankMessages.h"
#include "vtkRidgesCompatibility.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkFieldData;
VTK_ABI_NAMESPACE_END

// Arrays of numbers or of strings as messages between ranks, private to the module. Others are left
// out.

void vtkRidgesPackArrays(ridges::Bytes& message, vtkFieldData* arrays);

/// Adds the arrays; those of the same names are replaced.
void vtkRidgesTakeArrays(ridges::Unpacker& message, vtkFieldData* arrays);

#endif
