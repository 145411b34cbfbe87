// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MeshEdges_h
#define MeshEdges_h

#include "Reading/PolygonMesh.h"

#include <cstddef>
#include <vector>

namespace program
{

/// A side of a face, between two points in ascending order.
struct FaceSide
{
  vtkIdType low;
  vtkIdType high;
  std::size_t face;
  bool isForward; ///< Whether the face runs from low to high.

  bool HasSameEdge(const FaceSide& other) const
  {
    return this->low == other.low && this->high == other.high;
  }
};

/// The sides of all faces, those of an edge side by side.
std::vector<FaceSide> SortedSides(const PolygonMesh& mesh);

/// Calls use(first, last) with the sides of each edge.
template <typename Use>
void ForEachEdge(const std::vector<FaceSide>& sides, const Use& use)
{
  for (auto first = sides.begin(); first != sides.end();)
  {
    auto last = first + 1;
    while (last != sides.end() && last->HasSameEdge(*first))
    {
      ++last;
    }
    use(first, last);
    first = last;
  }
}

/// How many edges have one face, two, and more.
struct EdgeCounts
{
  std::size_t border = 0;
  std::size_t inner = 0;
  std::size_t nonManifold = 0;
};

EdgeCounts CountEdges(const std::vector<FaceSide>& sides);

} // namespace program

#endif
