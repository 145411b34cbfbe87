// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/BorderStrip.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace ridges
{
namespace
{

using Entry = std::pair<double, Id>; ///< Distance and point.

} // namespace

std::vector<std::uint8_t> BorderStrip(const TriangleMesh& mesh, const double* radii)
{
  const auto count = static_cast<std::size_t>(mesh.NumberOfPoints());
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    if (mesh.OnBorder(p))
    {
      queue.emplace(0.0, p);
    }
  }
  if (queue.empty())
  {
    return {};
  }
  std::vector<double> distances(count);
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    distances[p] = mesh.OnBorder(p) ? 0.0 : std::numeric_limits<double>::infinity();
  }
  const double farthest = radii && count > 0 ? *std::max_element(radii, radii + count) : 0.0;
  while (!queue.empty())
  {
    const auto [distance, p] = queue.top();
    queue.pop();
    if (distance > distances[p])
    {
      continue;
    }
    for (const Id t : mesh.TrianglesAround(p))
    {
      for (const Id q : mesh.Corners(t))
      {
        const double there = distance + (mesh.Point(q) - mesh.Point(p)).norm();
        if (there < distances[q] && there <= farthest)
        {
          distances[q] = there;
          queue.emplace(there, q);
        }
      }
    }
  }
  std::vector<std::uint8_t> strip(count);
  for (std::size_t p = 0; p < count; ++p)
  {
    strip[p] = distances[p] <= (radii ? std::max(radii[p], 0.0) : 0.0) ? 1 : 0;
  }
  return strip;
}

} // namespace ridges
