// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Salience/SmoothingPlan.h"

#include "Mesh/CurveOrder.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace ridges
{
namespace
{

std::vector<Id> PointsInOrder(const TriangleMesh& mesh)
{
  std::vector<Id> points(mesh.NumberOfPoints());
  std::iota(points.begin(), points.end(), Id{ 0 });
  return points;
}

} // namespace

SmoothingPlan::SmoothingPlan(const OneRings& rings, const double* fitScale, int averages)
  : FitScale_(fitScale)
  , Levels_(1)
{
  const std::vector<Id> points = PointsInOrder(rings.Mesh());
  SmoothingLevel& level = this->Levels_.front();
  level.graph = RingGraph(rings, points);
  level.sweeps.resize(averages);
  level.shares.assign(points.size(), 1.0);
  level.variances.resize(points.size());
  for (const Id p : points)
  {
    level.variances[p] = averages * level.graph.Variance(p);
  }
}

SmoothingPlan::SmoothingPlan(
  const OneRings& rings, const double* fitScale, double sigma, const RangeLoop& loop)
  : FitScale_(fitScale)
{
  constexpr double greatest = 1e100; // whose square is a number
  double variance = std::min(sigma, greatest) * std::min(sigma, greatest);
  const double averages = this->AveragesOfMesh(rings, variance);
  // So written that what is not finite is cut as well.
  this->IsCut_ = !(averages <= MostAverages);
  if (this->IsCut_)
  {
    variance *= MostAverages / averages;
  }
  std::vector<Id> points = PointsInOrder(rings.Mesh());
  if (averages > MostPlainAverages)
  {
    // With many sweeps it pays that neighbours are near each other in memory.
    points = PointsAlongCurve(rings.Mesh());
    this->Cells_.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      this->Cells_[points[i]] = static_cast<Id>(i);
    }
  }
  std::vector<double> missing(points.size());
  std::vector<std::uint8_t> joins(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    missing[i] = std::max(0.0, variance - this->FitVariance(points[i]));
    // Of points with more triangles the rings do not have all neighbours.
    joins[i] = rings.Mesh().TrianglesAround(points[i]).size() <= OrderedRings::LargestFan ? 1 : 0;
  }
  const auto rank = [&rings, &points](Id cell) { return rings.Mesh().RankAtPlace(points[cell]); };
  RingGraph graph(rings, points);
  graph.SetNormals(rings, points, loop);
  graph.SetFactors(loop);
  this->Levels_ = BuildSmoothingLevels(
    std::move(graph), std::move(missing), std::move(joins), rank, LeastAverages, loop);
}

double SmoothingPlan::AveragesOfMesh(const OneRings& rings, double variance) const
{
  std::vector<double> averages;
  for (Id p = 0; p < rings.Mesh().NumberOfPoints(); ++p)
  {
    if (rings.Around(p).size() > 0)
    {
      averages.push_back(AveragesFor(variance - this->FitVariance(p), rings.Variance(p)));
    }
  }
  return MostOf(std::move(averages));
}

double SmoothingPlan::FitVariance(Id p) const
{
  const double sigma = this->FitScale_ ? SigmaPerRadius * this->FitScale_[p] : 0.0;
  return sigma * sigma;
}

double SmoothingPlan::Sigma(Id p) const
{
  return std::sqrt(this->FitVariance(p) + this->Levels_.front().variances[this->CellOf(p)]);
}

double SmoothingPlan::MedianSigma(const double* fitScale, Id numberOfPoints)
{
  std::vector<double> scales;
  std::copy_if(fitScale, fitScale + (fitScale ? numberOfPoints : 0), std::back_inserter(scales),
    [](double value) { return std::isfinite(value); });
  if (scales.empty())
  {
    return 0.0;
  }
  const auto middle = scales.begin() + static_cast<std::ptrdiff_t>(scales.size() / 2);
  std::nth_element(scales.begin(), middle, scales.end());
  return SigmaPerRadius * *middle;
}

} // namespace ridges
