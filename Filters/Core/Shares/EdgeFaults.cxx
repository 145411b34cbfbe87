// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shares/EdgeFaults.h"

#include <map>

namespace ridges
{

EdgeFaults EdgeFaultsAt(const TriangleMesh& mesh, Id p, const std::function<bool(Id)>& isCounted)
{
  struct Sides
  {
    Id from = 0; ///< Triangles that run through the edge from p,
    Id to = 0;   ///< and to p.
  };
  std::map<Id, Sides> edges;
  for (const Id t : mesh.TrianglesAround(p))
  {
    const Triangle& corners = mesh.Corners(t);
    const int corner = CornerOf(corners, p);
    ++edges[corners[(corner + 1) % 3]].from;
    ++edges[corners[(corner + 2) % 3]].to;
  }
  EdgeFaults faults;
  for (const auto& [q, sides] : edges)
  {
    if (isCounted(q))
    {
      faults.nonManifold += sides.from + sides.to > 2 ? 1 : 0;
      faults.inconsistent += sides.from + sides.to == 2 && sides.from != 1 ? 1 : 0;
    }
  }
  return faults;
}

} // namespace ridges
