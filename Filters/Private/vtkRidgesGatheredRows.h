// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesGatheredRows_h
#define vtkRidgesGatheredRows_h

#include "Core/Base/Ranks.h"
#include "Core/Base/Types.h"
#include "vtkRidgesCompatibility.h"

#include "vtkType.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkFieldData;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

// Points of pieces on their way into one mesh, private to the module.

/// Some points of a piece: the coordinates first, then the arrays.
void vtkRidgesPackPoints(
  ridges::Bytes& message, vtkPolyData* piece, const std::vector<ridges::Id>& points);

/// Rows of one rank into the arrays of all, of so many, which the first rank that has any makes.
void vtkRidgesPutRows(vtkFieldData* from, const std::vector<vtkIdType>& places, vtkIdType count,
  bool areCoordinates, vtkFieldData* to);

#endif
