// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/RingNeighborhood.h"

#include "Mesh/PositionOrder.h"

#include <algorithm>
#include <type_traits>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace ridges
{
namespace
{

/// Accepts any point.
struct All
{
  bool operator()(Id) const { return true; }
};

constexpr Id LargestSmallFan = OrderedRings::ReadableIds;

/// The first place of an id among eight; 8 if it is not there. Without branches, as the place is
/// as good as random.
Id PlaceAmongEight(const Id* ids, Id wanted)
{
  static_assert(LargestSmallFan == 8);
#ifdef __SSE2__
  const __m128i all = _mm_set1_epi32(wanted);
  const auto equal = [all](const Id* four)
  { return _mm_cmpeq_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(four)), all); };
  const __m128i words = _mm_packs_epi32(equal(ids), equal(ids + 4));
  const int found = _mm_movemask_epi8(_mm_packs_epi16(words, words));
  return __builtin_ctz(static_cast<unsigned>(found) | 0x100U);
#else
  return static_cast<Id>(std::find(ids, ids + 8, wanted) - ids);
#endif
}

bool IsEnough(const NeighborhoodRule& rule, int rings, Id count)
{
  const bool enoughPoints = count >= rule.minimumNumberOfPoints;
  const bool enoughRings = rings >= rule.numberOfRings;
  switch (rule.kind)
  {
    case NeighborhoodRule::Kind::PointCount:
      return enoughPoints;
    case NeighborhoodRule::Kind::Rings:
      return enoughRings;
    default:
      return enoughPoints && enoughRings;
  }
}

} // namespace

RingNeighborhood::RingNeighborhood(const TriangleMesh& mesh, const OrderedRings& rings)
  : Mesh_(mesh)
  , Rings_(rings)
  , Stamps_(mesh.NumberOfPoints(), 0)
{
}

template <typename Accept>
bool RingNeighborhood::AddRing(Accept accept)
{
  constexpr bool all = std::is_same_v<Accept, All>;
  const Id ringEnd = this->Count_;
  const std::uint16_t stamp = this->Stamp_;
  std::uint16_t* stamps = this->Stamps_.data();
  Id count = ringEnd;
  bool isInRings = this->IsInRings_;
  for (Id i = this->RingBegin_; i < ringEnd; ++i)
  {
    const Id center = this->Points_[i];
    isInRings = isInRings && !this->Rings_.StartsAtAny(center);
    const Span<Id> ring = this->Rings_.Around(center);
    const Span<Id> neighbors = ring.size() > 0 ? ring : this->NeighborsOfIrregular(center);
    const std::size_t room = static_cast<std::size_t>(count) + neighbors.size();
    if (this->Points_.size() < room)
    {
      this->Points_.resize(2 * room);
    }
    // Without a branch on what is new: that is as good as random.
    Id* points = this->Points_.data();
    for (const Id p : neighbors)
    {
      const bool isNew = stamps[p] != stamp && accept(p);
      points[count] = p;
      count += isNew ? 1 : 0;
      stamps[p] = all || isNew ? stamp : stamps[p];
    }
  }
  this->Count_ = count;
  this->RingBegin_ = ringEnd;
  this->IsInRings_ = this->IsInRings_ && isInRings;
  this->RingsWalked_ += count > ringEnd ? 1 : 0;
  this->Reach_ = std::max(this->Reach_, this->RingsWalked_);
  return count > ringEnd;
}

/// By distance from the center, then by position, and in one place by what lies around them: points
/// at one place have normals of their own.
bool RingNeighborhood::ComesBefore(Id center, Id p, Id q) const
{
  const auto x = this->Mesh_.Point(p);
  const auto y = this->Mesh_.Point(q);
  const double distanceX = (x - this->Mesh_.Point(center)).squaredNorm();
  const double distanceY = (y - this->Mesh_.Point(center)).squaredNorm();
  return distanceX != distanceY ? distanceX < distanceY : PointComesBefore(this->Mesh_, p, q);
}

Span<Id> RingNeighborhood::NeighborsOfIrregular(Id p)
{
  // No fan to follow.
  std::vector<Id>& neighbors = this->Irregular_;
  neighbors.clear();
  for (const Id t : this->Mesh_.TrianglesAround(p))
  {
    const Triangle& corners = this->Mesh_.Corners(t);
    neighbors.insert(neighbors.end(), corners.begin(), corners.end());
  }
  std::sort(neighbors.begin(), neighbors.end(),
    [this, p](Id q, Id r) { return q != r && this->ComesBefore(p, q, r); });
  neighbors.erase(std::unique(neighbors.begin(), neighbors.end()), neighbors.end());
  for (std::size_t i = 1; i < neighbors.size(); ++i)
  {
    const bool shareAPlace = this->Mesh_.Point(neighbors[i]) == this->Mesh_.Point(neighbors[i - 1]);
    this->IsInRings_ = this->IsInRings_ && !shareAPlace;
  }
  return { neighbors.data(), neighbors.data() + neighbors.size() };
}

/// The points that were gathered.
Span<Id> RingNeighborhood::Result()
{
  const Id* points = this->Points_.data();
  if (this->IsInRings_)
  {
    return { points, points + this->Count_ };
  }
  this->Sorted_.assign(points, points + this->Count_);
  std::sort(this->Sorted_.begin() + 1, this->Sorted_.end(),
    [this](Id p, Id q) { return this->ComesBefore(this->Sorted_.front(), p, q); });
  return { this->Sorted_.data(), this->Sorted_.data() + this->Count_ };
}

void RingNeighborhood::Begin(Id vertex)
{
  if (++this->Stamp_ == 0)
  {
    std::fill(this->Stamps_.begin(), this->Stamps_.end(), std::uint16_t{ 0 });
    this->Stamp_ = 1;
  }
  if (this->Points_.empty())
  {
    this->Points_.resize(2 * LargestSmallFan * LargestSmallFan);
  }
  this->Points_[0] = vertex;
  this->Count_ = 1;
  this->Stamps_[vertex] = this->Stamp_;
  this->RingBegin_ = 0;
  this->NumberOfRings_ = 0;
  this->RingsWalked_ = 0;
  this->IsInRings_ = !this->Rings_.StartsAtAny(vertex);
}

/// The first two rings at once, where all fans are closed and of the usual sizes, and no point is
/// met twice; else false, with nothing done. The fan of a neighbour goes from the vertex to the
/// neighbour before, and then along the second ring, where its first point is the last of the
/// neighbour before. So which points are new is known from the fans, and stamps only prove it.
bool RingNeighborhood::AddTwoRings()
{
  Id* points = this->Points_.data();
  const Id vertex = points[0];
  const Span<Id> fan = this->Rings_.Around(vertex);
  bool good = this->Rings_.IsClosed(vertex) && fan.size() <= LargestSmallFan;
  if (!good)
  {
    return false;
  }
  std::copy(fan.begin(), fan.end(), points + 1);
  Id* end = points + 1 + fan.size();
  for (const Id neighbor : fan)
  {
    const Span<Id> around = this->Rings_.Around(neighbor);
    const Id size = around.size();
    const Id place = PlaceAmongEight(around.begin(), vertex) + 3;
    good = good && this->Rings_.IsClosed(neighbor) && size >= 4 && size <= LargestSmallFan;
    // As many as there may be, and then only those that there are.
    for (Id i = 0; i < LargestSmallFan - 4; ++i)
    {
      const Id next = place + i - (place + i >= size ? size : 0);
      end[i] = around.begin()[next & (LargestSmallFan - 1)];
    }
    end += good ? size - 4 : 0;
  }
  // Where all of the second ring is one point, each neighbour leaves it to the one before.
  if (!good || end == points + 1 + fan.size())
  {
    return false;
  }
  const auto count = static_cast<Id>(end - points);
  bool metTwice = false;
  for (Id i = 1; i < count; ++i)
  {
    std::uint16_t& stamp = this->Stamps_[points[i]];
    metTwice |= stamp == this->Stamp_;
    stamp = this->Stamp_;
  }
  if (metTwice)
  {
    this->Begin(vertex);
    return false;
  }
  this->Count_ = count;
  this->RingBegin_ = 1 + fan.size();
  this->NumberOfRings_ = 2;
  this->RingsWalked_ = 2;
  this->Reach_ = std::max(this->Reach_, 2);
  return true;
}

/// Rings until there are enough of them, or points; inside the ball, if it is by radius.
template <typename Accept>
void RingNeighborhood::AddRings(const NeighborhoodRule& rule, Accept accept)
{
  if (rule.kind == NeighborhoodRule::Kind::Radius)
  {
    const Eigen::Vector3d center = this->Mesh_.Point(this->Points_[0]);
    const double squaredRadius = rule.radius * rule.radius;
    const auto inside = [this, &center, squaredRadius, &accept](Id p)
    { return (this->Mesh_.Point(p) - center).squaredNorm() <= squaredRadius && accept(p); };
    while (this->AddRing(inside))
    {
    }
    return;
  }
  while (!IsEnough(rule, this->NumberOfRings_, this->Count_) && this->AddRing(accept))
  {
    ++this->NumberOfRings_;
  }
}

Span<Id> RingNeighborhood::Gather(Id vertex, const NeighborhoodRule& rule)
{
  this->Begin(vertex);
  if (rule.kind != NeighborhoodRule::Kind::Radius &&
    !IsEnough(rule, 1, 1 + this->Rings_.Around(vertex).size()))
  {
    this->AddTwoRings();
  }
  this->AddRings(rule, All());
  return this->Result();
}

Span<Id> RingNeighborhood::Gather(
  Id vertex, const NeighborhoodRule& rule, const std::function<bool(Id)>& isAccepted)
{
  this->Begin(vertex);
  this->AddRings(rule, [&isAccepted](Id p) { return isAccepted(p); });
  return this->Result();
}

Span<Id> RingNeighborhood::Grow()
{
  this->NumberOfRings_ += this->AddRing(All()) ? 1 : 0;
  return this->Result();
}

} // namespace ridges
