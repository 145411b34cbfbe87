// SPDX-License-Identifier: BSD-3-Clause
#include "RingNeighborhood.h"

#include <algorithm>

namespace ridges
{

RingNeighborhood::RingNeighborhood(const TriangleMesh& mesh)
  : Mesh_(mesh)
  , Stamps_(mesh.NumberOfPoints(), 0)
{
}

template <typename Accept>
bool RingNeighborhood::AddRing(Accept accept)
{
  const Id ringEnd = static_cast<Id>(this->Points_.size());
  for (Id i = this->RingBegin_; i < ringEnd; ++i)
  {
    for (const Id t : this->Mesh_.TrianglesAround(this->Points_[i]))
    {
      for (const Id p : this->Mesh_.Corners(t))
      {
        if (this->Stamps_[p] != this->Stamp_ && accept(p))
        {
          this->Stamps_[p] = this->Stamp_;
          this->Points_.push_back(p);
        }
      }
    }
  }
  this->RingBegin_ = ringEnd;
  return static_cast<Id>(this->Points_.size()) > ringEnd;
}

Span<Id> RingNeighborhood::Gather(Id vertex, const NeighborhoodRule& rule)
{
  if (++this->Stamp_ == 0)
  {
    std::fill(this->Stamps_.begin(), this->Stamps_.end(), 0);
    this->Stamp_ = 1;
  }
  this->Points_.assign(1, vertex);
  this->Stamps_[vertex] = this->Stamp_;
  this->RingBegin_ = 0;
  this->NumberOfRings_ = 0;

  const auto any = [](Id) { return true; };
  switch (rule.kind)
  {
    case NeighborhoodRule::Kind::PointCount:
      while (
        static_cast<Id>(this->Points_.size()) < rule.minimumNumberOfPoints && this->AddRing(any))
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
  return this->Sorted();
}

Span<Id> RingNeighborhood::Grow()
{
  // Sorting has mixed the rings, so that the next one is sought around all points.
  this->RingBegin_ = 0;
  this->NumberOfRings_ += this->AddRing([](Id) { return true; }) ? 1 : 0;
  return this->Sorted();
}

Span<Id> RingNeighborhood::Sorted()
{
  const Eigen::Vector3d center = this->Mesh_.Point(this->Points_.front());
  this->Ranked_.clear();
  for (auto p = this->Points_.begin() + 1; p != this->Points_.end(); ++p)
  {
    this->Ranked_.push_back({ (this->Mesh_.Point(*p) - center).squaredNorm(), *p });
  }
  std::sort(this->Ranked_.begin(), this->Ranked_.end(),
    [this](const Ranked& a, const Ranked& b)
    {
      if (a.squaredDistance != b.squaredDistance)
      {
        return a.squaredDistance < b.squaredDistance;
      }
      const auto p = this->Mesh_.Point(a.point);
      const auto q = this->Mesh_.Point(b.point);
      return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
    });
  std::transform(this->Ranked_.begin(), this->Ranked_.end(), this->Points_.begin() + 1,
    [](const Ranked& ranked) { return ranked.point; });
  return { this->Points_.data(), this->Points_.data() + this->Points_.size() };
}

} // namespace ridges
