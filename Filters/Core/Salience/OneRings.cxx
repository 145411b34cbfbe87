// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Salience/OneRings.h"

#include "Mesh/PositionOrder.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>

namespace ridges
{

OneRings::OneRings(const TriangleMesh& mesh, const OrderedRings& rings)
  : Mesh_(mesh)
  , Rings_(rings)
  , Areas_(mesh.NumberOfPoints())
{
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    if (!rings.IsRegular(p) && mesh.TrianglesAround(p).size() > 0)
    {
      this->AddIrregular(p);
    }
  }
  this->IrregularBegins_.push_back(static_cast<Id>(this->IrregularNeighbors_.size()));
}

void OneRings::AddIrregular(Id p)
{
  const std::size_t begin = this->IrregularNeighbors_.size();
  this->IrregularPoints_.push_back(p);
  this->IrregularBegins_.push_back(static_cast<Id>(begin));
  for (const Id t : this->Mesh_.TrianglesAround(p))
  {
    for (const Id q : this->Mesh_.Corners(t))
    {
      if (q != p)
      {
        this->IrregularNeighbors_.push_back(q);
      }
    }
  }
  const auto first = this->IrregularNeighbors_.begin() + static_cast<std::ptrdiff_t>(begin);
  std::sort(first, this->IrregularNeighbors_.end(),
    [this](Id a, Id b) {
      return PointComesBefore(this->Mesh_, a, b) || (!PointComesBefore(this->Mesh_, b, a) && a < b);
    });
  this->IrregularNeighbors_.erase(
    std::unique(first, this->IrregularNeighbors_.end()), this->IrregularNeighbors_.end());
}

Span<Id> OneRings::AroundIrregular(Id p) const
{
  const auto found =
    std::lower_bound(this->IrregularPoints_.begin(), this->IrregularPoints_.end(), p);
  if (found == this->IrregularPoints_.end() || *found != p)
  {
    return {};
  }
  const auto i = static_cast<std::size_t>(found - this->IrregularPoints_.begin());
  const Id* base = this->IrregularNeighbors_.data();
  return { base + this->IrregularBegins_[i], base + this->IrregularBegins_[i + 1] };
}

void OneRings::Build(Id begin, Id end)
{
  for (Id p = begin; p < end; ++p)
  {
    this->Areas_[p] = this->IsFan(p) ? this->AreaOfFan(p) : this->AreaOfTriangles(p);
  }
}

double OneRings::AreaOfFan(Id p) const
{
  const Span<Id> ring = this->Rings_.Around(p);
  const Eigen::Vector3d center = this->Mesh_.Point(p);
  const Eigen::Vector3d first = this->Mesh_.Point(ring[0]) - center;
  Eigen::Vector3d before = first;
  double twice = 0.0;
  for (Id i = 1; i < ring.size(); ++i)
  {
    const Eigen::Vector3d next = this->Mesh_.Point(ring[i]) - center;
    twice += before.cross(next).norm();
    before = next;
  }
  if (this->IsClosed(p))
  {
    twice += before.cross(first).norm();
  }
  return twice / 6.0;
}

Eigen::Vector3d OneRings::AreaNormal(Id p) const
{
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  if (!this->IsFan(p))
  {
    return normal;
  }
  const Span<Id> ring = this->Rings_.Around(p);
  const Eigen::Vector3d center = this->Mesh_.Point(p);
  Eigen::Vector3d before = this->Mesh_.Point(ring[0]) - center;
  for (Id i = 1; i < ring.size() + (this->IsClosed(p) ? 1 : 0); ++i)
  {
    const Eigen::Vector3d next = this->Mesh_.Point(ring[i % ring.size()]) - center;
    normal += before.cross(next);
    before = next;
  }
  return normal;
}

double OneRings::AreaOfTriangles(Id p) const
{
  std::vector<double> areas;
  for (const Id t : this->Mesh_.TrianglesAround(p))
  {
    areas.push_back(this->Mesh_.AreaNormal(t).norm());
  }
  std::sort(areas.begin(), areas.end()); // so that the numbering does not change the sum
  return std::accumulate(areas.begin(), areas.end(), 0.0) / 6.0;
}

double OneRings::Variance(Id p) const
{
  const Eigen::Vector3d center = this->Mesh_.Point(p);
  double weights = this->Areas_[p];
  double sum = 0.0;
  for (const Id q : this->Around(p))
  {
    weights += this->Areas_[q];
    sum += this->Areas_[q] * (this->Mesh_.Point(q) - center).squaredNorm();
  }
  return weights > 0.0 ? 0.5 * sum / weights : 0.0;
}

} // namespace ridges
