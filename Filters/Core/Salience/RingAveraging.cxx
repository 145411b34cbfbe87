// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Salience/RingAveraging.h"

#include "Mesh/CurveOrder.h"

#include <numeric>
#include <utility>

namespace ridges
{

template <int Components>
RingAveraging<Components>::RingAveraging(const OneRings& rings, bool hasBoxes)
  : Rings_(rings)
  , Now_(static_cast<std::size_t>(Stride) * rings.Mesh().NumberOfPoints())
  , Next_(static_cast<std::size_t>(Stride) * rings.Mesh().NumberOfPoints())
  , Sum_(hasBoxes ? static_cast<std::size_t>(Stride) * rings.Mesh().NumberOfPoints() : 0)
  , Areas_(rings.Mesh().NumberOfPoints())
  , Own_(rings.Mesh().NumberOfPoints())
  , Ring_(rings.Mesh().NumberOfPoints())
{
  this->SetPlaces(hasBoxes);
}

template <int Components>
void RingAveraging<Components>::SetPlaces(bool alongCurve)
{
  const Id count = this->Rings_.Mesh().NumberOfPoints();
  std::vector<Id> points;
  if (alongCurve)
  {
    points = PointsAlongCurve(this->Rings_.Mesh());
  }
  else
  {
    points.resize(count);
    std::iota(points.begin(), points.end(), Id{ 0 });
  }
  this->Places_.resize(count);
  this->Begins_.reserve(static_cast<std::size_t>(count) + 1);
  Id begin = 0;
  for (Id place = 0; place < count; ++place)
  {
    this->Places_[points[place]] = place;
    this->Begins_.push_back(begin);
    begin += this->Rings_.Around(points[place]).size();
  }
  this->Begins_.push_back(begin);
  this->Neighbors_.reserve(begin);
  for (const Id p : points)
  {
    for (const Id q : this->Rings_.Around(p))
    {
      this->Neighbors_.push_back(this->Places_[q]);
    }
  }
}

template <int Components>
void RingAveraging<Components>::Set(Id p, const Values& values, bool counts)
{
  const double area = counts ? this->Rings_.Area(p) : 0.0;
  const Id place = this->Places_[p];
  this->Areas_[place] = area;
  double* now = this->At(this->Now_, place);
  for (int i = 0; i < Components; ++i)
  {
    now[i] = counts ? area * values[i] : 0.0;
  }
}

template <int Components>
void RingAveraging<Components>::Prepare(Id p, double share)
{
  const Id place = this->Places_[p];
  const double area = this->Areas_[place];
  double sum = area;
  for (Id i = this->Begins_[place]; i < this->Begins_[place + 1]; ++i)
  {
    sum += this->Areas_[this->Neighbors_[i]];
  }
  this->Own_[place] = 1.0 - share;
  this->Ring_[place] = sum > 0.0 ? share * area / sum : 0.0;
}

template <int Components>
void RingAveraging<Components>::Step(Id begin, Id end, const AveragingSweep& sweep)
{
  const double whole = sweep.step == sweep.length ? 1.0 / (2.0 * sweep.length + 1.0) : 1.0;
  for (Id place = begin; place < end; ++place)
  {
    const double* own = this->At(this->Now_, place);
    double sum[Components];
    for (int i = 0; i < Components; ++i)
    {
      sum[i] = own[i];
    }
    for (Id n = this->Begins_[place]; n < this->Begins_[place + 1]; ++n)
    {
      const double* other = this->At(this->Now_, this->Neighbors_[n]);
      for (int i = 0; i < Components; ++i)
      {
        sum[i] += other[i];
      }
    }
    const double stays = this->Own_[place];
    const double taken = this->Ring_[place];
    double* next = this->At(this->Next_, place);
    if (sweep.step == 0)
    {
      for (int i = 0; i < Components; ++i)
      {
        next[i] = stays * own[i] + taken * sum[i];
      }
      continue;
    }
    double* box = this->At(this->Sum_, place);
    for (int i = 0; i < Components; ++i)
    {
      const double average = stays * own[i] + taken * sum[i];
      // T_(k+1)(A) x = 2 A T_k(A) x - T_(k-1)(A) x.
      const double chebyshev = sweep.step > 1 ? 2.0 * average - next[i] : average;
      const double soFar = sweep.step > 1 ? box[i] : own[i];
      next[i] = chebyshev;
      box[i] = whole * (soFar + 2.0 * chebyshev);
    }
  }
}

template <int Components>
void RingAveraging<Components>::Swap(const AveragingSweep& sweep)
{
  const bool endsBox = sweep.step > 0 && sweep.step == sweep.length;
  std::swap(this->Now_, endsBox ? this->Sum_ : this->Next_);
}

template <int Components>
bool RingAveraging<Components>::Get(Id p, Values& values) const
{
  const Id place = this->Places_[p];
  const double area = this->Areas_[place];
  const double* now = this->Now_.data() + static_cast<std::size_t>(Stride) * place;
  for (int i = 0; i < Components; ++i)
  {
    values[i] = area > 0.0 ? now[i] / area : 0.0;
  }
  return area > 0.0;
}

template class RingAveraging<9>;
template class RingAveraging<21>;
template class RingAveraging<34>;

} // namespace ridges
