// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_LevelAveraging_h
#define ridges_LevelAveraging_h

#include "Salience/SmoothingPlan.h"

#include <deque>
#include <functional>

namespace ridges
{

/// Carries out a plan: averages on all of its levels, from the finest to the coarsest and back.
template <int Components>
class LevelAveraging
{
public:
  using Averaging = RingAveraging<Components>;
  using Values = typename Averaging::Values;

  /// Runs body(begin, end) over ranges that make up [0, count), maybe at the same time; `done` is
  /// the part of all work that is done then. False to stop.
  using Loop = std::function<bool(Id count, double done, const std::function<void(Id, Id)>& body)>;

  /// Refers to the plan.
  explicit LevelAveraging(const SmoothingPlan& plan);

  /// The values of a point at the start. Where it does not count they are ignored.
  void Set(Id p, const Values& values, bool counts = true)
  {
    this->Averagings_.front().Set(this->Plan_.CellOf(p), values, counts);
  }

  /// After all points are set. False if the loop was stopped.
  bool Run(const Loop& loop);

  /// The values of a point at the end; false if it does not count.
  bool Get(Id p, Values& values) const
  {
    return this->Averagings_.front().Get(this->Plan_.CellOf(p), values);
  }

private:
  bool Gather(std::size_t level, const Loop& loop);
  bool Interpolate(std::size_t level, const Loop& loop);
  bool Prepare(std::size_t level, const Loop& loop);
  bool Average(std::size_t level, const Loop& loop);

  const SmoothingPlan& Plan_;
  std::deque<Averaging> Averagings_; ///< By level.
  double Work_ = 0.0;                ///< Of all, in cells.
  double Done_ = 0.0;
};

} // namespace ridges

#endif
