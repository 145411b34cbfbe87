// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/BorderStrip.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

namespace ridges
{
namespace
{

using Entry = std::pair<double, Id>; ///< Distance and point.

/// The points on edges that have no second triangle.
std::vector<Entry> PointsOnBorder(const TriangleMesh& mesh, std::vector<double>& distances)
{
  std::vector<Entry> queue;
  for (Id e = 0; e < mesh.NumberOfEdges(); ++e)
  {
    const Edge& edge = mesh.EdgeAt(e);
    for (const Id p : { edge.v0, edge.v1 })
    {
      if (edge.t1 < 0 && distances[p] > 0.0)
      {
        distances[p] = 0.0;
        queue.emplace_back(0.0, p);
      }
    }
  }
  return queue;
}

} // namespace

std::vector<std::uint8_t> BorderStrip(const TriangleMesh& mesh, const double* radii)
{
  const auto count = static_cast<std::size_t>(mesh.NumberOfPoints());
  std::vector<double> distances(count, std::numeric_limits<double>::infinity());
  std::vector<Entry> queue = PointsOnBorder(mesh, distances);
  if (queue.empty())
  {
    return {};
  }
  const double farthest = radii && count > 0 ? *std::max_element(radii, radii + count) : 0.0;
  std::make_heap(queue.begin(), queue.end(), std::greater<Entry>());
  while (!queue.empty())
  {
    std::pop_heap(queue.begin(), queue.end(), std::greater<Entry>());
    const auto [distance, p] = queue.back();
    queue.pop_back();
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
          queue.emplace_back(there, q);
          std::push_heap(queue.begin(), queue.end(), std::greater<Entry>());
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
