// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Salience/RingAveraging.h"

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
}

template <int Components>
void RingAveraging<Components>::Set(Id p, const Values& values, bool counts)
{
  const double area = counts ? this->Rings_.Area(p) : 0.0;
  this->Areas_[p] = area;
  double* now = this->Now_.data() + static_cast<std::size_t>(Stride) * p;
  for (int i = 0; i < Components; ++i)
  {
    now[i] = counts ? area * values[i] : 0.0;
  }
}

template <int Components>
void RingAveraging<Components>::Prepare(Id p, double share)
{
  const double area = this->Areas_[p];
  double sum = area;
  for (const Id q : this->Rings_.Around(p))
  {
    sum += this->Areas_[q];
  }
  this->Own_[p] = 1.0 - share;
  this->Ring_[p] = sum > 0.0 ? share * area / sum : 0.0;
}

template <int Components>
void RingAveraging<Components>::Step(Id begin, Id end, const AveragingSweep& sweep)
{
  const double whole = sweep.step == sweep.length ? 1.0 / (2.0 * sweep.length + 1.0) : 1.0;
  for (Id p = begin; p < end; ++p)
  {
    const double* own = this->Now_.data() + static_cast<std::size_t>(Stride) * p;
    double sum[Components];
    for (int i = 0; i < Components; ++i)
    {
      sum[i] = own[i];
    }
    for (const Id q : this->Rings_.Around(p))
    {
      const double* other = this->Now_.data() + static_cast<std::size_t>(Stride) * q;
      for (int i = 0; i < Components; ++i)
      {
        sum[i] += other[i];
      }
    }
    const double stays = this->Own_[p];
    const double taken = this->Ring_[p];
    const std::size_t at = static_cast<std::size_t>(Stride) * p;
    double* next = this->Next_.data() + at;
    if (sweep.step == 0)
    {
      for (int i = 0; i < Components; ++i)
      {
        next[i] = stays * own[i] + taken * sum[i];
      }
      continue;
    }
    double* box = this->Sum_.data() + at;
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
  const double area = this->Areas_[p];
  const double* now = this->Now_.data() + static_cast<std::size_t>(Stride) * p;
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
