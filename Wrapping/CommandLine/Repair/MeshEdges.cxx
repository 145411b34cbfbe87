// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/MeshEdges.h"

#include <algorithm>
#include <tuple>

namespace program
{

std::vector<FaceSide> SortedSides(const PolygonMesh& mesh)
{
  std::vector<FaceSide> sides;
  sides.reserve(mesh.corners.size());
  for (std::size_t f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    const Face face = mesh.FaceAt(f);
    for (std::size_t i = 0; i < face.size(); ++i)
    {
      const vtkIdType from = face[i];
      const vtkIdType to = face.Next(i);
      sides.push_back({ std::min(from, to), std::max(from, to), f, from < to });
    }
  }
  std::sort(sides.begin(), sides.end(),
    [](const FaceSide& a, const FaceSide& b)
    { return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face); });
  return sides;
}

EdgeCounts CountEdges(const std::vector<FaceSide>& sides)
{
  EdgeCounts counts;
  ForEachEdge(sides,
    [&counts](auto first, auto last)
    {
      const auto size = last - first;
      (size == 1 ? counts.border : size == 2 ? counts.inner : counts.nonManifold) += 1;
    });
  return counts;
}

} // namespace program
