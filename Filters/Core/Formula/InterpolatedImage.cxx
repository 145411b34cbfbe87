// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Formula/InterpolatedImage.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ridges
{

InterpolatedImage::InterpolatedImage(const ImageGrid& grid, double value)
  : PointwiseFunction(grid.spacing.cwiseInverse().asDiagonal() * grid.axes.transpose())
  , Grid_(grid)
  , Value_(value)
{
}

void InterpolatedImage::Evaluate(const Eigen::Vector3d& x, int order, double* coefficients) const
{
  const Eigen::Vector3d index = this->Grid_.IndexOf(x);
  std::array<std::size_t, 3> first{};
  std::array<double, 3> share{};
  for (int i = 0; i < 3; ++i)
  {
    const double inside = std::clamp(index[i], 0.0, this->Grid_.size[i] - 1.0);
    const double lower = std::min(std::floor(inside), this->Grid_.size[i] - 2.0);
    first[i] = static_cast<std::size_t>(lower);
    share[i] = inside - lower;
  }
  std::fill_n(coefficients, Taylor3<4>::Offset(order + 1), 0.0);
  coefficients[0] = -this->Value_;
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const std::array<std::size_t, 3> side{ corner & 1, corner >> 1 & 1, corner >> 2 };
    const auto row = (first[2] + side[2]) * this->Grid_.size[1] + first[1] + side[1];
    const double sample = this->Grid_.values[row * this->Grid_.size[0] + first[0] + side[0]];
    std::array<double, 3> weight{};
    for (int i = 0; i < 3; ++i)
    {
      weight[i] = side[i] == 1 ? share[i] : 1.0 - share[i];
    }
    coefficients[0] += weight[0] * weight[1] * weight[2] * sample;
    const auto slope = [&side](int i) { return side[i] == 1 ? 1.0 : -1.0; };
    coefficients[Taylor3<4>::Index(1, 0, 0)] += slope(0) * weight[1] * weight[2] * sample;
    coefficients[Taylor3<4>::Index(0, 1, 0)] += weight[0] * slope(1) * weight[2] * sample;
    coefficients[Taylor3<4>::Index(0, 0, 1)] += weight[0] * weight[1] * slope(2) * sample;
  }
}

} // namespace ridges
