// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ridges/SmallLoops.h"

#include "Monge/CurvatureSlope.h"

#include <algorithm>
#include <cmath>
#include <utility>

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
  if (!(error > 0.0))
  {
    return false;
  }
  const double b = std::abs(this->Crossings_.Field().Extremality(color, point));
  return b <= this->Significance_ * error ||
    b <= this->Significance_ * std::hypot(error, this->Difference(point));
}

/// Of the extremality to the derivative of the curvature from point to point. What the polynomials
/// cannot follow shows here, even if little is left over.
double SmallLoops::Difference(Id point) const
{
  const MongeField& field = this->Crossings_.Field();
  const Color color = this->Crossings_.RidgeColor();
  return field.Extremality(color, point) -
    CurvatureSlope(this->Crossings_.Mesh(), field, color, point);
}

SmallLoops::Part SmallLoops::FindPart(Id start, const Fence& fence) const
{
  Part part;
  part.points.push_back(start);
  while (!part.IsWhole())
  {
    this->GrowByOne(part, fence);
  }
  return part;
}

/// Looks at the next point of a part, and at its neighbours.
void SmallLoops::GrowByOne(Part& part, const Fence& fence) const
{
  const TriangleMesh& mesh = this->Crossings_.Mesh();
  const Id point = part.points[part.done++];
  if (part.points.size() <= MostPoints)
  {
    mesh.LookAt(point);
  }
  part.isSmall = part.points.size() <= MostPoints && this->IsInsignificant(point);
  for (const Id t : mesh.TrianglesAround(point))
  {
    if (!part.isSmall)
    {
      return;
    }
    for (int side = 0; side < 3; ++side)
    {
      const Id e = mesh.EdgeOf(t, side);
      const Edge& edge = mesh.EdgeAt(e);
      const Id other = edge.v0 == point ? edge.v1 : (edge.v1 == point ? edge.v0 : -1);
      if (other >= 0 && !IsIn(part.points, other) &&
        !std::binary_search(fence.begin(), fence.end(), e))
      {
        part.points.push_back(other);
      }
    }
    // One point may have very many neighbours.
    part.isSmall = part.points.size() <= MostPoints;
  }
}

// Whether each edge of the fence has one end in the part.
bool SmallLoops::Separates(const Part& part, const Fence& fence) const
{
  const TriangleMesh& mesh = this->Crossings_.Mesh();
  return std::all_of(fence.begin(), fence.end(),
    [&mesh, &part](Id e)
    {
      const Edge& edge = mesh.EdgeAt(e);
      return IsIn(part.points, edge.v0) != IsIn(part.points, edge.v1);
    });
}

// Colours the parts at the two ends of each edge of the fence differently, and looks whether all
// those of one colour are small. Parts that are not small are one: which of them are connected far
// away makes no difference, as they have to be on the same side in any case.
bool SmallLoops::HasSmallSide(const Fence& fence, const std::array<Part, 2>& known) const
{
  constexpr std::size_t large = 0;
  std::vector<Part> parts(1);
  parts.insert(parts.end(), known.begin(), known.end());
  const auto partOf = [this, &parts, &fence](Id point)
  {
    for (std::size_t i = 1; i < parts.size(); ++i)
    {
      if (IsIn(parts[i].points, point))
      {
        return parts[i].isSmall ? i : large;
      }
    }
    parts.push_back(this->FindPart(point, fence));
    return parts.back().isSmall ? parts.size() - 1 : large;
  };
  std::vector<std::pair<std::size_t, std::size_t>> borders;
  for (const Id e : fence)
  {
    const Edge& edge = this->Crossings_.Mesh().EdgeAt(e);
    const std::size_t first = partOf(edge.v0);
    borders.emplace_back(first, partOf(edge.v1));
  }
  // Large parts are outside. Whatever they do not reach has two sides that are small both.
  std::vector<int> sides(parts.size(), 0);
  const auto color = [&sides, &borders](std::size_t start)
  {
    sides[start] = -1;
    for (bool changed = true; changed;)
    {
      changed = false;
      for (const auto& [a, b] : borders)
      {
        if (sides[a] != 0 && sides[a] == sides[b])
        {
          return false;
        }
        if ((sides[a] == 0) != (sides[b] == 0))
        {
          (sides[a] == 0 ? sides[a] : sides[b]) = -(sides[a] + sides[b]);
          changed = true;
        }
      }
    }
    return true;
  };
  bool consistent = color(large);
  for (const auto& border : borders)
  {
    consistent = consistent && (sides[border.first] != 0 || color(border.first));
  }
  return consistent;
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
  Fence fence;
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
  // Mostly the loop runs around one part, which is found first if both grow at the same time.
  const Edge& edge = this->Crossings_.Mesh().EdgeAt(fence.front());
  std::array<Part, 2> parts;
  parts[0].points.push_back(edge.v0);
  parts[1].points.push_back(edge.v1);
  while (!parts[0].IsWhole() || !parts[1].IsWhole())
  {
    for (Part& part : parts)
    {
      if (part.IsWhole())
      {
        continue;
      }
      this->GrowByOne(part, fence);
      if (part.isSmall && part.IsWhole() && this->Separates(part, fence))
      {
        return true;
      }
    }
  }
  return (parts[0].isSmall || parts[1].isSmall) && this->HasSmallSide(fence, parts);
}

} // namespace ridges
