// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Salience/SmoothingLevels.h"

#include "Salience/GraphCoarsening.h"
#include "Salience/GraphInterpolation.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace ridges
{
namespace
{

/// Cells that need more averages are joined, so that joined ones need about twenty at least. Then
/// the result hardly differs from that of averages of the mesh itself. With 30 in place of 100, or
/// six averages left, sharp edges lose a tenth of their curvature.
constexpr double MostAveragesOfCell = 100.0;

/// For those few that need more and cannot be joined.
constexpr double MostAveragesOfLevel = 200.0;

/// Each level has a fourth of the cells of the one before.
constexpr std::size_t MostLevels = 20;

constexpr int NumberOfBoxes = 6;

/// What a box of n steps is worth.
double AveragesOfBox(int n)
{
  return n * (n + 1.0) / 3.0;
}

/// As many sweeps as are worth so many averages or hardly more; the result is how many they are.
double MakeSweeps(double averages, std::vector<AveragingSweep>& sweeps)
{
  if (averages <= MostPlainAverages)
  {
    sweeps.resize(static_cast<std::size_t>(std::ceil(averages)));
    return std::ceil(averages);
  }
  int length = 1;
  while (NumberOfBoxes * AveragesOfBox(length) < averages)
  {
    ++length;
  }
  // As many of them as will do are a step shorter.
  const double saved = AveragesOfBox(length) - AveragesOfBox(length - 1);
  const double excess = NumberOfBoxes * AveragesOfBox(length) - averages;
  const int shorter = std::min(NumberOfBoxes - 1, static_cast<int>(excess / saved));
  double worth = 0.0;
  for (int box = 0; box < NumberOfBoxes; ++box)
  {
    const int n = box < shorter ? length - 1 : length;
    worth += AveragesOfBox(n);
    for (int step = 1; step <= n; ++step)
    {
      sweeps.push_back({ step, n });
    }
  }
  return worth;
}

void ForCells(Id count, const RangeLoop& loop, const std::function<void(Id)>& body)
{
  loop(count,
    [&body](Id begin, Id end)
    {
      for (Id cell = begin; cell < end; ++cell)
      {
        body(cell);
      }
    });
}

/// What is known of the cells of the level that is being built.
struct Need
{
  std::vector<double> missing; ///< Variance.
  std::vector<double> perAverage;
  std::vector<double> averages;
  std::vector<std::uint8_t> joins;
};

void CountAverages(const RingGraph& graph, const RangeLoop& loop, Need& need)
{
  const Id count = graph.NumberOfCells();
  need.perAverage.resize(count);
  need.averages.resize(count);
  ForCells(count, loop,
    [&graph, &need](Id cell)
    {
      need.perAverage[cell] = graph.Variance(cell);
      need.averages[cell] = AveragesFor(need.missing[cell], need.perAverage[cell]);
    });
}

double MostAveragesOf(const RingGraph& graph, const Need& need)
{
  std::vector<double> averages;
  averages.reserve(need.averages.size());
  for (Id cell = 0; cell < graph.NumberOfCells(); ++cell)
  {
    if (graph.Around(cell).size() > 0)
    {
      averages.push_back(need.averages[cell]);
    }
  }
  return MostOf(std::move(averages));
}

void FinishLastLevel(double most, int leastAverages, const Need& need, SmoothingLevel& level)
{
  const double least = leastAverages;
  const double averages = MakeSweeps(std::clamp(most, least, MostAveragesOfLevel), level.sweeps);
  const std::size_t count = need.averages.size();
  level.shares.resize(count);
  level.variances.resize(count);
  for (std::size_t cell = 0; cell < count; ++cell)
  {
    level.shares[cell] = std::min(1.0, std::max(least, need.averages[cell]) / averages);
    level.variances[cell] = averages * level.shares[cell] * need.perAverage[cell];
  }
}

/// One average where cells are joined or next to such, on the way to the next level and on the way
/// back: the sums over coarse cells would take what alternates between fine ones for something
/// else, and interpolation leaves bends at the borders of coarse cells. The variances are those of
/// both ways.
void FinishJoinedLevel(
  const Coarsening& next, const Need& need, const RangeLoop& loop, SmoothingLevel& level)
{
  const RingGraph& graph = level.graph;
  const Id count = graph.NumberOfCells();
  level.sweeps.resize(1);
  level.shares.resize(count);
  level.variances.resize(count);
  const auto isJoined = [&next](Id cell) { return next.Members(next.coarse[cell]).size() > 1; };
  ForCells(count, loop,
    [&](Id cell)
    {
      const Span<Id> ring = graph.Around(cell);
      const bool averages = isJoined(cell) || std::any_of(ring.begin(), ring.end(), isJoined);
      const Id coarse = next.coarse[cell];
      level.shares[cell] = averages ? 1.0 : 0.0;
      level.variances[cell] =
        2.0 * level.shares[cell] * need.perAverage[cell] + next.variances[coarse];
      if (averages)
      {
        level.variances[cell] +=
          GraphInterpolation(next.graph, coarse, graph.positions[cell], graph.normals[cell])
            .Variance();
      }
    });
}

/// What is missing at coarse cells, and which of them may be joined again.
Need NeedOfCoarse(const SmoothingLevel& level, const Coarsening& next, const Need& need)
{
  const Id count = next.graph.NumberOfCells();
  Need coarse;
  coarse.missing.resize(count);
  coarse.joins.resize(count);
  for (Id cell = 0; cell < count; ++cell)
  {
    double area = 0.0;
    double sum = 0.0;
    for (const Id member : next.Members(cell))
    {
      area += level.graph.areas[member];
      sum += level.graph.areas[member] * (need.missing[member] - level.variances[member]);
    }
    coarse.missing[cell] = area > 0.0 ? std::max(0.0, sum / area) : 0.0;
    coarse.joins[cell] = need.joins[next.Members(cell)[0]];
  }
  return coarse;
}

} // namespace

double AveragesFor(double missing, double perAverage)
{
  return missing > 0.0 && perAverage > 0.0 ? missing / perAverage : 0.0;
}

double MostOf(std::vector<double> averages)
{
  constexpr double part = 0.95;
  if (averages.empty())
  {
    return 0.0;
  }
  const auto which =
    averages.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(averages.size() - 1));
  std::nth_element(averages.begin(), which, averages.end());
  return *which;
}

std::deque<SmoothingLevel> BuildSmoothingLevels(RingGraph finest, std::vector<double> missing,
  std::vector<std::uint8_t> joins, const std::function<std::uint64_t(Id)>& rank, int leastAverages,
  const RangeLoop& loop)
{
  std::deque<SmoothingLevel> levels(1);
  levels.back().graph = std::move(finest);
  Need need;
  need.missing = std::move(missing);
  need.joins = std::move(joins);
  for (;;)
  {
    SmoothingLevel& level = levels.back();
    const Id count = level.graph.NumberOfCells();
    CountAverages(level.graph, loop, need);
    const double most = MostAveragesOf(level.graph, need);
    Coarsening next;
    if (most > MostAveragesOfCell && levels.size() < MostLevels)
    {
      for (Id cell = 0; cell < count; ++cell)
      {
        const bool needsMany = need.averages[cell] > MostAveragesOfCell;
        need.joins[cell] = need.joins[cell] != 0 && needsMany ? 1 : 0;
      }
      const bool isFinest = levels.size() == 1;
      // The ranks of points do not hold for the cells that they are joined to.
      next = Coarsen(
        level.graph, need.joins, isFinest ? rank : [](Id) { return std::uint64_t{ 0 }; }, loop);
    }
    if (next.coarse.empty() || next.graph.NumberOfCells() == count)
    {
      FinishLastLevel(most, leastAverages, need, level);
      break;
    }
    FinishJoinedLevel(next, need, loop, level);
    need = NeedOfCoarse(level, next, need);
    level.coarse = std::move(next.coarse);
    level.begins = std::move(next.begins);
    level.members = std::move(next.members);
    levels.emplace_back();
    levels.back().graph = std::move(next.graph);
  }
  for (auto level = std::next(levels.rbegin()); level != levels.rend(); ++level)
  {
    const std::vector<double>& there = std::prev(level)->variances;
    for (std::size_t cell = 0; cell < level->variances.size(); ++cell)
    {
      level->variances[cell] += there[level->coarse[cell]];
    }
  }
  return levels;
}

} // namespace ridges
