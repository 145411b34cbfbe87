// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ImageReader_h
#define ImageReader_h

#include "vtkSmartPointer.h"

#include <string>

class vtkImageData;

namespace program
{

/**
 * Reads a three-dimensional image in one of the formats that VTK knows: VTI, NRRD, NIfTI, MetaImage
 * and others. Throws Failure if there is no such file or format, or if it has no samples. What VTK
 * reports meanwhile goes to vtkOutputWindow.
 */
vtkSmartPointer<vtkImageData> ReadImage(const std::string& fileName);

} // namespace program

#endif
