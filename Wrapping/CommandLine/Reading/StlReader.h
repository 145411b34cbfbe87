// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef StlReader_h
#define StlReader_h

#include "Reading/PolygonMesh.h"

#include <string>
#include <string_view>

namespace program
{

/**
 * Reads a mesh in STL, the format of stereolithography, binary or ASCII. A binary file must have
 * the size that its number of triangles asks for, and an ASCII file must be complete. Each triangle
 * has corners of its own: STL says nothing about neighbours.
 *
 * Throws Failure with the name of the file and the number of the line.
 */
PolygonMesh ParseStl(std::string_view bytes, const std::string& fileName);

} // namespace program

#endif
