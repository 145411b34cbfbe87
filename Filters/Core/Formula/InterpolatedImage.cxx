// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Formula/InterpolatedImage.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ridges
{
namespace
{

/// Of Catmull and Rom: four samples along an axis, of which those beyond the border are the last
/// ones again.
struct CubicWeights
{
  CubicWeights() = default;
  CubicWeights(double index, int size)
  {
    const double inside = std::clamp(index, 0.0, size - 1.0);
    const double lower = std::min(std::floor(inside), size - 2.0);
    const double t = inside - lower;
    for (int i = 0; i < 4; ++i)
    {
      sample[i] = static_cast<std::size_t>(std::clamp(lower + i - 1.0, 0.0, size - 1.0));
    }
    value = { 0.5 * t * (-1.0 + t * (2.0 - t)), 1.0 + 0.5 * t * t * (-5.0 + 3.0 * t),
      0.5 * t * (1.0 + t * (4.0 - 3.0 * t)), 0.5 * t * t * (t - 1.0) };
    slope = { 0.5 * (-1.0 + t * (4.0 - 3.0 * t)), 0.5 * t * (-10.0 + 9.0 * t),
      0.5 * (1.0 + t * (8.0 - 9.0 * t)), 0.5 * t * (3.0 * t - 2.0) };
  }

  std::array<std::size_t, 4> sample{};
  std::array<double, 4> value{};
  std::array<double, 4> slope{};
};

} // namespace

InterpolatedImage::InterpolatedImage(const ImageGrid& grid, double value)
  : PointwiseFunction(grid.spacing.cwiseInverse().asDiagonal() * grid.axes.transpose())
  , Grid_(grid)
  , Value_(value)
{
}

void InterpolatedImage::Evaluate(const Eigen::Vector3d& x, int order, double* coefficients) const
{
  const Eigen::Vector3d index = this->Grid_.IndexOf(x);
  std::array<CubicWeights, 3> axes;
  for (int i = 0; i < 3; ++i)
  {
    axes[i] = CubicWeights(index[i], this->Grid_.size[i]);
  }
  std::fill_n(coefficients, Taylor3<4>::Offset(order + 1), 0.0);
  coefficients[0] = -this->Value_;
  double& alongX = coefficients[Taylor3<4>::Index(1, 0, 0)];
  double& alongY = coefficients[Taylor3<4>::Index(0, 1, 0)];
  double& alongZ = coefficients[Taylor3<4>::Index(0, 0, 1)];
  for (int k = 0; k < 4; ++k)
  {
    for (int j = 0; j < 4; ++j)
    {
      const auto row = axes[2].sample[k] * this->Grid_.size[1] + axes[1].sample[j];
      const double* samples = this->Grid_.values + row * this->Grid_.size[0];
      double value = 0.0;
      double slope = 0.0;
      for (int i = 0; i < 4; ++i)
      {
        value += axes[0].value[i] * samples[axes[0].sample[i]];
        slope += axes[0].slope[i] * samples[axes[0].sample[i]];
      }
      coefficients[0] += axes[2].value[k] * axes[1].value[j] * value;
      alongX += axes[2].value[k] * axes[1].value[j] * slope;
      alongY += axes[2].value[k] * axes[1].slope[j] * value;
      alongZ += axes[2].slope[k] * axes[1].value[j] * value;
    }
  }
}

} // namespace ridges
