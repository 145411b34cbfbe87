// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PlyReader_h
#define PlyReader_h

#include "Reading/PolygonMesh.h"

#include <string>
#include <string_view>

namespace program
{

/**
 * Reads a mesh in PLY, the polygon file format of Stanford, in ASCII or binary of either byte
 * order: x, y and z of the element `vertex`, the corners of `face`, and `tristrips`, where -1 ends
 * a strip. All other elements and properties are skipped.
 *
 * Throws Failure with the name of the file and the line or element.
 */
PolygonMesh ParsePly(std::string_view bytes, const std::string& fileName);

} // namespace program

#endif
