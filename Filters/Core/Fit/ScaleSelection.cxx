// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fit/ScaleSelection.h"

#include "Mesh/PositionHash.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace ridges
{
namespace
{

using Fit = ScaleTrial::Fit;
constexpr int NumberOfScales = ScaleTrial::NumberOfScales;

double Median(std::vector<double>& values)
{
  const auto middle = values.begin() + values.size() / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

using Trials = std::vector<const ScaleTrial*>;

/// The variance of the noise. By the median, as where the surface has edges and creases it is they
/// that are left over.
double NoiseVariance(const Trials& trials)
{
  std::vector<double> values;
  for (const ScaleTrial* trial : trials)
  {
    if (trial->noiseFreedom > 0)
    {
      // Over the median of a chi-squared variable, by Wilson and Hilferty.
      const double root = 1.0 - 2.0 / (9.0 * trial->noiseFreedom);
      values.push_back(trial->noiseSquares / (trial->noiseFreedom * root * root * root));
    }
  }
  return values.empty() ? 0.0 : Median(values);
}

/// Squared differences of the tensors, off the diagonal counted twice as they are there twice.
double SquaredDifference(const Fit& fit, const Fit& other)
{
  const double uu = fit.second[0] - other.second[0];
  const double uv = fit.second[1] - other.second[1];
  const double vv = fit.second[2] - other.second[2];
  return uu * uu + 2.0 * uv * uv + vv * vv;
}

/// How much the surface bends within the neighbourhood, as a fit on the middle scale has it.
double Bending(const ScaleTrial* trial)
{
  const Fit& fit = trial->fits[NumberOfScales / 2];
  return SquaredDifference(fit, Fit()) * trial->fits[0].radius * trial->fits[0].radius;
}

/// The root of the mean squared error at each scale.
std::array<double, NumberOfScales> RootErrors(
  Trials::const_iterator begin, Trials::const_iterator end, double noise, int degree)
{
  const auto count = static_cast<double>(end - begin);
  std::array<double, NumberOfScales> variance{};
  std::array<double, NumberOfScales> difference{}; // from the scale before
  std::array<double, NumberOfScales> radius{};
  for (auto trial = begin; trial != end; ++trial)
  {
    const auto& fits = (*trial)->fits;
    for (int scale = 0; scale < NumberOfScales; ++scale)
    {
      variance[scale] += noise * fits[scale].spread / count;
      radius[scale] += fits[scale].radius / count;
      difference[scale] +=
        scale > 0 ? SquaredDifference(fits[scale], fits[scale - 1]) / count : 0.0;
    }
  }

  // Errors of the next higher order are odd, and cancel out on even samplings.
  const double order = degree % 2 == 0 ? degree : degree - 1;
  std::array<double, NumberOfScales> errors{};
  double squaredBias = 0.0;
  for (int scale = NumberOfScales - 1; scale >= 0; --scale)
  {
    const double ratio = scale > 0 ? radius[scale - 1] / radius[scale] : 0.0;
    if (scale > 0 && ratio < 1.0)
    {
      const double excess = difference[scale] - (variance[scale - 1] - variance[scale]);
      const double part = 1.0 - std::pow(ratio, order);
      squaredBias = std::max(0.0, excess) / (part * part);
    }
    else if (scale == 0)
    {
      squaredBias *= std::pow(radius[0] / radius[1], 2.0 * order);
    }
    errors[scale] = std::sqrt(variance[scale] + squaredBias);
  }
  return errors;
}

} // namespace

ScaleProbe::ScaleProbe(
  const TriangleMesh& mesh, const OrderedRings& rings, int degree, int minimumNumberOfPoints)
  : Mesh_(mesh)
  , Neighborhood_(mesh, rings)
  , Degree_(degree)
{
  this->Rule_.kind = NeighborhoodRule::Kind::RingsAndPointCount;
  this->Rule_.minimumNumberOfPoints = minimumNumberOfPoints;
  this->Rule_.numberOfRings = ScaleTrial::FewestRings;
}

ScaleTrial ScaleProbe::Try(Id vertex)
{
  constexpr double worstCondition = 2000.0;
  ScaleTrial trial;
  Span<Id> points = this->Neighborhood_.Gather(vertex, this->Rule_);
  const Eigen::Vector3d origin = this->Mesh_.Point(vertex);
  this->Offsets_.resize(3, points.size());
  for (Id i = 0; i < points.size(); ++i)
  {
    this->Offsets_.col(i) = this->Mesh_.Point(points[i]) - origin;
  }
  const JetFit smallest =
    this->Fitter_.Fit(this->Offsets_, this->Degree_, this->Mesh_.PointNormal(vertex));
  if (smallest.degree < this->Degree_ || !(smallest.conditionNumber <= worstCondition))
  {
    return trial;
  }

  const int size = HeightJet::Size(this->Degree_);
  this->Normal_.setZero(size, size);
  this->Projected_.setZero(size);
  this->Count_ = 0;
  trial.usable = true;
  for (int scale = 0; scale < NumberOfScales && trial.usable; ++scale)
  {
    Id before = -1;
    while (this->Neighborhood_.NumberOfRings() < ScaleTrial::FewestRings + scale &&
      points.size() > before)
    {
      before = points.size();
      points = this->Neighborhood_.Grow();
    }
    this->AddPoints(vertex, points, smallest);
    trial.usable = this->FitPoints(smallest.radius, trial.fits[scale]);
    // From degree 5 on the second scale may have too few points for that.
    if (scale == 1 || (scale > 1 && this->Degree_ > 4 && trial.noiseFreedom == 0))
    {
      this->FitHigherDegree(smallest.radius, trial);
    }
  }
  return trial;
}

void ScaleProbe::AddPoints(Id vertex, Span<Id> points, const JetFit& smallest)
{
  const Eigen::Index size = this->Projected_.size();
  if (this->Monomials_.cols() < points.size() || this->Monomials_.rows() != size)
  {
    this->Monomials_.conservativeResize(size, 2 * points.size());
    this->Heights_.conservativeResize(2 * points.size());
  }
  const Eigen::Vector3d origin = this->Mesh_.Point(vertex);
  const Eigen::Index first = this->Count_;
  for (; this->Count_ < points.size(); ++this->Count_)
  {
    const Eigen::Vector3d offset =
      this->Mesh_.Point(points[static_cast<Id>(this->Count_)]) - origin;
    const Eigen::Vector3d local = smallest.frame.transpose() * offset / smallest.radius;
    auto monomials = this->Monomials_.col(this->Count_);
    monomials[0] = 1.0;
    for (int d = 1; d <= this->Degree_; ++d)
    {
      for (int j = 0; j < d; ++j)
      {
        monomials[HeightJet::Index(d - j, j)] =
          monomials[HeightJet::Index(d - 1 - j, j)] * local[0];
      }
      monomials[HeightJet::Index(0, d)] = monomials[HeightJet::Index(0, d - 1)] * local[1];
    }
    this->Heights_[this->Count_] = local[2];
  }
  const auto added = this->Monomials_.middleCols(first, this->Count_ - first);
  this->Normal_.selfadjointView<Eigen::Lower>().rankUpdate(added);
  this->Projected_ += added * this->Heights_.segment(first, this->Count_ - first);
}

bool ScaleProbe::FitPoints(double unit, Fit& fit)
{
  this->Solver_.compute(this->Normal_.selfadjointView<Eigen::Lower>());
  if (this->Solver_.info() != Eigen::Success)
  {
    return false;
  }
  const Eigen::VectorXd coefficients = this->Solver_.solve(this->Projected_);
  const auto monomials = this->Monomials_.leftCols(this->Count_);
  fit.squares = unit * unit *
    (this->Heights_.head(this->Count_) - monomials.transpose() * coefficients).squaredNorm();
  fit.freedom = static_cast<int>(this->Count_ - coefficients.size());
  fit.radius = unit *
    std::sqrt((monomials.row(1).array().square() + monomials.row(2).array().square() +
      this->Heights_.head(this->Count_).transpose().array().square())
                .maxCoeff());
  if (this->Degree_ >= 2)
  {
    const int first = HeightJet::Index(2, 0);
    const double factors[3] = { 2.0, 1.0, 2.0 };
    const double times[3] = { 1.0, 2.0, 1.0 };
    fit.spread = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      Eigen::VectorXd column = Eigen::VectorXd::Unit(coefficients.size(), first + i);
      this->Solver_.matrixL().solveInPlace(column);
      fit.second[i] = factors[i] * coefficients[first + i] / unit;
      fit.spread += times[i] * factors[i] * factors[i] * column.squaredNorm();
    }
    fit.spread /= unit * unit * unit * unit;
  }
  return std::isfinite(fit.squares) && std::isfinite(fit.spread);
}

void ScaleProbe::FitHigherDegree(double unit, ScaleTrial& trial)
{
  constexpr int fewestFree = 3;
  const int degree = this->Degree_ + 2;
  const int size = HeightJet::Size(degree);
  const auto freedom = static_cast<int>(this->Count_ - size);
  if (freedom < fewestFree)
  {
    return;
  }
  const auto lower = this->Monomials_.leftCols(this->Count_);
  Eigen::MatrixXd& monomials = this->HigherMonomials_;
  monomials.resize(size, this->Count_);
  monomials.topRows(lower.rows()) = lower;
  for (int d = this->Degree_ + 1; d <= degree; ++d)
  {
    for (int j = 0; j < d; ++j)
    {
      monomials.row(HeightJet::Index(d - j, j)) =
        monomials.row(HeightJet::Index(d - 1 - j, j)).cwiseProduct(lower.row(1));
    }
    monomials.row(HeightJet::Index(0, d)) =
      monomials.row(HeightJet::Index(0, d - 1)).cwiseProduct(lower.row(2));
  }
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(size, size);
  normal.selfadjointView<Eigen::Lower>().rankUpdate(monomials);
  const auto heights = this->Heights_.head(this->Count_);
  this->Solver_.compute(normal.selfadjointView<Eigen::Lower>());
  if (this->Solver_.info() == Eigen::Success)
  {
    const Eigen::VectorXd coefficients = this->Solver_.solve(monomials * heights);
    trial.noiseSquares =
      unit * unit * (heights - monomials.transpose() * coefficients).squaredNorm();
    trial.noiseFreedom = std::isfinite(trial.noiseSquares) ? freedom : 0;
  }
}

std::vector<Id> ScaleSample(const TriangleMesh& mesh)
{
  constexpr double wanted = 2000.0;
  const double part = wanted / std::max(wanted, static_cast<double>(mesh.NumberOfPoints()));
  std::vector<std::pair<std::uint64_t, Id>> chosen;
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    const std::uint64_t hash = PositionHash(mesh.Point(p));
    if (part >= 1.0 || static_cast<double>(hash) < part * 0x1p64)
    {
      chosen.emplace_back(hash, p);
    }
  }
  std::sort(chosen.begin(), chosen.end());
  std::vector<Id> sample;
  for (std::size_t i = 0; i < chosen.size(); ++i)
  {
    const bool again = (i > 0 && chosen[i - 1].first == chosen[i].first) ||
      (i + 1 < chosen.size() && chosen[i + 1].first == chosen[i].first);
    if (!again)
    {
      sample.push_back(chosen[i].second);
    }
  }
  return sample;
}

int SelectNumberOfRings(const std::vector<ScaleTrial>& all, int degree)
{
  Trials trials;
  for (const ScaleTrial& trial : all)
  {
    if (trial.usable)
    {
      trials.push_back(&trial);
    }
  }
  if (trials.empty() || degree < 2)
  {
    return ScaleTrial::FewestRings;
  }
  const double noise = NoiseVariance(trials);

  // In groups of about the same bending: squares alone would listen to the sharpest bends only.
  constexpr std::size_t numberOfGroups = 8;
  std::stable_sort(trials.begin(), trials.end(),
    [](const ScaleTrial* a, const ScaleTrial* b) { return Bending(a) < Bending(b); });
  std::array<double, NumberOfScales> errors{};
  for (std::size_t group = 0; group < numberOfGroups; ++group)
  {
    const auto begin = trials.begin() + trials.size() * group / numberOfGroups;
    const auto end = trials.begin() + trials.size() * (group + 1) / numberOfGroups;
    if (begin == end)
    {
      continue;
    }
    const auto ofGroup = RootErrors(begin, end, noise, degree);
    for (int scale = 0; scale < NumberOfScales; ++scale)
    {
      errors[scale] += static_cast<double>(end - begin) * ofGroup[scale];
    }
  }
  const auto least = std::min_element(errors.begin(), errors.end());
  return ScaleTrial::FewestRings + static_cast<int>(least - errors.begin());
}

} // namespace ridges
