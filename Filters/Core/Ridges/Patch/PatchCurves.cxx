// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ridges/Patch/PatchCurves.h"

#include "Monge/FieldOrder.h"

#include <algorithm>
#include <cmath>

namespace ridges
{
PatchCurves::PatchCurves(const RidgeCrossings& crossings, const PatchContour& contour,
  const RefinedPatch& refined, Id umbilic)
  : Crossings_(crossings)
  , Contour_(contour)
  , Refined_(refined)
  , Umbilic_(umbilic)
{
}

bool PatchCurves::Find(int ridgeCount, std::vector<PatchCurve>& curves)
{
  if (!this->Refined_.IsValid() || !this->March() || !this->LookAtHole(ridgeCount) ||
    !this->LookAtContour())
  {
    return false;
  }
  this->UniteNearLoops();
  this->IsDone_.assign(this->Sides_.size(), 0);
  curves.clear();
  for (std::size_t s = 0; s < this->Sides_.size(); ++s)
  {
    const bool isEnd = this->OnHole_[s] >= 0 || this->OnContour_[s] >= 0;
    if (isEnd && !this->IsDone_[s] && !this->Append(this->Follow(static_cast<int>(s)), curves))
    {
      return false;
    }
  }
  return true;
}

bool PatchCurves::Append(const Trail& trail, std::vector<PatchCurve>& curves)
{
  this->IsDone_[trail.sides.front()] = 1;
  this->IsDone_[trail.sides.back()] = 1;
  curves.push_back(trail.curve);
  PatchCurve& curve = curves.back();
  const bool isInTriangle =
    curve.from == PatchCurve::Umbilic && curve.to == PatchCurve::Umbilic && curve.path.empty();
  return !isInTriangle || this->LeadOverBorder(trail, curve.path);
}

/// False if the acute rule is not coherent around one of the small triangles.
bool PatchCurves::March()
{
  const auto& triangles = this->Refined_.Triangles();
  this->SidesOf_.resize(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    int crossed = 0;
    for (int i = 0; i < 3; ++i)
    {
      const int v = triangles[t][i];
      const int w = triangles[t][(i + 1) % 3];
      this->SidesOf_[t][i] = -1;
      if (!this->Refined_.IsCrossed(v, w))
      {
        continue;
      }
      ++crossed;
      const auto inserted =
        this->NumberOf_.insert({ RefinedPatch::Key(v, w), static_cast<int>(this->Sides_.size()) });
      if (inserted.second)
      {
        this->Sides_.push_back({ { v, w }, { static_cast<int>(t), -1 } });
      }
      else
      {
        this->Sides_[inserted.first->second].triangles[1] = static_cast<int>(t);
      }
      this->SidesOf_[t][i] = inserted.first->second;
    }
    if (crossed % 2 != 0)
    {
      return false;
    }
  }
  return true;
}

bool PatchCurves::LookAtHole(int ridgeCount)
{
  this->OnHole_.assign(this->Sides_.size(), -1);
  const std::vector<int>& hole = this->Refined_.Rings().back();
  for (std::size_t i = 0; i < hole.size(); ++i)
  {
    const auto found =
      this->NumberOf_.find(RefinedPatch::Key(hole[i], hole[(i + 1) % hole.size()]));
    if (found != this->NumberOf_.end())
    {
      this->OnHole_[found->second] = static_cast<int>(i);
      this->AroundHole_.push_back(found->second);
    }
  }
  return static_cast<int>(this->AroundHole_.size()) == ridgeCount;
}

/// Of several on one edge that goes on from which nothing is cut off when the others turn back in
/// pairs, and which is nearest to where the edge of the mesh is crossed.
bool PatchCurves::LookAtContour()
{
  this->OnContour_.assign(this->Sides_.size(), -1);
  this->TurnsTo_.assign(this->Sides_.size(), -1);
  std::map<int, std::vector<std::pair<double, int>>> onSide; // of the contour
  std::unordered_map<Id, int> sideOfEdge;
  for (std::size_t i = 0; i < this->Contour_.Sides().size(); ++i)
  {
    if (!sideOfEdge.insert({ this->Contour_.Sides()[i].edge, static_cast<int>(i) }).second)
    {
      return false;
    }
    onSide[static_cast<int>(i)];
  }
  for (std::size_t s = 0; s < this->Sides_.size(); ++s)
  {
    const Side& side = this->Sides_[s];
    if (side.triangles[1] >= 0 || this->OnHole_[s] >= 0)
    {
      continue;
    }
    const auto part = this->Refined_.PartBetween(side.corners[0], side.corners[1]);
    const auto found = sideOfEdge.find(part.edge);
    if (found == sideOfEdge.end())
    {
      return false;
    }
    onSide[found->second].emplace_back(
      this->Refined_.ParameterOn(part, side.corners[0], side.corners[1]), static_cast<int>(s));
  }
  for (auto& [number, crossed] : onSide)
  {
    const Id edge = this->Contour_.Sides()[number].edge;
    if (this->Crossings_.IsCrossed(edge) != (crossed.size() % 2 != 0))
    {
      return false;
    }
    std::sort(crossed.begin(), crossed.end());
    if (crossed.size() % 2 != 0)
    {
      const OrderedEdge ends = EndsInOrder(this->Crossings_.Mesh(), this->Crossings_.Field(), edge);
      const double parameter = this->Crossings_.PointOn(edge).parameter;
      const double shown = ends.swaps ? 1.0 - parameter : parameter;
      std::size_t best = 0;
      for (std::size_t i = 2; i < crossed.size(); i += 2)
      {
        best =
          std::abs(crossed[i].first - shown) < std::abs(crossed[best].first - shown) ? i : best;
      }
      this->OnContour_[crossed[best].second] = number;
      crossed.erase(crossed.begin() + static_cast<std::ptrdiff_t>(best));
    }
    for (std::size_t i = 0; i + 1 < crossed.size(); i += 2)
    {
      this->TurnsTo_[crossed[i].second] = crossed[i + 1].second;
      this->TurnsTo_[crossed[i + 1].second] = crossed[i].second;
    }
  }
  return true;
}

int PatchCurves::NextIn(int triangle, int side) const
{
  for (const int s : this->SidesOf_[triangle])
  {
    if (s >= 0 && s != side)
    {
      return s;
    }
  }
  return -1;
}

PatchCurves::Trail PatchCurves::Follow(int start) const
{
  Trail trail;
  trail.sides.push_back(start);
  int triangle = this->Sides_[start].triangles[0];
  for (int side = start;;)
  {
    side = this->NextIn(triangle, side);
    trail.sides.push_back(side);
    const Side& here = this->Sides_[side];
    const int from = here.triangles[0] == triangle ? 0 : 1;
    const auto switched = this->Switches_.find({ side, from });
    if (switched != this->Switches_.end())
    {
      side = switched->second.side;
      trail.sides.push_back(side);
      triangle = this->Sides_[side].triangles[switched->second.triangle];
    }
    else if (here.triangles[1] >= 0)
    {
      const auto part = this->Refined_.PartBetween(here.corners[0], here.corners[1]);
      if (part.edge >= 0)
      {
        trail.curve.path.push_back(
          { part.edge, this->Refined_.ParameterOn(part, here.corners[0], here.corners[1]) });
      }
      triangle = here.triangles[1 - from];
    }
    else if (this->TurnsTo_[side] >= 0)
    {
      side = this->TurnsTo_[side];
      trail.sides.push_back(side);
      triangle = this->Sides_[side].triangles[0];
    }
    else
    {
      break;
    }
  }
  const auto nodeOf = [this](int side)
  { return this->OnHole_[side] >= 0 ? PatchCurve::Umbilic : this->OnContour_[side]; };
  trail.curve.from = nodeOf(start);
  trail.curve.to = nodeOf(trail.sides.back());
  return trail;
}

Eigen::Vector3d PatchCurves::MiddleOf(int side) const
{
  const auto& corners = this->Sides_[side].corners;
  return 0.5 * (this->Refined_.Position(corners[0]) + this->Refined_.Position(corners[1]));
}

void PatchCurves::UniteNearLoops()
{
  const TriangleMesh& mesh = this->Crossings_.Mesh();
  const Triangle& corners = mesh.Corners(this->Umbilic_);
  for (int i = 0; i < 3; ++i)
  {
    const double length = (mesh.Point(corners[i]) - mesh.Point(corners[(i + 1) % 3])).norm();
    this->Reach_ = std::max(this->Reach_, 0.5 * length);
  }
  std::vector<std::uint8_t> isFromHole(this->Sides_.size(), 0);
  std::vector<Trail> loops;
  for (const int start : this->AroundHole_)
  {
    const Trail trail = this->Follow(start);
    for (const int side : trail.sides)
    {
      isFromHole[side] = 1;
    }
    if (this->OnHole_[trail.sides.back()] > this->OnHole_[start] && this->IsNear(trail))
    {
      loops.push_back(trail);
    }
  }
  for (const Trail& loop : loops)
  {
    this->Unite(loop, isFromHole);
  }
}

bool PatchCurves::IsNear(const Trail& loop) const
{
  const Eigen::Vector3d umbilic = this->MiddleOf(loop.sides.front());
  return std::all_of(loop.sides.begin(), loop.sides.end(),
    [this, &umbilic](int side) { return (this->MiddleOf(side) - umbilic).norm() < this->Reach_; });
}

/// A loop with what passes by nearest to it, where both are in one triangle of the mesh.
void PatchCurves::Unite(const Trail& loop, const std::vector<std::uint8_t>& isFromHole)
{
  const auto ownerOf = [this](int side) -> Id
  {
    const Side& s = this->Sides_[side];
    const bool isInside =
      s.triangles[1] >= 0 && this->Refined_.PartBetween(s.corners[0], s.corners[1]).edge < 0;
    return isInside ? this->Refined_.OwnerOf(s.triangles[0]) : -1;
  };
  double least = this->Reach_;
  int ofLoop = -1;
  int beyond = -1;
  for (const int s : loop.sides)
  {
    const Id owner = ownerOf(s);
    for (std::size_t other = 0; owner >= 0 && other < this->Sides_.size(); ++other)
    {
      const auto t = static_cast<int>(other);
      if (!isFromHole[other] && ownerOf(t) == owner)
      {
        const double distance = (this->MiddleOf(s) - this->MiddleOf(t)).norm();
        if (distance < least)
        {
          least = distance;
          ofLoop = s;
          beyond = t;
        }
      }
    }
  }
  if (beyond < 0)
  {
    return;
  }
  for (int i = 0; i < 2; ++i)
  {
    const int outer = this->Sides_[ofLoop].corners[i];
    const int inner = this->Sides_[ofLoop].corners[1 - i];
    const std::vector<std::uint8_t> isReached = this->Flood(outer);
    for (const int near : this->Sides_[beyond].corners)
    {
      if (isReached[near])
      {
        // Each half of the one goes on in the half of the other on the same side of the way
        // between.
        const int a = this->TriangleAlong(ofLoop, inner);
        const int b = this->TriangleAlong(beyond, near);
        for (const int turn : { 0, 1 })
        {
          this->Switches_[{ ofLoop, a ^ turn }] = { beyond, b ^ turn };
          this->Switches_[{ beyond, b ^ turn }] = { ofLoop, a ^ turn };
        }
        return;
      }
    }
  }
}

/// The corners that can be reached from one near by without crossing a ridge.
std::vector<std::uint8_t> PatchCurves::Flood(int corner) const
{
  std::vector<std::vector<int>> next(static_cast<std::size_t>(this->Refined_.NumberOfCorners()));
  for (const RefinedPatch::Corners& corners : this->Refined_.Triangles())
  {
    for (int i = 0; i < 3; ++i)
    {
      next[corners[i]].push_back(corners[(i + 1) % 3]);
      next[corners[(i + 1) % 3]].push_back(corners[i]);
    }
  }
  const Eigen::Vector3d center = this->Refined_.Position(corner);
  std::vector<std::uint8_t> isReached(next.size(), 0);
  std::vector<int> reached{ corner };
  isReached[corner] = 1;
  for (std::size_t i = 0; i < reached.size(); ++i)
  {
    const int v = reached[i];
    for (const int w : next[v])
    {
      if (!isReached[w] && this->NumberOf_.count(RefinedPatch::Key(v, w)) == 0 &&
        (this->Refined_.Position(w) - center).norm() < 2.0 * this->Reach_)
      {
        isReached[w] = 1;
        reached.push_back(w);
      }
    }
  }
  return isReached;
}

/// Which of its two triangles runs along a side from this corner: that on the left.
int PatchCurves::TriangleAlong(int side, int from) const
{
  const Side& s = this->Sides_[side];
  const int to = s.corners[0] == from ? s.corners[1] : s.corners[0];
  const RefinedPatch::Corners& corners = this->Refined_.Triangles()[s.triangles[0]];
  for (int i = 0; i < 3; ++i)
  {
    if (corners[i] == from && corners[(i + 1) % 3] == to)
    {
      return 0;
    }
  }
  return 1;
}

/// The rays around the hole between which a ridge from the umbilic to itself starts and ends, on
/// the side where no other one does: from the first on to the last.
std::pair<int, int> PatchCurves::RaysOf(const Trail& loop) const
{
  const auto count = static_cast<int>(this->Refined_.Rings().back().size());
  const int i = this->OnHole_[loop.sides.front()];
  const int j = this->OnHole_[loop.sides.back()];
  const int first = std::min(i, j);
  const int last = std::max(i, j);
  const bool isFree = std::none_of(this->AroundHole_.begin(), this->AroundHole_.end(),
    [this, first, last](int side)
    { return this->OnHole_[side] > first && this->OnHole_[side] < last; });
  return isFree ? std::make_pair(first + 1, last) : std::make_pair(last + 1, first + count);
}

/// A ridge from the umbilic to itself within its triangle: out over an edge and back, as ridges
/// have their points on edges.
bool PatchCurves::LeadOverBorder(const Trail& loop, std::vector<EdgeCrossing>& path) const
{
  const std::vector<int>& border = this->Refined_.Rings().front();
  const auto count = static_cast<int>(border.size());
  const auto [first, last] = this->RaysOf(loop);
  const int length = last - first + 1;
  // The middle first.
  for (int k = 0; k <= length; ++k)
  {
    const int i = first + length / 2 + (k % 2 == 0 ? k / 2 : -(k + 1) / 2);
    const int v = border[(i + count - 1) % count];
    const int w = border[(i + count) % count];
    const auto part = this->Refined_.PartBetween(v, w);
    if (part.edge >= 0 && !this->Refined_.IsCrossed(v, w) &&
      this->Contour_.Across(this->Umbilic_, part.edge) >= 0)
    {
      const double step = part.to - part.from;
      path = { { part.edge, part.from + 0.25 * step }, { part.edge, part.from + 0.75 * step } };
      return true;
    }
  }
  return false;
}

} // namespace ridges
