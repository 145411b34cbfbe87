// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fit/JetSelection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ridges
{
namespace
{

constexpr std::array<int, 12> RingsToTry{ 2, 3, 4, 5, 6, 7, 8, 10, 12, 15, 19,
  JetSelection::MostRings };
constexpr int NumberOfBands = JetTrial::NumberOfBands;

/// Degrees that fits can have: the highest band is there to compare with.
constexpr int LastDegree = NumberOfBands - 2;

constexpr double Quantile = 0.2;
constexpr double QuantileOfNormal = -0.8416;

/// Of fewer, what is left over is next to nothing now and then.
constexpr int FewestLeft = 4;

double QuantileOf(std::vector<double>& values)
{
  const auto at =
    values.begin() + static_cast<std::ptrdiff_t>(Quantile * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// That of a chi-squared variable over its mean, by Wilson and Hilferty.
double QuantileOfSquares(double freedom)
{
  const double ninth = 2.0 / (9.0 * freedom);
  const double root = 1.0 - ninth + QuantileOfNormal * std::sqrt(ninth);
  return root * root * root;
}

/// The variance of noise: there is as much everywhere, but of the surface more in some places than
/// in others. So a low quantile of the squares tells it.
double NoiseOf(const std::vector<JetTrial>& trials)
{
  double least = std::numeric_limits<double>::infinity();
  for (int band = 1; band < NumberOfBands; ++band)
  {
    std::vector<double> squares;
    for (const JetTrial& trial : trials)
    {
      if (trial.bands > band)
      {
        squares.push_back(trial.band[band].meanSquare);
      }
    }
    if (2 * squares.size() > trials.size())
    {
      const double coefficients = 4.0 * band + 5.0;
      least = std::min(least, QuantileOf(squares) / QuantileOfSquares(coefficients));
    }
  }
  return std::isfinite(least) ? least : 0.0;
}

/// The same of what is left over by all bands. Noise of neighbours that is not independent is
/// partly in the bands: then this is less.
double NoiseLeftOver(const std::vector<JetTrial>& trials)
{
  std::vector<double> variances;
  for (const JetTrial& trial : trials)
  {
    if (trial.freedom >= FewestLeft)
    {
      variances.push_back(trial.variance / QuantileOfSquares(trial.freedom));
    }
  }
  return 2 * variances.size() > trials.size() ? QuantileOf(variances)
                                              : std::numeric_limits<double>::infinity();
}

/// What the variance counts for. With these the mean error is at most a seventh above its minimum.
constexpr double WeightOfVariance = 4.0;
constexpr double WeightOfUnaveragedVariance = 8.0;

/// What part of the variance averages leave, which are a Gaussian of `sigma` radii: of third
/// derivatives at the centre of a disk with many points, for degree 4, 6 and 8.
double VarianceLeft(int degree, double sigma)
{
  constexpr double perStep = 0.05;
  constexpr int numberOfSteps = 8;
  constexpr double left[3][numberOfSteps + 1] = { { 1.0, 0.794, 0.584, 0.405, 0.264, 0.163, 0.096,
                                                    0.055, 0.031 },
    { 1.0, 0.759, 0.490, 0.277, 0.139, 0.064, 0.029, 0.013, 0.006 },
    { 1.0, 0.714, 0.389, 0.170, 0.063, 0.021, 0.007, 0.003, 0.001 } };
  const double at = std::min(sigma / perStep, numberOfSteps - 1e-9);
  const auto i = static_cast<int>(at);
  const double* row = left[std::clamp(degree - 1, 0, 2)];
  return row[i] + (at - i) * (row[i + 1] - row[i]);
}

/// The variance along an axis that an average over a one-ring adds, in squared edges: of a regular
/// point, which is one of seven.
constexpr double VarianceOfAverage = 3.0 / 7.0;

/// Averages are small beside such neighbourhoods only.
constexpr int FewestRingsToAverage = 5;

/// The variance of some averages in squared radii.
double SquaredSigma(int averages, int numberOfRings)
{
  return averages * VarianceOfAverage / (static_cast<double>(numberOfRings) * numberOfRings);
}

using Values = std::array<double, 4>;

double SquaredNorm(const Values& values, int order)
{
  const double times[] = { 1.0, order == 2 ? 2.0 : 3.0, order == 2 ? 1.0 : 3.0, 1.0 };
  double sum = 0.0;
  for (int i = 0; i <= order; ++i)
  {
    sum += times[i] * values[i] * values[i];
  }
  return sum;
}

} // namespace

JetSelection::JetSelection(int order, int degree)
  : Order_(order)
  , Degree_(degree)
{
  if (degree > 0)
  {
    this->Choice_.degree = degree;
  }
}

int JetSelection::NextRings() const
{
  return this->Step_ < RingsToTry.size() && !this->IsPastLeast_ ? RingsToTry[this->Step_] : 0;
}

int JetSelection::NextBands() const
{
  // Many rings are for noise, which wants low degrees.
  constexpr int manyRings = 8;
  const bool isLow = this->Degree_ <= JetTrial::DegreeOf(LastDegree - 1);
  return this->NextRings() > manyRings && isLow ? NumberOfBands - 1 : NumberOfBands;
}

void JetSelection::Add(const std::vector<JetTrial>& trials)
{
  if (this->Sample_.empty())
  {
    this->Sort(trials);
    double radii = 0.0;
    for (const JetTrial& trial : trials)
    {
      radii += trial.radius;
    }
    this->Edge_ = radii / static_cast<double>(RingsToTry.front() * trials.size());
  }
  this->Noise_.push_back(NoiseOf(trials));
  this->LeftOver_ = std::min(this->LeftOver_, NoiseLeftOver(trials));
  const auto steep = std::count_if(
    trials.begin(), trials.end(), [](const JetTrial& trial) { return trial.isSteep; });
  this->IsSteep_.push_back(2 * static_cast<std::size_t>(steep) > trials.size() ? 1 : 0);
  for (std::size_t group = 0; group < this->Groups_.size(); ++group)
  {
    this->Groups_[group].push_back(this->TermsOf(trials, group));
  }
  this->Choose();
  ++this->Step_;
}

/// Into groups: squares alone would follow the sharpest bends only.
void JetSelection::Sort(const std::vector<JetTrial>& trials)
{
  constexpr std::size_t numberOfGroups = 8;
  std::vector<double> bending(trials.size());
  for (std::size_t i = 0; i < trials.size(); ++i)
  {
    const JetTrial& trial = trials[i];
    bending[i] = SquaredNorm(trial.band[0].second.values, 2) * trial.radius * trial.radius;
  }
  std::vector<std::size_t> order(trials.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
    [&bending](std::size_t i, std::size_t j) { return bending[i] < bending[j]; });
  for (std::size_t group = 0; group < numberOfGroups; ++group)
  {
    const auto at = [&order](std::size_t part)
    { return order.begin() + order.size() * part / numberOfGroups; };
    if (at(group) != at(group + 1))
    {
      this->Sample_.emplace_back(at(group), at(group + 1));
    }
  }
  this->Groups_.resize(this->Sample_.size());
}

JetSelection::Terms JetSelection::TermsOf(
  const std::vector<JetTrial>& trials, std::size_t group) const
{
  Terms terms{ 0.0, {}, {}, {} };
  const std::vector<std::size_t>& sample = this->Sample_[group];
  for (int degree = 0; degree < NumberOfBands; ++degree)
  {
    double variance = 0.0;
    double varianceOfNext = 0.0;
    double squareOfNext = 0.0;
    double radius = 0.0;
    std::size_t count = 0;
    std::size_t compared = 0;
    for (const std::size_t i : sample)
    {
      const JetTrial& trial = trials[i];
      const auto inBand = [this, &trial](int band) -> const JetTrial::Derivative&
      { return this->Order_ == 2 ? trial.band[band].second : trial.band[band].third; };
      if (trial.bands > degree)
      {
        ++count;
        radius += trial.radius;
        for (int band = 0; band <= degree; ++band)
        {
          variance += inBand(band).variance;
        }
      }
      if (trial.bands > degree + 1)
      {
        ++compared;
        varianceOfNext += inBand(degree + 1).variance;
        squareOfNext += SquaredNorm(inBand(degree + 1).values, this->Order_);
      }
    }
    // Where few points allow it, it says little.
    const auto mean = [&sample](double sum, std::size_t number)
    { return 2 * number > sample.size() ? sum / static_cast<double>(number) : -1.0; };
    terms.variance[degree] = mean(variance, count);
    terms.varianceOfNext[degree] = mean(varianceOfNext, compared);
    terms.squareOfNext[degree] = mean(squareOfNext, compared);
    if (degree == 0)
    {
      terms.radius = mean(radius, count);
    }
  }
  return terms;
}

/// On few rings only low bands are there, which have much of the surface. As noise is as large on
/// more rings, or larger where it is correlated, what these show is a bound.
double JetSelection::NoiseAt(std::size_t step) const
{
  return *std::min_element(
    this->Noise_.begin() + static_cast<std::ptrdiff_t>(step), this->Noise_.end());
}

/// The geometric mean over the surface, as ridges are wanted where it bends little, too; negative
/// if it is not known.
double JetSelection::MeanError(std::size_t step, int degree, int averages) const
{
  // A fit of degree 4 errs as much as a Gaussian of this part of the squared radius: both have the
  // Laplacian of the derivatives for their first term.
  constexpr double squaredSigmaOfDegree4 = 0.1;
  const double squaredSigma = SquaredSigma(averages, RingsToTry[step]);
  const double weight = averages > 0
    ? WeightOfVariance * VarianceLeft(degree, std::sqrt(squaredSigma))
    : WeightOfUnaveragedVariance;
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t g = 0; g < this->Groups_.size(); ++g)
  {
    const Group& group = this->Groups_[g];
    const double variance = this->NoiseAt(step) * group[step].variance[degree];
    const double squaredBias = this->SquaredBias(group, step, degree);
    const double ofDegree4 = averages > 0 ? this->SquaredBias(group, step, 1) : 0.0;
    if (this->IsSteep_[step] != 0 || variance < 0.0 || squaredBias < 0.0 || ofDegree4 < 0.0)
    {
      return -1.0;
    }
    const double bias =
      std::sqrt(squaredBias) + std::sqrt(ofDegree4) * squaredSigma / squaredSigmaOfDegree4;
    const auto size = static_cast<double>(this->Sample_[g].size());
    sum += 0.5 * size * std::log(weight * variance + bias * bias);
    count += size;
  }
  return count > 0.0 ? std::exp(sum / count) : -1.0;
}

/// More rings show it better, where it is larger than what noise adds, and show it where few points
/// leave nothing to compare with. They may overrate it, as terms of still higher degrees come in.
double JetSelection::SquaredBias(const Group& group, std::size_t step, int degree) const
{
  // The first terms left out that do not cancel on even samplings are of degree + 2 for second
  // derivatives, of degree + 1 for third ones.
  const int power = JetTrial::DegreeOf(degree) + 2 - (this->Order_ == 2 ? 2 : 4);
  double least = -1.0;
  for (std::size_t more = step; more < group.size(); ++more)
  {
    const Terms& terms = group[more];
    if (terms.squareOfNext[degree] >= 0.0)
    {
      const double excess = std::max(
        0.0, terms.squareOfNext[degree] - this->NoiseAt(more) * terms.varianceOfNext[degree]);
      const double here = excess * std::pow(group[step].radius / terms.radius, 2 * power);
      least = least < 0.0 ? here : std::min(least, here);
    }
  }
  return least;
}

/// Averages of hardly any noise err more in k than they gain.
bool JetSelection::MayAverage(std::size_t step) const
{
  return RingsToTry[step] >= FewestRingsToAverage &&
    std::sqrt(this->NoiseAt(step)) >= JetChoice::HardlyAnyNoise * this->Edge_;
}

void JetSelection::Choose()
{
  // An odd degree gives even derivatives as the one below it does, and odd ones as the one above.
  const int given = std::clamp((this->Degree_ + this->Order_ - 2) / 2 - 1, 0, LastDegree);
  const int lowest = this->Degree_ > 0 ? given : (this->Order_ == 2 ? 0 : 1);
  const int highest = this->Degree_ > 0 ? given : LastDegree;
  this->Least_ = std::numeric_limits<double>::infinity();
  for (std::size_t step = 0; step <= this->Step_; ++step)
  {
    double leastOfStep = std::numeric_limits<double>::infinity();
    for (int degree = lowest; degree <= highest; ++degree)
    {
      for (const int averages : { 0, MostAverages })
      {
        if (averages > 0 && !this->MayAverage(step))
        {
          continue;
        }
        const double error = this->MeanError(step, degree, averages);
        if (error < 0.0)
        {
          continue;
        }
        leastOfStep = std::min(leastOfStep, error);
        if (error < this->Least_)
        {
          this->Least_ = error;
          this->Choice_ = { this->Degree_ > 0 ? this->Degree_ : JetTrial::DegreeOf(degree),
            RingsToTry[step], averages, std::sqrt(this->NoiseAt(step)), this->Edge_ };
        }
      }
    }
    // Before the fifth, errors of high degrees are not known.
    this->IsPastLeast_ = step >= 4 && leastOfStep > 1.5 * this->Least_;
  }
  this->MayBlend();
}

/// Where there is hardly any noise. What looks like noise may be a surface that the mesh hardly
/// resolves: of that, high degrees leave over much less than of noise.
void JetSelection::MayBlend()
{
  constexpr int mostRings = 5;
  constexpr double muchLess = 0.1;
  JetChoice& choice = this->Choice_;
  const double leftOver = std::sqrt(this->LeftOver_);
  if (std::isfinite(this->Least_) && this->Degree_ == 0 && this->Order_ > 2 &&
    choice.numberOfRings <= mostRings &&
    (choice.noise < JetChoice::HardlyAnyNoise * this->Edge_ || leftOver < muchLess * choice.noise))
  {
    const std::vector<BlendedJet> jets = JetsWithoutNoise();
    const double noise = std::min(choice.noise, leftOver);
    choice = { jets.back().degree, jets.back().numberOfRings, 0, noise, this->Edge_ };
    choice.blend = jets;
  }
}

} // namespace ridges
