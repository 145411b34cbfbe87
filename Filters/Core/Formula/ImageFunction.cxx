// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Formula/ImageFunction.h"

#include "Formula/AxisWeights.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace ridges
{
namespace
{

constexpr int Orders = AxisWeights::Orders;
constexpr double BorderReach = 3.0; ///< What makes a difference to values, in deviations.

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
  , Remaining_((Sigma_.cwiseAbs2() - grid.smoothing.cwiseAbs2()).cwiseMax(0.0).cwiseSqrt())
  , Value_(value)
{
}

bool ImageFunction::IsAtBorder(const Eigen::Vector3d& x) const
{
  const Eigen::Vector3d index = this->Grid_.IndexOf(x);
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
  const Eigen::Vector3d index = this->Grid_.IndexOf(x);
  const auto coefficientCount = static_cast<std::size_t>(Taylor3<4>::Offset(order + 1));
  std::array<AxisWeights, 3> axes;
  for (int i = 0; i < 3; ++i)
  {
    axes[i] = AxisWeights(index[i], this->Remaining_[i], this->Grid_.size[i]);
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
