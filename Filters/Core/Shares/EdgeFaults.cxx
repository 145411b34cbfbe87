// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shares/EdgeFaults.h"

#include <map>

namespace ridges
{

namespace
{

struct Sides
{
  Id from = 0; ///< Triangles that run through the edge from p,
  Id to = 0;   ///< and to p.
};

/// By the other end of each edge from p.
std::map<Id, Sides> EdgesFrom(const TriangleMesh& mesh, Id p)
{
  std::map<Id, Sides> edges;
  for (const Id t : mesh.TrianglesAround(p))
  {
    const Triangle& corners = mesh.Corners(t);
    const int corner = CornerOf(corners, p);
    ++edges[corners[(corner + 1) % 3]].from;
    ++edges[corners[(corner + 2) % 3]].to;
  }
  return edges;
}

} // namespace

Id SharedEdgesAt(const TriangleMesh& mesh, Id p)
{
  Id count = 0;
  for (const auto& [q, sides] : EdgesFrom(mesh, p))
  {
    count += sides.from + sides.to == 2 ? 1 : 0;
  }
  return count;
}

EdgeFaults EdgeFaultsAt(const TriangleMesh& mesh, Id p, const std::function<bool(Id)>& isCounted)
{
  EdgeFaults faults;
  for (const auto& [q, sides] : EdgesFrom(mesh, p))
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
