// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Umbilics/WeakZones.h"

#include "Mesh/Regions.h"

#include <algorithm>

namespace ridges
{

std::vector<std::vector<Id>> WeakZones(
  const TriangleMesh& mesh, const std::vector<std::uint8_t>& isWeak)
{
  const auto isInside = [&mesh, &isWeak](Id p)
  {
    const Span<Id> around = mesh.TrianglesAround(p);
    return std::all_of(around.begin(), around.end(), [&isWeak](Id t) { return isWeak[t] != 0; });
  };
  const auto hasNoneInside = [&mesh, &isInside](const std::vector<Id>& zone)
  {
    return std::none_of(zone.begin(), zone.end(),
      [&mesh, &isInside](Id t)
      {
        const Triangle& corners = mesh.Corners(t);
        return std::any_of(corners.begin(), corners.end(), isInside);
      });
  };
  auto zones = RegionsWhere(mesh, [&isWeak](Id t) { return isWeak[t] != 0; });
  zones.erase(std::remove_if(zones.begin(), zones.end(), hasNoneInside), zones.end());
  return zones;
}

} // namespace ridges
