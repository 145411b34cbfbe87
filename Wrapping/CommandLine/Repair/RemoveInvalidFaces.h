// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef RemoveInvalidFaces_h
#define RemoveInvalidFaces_h

#include "Reading/PolygonMesh.h"

#include <cstddef>

namespace program
{

struct InvalidFaces
{
  std::size_t collapsed = 0; ///< Fewer than three different corners.
  std::size_t notFinite = 0; ///< A corner at infinity or at no place at all.
};

/// Removes faces that no step after this can use, and from polygons the corners that repeat the
/// one before. Returns what was removed.
InvalidFaces RemoveInvalidFaces(PolygonMesh& mesh);

} // namespace program

#endif
