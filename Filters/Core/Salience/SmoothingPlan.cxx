// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Salience/SmoothingPlan.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace ridges
{
namespace
{

/// With fewer averages boxes would be short, and save little.
constexpr double MostPlainAverages = 30.0;

constexpr int NumberOfBoxes = 6;

/// What a box of n steps is worth.
double AveragesOfBox(int n)
{
  return n * (n + 1.0) / 3.0;
}

} // namespace

SmoothingPlan::SmoothingPlan(const OneRings& rings, const double* fitScale, int averages)
  : Rings_(rings)
  , FitScale_(fitScale)
  , Sweeps_(averages)
  , Averages_(averages)
  , IsEven_(true)
{
}

SmoothingPlan::SmoothingPlan(const OneRings& rings, const double* fitScale, double sigma)
  : Rings_(rings)
  , FitScale_(fitScale)
  , Variance_(sigma * sigma)
{
  std::vector<double> averages;
  for (Id p = 0; p < rings.Mesh().NumberOfPoints(); ++p)
  {
    if (rings.Around(p).size() > 0)
    {
      averages.push_back(this->AveragesFor(p));
    }
  }
  double most = LeastAverages;
  if (!averages.empty())
  {
    // A few tiny triangles must not make all others wait for them.
    constexpr double part = 0.95;
    const auto which = averages.begin() +
      static_cast<std::ptrdiff_t>(part * static_cast<double>(averages.size() - 1));
    std::nth_element(averages.begin(), which, averages.end());
    // So written that what is not finite is cut as well.
    this->IsCut_ = !(*which <= MostAverages);
    most = this->IsCut_ ? MostAverages : std::max(most, *which);
  }
  this->SetSweeps(most);
}

void SmoothingPlan::SetSweeps(double averages)
{
  if (averages <= MostPlainAverages)
  {
    this->Averages_ = std::ceil(averages);
    this->Sweeps_.resize(static_cast<std::size_t>(this->Averages_));
    return;
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
  this->Averages_ = 0.0;
  for (int box = 0; box < NumberOfBoxes; ++box)
  {
    const int n = box < shorter ? length - 1 : length;
    this->Averages_ += AveragesOfBox(n);
    for (int step = 1; step <= n; ++step)
    {
      this->Sweeps_.push_back({ step, n });
    }
  }
}

double SmoothingPlan::FitVariance(Id p) const
{
  const double sigma = this->FitScale_ ? SigmaPerRadius * this->FitScale_[p] : 0.0;
  return sigma * sigma;
}

double SmoothingPlan::AveragesFor(Id p) const
{
  const double missing = this->Variance_ - this->FitVariance(p);
  const double perAverage = this->Rings_.Variance(p);
  return missing > 0.0 && perAverage > 0.0 ? missing / perAverage : 0.0;
}

double SmoothingPlan::Share(Id p) const
{
  return this->IsEven_
    ? 1.0
    : std::min(1.0, std::max<double>(LeastAverages, this->AveragesFor(p)) / this->Averages_);
}

double SmoothingPlan::Sigma(Id p) const
{
  return std::sqrt(
    this->FitVariance(p) + this->Averages_ * this->Share(p) * this->Rings_.Variance(p));
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
