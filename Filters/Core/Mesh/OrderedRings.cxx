// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/OrderedRings.h"

#include "Mesh/PositionOrder.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>

namespace ridges
{
namespace
{

std::vector<Id> NeighborsOf(const TriangleMesh& mesh, Id p)
{
  std::vector<Id> neighbors;
  for (const Id t : mesh.TrianglesAround(p))
  {
    const Triangle& corners = mesh.Corners(t);
    std::copy_if(
      corners.begin(), corners.end(), std::back_inserter(neighbors), [p](Id q) { return q != p; });
  }
  std::sort(neighbors.begin(), neighbors.end());
  return neighbors;
}

} // namespace

OrderedRings::OrderedRings(const TriangleMesh& mesh)
  : Mesh_(mesh)
  , Rings_(
      3 * static_cast<std::size_t>(mesh.NumberOfTriangles()) + mesh.NumberOfPoints() + ReadableIds)
  , Sizes_(mesh.NumberOfPoints(), 0)
  , Kinds_(mesh.NumberOfPoints(), Kind::Irregular)
{
  std::fill(this->Rings_.end() - ReadableIds, this->Rings_.end(), -1);
}

void OrderedRings::Build(Id begin, Id end)
{
  for (Id p = begin; p < end; ++p)
  {
    Id* ring = this->Rings_.data() + this->Offset(p);
    if (this->BuildSmallRing(p, ring, this->Kinds_[p]))
    {
      this->Sizes_[p] = static_cast<std::uint8_t>(this->Mesh_.TrianglesAround(p).size());
    }
    else
    {
      this->Kinds_[p] = this->BuildRing(p, ring, this->Sizes_[p]);
    }
  }
}

bool OrderedRings::HasIrregular() const
{
  for (Id p = 0; p < this->Mesh_.NumberOfPoints(); ++p)
  {
    if (!this->IsRegular(p) && this->Mesh_.TrianglesAround(p).size() > 0)
    {
      return true;
    }
  }
  return false;
}

/// The ring of a point in at most eight triangles that form a closed fan, as nearly all do; false
/// for any other. Nothing here branches on how the triangles happen to be stored, which no
/// processor could foresee.
bool OrderedRings::BuildSmallRing(Id p, Id* ring, Kind& kind) const
{
  constexpr Id most = 8;
  const Span<Id> triangles = this->Mesh_.TrianglesAround(p);
  const Id count = triangles.size();
  if (count < 3 || count > most)
  {
    return false;
  }
  std::array<Id, most> from;
  std::array<Id, most> to;
  std::array<double, most> x;
  from.fill(-1);
  double least = std::numeric_limits<double>::infinity();
  for (Id i = 0; i < count; ++i)
  {
    const Triangle& c = this->Mesh_.Corners(triangles[i]);
    from[i] = c[0] == p ? c[1] : (c[1] == p ? c[2] : c[0]);
    to[i] = c[0] == p ? c[2] : (c[1] == p ? c[0] : c[1]);
    x[i] = this->Mesh_.Point(from[i]).x();
    least = std::min(least, x[i]);
  }

  // Which triangle begins where each ends: 0 if none does, above 15 if more than one.
  std::array<Id, most> next;
  Id start = 0;
  Id leftmost = 0;
  for (Id i = 0; i < count; ++i)
  {
    Id sum = 0;
    for (Id j = 0; j < most; ++j)
    {
      sum += from[j] == to[i] ? 8 + j : 0;
    }
    next[i] = sum;
    start = x[i] == least ? i : start;
    leftmost += x[i] == least ? 1 : 0;
  }
  kind = Kind::Closed;
  if (leftmost > 1)
  {
    start = this->FirstOf(from.data(), count, kind);
  }
  Id i = start;
  bool closed = true;
  for (Id length = 1; length <= count; ++length)
  {
    *ring++ = from[i];
    closed = closed && next[i] >= 8 && next[i] < 16;
    i = next[i] & 7;
    closed = closed && ((i == start) == (length == count));
  }
  return closed;
}

OrderedRings::Kind OrderedRings::BuildRing(Id p, Id* ring, std::uint8_t& size) const
{
  // Each triangle at p leads from one neighbour to the next.
  std::array<Id, LargestFan> from{};
  std::array<Id, LargestFan> to{};
  const Span<Id> triangles = this->Mesh_.TrianglesAround(p);
  const Id count = triangles.size();
  size = 0;
  if (count == 0 || count > LargestFan)
  {
    size = static_cast<std::uint8_t>(count == 0 ? 0 : this->PickEvenly(p, ring));
    return this->KindOfIrregular(p);
  }
  for (Id i = 0; i < count; ++i)
  {
    const Triangle& c = this->Mesh_.Corners(triangles[i]);
    const int corner = c[0] == p ? 0 : (c[1] == p ? 1 : 2);
    from[i] = c[(corner + 1) % 3];
    to[i] = c[(corner + 2) % 3];
  }
  // An edge that two triangles run through in one direction is not in a regular fan.
  for (Id i = 1; i < count; ++i)
  {
    if (std::find(from.begin(), from.begin() + i, from[i]) != from.begin() + i)
    {
      return this->KindOfIrregular(p);
    }
  }

  // The chain from the first triangle on grows at its end, or, where it cannot, at its beginning.
  for (Id length = 1; length < count; ++length)
  {
    const auto rest = from.begin() + length;
    const auto next = std::find(rest, from.begin() + count, to[length - 1]);
    if (next != from.begin() + count)
    {
      std::iter_swap(rest, next);
      std::swap(to[length], to[next - from.begin()]);
      continue;
    }
    const auto before = std::find(to.begin() + length, to.begin() + count, from[0]);
    if (before == to.begin() + count)
    {
      return this->KindOfIrregular(p);
    }
    const auto index = before - to.begin();
    std::rotate(from.begin(), from.begin() + index, from.begin() + index + 1);
    std::rotate(to.begin(), to.begin() + index, to.begin() + index + 1);
  }

  size = static_cast<std::uint8_t>(count);
  if (to[count - 1] != from[0])
  {
    if (std::find(from.begin(), from.begin() + count, to[count - 1]) != from.begin() + count)
    {
      size = 0;
      return this->KindOfIrregular(p);
    }
    std::copy_n(from.begin(), count, ring);
    ring[count] = to[count - 1];
    ++size;
    return Kind::Open;
  }
  Kind kind = Kind::Closed;
  const Id start = this->FirstOf(from.data(), count, kind);
  std::rotate_copy(from.begin(), from.begin() + start, from.begin() + count, ring);
  return kind;
}

/// Where the first of some points by position is among them, and whether there is only one.
Id OrderedRings::FirstOf(const Id* points, Id size, Kind& kind) const
{
  const auto comesBefore = [this](Id p, Id q)
  { return ComesBefore(this->Mesh_.Point(p), this->Mesh_.Point(q)); };
  const Id* first = std::min_element(points, points + size, comesBefore);
  const auto isThere = [this, first](Id p)
  { return this->Mesh_.Point(p) == this->Mesh_.Point(*first); };
  kind = std::count_if(points, points + size, isThere) > 1 ? Kind::ClosedFromAny : Kind::Closed;
  return static_cast<Id>(first - points);
}

/// Always the neighbour whose direction is farthest from those of the ones before, the first by
/// position in the beginning.
Id OrderedRings::PickEvenly(Id p, Id* ring) const
{
  struct Candidate
  {
    Id point;
    Eigen::Vector3d direction;
    double distance;
  };
  std::vector<Id> neighbors = NeighborsOf(this->Mesh_, p);
  neighbors.erase(std::unique(neighbors.begin(), neighbors.end()), neighbors.end());
  std::vector<Candidate> candidates;
  candidates.reserve(neighbors.size());
  for (const Id q : neighbors)
  {
    const Eigen::Vector3d offset = this->Mesh_.Point(q) - this->Mesh_.Point(p);
    candidates.push_back({ q, offset.stableNormalized(), std::numeric_limits<double>::infinity() });
  }
  const auto isBetter = [this](const Candidate& a, const Candidate& b)
  {
    return a.distance != b.distance ? a.distance > b.distance
                                    : PointComesBefore(this->Mesh_, a.point, b.point);
  };
  Id size = 0;
  for (const Id most = std::min(NeighborsOfLargeFan, static_cast<Id>(candidates.size()));
       size < most; ++size)
  {
    const Candidate best = *std::min_element(candidates.begin(), candidates.end(), isBetter);
    ring[size] = best.point;
    for (Candidate& candidate : candidates)
    {
      candidate.distance =
        std::min(candidate.distance, (candidate.direction - best.direction).squaredNorm());
    }
  }
  return size;
}

OrderedRings::Kind OrderedRings::KindOfIrregular(Id p) const
{
  const std::vector<Id> neighbors = NeighborsOf(this->Mesh_, p);
  for (std::size_t i = 0; i < neighbors.size(); i += 2)
  {
    const bool inTwoTriangles = i + 1 < neighbors.size() && neighbors[i] == neighbors[i + 1] &&
      (i + 2 == neighbors.size() || neighbors[i + 2] != neighbors[i]);
    if (!inTwoTriangles)
    {
      return Kind::IrregularOnBorder;
    }
  }
  return Kind::Irregular;
}

} // namespace ridges
