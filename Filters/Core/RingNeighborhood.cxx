// SPDX-License-Identifier: BSD-3-Clause
#include "RingNeighborhood.h"

#include <algorithm>
#include <type_traits>

namespace ridges
{
namespace
{

/// Accepts any point.
struct All
{
  bool operator()(Id) const { return true; }
};

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
  const std::uint32_t stamp = this->Stamp_;
  std::uint32_t* stamps = this->Stamps_.data();
  Id count = ringEnd;
  for (Id i = this->RingBegin_; i < ringEnd; ++i)
  {
    const Id center = this->Points_[i];
    const Span<Id> neighbors = this->Rings_.IsRegular(center) ? this->Rings_.Around(center)
                                                              : this->NeighborsOfIrregular(center);
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
  return count > ringEnd;
}

Span<Id> RingNeighborhood::NeighborsOfIrregular(Id p)
{
  // No fan to follow: by distance, and at one distance by coordinates.
  std::vector<Id>& neighbors = this->Irregular_;
  neighbors.clear();
  for (const Id t : this->Mesh_.TrianglesAround(p))
  {
    const Triangle& corners = this->Mesh_.Corners(t);
    neighbors.insert(neighbors.end(), corners.begin(), corners.end());
  }
  const auto center = this->Mesh_.Point(p);
  std::sort(neighbors.begin(), neighbors.end(),
    [&](Id q, Id r)
    {
      const auto x = this->Mesh_.Point(q);
      const auto y = this->Mesh_.Point(r);
      const double distanceX = (x - center).squaredNorm();
      const double distanceY = (y - center).squaredNorm();
      return distanceX != distanceY
        ? distanceX < distanceY
        : std::lexicographical_compare(x.data(), x.data() + 3, y.data(), y.data() + 3);
    });
  return { neighbors.data(), neighbors.data() + neighbors.size() };
}

Span<Id> RingNeighborhood::Gather(Id vertex, const NeighborhoodRule& rule)
{
  if (++this->Stamp_ == 0)
  {
    std::fill(this->Stamps_.begin(), this->Stamps_.end(), 0);
    this->Stamp_ = 1;
  }
  if (this->Points_.empty())
  {
    this->Points_.resize(64);
  }
  this->Points_[0] = vertex;
  this->Count_ = 1;
  this->Stamps_[vertex] = this->Stamp_;
  this->RingBegin_ = 0;
  this->NumberOfRings_ = 0;

  const All any;
  switch (rule.kind)
  {
    case NeighborhoodRule::Kind::PointCount:
      while (this->Count_ < rule.minimumNumberOfPoints && this->AddRing(any))
      {
        ++this->NumberOfRings_;
      }
      break;
    case NeighborhoodRule::Kind::Rings:
      while (this->NumberOfRings_ < rule.numberOfRings && this->AddRing(any))
      {
        ++this->NumberOfRings_;
      }
      break;
    case NeighborhoodRule::Kind::RingsAndPointCount:
      while (
        (this->NumberOfRings_ < rule.numberOfRings || this->Count_ < rule.minimumNumberOfPoints) &&
        this->AddRing(any))
      {
        ++this->NumberOfRings_;
      }
      break;
    case NeighborhoodRule::Kind::Radius:
    {
      const Eigen::Vector3d center = this->Mesh_.Point(vertex);
      const double squaredRadius = rule.radius * rule.radius;
      const auto inside = [&](Id p)
      { return (this->Mesh_.Point(p) - center).squaredNorm() <= squaredRadius; };
      while (this->AddRing(inside))
      {
      }
      break;
    }
  }
  return { this->Points_.data(), this->Points_.data() + this->Count_ };
}

Span<Id> RingNeighborhood::Grow()
{
  this->NumberOfRings_ += this->AddRing(All()) ? 1 : 0;
  return { this->Points_.data(), this->Points_.data() + this->Count_ };
}

} // namespace ridges
