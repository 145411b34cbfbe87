// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Salience/RingAveraging.h"

#include "Salience/GraphInterpolation.h"

#include <algorithm>
#include <utility>

namespace ridges
{

template <int Components>
RingAveraging<Components>::RingAveraging(const RingGraph& graph, bool hasBoxes)
  : Graph_(graph)
  , Now_(static_cast<std::size_t>(Components) * graph.NumberOfCells())
  , Next_(static_cast<std::size_t>(Components) * graph.NumberOfCells())
  , Sum_(hasBoxes ? static_cast<std::size_t>(Components) * graph.NumberOfCells() : 0)
  , Areas_(graph.NumberOfCells())
  , Own_(graph.NumberOfCells())
  , Ring_(graph.NumberOfCells())
{
}

template <int Components>
void RingAveraging<Components>::Set(Id cell, const Values& values, bool counts)
{
  const double area = counts ? this->Graph_.areas[cell] : 0.0;
  this->Areas_[cell] = area;
  double* now = At(this->Now_, cell);
  for (int i = 0; i < Components; ++i)
  {
    now[i] = counts ? area * values[i] : 0.0;
  }
}

template <int Components>
void RingAveraging<Components>::Gather(Id cell, const RingAveraging& fine, Span<Id> members)
{
  double* now = At(this->Now_, cell);
  std::fill_n(now, Components, 0.0);
  double area = 0.0;
  for (const Id member : members)
  {
    const double* other = At(fine.Now_, member);
    area += fine.Areas_[member];
    for (int i = 0; i < Components; ++i)
    {
      now[i] += other[i];
    }
  }
  this->Areas_[cell] = area;
}

template <int Components>
void RingAveraging<Components>::Prepare(Id cell, double share)
{
  const double area = this->Areas_[cell];
  double sum = area;
  for (Id i = this->Graph_.begins[cell]; i < this->Graph_.begins[cell + 1]; ++i)
  {
    sum += this->Graph_.Factor(i) * this->Areas_[this->Graph_.neighbors[i]];
  }
  this->Own_[cell] = 1.0 - share;
  this->Ring_[cell] = sum > 0.0 ? share * area / sum : 0.0;
}

template <int Components>
void RingAveraging<Components>::Take(Id cell, const RingAveraging& coarse, Id from)
{
  std::copy_n(At(coarse.Now_, from), Components, At(this->Now_, cell));
}

template <int Components>
void RingAveraging<Components>::Interpolate(Id cell, const RingAveraging& coarse, Id from)
{
  double* now = At(this->Now_, cell);
  std::fill_n(now, Components, 0.0);
  double whole = 0.0;
  for (const GraphInterpolation::Part& part : GraphInterpolation(
         coarse.Graph_, from, this->Graph_.positions[cell], this->Graph_.normals[cell]))
  {
    const double* other = At(coarse.Now_, part.cell);
    whole += part.factor * coarse.Areas_[part.cell];
    for (int i = 0; i < Components; ++i)
    {
      now[i] += part.factor * other[i];
    }
  }
  const double scale = whole > 0.0 ? this->Areas_[cell] / whole : 0.0;
  for (int i = 0; i < Components; ++i)
  {
    now[i] *= scale;
  }
}

template <int Components>
void RingAveraging<Components>::Step(Id begin, Id end, const AveragingSweep& sweep)
{
  if (this->Graph_.factors.empty())
  {
    this->template StepWith<false>(begin, end, sweep);
  }
  else
  {
    this->template StepWith<true>(begin, end, sweep);
  }
}

template <int Components>
template <bool HasFactors>
void RingAveraging<Components>::StepWith(Id begin, Id end, const AveragingSweep& sweep)
{
  const double whole = sweep.step == sweep.length ? 1.0 / (2.0 * sweep.length + 1.0) : 1.0;
  const Id* begins = this->Graph_.begins.data();
  const Id* neighbors = this->Graph_.neighbors.data();
  const float* factors = this->Graph_.factors.data();
  for (Id cell = begin; cell < end; ++cell)
  {
    const double* own = At(this->Now_, cell);
    double sum[Components];
    for (int i = 0; i < Components; ++i)
    {
      sum[i] = own[i];
    }
    for (Id n = begins[cell]; n < begins[cell + 1]; ++n)
    {
      const double* other = At(this->Now_, neighbors[n]);
      const double factor = HasFactors ? double{ factors[n] } : 1.0;
      for (int i = 0; i < Components; ++i)
      {
        sum[i] += HasFactors ? factor * other[i] : other[i];
      }
    }
    const double stays = this->Own_[cell];
    const double taken = this->Ring_[cell];
    double* next = At(this->Next_, cell);
    if (sweep.step == 0)
    {
      for (int i = 0; i < Components; ++i)
      {
        next[i] = stays * own[i] + taken * sum[i];
      }
      continue;
    }
    double* box = At(this->Sum_, cell);
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
bool RingAveraging<Components>::Get(Id cell, Values& values) const
{
  const double area = this->Areas_[cell];
  const double* now = At(this->Now_, cell);
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
