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

void SpreadDistances(const TriangleMesh& mesh, const std::vector<Id>& from, double farthest,
  std::vector<double>& distances)
{
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  for (const Id p : from)
  {
    queue.emplace(distances[p], p);
  }
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
}

std::vector<std::uint8_t> StripWithin(const std::vector<double>& distances, const double* radii)
{
  std::vector<std::uint8_t> strip(distances.size());
  for (std::size_t p = 0; p < distances.size(); ++p)
  {
    strip[p] = distances[p] <= (radii ? std::max(radii[p], 0.0) : 0.0) ? 1 : 0;
  }
  return strip;
}

std::vector<std::uint8_t> BorderStrip(const TriangleMesh& mesh, const double* radii)
{
  if (mesh.Part())
  {
    return mesh.Part()->borderStrip;
  }
  std::vector<Id> border;
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    if (mesh.OnBorder(p))
    {
      border.push_back(p);
    }
  }
  if (border.empty())
  {
    return {};
  }
  const auto count = static_cast<std::size_t>(mesh.NumberOfPoints());
  std::vector<double> distances(count, std::numeric_limits<double>::infinity());
  for (const Id p : border)
  {
    distances[p] = 0.0;
  }
  SpreadDistances(mesh, border, radii ? *std::max_element(radii, radii + count) : 0.0, distances);
  return StripWithin(distances, radii);
}

} // namespace ridges
