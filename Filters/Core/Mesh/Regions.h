// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_Regions_h
#define ridges_Regions_h

#include "Mesh/TriangleMesh.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace ridges
{

/**
 * The triangles that can be reached from one through edges with two triangles, itself first, the
 * nearest before others. `takes(from, next)` says whether a neighbour is to be had, and has to say
 * so only once.
 */
template <typename Takes>
std::vector<Id> TrianglesFrom(const TriangleMesh& mesh, Id first, const Takes& takes)
{
  std::vector<Id> region{ first };
  for (std::size_t i = 0; i < region.size(); ++i)
  {
    for (int side = 0; side < 3; ++side)
    {
      const Id next = mesh.Neighbor(region[i], side);
      if (next >= 0 && takes(region[i], next))
      {
        region.push_back(next);
      }
    }
  }
  return region;
}

/// The connected regions of the triangles for which `isIn` holds.
template <typename IsIn>
std::vector<std::vector<Id>> RegionsWhere(const TriangleMesh& mesh, const IsIn& isIn)
{
  std::vector<std::vector<Id>> regions;
  std::vector<std::uint8_t> isReached(mesh.NumberOfTriangles(), 0);
  for (Id first = 0; first < mesh.NumberOfTriangles(); ++first)
  {
    if (isReached[first] || !isIn(first))
    {
      continue;
    }
    isReached[first] = 1;
    regions.push_back(TrianglesFrom(mesh, first,
      [&isReached, &isIn](Id, Id next)
      {
        if (isReached[next] || !isIn(next))
        {
          return false;
        }
        isReached[next] = 1;
        return true;
      }));
  }
  return regions;
}

} // namespace ridges

#endif
