// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Umbilics/WeakZones.h"

#include <algorithm>
#include <utility>

namespace ridges
{

std::vector<std::vector<Id>> WeakZones(
  const TriangleMesh& mesh, const std::vector<std::uint8_t>& isWeak)
{
  std::vector<std::vector<Id>> zones;
  std::vector<std::uint8_t> isReached(mesh.NumberOfTriangles(), 0);
  const auto isInside = [&](Id p)
  {
    const Span<Id> around = mesh.TrianglesAround(p);
    return std::all_of(around.begin(), around.end(), [&](Id t) { return isWeak[t] != 0; });
  };
  for (Id first = 0; first < mesh.NumberOfTriangles(); ++first)
  {
    if (!isWeak[first] || isReached[first])
    {
      continue;
    }
    std::vector<Id> zone{ first };
    isReached[first] = 1;
    bool hasInside = false;
    for (std::size_t i = 0; i < zone.size(); ++i)
    {
      const Triangle& corners = mesh.Corners(zone[i]);
      hasInside = hasInside || std::any_of(corners.begin(), corners.end(), isInside);
      for (int side = 0; side < 3; ++side)
      {
        const Id next = mesh.Neighbor(zone[i], side);
        if (next >= 0 && isWeak[next] && !isReached[next])
        {
          isReached[next] = 1;
          zone.push_back(next);
        }
      }
    }
    if (hasInside)
    {
      zones.push_back(std::move(zone));
    }
  }
  return zones;
}

} // namespace ridges
