// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Data for the filters made of the fuzzer's bytes.

#ifndef RIDGES_FUZZ_DATA_H
#define RIDGES_FUZZ_DATA_H

#include "FuzzBytes.h"

#include "vtkAlgorithm.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace fuzz
{

// A grid, a ball or a soup of a few dozen points, with some points moved and some ids changed.
vtkSmartPointer<vtkPolyData> MakeMesh(FuzzBytes& bytes);

// Frames and coefficients at random, as vtkJetFitting would name them; then some arrays taken away,
// or replaced by ones of another type, number of components or tuples, or with other values.
void AddMongeArrays(vtkPolyData* mesh, FuzzBytes& bytes);

vtkSmartPointer<vtkImageData> MakeImage(FuzzBytes& bytes);

// Updates the filter and aborts the process if an output has NaN or infinity in arrays that the
// input does not have.
void Run(vtkAlgorithm* filter, vtkDataObject* input);

} // namespace fuzz

#endif
