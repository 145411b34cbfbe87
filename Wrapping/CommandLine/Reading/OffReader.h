// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OffReader_h
#define OffReader_h

#include "Reading/PolygonMesh.h"

#include <string>
#include <string_view>

namespace program
{

/**
 * Reads a mesh in Geomview's object file format, OFF. Accepts what varies from writer to writer:
 * comments and empty lines anywhere, counts on the line of the keyword, no keyword, no count of
 * edges, further numbers after the coordinates of a vertex (COFF, NOFF, STOFF, ...) and after the
 * corners of a face, faces of any size. Faces of fewer than three corners are skipped.
 *
 * Throws Failure with the name of the file and the number of the line.
 */
PolygonMesh ParseOff(std::string_view text, const std::string& fileName);

} // namespace program

#endif
