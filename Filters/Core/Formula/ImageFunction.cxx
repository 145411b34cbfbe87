// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Formula/ImageFunction.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace ridges
{
namespace
{

constexpr int Orders = 5;
constexpr double Reach = 6.5;       ///< Of the sums, in standard deviations.
constexpr double BorderReach = 3.0; ///< What makes a difference to values.

/// The weights along an axis: row n gives Taylor coefficient n.
struct AxisWeights
{
  int first = 0;
  int count = 0;
  std::vector<double> weights; ///< Order after order.

  double operator()(int order, int i) const
  {
    return this->weights[static_cast<std::size_t>(order) * this->count + i];
  }
  bool IsEmpty() const { return this->count < Orders; }
};

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

/// Five samples at least are needed: the window, which the moments do not depend on, is not
/// narrower than a sample.
AxisWeights WeightsOf(double index, double smoothing, int size)
{
  const double sigma = std::max(smoothing, 1.0);
  const double share = smoothing / sigma;
  const Eigen::Matrix<double, Orders, Orders> powers = SmoothedPowers(share * share);
  AxisWeights axis;
  const double least = std::ceil(index - Reach * sigma);
  const double greatest = std::floor(index + Reach * sigma);
  if (!(greatest >= 0.0 && least <= size - 1.0))
  {
    return axis;
  }
  axis.first = static_cast<int>(std::max(0.0, least));
  axis.count = static_cast<int>(std::min(size - 1.0, greatest)) - axis.first + 1;
  if (axis.IsEmpty())
  {
    return axis;
  }
  Eigen::Matrix<double, Orders, Orders> gram = Eigen::Matrix<double, Orders, Orders>::Zero();
  std::vector<Eigen::Matrix<double, Orders, 1>> monomials(static_cast<std::size_t>(axis.count));
  std::vector<double> gauss(monomials.size());
  for (int i = 0; i < axis.count; ++i)
  {
    const double s = (axis.first + i - index) / sigma;
    monomials[i] << 1.0, s, s * s, s * s * s, s * s * s * s;
    gauss[i] = std::exp(-0.5 * s * s);
    gram += gauss[i] * monomials[i] * monomials[i].transpose();
  }
  // Weights g(s) c.(1, s, ...) that take s^m to its smoothed coefficient: gram c = powers.
  const Eigen::Matrix<double, Orders, Orders> c = gram.ldlt().solve(powers);
  axis.weights.resize(static_cast<std::size_t>(Orders) * axis.count);
  double unit = 1.0; // coefficients are by samples, not by standard deviations
  for (int n = 0; n < Orders; ++n)
  {
    for (int i = 0; i < axis.count; ++i)
    {
      axis.weights[static_cast<std::size_t>(n) * axis.count + i] =
        gauss[i] * monomials[i].dot(c.col(n)) / unit;
    }
    unit *= sigma;
  }
  return axis;
}

/// to += weight * from, for `count` values.
void Add(double* to, double weight, const double* from, int count)
{
  for (int i = 0; i < count; ++i)
  {
    to[i] += weight * from[i];
  }
}

} // namespace

ImageFunction::ImageFunction(const ImageGrid& grid, double sigma, double value)
  : PointwiseFunction(grid.spacing.cwiseInverse().asDiagonal() * grid.axes.transpose())
  , Grid_(grid)
  , Sigma_(sigma * grid.spacing.cwiseInverse())
  , Value_(value)
{
}

Eigen::Vector3d ImageFunction::IndexOf(const Eigen::Vector3d& x) const
{
  return (this->Grid_.axes.transpose() * (x - this->Grid_.origin))
    .cwiseQuotient(this->Grid_.spacing);
}

bool ImageFunction::IsAtBorder(const Eigen::Vector3d& x) const
{
  const Eigen::Vector3d index = this->IndexOf(x);
  for (int i = 0; i < 3; ++i)
  {
    const double reach = BorderReach * this->Sigma_[i];
    if (index[i] < reach || index[i] > this->Grid_.size[i] - 1 - reach)
    {
      return true;
    }
  }
  return false;
}

// Summed along z first, with the samples of a row side by side; then along y, then along x.
void ImageFunction::Evaluate(const Eigen::Vector3d& x, int order, double* coefficients) const
{
  const Eigen::Vector3d index = this->IndexOf(x);
  const auto coefficientCount = static_cast<std::size_t>(Taylor3<4>::Offset(order + 1));
  std::array<AxisWeights, 3> axes;
  for (int i = 0; i < 3; ++i)
  {
    axes[i] = WeightsOf(index[i], this->Sigma_[i], this->Grid_.size[i]);
    if (axes[i].IsEmpty())
    {
      std::fill_n(coefficients, coefficientCount, std::numeric_limits<double>::quiet_NaN());
      return;
    }
  }
  const int width = axes[0].count;
  const auto rowOf = [width](std::vector<double>& rows, int i)
  { return rows.data() + static_cast<std::size_t>(i) * width; };
  std::vector<double> alongZ(static_cast<std::size_t>(Orders) * width);
  std::vector<double> alongYZ(static_cast<std::size_t>(Orders) * Orders * width);
  for (int j = 0; j < axes[1].count; ++j)
  {
    std::fill(alongZ.begin(), alongZ.end(), 0.0);
    for (int k = 0; k < axes[2].count; ++k)
    {
      const auto row = static_cast<std::size_t>(axes[2].first + k) * this->Grid_.size[1] +
        static_cast<std::size_t>(axes[1].first + j);
      const double* samples = this->Grid_.values + row * this->Grid_.size[0] + axes[0].first;
      for (int n = 0; n <= order; ++n)
      {
        Add(rowOf(alongZ, n), axes[2](n, k), samples, width);
      }
    }
    for (int n = 0; n <= order; ++n)
    {
      for (int m = 0; m + n <= order; ++m)
      {
        Add(rowOf(alongYZ, m * Orders + n), axes[1](m, j), rowOf(alongZ, n), width);
      }
    }
  }
  for (int n = 0; n <= order; ++n)
  {
    for (int m = 0; m + n <= order; ++m)
    {
      const double* row = rowOf(alongYZ, m * Orders + n);
      for (int l = 0; l + m + n <= order; ++l)
      {
        double sum = 0.0;
        for (int i = 0; i < width; ++i)
        {
          sum += axes[0](l, i) * row[i];
        }
        coefficients[Taylor3<4>::Index(l, m, n)] = sum;
      }
    }
  }
  coefficients[0] -= this->Value_;
}

} // namespace ridges
