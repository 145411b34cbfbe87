// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesSharedRows_h
#define vtkRidgesSharedRows_h

#include "Core/Shares/SharedMesh.h"
#include "vtkRidgesCompatibility.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPointData;
VTK_ABI_NAMESPACE_END

// Arrays of the points that each rank owns become arrays of other points: doubles and ints, as the
// filters make them. Private to the module. The former are removed. All
// ranks have to call these, with the same arrays.

/// Of the points of each rank's piece.
void vtkRidgesRowsOfPiece(ridges::Ranks& ranks, const ridges::SharedPoints& points,
  vtkPointData* owned, vtkPointData* piece);

/// Of the points of each rank's share.
void vtkRidgesRowsOfShare(
  ridges::Ranks& ranks, const ridges::MeshShare& share, vtkPointData* owned, vtkPointData* values);

/// The same for rows that are all on this rank.
void vtkRidgesPickRows(vtkPointData* values, const std::vector<ridges::Id>& rows, vtkPointData* to);

#endif
