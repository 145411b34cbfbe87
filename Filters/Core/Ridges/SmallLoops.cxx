// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ridges/SmallLoops.h"

#include <algorithm>
#include <cmath>

namespace ridges
{
namespace
{

bool IsIn(const std::vector<Id>& values, Id value)
{
  return std::find(values.begin(), values.end(), value) != values.end();
}

} // namespace

SmallLoops::SmallLoops(
  const RidgeCrossings& crossings, const FitErrorSource& errors, double significance)
  : Crossings_(crossings)
  , Errors_(errors)
  , Significance_(significance)
{
}

bool SmallLoops::IsInsignificant(Id point) const
{
  const Color color = this->Crossings_.RidgeColor();
  const double error = ExtremalityError(this->Crossings_.Mesh(), this->Errors_, color, point);
  return error > 0.0 &&
    std::abs(this->Crossings_.Field().Extremality(color, point)) <= this->Significance_ * error;
}

// Whether all points that can be reached from one without crossing the fence are insignificant,
// few, and not that outside.
bool SmallLoops::IsInsignificantBehind(Id start, Id outside, const std::vector<Id>& fence) const
{
  const TriangleMesh& mesh = this->Crossings_.Mesh();
  std::vector<Id> points{ start };
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (points[i] == outside || points.size() > MostPoints || !this->IsInsignificant(points[i]))
    {
      return false;
    }
    for (const Id t : mesh.TrianglesAround(points[i]))
    {
      for (int side = 0; side < 3; ++side)
      {
        const Id e = mesh.EdgeOf(t, side);
        const Edge& edge = mesh.EdgeAt(e);
        const Id other = edge.v0 == points[i] ? edge.v1 : (edge.v1 == points[i] ? edge.v0 : -1);
        if (other >= 0 && !IsIn(points, other) &&
          !std::binary_search(fence.begin(), fence.end(), e))
        {
          points.push_back(other);
        }
      }
    }
  }
  return true;
}

bool SmallLoops::Contain(const Ridge& ridge, const std::vector<RidgeSegment>& segments,
  const std::vector<RidgePath>& paths) const
{
  if (!ridge.closed || ridge.nodes.size() > MostCrossings)
  {
    return false;
  }
  std::vector<Id> crossed(ridge.nodes.begin(), ridge.nodes.end() - 1);
  for (const Id s : ridge.segments)
  {
    if (segments[s].path != RidgeSegment::NoPath)
    {
      const std::vector<Id>& through = paths[segments[s].path].edges;
      crossed.insert(crossed.end(), through.begin(), through.end());
    }
  }
  // An edge crossed twice has both ends on the same side.
  std::sort(crossed.begin(), crossed.end());
  std::vector<Id> fence;
  for (const Id edge : crossed)
  {
    if (!fence.empty() && fence.back() == edge)
    {
      fence.pop_back();
    }
    else
    {
      fence.push_back(edge);
    }
  }
  if (fence.empty())
  {
    return true;
  }
  const Edge& edge = this->Crossings_.Mesh().EdgeAt(fence.front());
  return this->IsInsignificantBehind(edge.v0, edge.v1, fence) ||
    this->IsInsignificantBehind(edge.v1, edge.v0, fence);
}

} // namespace ridges
