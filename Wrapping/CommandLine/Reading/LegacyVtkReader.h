// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LegacyVtkReader_h
#define LegacyVtkReader_h

#include "Reading/PolygonMesh.h"

#include <string>
#include <string_view>

namespace program
{

/**
 * Reads points, polygons and triangle strips of a polygonal dataset in VTK's legacy format, ASCII
 * or binary, of any version. Its arrays are only walked over, to see whether the file is complete.
 *
 * A reader of our own, as VTK's takes an incomplete file for a whole one and trusts its counts.
 * Throws Failure with the name of the file and the number of the line.
 */
PolygonMesh ParseLegacyVtk(std::string_view bytes, const std::string& fileName);

} // namespace program

#endif
