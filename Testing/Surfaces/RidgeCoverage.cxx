// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RidgeCoverage.h"

#include "SegmentGrid.h"

#include <algorithm>
#include <numeric>

namespace ridges
{
namespace testing
{

using Eigen::Vector3d;

namespace
{

constexpr double Reach = 6.0; // in edges

struct Sample
{
  double distance;
  double length;
};

//------------------------------------------------------------------------------
// Both ends and the middle of each segment, each with its share of the length.
template <typename Visitor>
void ForSamples(const std::vector<Vector3d>& points, const Visitor& visit)
{
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    const double length = (points[i] - points[i - 1]).norm();
    visit(points[i - 1], 0.25 * length);
    visit(0.5 * (points[i - 1] + points[i]), 0.5 * length);
    visit(points[i], 0.25 * length);
  }
}

//------------------------------------------------------------------------------
// The samples of a colour, and what becomes of the coverage.
class CoverageSum
{
public:
  void Add(const Vector3d& point, double distance, double length)
  {
    this->Samples.push_back({ distance, length });
    if (distance > this->Sum.greatest)
    {
      this->Sum.greatest = distance;
      this->Sum.farthest = point;
    }
  }

  void AddWrongType(double length) { this->Sum.wrongType += length; }

  Coverage Summarize()
  {
    Coverage coverage = this->Sum;
    std::sort(this->Samples.begin(), this->Samples.end(),
      [](const Sample& a, const Sample& b) { return a.distance < b.distance; });
    const double total = std::accumulate(this->Samples.begin(), this->Samples.end(), 0.0,
      [](double sum, const Sample& sample) { return sum + sample.length; });
    double sum = 0.0;
    for (const Sample& sample : this->Samples)
    {
      sum += sample.length;
      coverage.mean += sample.distance * sample.length / total;
      coverage.percentile95 = sum <= 0.95 * total ? sample.distance : coverage.percentile95;
      coverage.off += sample.distance > 1.0 ? sample.length : 0.0;
    }
    return coverage;
  }

private:
  std::vector<Sample> Samples;
  Coverage Sum;
};

//------------------------------------------------------------------------------
bool TypeIsRight(int type, const TrueRidge& ridge, int segment, double edge)
{
  const bool elliptic = type == 1 || type == 3;
  // Any place within an edge of the turning point will do.
  const Vector3d at = ridge.points[segment];
  for (const int step : { -1, 1 })
  {
    for (int i = segment; i >= 0 && i < static_cast<int>(ridge.points.size()); i += step)
    {
      if ((ridge.P[i] < 0.0) == elliptic)
      {
        return true;
      }
      if ((ridge.points[i] - at).norm() > edge)
      {
        break;
      }
    }
  }
  return false;
}

} // namespace

//------------------------------------------------------------------------------
FoundCoverage MeasureFound(
  const std::vector<TrueRidge>& truth, const std::vector<FoundRidge>& found, double edge)
{
  std::array<SegmentGrid, 2> grids{ SegmentGrid(Reach * edge), SegmentGrid(Reach * edge) };
  for (std::size_t r = 0; r < truth.size(); ++r)
  {
    const TrueRidge& ridge = truth[r];
    for (std::size_t i = 1; i < ridge.points.size(); ++i)
    {
      grids[ridge.maximum ? 0 : 1].Add(
        ridge.points[i - 1], ridge.points[i], static_cast<int>(r), static_cast<int>(i) - 1);
    }
  }

  FoundCoverage result;
  std::array<CoverageSum, 2> sums;
  for (const FoundRidge& ridge : found)
  {
    const int color = ridge.IsMaximum() ? 0 : 1;
    std::vector<double> lengthOn(truth.size() + 1, 0.0);
    for (const FoundLine& line : ridge.lines)
    {
      ForSamples(line.points,
        [&](const Vector3d& point, double length)
        {
          const SegmentGrid::Hit hit = grids[color].Nearest(point);
          const double distance = std::min(Reach, hit.distance / edge);
          sums[color].Add(point, distance, length);
          const bool near = distance <= 1.0;
          lengthOn[near ? hit.line : truth.size()] += length;
          if (near && line.type != 0 && !TypeIsRight(line.type, truth[hit.line], hit.segment, edge))
          {
            sums[color].AddWrongType(length);
          }
        });
    }
    const auto most = std::max_element(lengthOn.begin(), lengthOn.end() - 1);
    const bool spurious = lengthOn.back() > 0.5 * LengthOf(ridge);
    result.ridges.push_back(spurious ? -1 : static_cast<int>(most - lengthOn.begin()));
  }
  result.colors = { sums[0].Summarize(), sums[1].Summarize() };
  return result;
}

//------------------------------------------------------------------------------
TrueCoverage MeasureTrue(
  const std::vector<TrueRidge>& truth, const std::vector<FoundRidge>& found, double edge)
{
  std::array<SegmentGrid, 2> grids{ SegmentGrid(Reach * edge), SegmentGrid(Reach * edge) };
  for (std::size_t r = 0; r < found.size(); ++r)
  {
    for (const FoundLine& line : found[r].lines)
    {
      for (std::size_t i = 1; i < line.points.size(); ++i)
      {
        grids[found[r].IsMaximum() ? 0 : 1].Add(
          line.points[i - 1], line.points[i], static_cast<int>(r), 0);
      }
    }
  }

  TrueCoverage result;
  std::array<CoverageSum, 2> sums;
  for (const TrueRidge& ridge : truth)
  {
    const int color = ridge.maximum ? 0 : 1;
    double missing = 0.0;
    ForSamples(ridge.points,
      [&](const Vector3d& point, double length)
      {
        const double distance = std::min(Reach, grids[color].Nearest(point).distance / edge);
        sums[color].Add(point, distance, length);
        missing += distance > 1.0 ? length : 0.0;
      });
    result.missing.push_back(missing);
  }
  result.colors = { sums[0].Summarize(), sums[1].Summarize() };
  return result;
}

} // namespace testing
} // namespace ridges
