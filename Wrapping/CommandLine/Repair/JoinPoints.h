// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef JoinPoints_h
#define JoinPoints_h

#include "Reading/PolygonMesh.h"

#include <cstddef>

namespace program
{

/// Which points at the same place become one.
enum class Joining
{
  None,
  /// Those on borders, as along the seams of parts and textures. Points within a surface stay, so
  /// that parts that touch in a point, or triangles without extent, do not become something else.
  Borders,
  All
};

/// Joins points that have the same coordinates, and returns how many are gone. Faces that collapse
/// are removed. With Borders none is joined if that left more edges of three and more faces than of
/// two: sheets that lie on each other have no seam.
std::size_t JoinPoints(PolygonMesh& mesh, Joining joining);

} // namespace program

#endif
