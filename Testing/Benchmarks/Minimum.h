// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The time of a piece of work on a machine with other things to do: the least of several.

#ifndef RIDGES_BENCHMARKS_MINIMUM_H
#define RIDGES_BENCHMARKS_MINIMUM_H

#include <algorithm>
#include <chrono>
#include <ctime>
#include <limits>

namespace benchmarks
{

// Seconds that passed, and those that this thread computed: the others went to other programs, or
// were spent in waiting for other threads.
struct Times
{
  double wall = 0.0;
  double thread = 0.0;

  Times operator+(const Times& other) const
  {
    return { this->wall + other.wall, this->thread + other.thread };
  }
};

template <typename Work>
Times TimesOf(Work&& work)
{
  const auto threadSeconds = []
  {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  const auto start = std::chrono::steady_clock::now();
  const double threadStart = threadSeconds();
  work();
  const double threadEnd = threadSeconds();
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  return { wall.count(), threadEnd - threadStart };
}

// The least of each of the two, not of one and the same run.
class Minimum
{
public:
  void Take(const Times& times)
  {
    this->Least.wall = std::min(this->Least.wall, times.wall);
    this->Least.thread = std::min(this->Least.thread, times.thread);
  }
  template <typename Work>
  void Time(Work&& work)
  {
    this->Take(TimesOf(work));
  }
  const Times& Get() const { return this->Least; }

private:
  Times Least{ std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity() };
};

} // namespace benchmarks

#endif
