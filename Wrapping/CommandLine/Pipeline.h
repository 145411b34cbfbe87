// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Pipeline_h
#define Pipeline_h

#include "Console.h"
#include "Options.h"
#include "Report.h"

namespace program
{

/// The mesh of the file as the filters get it, or that of the image, of the formula or of the
/// example. Throws Failure.
vtkSmartPointer<vtkPolyData> MakeMesh(
  const Options& options, Filters& filters, Stages& stages, Results& results);

/// Runs the filters one after the other, from the mesh to the ridges that are kept. Throws Failure.
void RunFilters(const Options& options, Filters& filters, Stages& stages, Results& results);

} // namespace program

#endif
