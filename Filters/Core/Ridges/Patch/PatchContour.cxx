// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ridges/Patch/PatchContour.h"

#include "Mesh/PositionOrder.h"

#include <algorithm>
#include <unordered_map>

namespace ridges
{

PatchContour::PatchContour(const TriangleMesh& mesh, const std::vector<Id>& triangles)
  : Mesh_(mesh)
{
  if (triangles.empty())
  {
    return;
  }
  this->GlueAll(triangles);
  if (!this->Walk())
  {
    const auto comesFirst = [&mesh](Id a, Id b) { return ComesBefore(mesh, a, b); };
    this->GlueTree(*std::min_element(triangles.begin(), triangles.end(), comesFirst));
    this->Walk();
  }
}

Id PatchContour::Across(Id triangle, Id edge) const
{
  const int side = this->Mesh_.SideOf(triangle, edge);
  return this->Find(triangle)->Has(side) ? this->Mesh_.Neighbor(triangle, side) : -1;
}

const PatchContour::Glued* PatchContour::Find(Id triangle) const
{
  const auto found =
    std::lower_bound(this->Glued_.begin(), this->Glued_.end(), Glued{ triangle, 0U });
  return found != this->Glued_.end() && found->triangle == triangle ? &*found : nullptr;
}

void PatchContour::GlueAll(const std::vector<Id>& triangles)
{
  this->Glued_.reserve(triangles.size());
  for (const Id t : triangles)
  {
    this->Glued_.push_back({ t, 0U });
  }
  std::sort(this->Glued_.begin(), this->Glued_.end());
  for (Glued& glued : this->Glued_)
  {
    for (int side = 0; side < 3; ++side)
    {
      const Id neighbor = this->Mesh_.Neighbor(glued.triangle, side);
      glued.sides |= neighbor >= 0 && this->Contains(neighbor) ? 1U << side : 0U;
    }
  }
}

void PatchContour::GlueTree(Id root)
{
  std::vector<Id> reached{ root };
  std::unordered_map<Id, unsigned> tree{ { root, 0U } };
  for (std::size_t i = 0; i < reached.size(); ++i)
  {
    for (const NeighborAcross& next : NeighborsByPosition(this->Mesh_, reached[i]))
    {
      if (this->Contains(next.triangle) && tree.count(next.triangle) == 0)
      {
        tree[reached[i]] |= 1U << this->Mesh_.SideOf(reached[i], next.edge);
        tree[next.triangle] = 1U << this->Mesh_.SideOf(next.triangle, next.edge);
        reached.push_back(next.triangle);
      }
    }
  }
  this->Glued_.clear();
  for (const auto& [triangle, sides] : tree)
  {
    this->Glued_.push_back({ triangle, sides });
  }
  std::sort(this->Glued_.begin(), this->Glued_.end());
}

std::size_t PatchContour::NumberOfSides() const
{
  std::size_t count = 0;
  for (const Glued& glued : this->Glued_)
  {
    for (int side = 0; side < 3; ++side)
    {
      count += glued.Has(side) ? 0 : 1;
    }
  }
  return count;
}

// From a place that does not depend on the numbering.
bool PatchContour::FindStart(Place& start) const
{
  start.triangle = -1;
  Eigen::Vector3d least;
  for (const Glued& glued : this->Glued_)
  {
    const Triangle& corners = this->Mesh_.Corners(glued.triangle);
    for (int side = 0; side < 3; ++side)
    {
      if (glued.Has(side))
      {
        continue;
      }
      const Eigen::Vector3d middle =
        this->Mesh_.Point(corners[side]) + this->Mesh_.Point(corners[(side + 1) % 3]);
      // An edge that is cut has two triangles, and sides of one have one middle where points
      // coincide.
      const bool comesFirst = start.triangle < 0 || ComesBefore(middle, least) ||
        (middle == least &&
          (glued.triangle != start.triangle
              ? ComesBefore(this->Mesh_, glued.triangle, start.triangle)
              : PointComesBefore(this->Mesh_, corners[(side + 1) % 3], start.end)));
      if (comesFirst)
      {
        start = { glued.triangle, this->Mesh_.EdgeOf(glued.triangle, side),
          corners[(side + 1) % 3] };
        least = middle;
      }
    }
  }
  return start.triangle >= 0;
}

PatchContour::Side PatchContour::Advance(Place& place) const
{
  Side side{ place.triangle, place.edge, place.end, {} };
  // Around the end, from the edge that leads there to the next one that leads on.
  for (;;)
  {
    const Triangle& corners = this->Mesh_.Corners(place.triangle);
    const int corner = corners[0] == place.end ? 0 : (corners[1] == place.end ? 1 : 2);
    const Id after = this->Mesh_.EdgeOf(place.triangle, corner);
    const Id before = this->Mesh_.EdgeOf(place.triangle, (corner + 2) % 3);
    place.edge = place.edge == after ? before : after;
    const Id across = this->Across(place.triangle, place.edge);
    if (across < 0)
    {
      break;
    }
    side.spokes.push_back(place.edge);
    place.triangle = across;
  }
  const Edge& next = this->Mesh_.EdgeAt(place.edge);
  place.end = next.v0 == place.end ? next.v1 : next.v0;
  return side;
}

bool PatchContour::Walk()
{
  this->Sides_.clear();
  Place place;
  if (!this->FindStart(place))
  {
    return false;
  }
  const Place start = place;
  const std::size_t count = this->NumberOfSides();
  do
  {
    this->Sides_.push_back(this->Advance(place));
  } while (this->Sides_.size() <= count &&
    !(place.triangle == start.triangle && place.edge == start.edge));
  return this->Sides_.size() == count;
}

} // namespace ridges
