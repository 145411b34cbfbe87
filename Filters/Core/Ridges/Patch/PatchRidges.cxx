// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ridges/Patch/PatchRidges.h"

#include "Mesh/PositionOrder.h"
#include "Ridges/Patch/PairingRing.h"
#include "Ridges/Patch/PatchCurves.h"
#include "Ridges/Patch/PatchPaths.h"
#include "Ridges/Patch/RefinedPatch.h"

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
  const PatchContour contour(this->Crossings_.Mesh(), patch.triangles);
  const std::vector<Crossing> crossings = this->FindCrossings(contour, patch.umbilic);
  // An odd number without an umbilic to end at means triangles missing: nothing to be done.
  const bool hasUmbilic = contour.Contains(patch.umbilic);
  // Two ridges to an umbilic that cross the same edges are not seen by marching.
  const bool hidesRidges = hasUmbilic && static_cast<int>(crossings.size()) < patch.ridgeCount;
  const bool isDrawn = this->IsDrawnByMarching(patch, crossings);
  if ((isDrawn && !hidesRidges) || (crossings.size() % 2 != 0 && !hasUmbilic))
  {
    return;
  }
  std::vector<PatchCurve> curves;
  if (!this->FindCurves(patch, contour, curves))
  {
    if (isDrawn)
    {
      return;
    }
    curves = this->MakeCurves(patch, contour, crossings);
  }
  for (const Id t : patch.triangles)
  {
    if (contour.Contains(t))
    {
      isReplaced[t] = 1;
    }
  }
  for (const PatchCurve& curve : curves)
  {
    this->Append(patch, contour, curve, segments, paths);
  }
}

/// In the interpolated form, where the only umbilic is that of the patch.
bool PatchRidges::FindCurves(
  const RidgePatch& patch, const PatchContour& contour, std::vector<PatchCurve>& curves) const
{
  if (!contour.Contains(patch.umbilic) || !this->IsSingular(patch.umbilic))
  {
    return false;
  }
  const auto singular = std::count_if(
    patch.triangles.begin(), patch.triangles.end(), [this](Id t) { return this->IsSingular(t); });
  if (singular != 1)
  {
    return false;
  }
  const RefinedPatch refined(this->Crossings_.Mesh(), this->Crossings_.Field(),
    this->Crossings_.RidgeColor(), patch.triangles, patch.umbilic);
  return PatchCurves(this->Crossings_, contour, refined, patch.umbilic)
    .Find(patch.ridgeCount, curves);
}

std::vector<PatchCurve> PatchRidges::MakeCurves(const RidgePatch& patch,
  const PatchContour& contour, const std::vector<Crossing>& crossings) const
{
  const Joints joints = this->Join(patch, contour, crossings);
  PatchPaths layout(this->Crossings_.Mesh(), this->Crossings_.Field(), contour);
  std::vector<Eigen::Vector3d> starts;
  for (const std::size_t side : joints.toUmbilic)
  {
    starts.push_back(this->Crossings_.PointOn(contour.Sides()[side].edge).position);
  }
  const auto toUmbilic = layout.ToPoint(joints.toUmbilic, starts, patch.umbilic, patch.position);
  std::vector<PatchCurve> curves;
  for (std::size_t i = 0; i < toUmbilic.size(); ++i)
  {
    curves.push_back({ static_cast<int>(joints.toUmbilic[i]), PatchCurve::Umbilic, toUmbilic[i] });
  }
  for (const Pair& pair : joints.pairs)
  {
    curves.push_back({ static_cast<int>(pair.first), static_cast<int>(pair.last),
      layout.AlongContour(pair.first, pair.last) });
  }
  return curves;
}

void PatchRidges::Append(const RidgePatch& patch, const PatchContour& contour,
  const PatchCurve& curve, std::vector<RidgeSegment>& segments, std::vector<RidgePath>& paths) const
{
  const TriangleMesh& mesh = this->Crossings_.Mesh();
  const Color color = this->Crossings_.RidgeColor();
  const bool starts = curve.from == PatchCurve::Umbilic;
  const bool ends = curve.to == PatchCurve::Umbilic;
  const auto edgeOf = [&contour](int side)
  { return side == PatchCurve::Umbilic ? RidgeSegment::ToUmbilic : contour.Sides()[side].edge; };
  RidgePath path;
  for (const EdgeCrossing& crossing : curve.path)
  {
    path.edges.push_back(crossing.edge);
    path.points.push_back(
      RidgePointAt(mesh, this->Crossings_.Field(), color, crossing.edge, crossing.parameter));
  }
  RidgeSegment segment{ patch.umbilic, edgeOf(curve.from), edgeOf(curve.to), TypeOf(color, false),
    static_cast<Id>(paths.size()) };
  if (starts && !ends)
  {
    std::swap(segment.edge0, segment.edge1);
    std::reverse(path.edges.begin(), path.edges.end());
    std::reverse(path.points.begin(), path.points.end());
  }
  if (!starts && !ends)
  {
    // Cut along an edge a region may have the same crossing twice: nothing is left of the ridge.
    if (segment.edge0 == segment.edge1)
    {
      return;
    }
    segment.triangle = contour.Sides()[curve.from].triangle;
    segment.type = TypeOf(color,
      this->Crossings_.PointOn(segment.edge0).P + this->Crossings_.PointOn(segment.edge1).P < 0.0);
  }
  segments.push_back(segment);
  paths.push_back(std::move(path));
}

} // namespace ridges
