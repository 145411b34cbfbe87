// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ObjReader_h
#define ObjReader_h

#include "Reading/PolygonMesh.h"

#include <string>
#include <string_view>

namespace program
{

/**
 * Reads a mesh in Wavefront's object format, OBJ: its vertices (v) and faces (f). Faces are joined
 * by the numbers of vertices, so that seams of textures and normals do not cut the surface. Texture
 * coordinates and normals are skipped, whether they are there or not (1, 1/2, 1//3, 1//, 1/2/),
 * as are all other statements. Negative numbers count from the last vertex; a backslash at the end
 * of a line continues it.
 *
 * Throws Failure with the name of the file and the number of the line.
 */
PolygonMesh ParseObj(std::string_view text, const std::string& fileName);

} // namespace program

#endif
