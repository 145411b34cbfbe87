// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Formula/AxisWeights.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace ridges
{
namespace
{

constexpr int Orders = AxisWeights::Orders;
constexpr double Reach = 6.5; ///< Of the sums, in standard deviations.

/// Taylor coefficient n at 0 of the polynomial s^m, smoothed by a Gaussian of some variance: the
/// binomial coefficient (m, n) times the moment of degree m - n.
Eigen::Matrix<double, Orders, Orders> SmoothedPowers(double variance)
{
  const double moments[Orders] = { 1.0, 0.0, variance, 0.0, 3.0 * variance * variance };
  Eigen::Matrix<double, Orders, Orders> powers = Eigen::Matrix<double, Orders, Orders>::Zero();
  for (int m = 0; m < Orders; ++m)
  {
    double binomial = 1.0;
    for (int n = 0; n <= m; ++n)
    {
      powers(m, n) = binomial * moments[m - n];
      binomial = binomial * (m - n) / (n + 1);
    }
  }
  return powers;
}

} // namespace

// Five samples at least are needed: the window, which the moments do not depend on, is not narrower
// than a sample.
AxisWeights::AxisWeights(double index, double smoothing, int size)
{
  const double sigma = std::max(smoothing, 1.0);
  const double share = smoothing / sigma;
  const Eigen::Matrix<double, Orders, Orders> powers = SmoothedPowers(share * share);
  const double least = std::ceil(index - Reach * sigma);
  const double greatest = std::floor(index + Reach * sigma);
  if (!(greatest >= 0.0 && least <= size - 1.0))
  {
    return;
  }
  this->first = static_cast<int>(std::max(0.0, least));
  this->count = static_cast<int>(std::min(size - 1.0, greatest)) - this->first + 1;
  if (this->IsEmpty())
  {
    return;
  }
  Eigen::Matrix<double, Orders, Orders> gram = Eigen::Matrix<double, Orders, Orders>::Zero();
  std::vector<Eigen::Matrix<double, Orders, 1>> monomials(static_cast<std::size_t>(this->count));
  std::vector<double> gauss(monomials.size());
  for (int i = 0; i < this->count; ++i)
  {
    const double s = (this->first + i - index) / sigma;
    monomials[i] << 1.0, s, s * s, s * s * s, s * s * s * s;
    gauss[i] = std::exp(-0.5 * s * s);
    gram += gauss[i] * monomials[i] * monomials[i].transpose();
  }
  // Weights g(s) c.(1, s, ...) that take s^m to its smoothed coefficient: gram c = powers.
  const Eigen::Matrix<double, Orders, Orders> c = gram.ldlt().solve(powers);
  this->Weights_.resize(static_cast<std::size_t>(Orders) * this->count);
  double unit = 1.0; // coefficients are by samples, not by standard deviations
  for (int n = 0; n < Orders; ++n)
  {
    for (int i = 0; i < this->count; ++i)
    {
      this->Weights_[static_cast<std::size_t>(n) * this->count + i] =
        gauss[i] * monomials[i].dot(c.col(n)) / unit;
    }
    unit *= sigma;
  }
}

} // namespace ridges
