// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/PositionSample.h"

#include "Mesh/PositionHash.h"

#include <algorithm>
#include <utility>

namespace ridges
{

std::vector<Id> PositionSample(const TriangleMesh& mesh, double wanted)
{
  const double part = wanted / std::max(wanted, static_cast<double>(mesh.NumberOfPoints()));
  std::vector<std::pair<std::uint64_t, Id>> chosen;
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    const std::uint64_t hash = PositionHash(mesh.Point(p));
    if (part >= 1.0 || static_cast<double>(hash) < part * 0x1p64)
    {
      chosen.emplace_back(hash, p);
    }
  }
  std::sort(chosen.begin(), chosen.end());
  std::vector<Id> sample;
  for (std::size_t i = 0; i < chosen.size(); ++i)
  {
    const bool again = (i > 0 && chosen[i - 1].first == chosen[i].first) ||
      (i + 1 < chosen.size() && chosen[i + 1].first == chosen[i].first);
    if (!again)
    {
      sample.push_back(chosen[i].second);
    }
  }
  return sample;
}

} // namespace ridges
