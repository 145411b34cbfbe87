// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Salience/LevelAveraging.h"

namespace ridges
{

template <int Components>
LevelAveraging<Components>::LevelAveraging(const SmoothingPlan& plan)
  : Plan_(plan)
{
  for (const SmoothingLevel& level : plan.Levels())
  {
    const bool hasBoxes = !level.sweeps.empty() && level.sweeps.front().length > 0;
    this->Averagings_.emplace_back(level.graph, hasBoxes);
    // On all levels but the last sweeps are made twice.
    const double times = level.coarse.empty() ? 1.0 : 2.0;
    this->Work_ += times * static_cast<double>(level.sweeps.size()) * level.graph.NumberOfCells();
  }
}

template <int Components>
bool LevelAveraging<Components>::Run(const Loop& loop)
{
  const std::size_t count = this->Averagings_.size();
  for (std::size_t level = 0; level < count; ++level)
  {
    if ((level > 0 && !this->Gather(level, loop)) || !this->Prepare(level, loop) ||
      !this->Average(level, loop))
    {
      return false;
    }
  }
  for (std::size_t level = count - 1; level-- > 0;)
  {
    if (!this->Interpolate(level, loop) || !this->Average(level, loop))
    {
      return false;
    }
  }
  return true;
}

template <int Components>
bool LevelAveraging<Components>::Gather(std::size_t level, const Loop& loop)
{
  const SmoothingLevel& finer = this->Plan_.Levels()[level - 1];
  const Averaging& from = this->Averagings_[level - 1];
  Averaging& to = this->Averagings_[level];
  return loop(this->Plan_.Levels()[level].graph.NumberOfCells(), this->Done_ / this->Work_,
    [&finer, &from, &to](Id begin, Id end)
    {
      for (Id cell = begin; cell < end; ++cell)
      {
        to.Gather(cell, from, finer.Members(cell));
      }
    });
}

template <int Components>
bool LevelAveraging<Components>::Interpolate(std::size_t level, const Loop& loop)
{
  const SmoothingLevel& finer = this->Plan_.Levels()[level];
  const Averaging& from = this->Averagings_[level + 1];
  Averaging& to = this->Averagings_[level];
  return loop(finer.graph.NumberOfCells(), this->Done_ / this->Work_,
    [&finer, &from, &to](Id begin, Id end)
    {
      for (Id cell = begin; cell < end; ++cell)
      {
        if (finer.shares[cell] > 0.0)
        {
          to.Interpolate(cell, from, finer.coarse[cell]);
        }
        else
        {
          to.Take(cell, from, finer.coarse[cell]);
        }
      }
    });
}

template <int Components>
bool LevelAveraging<Components>::Prepare(std::size_t level, const Loop& loop)
{
  const SmoothingLevel& plan = this->Plan_.Levels()[level];
  Averaging& averaging = this->Averagings_[level];
  return loop(plan.graph.NumberOfCells(), this->Done_ / this->Work_,
    [&plan, &averaging](Id begin, Id end)
    {
      for (Id cell = begin; cell < end; ++cell)
      {
        averaging.Prepare(cell, plan.shares[cell]);
      }
    });
}

template <int Components>
bool LevelAveraging<Components>::Average(std::size_t level, const Loop& loop)
{
  const SmoothingLevel& plan = this->Plan_.Levels()[level];
  Averaging& averaging = this->Averagings_[level];
  const Id count = plan.graph.NumberOfCells();
  for (const AveragingSweep& sweep : plan.sweeps)
  {
    this->Done_ += count;
    const auto step = [&averaging, &sweep](Id begin, Id end) { averaging.Step(begin, end, sweep); };
    if (!loop(count, this->Done_ / this->Work_, step))
    {
      return false;
    }
    averaging.Swap(sweep);
  }
  return true;
}

template class LevelAveraging<9>;
template class LevelAveraging<21>;
template class LevelAveraging<34>;

} // namespace ridges
