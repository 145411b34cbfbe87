// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_Triangle_h
#define ridges_Triangle_h

#include "Base/Types.h"

#include <algorithm>
#include <array>

namespace ridges
{

/// Corners of a triangle, in the order that orients it.
using Triangle = std::array<Id, 3>;

/// The number of a point among the corners of a triangle that has it.
inline int CornerOf(const Triangle& corners, Id point)
{
  return corners[0] == point ? 0 : (corners[1] == point ? 1 : 2);
}

/// Whether a triangle runs from p straight to q.
inline bool RunsThrough(const Triangle& corners, Id p, Id q)
{
  return (corners[0] == p && corners[1] == q) || (corners[1] == p && corners[2] == q) ||
    (corners[2] == p && corners[0] == q);
}

/// Whether all three corners have values, by a flag for each point; null means all have.
inline bool AreUsable(const Triangle& corners, const std::uint8_t* usable)
{
  return !usable ||
    std::all_of(corners.begin(), corners.end(), [usable](Id p) { return usable[p] != 0; });
}

/// An undirected edge, from the smaller point id to the larger, and the triangles at its sides.
struct Edge
{
  Id v0;
  Id v1;
  Id t0;
  Id t1; ///< The second triangle, or TriangleMesh::Border, or TriangleMesh::NonManifold.
};

} // namespace ridges

#endif
