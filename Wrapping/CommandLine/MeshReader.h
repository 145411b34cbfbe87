// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MeshReader_h
#define MeshReader_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace program
{

/// What is done to a mesh after it was read.
struct Mending
{
  bool merge = false;  ///< Points at the same place become one.
  bool orient = false; ///< Neighbouring triangles get one orientation, outward if it is closed.
};

/// The extensions that ReadMesh knows, for messages.
const char* ReadableExtensions();

/**
 * Reads a mesh by the extension of its name, in upper or lower case. Throws Failure if there is
 * no such file or format or no surface in it; what VTK's readers complain about goes to
 * vtkOutputWindow.
 */
vtkSmartPointer<vtkPolyData> ReadMesh(const std::string& fileName);

vtkSmartPointer<vtkPolyData> Mend(vtkPolyData* mesh, const Mending& mending);

} // namespace program

#endif
