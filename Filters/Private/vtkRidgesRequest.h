// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesRequest_h
#define vtkRidgesRequest_h

#include "vtkRidgesCompatibility.h"

#include <initializer_list>
#include <string>
#include <utility>

// What filters share in their requests, private to the module.

VTK_ABI_NAMESPACE_BEGIN
class vtkInformationVector;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

/// The data set of an input. Null, after an error, where it is of another type: VTK lets filters
/// run on every block of a composite data set, whatever it is.
vtkPolyData* vtkRidgesGetPolyData(vtkAlgorithm* filter, vtkInformationVector* input);

/// Whether properties are numbers; those that are not are named in one error of the filter. A
/// setter that clamps lets NaN through.
bool vtkRidgesAreNumbers(
  vtkAlgorithm* filter, std::initializer_list<std::pair<const char*, double>> properties);

/// The text of a warning or error event without what VTK puts around it: file, line and object.
std::string vtkRidgesBareText(const char* message);

#endif
