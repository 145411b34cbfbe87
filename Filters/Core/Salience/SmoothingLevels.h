// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_SmoothingLevels_h
#define ridges_SmoothingLevels_h

#include "Salience/RingAveraging.h"

#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

namespace ridges
{

/// What is averaged over one graph, and how its cells are joined to those of the next level.
struct SmoothingLevel
{
  RingGraph graph;
  std::vector<AveragingSweep> sweeps; ///< Before cells are joined and after, or at the last level.
  std::vector<double> shares;         ///< Of each average that a cell takes (RingAveraging).
  std::vector<double> variances;      ///< What comes out at a cell, from this level down and back.
  std::vector<Id> coarse;             ///< By cell, the one of the next level. Empty at the last.
  std::vector<Id> begins, members;    ///< By cell of the next level, the cells that it is made of.

  Span<Id> Members(Id cell) const
  {
    const Id* base = this->members.data();
    return { base + this->begins[cell], base + this->begins[cell + 1] };
  }
};

/// With fewer averages boxes would be short, and save little.
constexpr double MostPlainAverages = 30.0;

/// What adds up to a variance that is missing, with a fraction; 0 where nothing is missing.
double AveragesFor(double missing, double perAverage);

/// How many of averages are made, by what all cells need: a few tiny triangles must not make all
/// others wait for them.
double MostOf(std::vector<double> averages);

/// The levels of a plan. Cells that do not join stay as they are on all levels. For the variance
/// that is missing at each cell; see Coarsen for the others.
std::deque<SmoothingLevel> BuildSmoothingLevels(RingGraph finest, std::vector<double> missing,
  std::vector<std::uint8_t> joins, const std::function<std::uint64_t(Id)>& rank, int leastAverages,
  const RangeLoop& loop);

} // namespace ridges

#endif
