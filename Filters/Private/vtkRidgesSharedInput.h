// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesSharedInput_h
#define vtkRidgesSharedInput_h

#include "Core/Base/Ranks.h"
#include "vtkRidgesCompatibility.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkInformationVector;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

// What ranks agree on before they work on a mesh together, private to the module. All have to call
// these.

/// The piece of this rank. Null if it is missing or of another type, which `faults` then says.
vtkPolyData* vtkRidgesGetPiece(
  const ridges::Ranks& ranks, vtkInformationVector* input, std::string& faults);

/// Whether all ranks go on. If one has a fault, or they differ in the properties of the filter or
/// in the names and types of their arrays, all of them have an error, which names the ranks.
/// Pieces without points may lack arrays.
bool vtkRidgesAgree(vtkAlgorithm* filter, ridges::Ranks& ranks, vtkPolyData* piece,
  const std::string& properties, const std::string& faults);

/// The same without a piece.
bool vtkRidgesAgree(vtkAlgorithm* filter, ridges::Ranks& ranks, const std::string& faults);

/// The names and types of the arrays of a piece, in one text; empty if it has none. Any rank may
/// call this alone.
std::string vtkRidgesDescribeArrays(vtkPolyData* piece);

#endif
