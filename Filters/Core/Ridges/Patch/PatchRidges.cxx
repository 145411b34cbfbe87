// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ridges/Patch/PatchRidges.h"

#include "Mesh/PositionOrder.h"
#include "Ridges/Patch/PairingRing.h"
#include "Ridges/Patch/PatchPaths.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <tuple>

namespace ridges
{

bool PatchRidges::IsSingular(Id triangle) const
{
  int crossed = 0;
  for (int side = 0; side < 3; ++side)
  {
    crossed += this->Crossings_.IsCrossed(this->Crossings_.Mesh().EdgeOf(triangle, side)) ? 1 : 0;
  }
  return crossed % 2 != 0;
}

// Follows marching from each crossing of the contour to where it ends inside.
std::vector<PatchRidges::Crossing> PatchRidges::FindCrossings(
  const PatchContour& contour, Id umbilic) const
{
  const TriangleMesh& mesh = this->Crossings_.Mesh();
  std::vector<Crossing> crossings;
  // A region that is cut along an edge has a side of it in each of its triangles.
  struct Numbered
  {
    Id triangle;
    Id edge;
    Id number;
    bool operator<(const Numbered& other) const
    {
      return std::tie(this->triangle, this->edge) < std::tie(other.triangle, other.edge);
    }
  };
  std::vector<Numbered> numbers;
  for (std::size_t i = 0; i < contour.Sides().size(); ++i)
  {
    const PatchContour::Side& side = contour.Sides()[i];
    if (this->Crossings_.IsCrossed(side.edge))
    {
      numbers.push_back({ side.triangle, side.edge, static_cast<Id>(crossings.size()) });
      crossings.push_back({ i });
    }
  }
  std::sort(numbers.begin(), numbers.end());
  for (Crossing& crossing : crossings)
  {
    Id triangle = contour.Sides()[crossing.side].triangle;
    Id edge = contour.Sides()[crossing.side].edge;
    while (triangle >= 0 && !this->IsSingular(triangle))
    {
      int side = 0;
      while (mesh.EdgeOf(triangle, side) == edge ||
        !this->Crossings_.IsCrossed(mesh.EdgeOf(triangle, side)))
      {
        ++side;
      }
      edge = mesh.EdgeOf(triangle, side);
      const Id across = contour.Across(triangle, edge);
      if (across < 0)
      {
        crossing.partner =
          std::lower_bound(numbers.begin(), numbers.end(), Numbered{ triangle, edge, 0 })->number;
      }
      triangle = across;
    }
    crossing.toUmbilic = triangle >= 0 && triangle == umbilic;
  }
  return crossings;
}

bool PatchRidges::IsDrawnByMarching(
  const RidgePatch& patch, const std::vector<Crossing>& crossings) const
{
  const auto isSingular = [this](Id t) { return this->IsSingular(t); };
  const auto singular = std::count_if(patch.triangles.begin(), patch.triangles.end(), isSingular);
  if (patch.umbilic == RidgePatch::NoUmbilic || !this->IsSingular(patch.umbilic))
  {
    return singular == 0;
  }
  int atUmbilic = 0;
  for (int side = 0; side < 3; ++side)
  {
    const Id edge = this->Crossings_.Mesh().EdgeOf(patch.umbilic, side);
    atUmbilic += this->Crossings_.IsCrossed(edge) ? 1 : 0;
  }
  const auto arriving = std::count_if(crossings.begin(), crossings.end(),
    [](const Crossing& crossing) { return crossing.toUmbilic; });
  const auto wanted = std::min(patch.ridgeCount, static_cast<int>(crossings.size()));
  return singular == 1 && atUmbilic == wanted && arriving == wanted;
}

PatchRidges::Joints PatchRidges::Join(const RidgePatch& patch, const PatchContour& contour,
  const std::vector<Crossing>& crossings) const
{
  // Pairs that marching joins are taken for this much nearer than they are.
  constexpr double preference = 0.25;
  const auto position = [this, &contour, &crossings](Id i) -> const Eigen::Vector3d&
  { return this->Crossings_.PointOn(contour.Sides()[crossings[i].side].edge).position; };
  // Two on sides of the umbilic's own triangle are joined straight through it: not where that
  // would cut the umbilic off from the others.
  const auto cutsOff = [this, &contour, &crossings, &patch, &position](Id i, Id j)
  {
    const PatchContour::Side& a = contour.Sides()[crossings[i].side];
    const PatchContour::Side& b = contour.Sides()[crossings[j].side];
    if (a.triangle != patch.umbilic || b.triangle != patch.umbilic || a.edge == b.edge)
    {
      return false;
    }
    const TriangleMesh& mesh = this->Crossings_.Mesh();
    const Edge& first = mesh.EdgeAt(a.edge);
    const Edge& second = mesh.EdgeAt(b.edge);
    const Id corner = first.v0 == second.v0 || first.v0 == second.v1 ? first.v0 : first.v1;
    const Eigen::Vector3d across =
      AreaNormalInOrder(mesh, patch.umbilic).cross(position(j) - position(i));
    return across.dot(mesh.Point(corner) - position(i)) * across.dot(patch.position - position(i)) >
      0.0;
  };
  const auto cost = [&position, &crossings, &cutsOff](Id i, Id j)
  {
    const double distance = (position(i) - position(j)).norm();
    const double preferred = crossings[i].partner == j ? preference * distance : distance;
    return cutsOff(i, j) ? std::numeric_limits<double>::max() : preferred;
  };

  std::vector<std::size_t> places;
  places.reserve(crossings.size());
  for (const Crossing& crossing : crossings)
  {
    places.push_back(crossing.side);
  }
  const std::size_t wanted =
    contour.Contains(patch.umbilic) ? static_cast<std::size_t>(patch.ridgeCount) : 0;
  const PairingRing::Cost costOf = cost;
  PairingRing ring(places, contour.Sides().size(), costOf);
  Joints joints;
  while (ring.Size() > wanted && ring.Size() > 1)
  {
    const auto [from, to] = ring.TakeCheapest();
    joints.pairs.push_back({ crossings[from].side, crossings[to].side });
  }
  for (Id i = 0; i < static_cast<Id>(crossings.size()); ++i)
  {
    if (ring.Has(i))
    {
      joints.toUmbilic.push_back(crossings[i].side);
    }
  }
  return joints;
}

void PatchRidges::Draw(const RidgePatch& patch, std::vector<RidgeSegment>& segments,
  std::vector<RidgePath>& paths, std::vector<std::uint8_t>& isReplaced) const
{
  const TriangleMesh& mesh = this->Crossings_.Mesh();
  const Color color = this->Crossings_.RidgeColor();
  const PatchContour contour(mesh, patch.triangles);
  const std::vector<Crossing> crossings = this->FindCrossings(contour, patch.umbilic);
  // An odd number without an umbilic to end at means triangles missing: nothing to be done.
  const bool hasUmbilic = contour.Contains(patch.umbilic);
  if (this->IsDrawnByMarching(patch, crossings) || (crossings.size() % 2 != 0 && !hasUmbilic))
  {
    return;
  }
  for (const Id t : patch.triangles)
  {
    if (contour.Contains(t))
    {
      isReplaced[t] = 1;
    }
  }
  const Joints joints = this->Join(patch, contour, crossings);

  const auto edgeOf = [&contour](std::size_t side) { return contour.Sides()[side].edge; };
  const auto add = [this, &mesh, &color, &segments, &paths](Id triangle, Id edge0, Id edge1,
                     RidgeType type, const std::vector<EdgeCrossing>& through)
  {
    RidgePath path;
    for (const EdgeCrossing& crossing : through)
    {
      path.edges.push_back(crossing.edge);
      path.points.push_back(
        RidgePointAt(mesh, this->Crossings_.Field(), color, crossing.edge, crossing.parameter));
    }
    segments.push_back({ triangle, edge0, edge1, type, static_cast<Id>(paths.size()) });
    paths.push_back(std::move(path));
  };

  PatchPaths layout(mesh, this->Crossings_.Field(), contour);
  std::vector<Eigen::Vector3d> starts;
  for (const std::size_t side : joints.toUmbilic)
  {
    starts.push_back(this->Crossings_.PointOn(edgeOf(side)).position);
  }
  const auto toUmbilic = layout.ToPoint(joints.toUmbilic, starts, patch.umbilic, patch.position);
  for (std::size_t i = 0; i < toUmbilic.size(); ++i)
  {
    add(patch.umbilic, edgeOf(joints.toUmbilic[i]), RidgeSegment::ToUmbilic, TypeOf(color, false),
      toUmbilic[i]);
  }
  for (const Pair& pair : joints.pairs)
  {
    // Cut along an edge a region may have the same crossing twice: nothing is left of the ridge.
    const Id edge0 = edgeOf(pair.first);
    const Id edge1 = edgeOf(pair.last);
    const auto through = layout.AlongContour(pair.first, pair.last);
    if (edge0 != edge1)
    {
      const bool elliptic =
        this->Crossings_.PointOn(edge0).P + this->Crossings_.PointOn(edge1).P < 0.0;
      add(contour.Sides()[pair.first].triangle, edge0, edge1, TypeOf(color, elliptic), through);
    }
  }
}

} // namespace ridges
