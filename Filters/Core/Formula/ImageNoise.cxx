// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Formula/ImageNoise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ridges
{
namespace
{

constexpr double Second[3] = { 1.0, -2.0, 1.0 };

/// Second differences along the three axes at the sample nearest to an index that is inside.
double MixedDifference(const ImageGrid& grid, const Eigen::Vector3d& index)
{
  std::array<std::size_t, 3> first{};
  for (int i = 0; i < 3; ++i)
  {
    const double center = std::clamp(std::round(index[i]), 1.0, grid.size[i] - 2.0);
    first[i] = static_cast<std::size_t>(center) - 1;
  }
  const auto width = static_cast<std::size_t>(grid.size[0]);
  const auto height = static_cast<std::size_t>(grid.size[1]);
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      const double* row = grid.values + ((first[2] + k) * height + first[1] + j) * width + first[0];
      sum += Second[k] * Second[j] * (row[0] - 2.0 * row[1] + row[2]);
    }
  }
  return sum;
}

} // namespace

double EstimateImageNoise(const ImageGrid& grid, Span<double> places)
{
  std::vector<double> sizes;
  for (Id p = 0; p + 2 < places.size(); p += 3)
  {
    const Eigen::Vector3d index = grid.IndexOf(Eigen::Map<const Eigen::Vector3d>(&places[p]));
    bool isInside = true;
    for (int i = 0; i < 3; ++i)
    {
      isInside = isInside && index[i] >= 0.0 && index[i] <= grid.size[i] - 1.0;
    }
    const double size = isInside ? std::abs(MixedDifference(grid, index)) : -1.0;
    if (size >= 0.0)
    {
      sizes.push_back(size);
    }
  }
  if (sizes.empty())
  {
    return 0.0;
  }
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  constexpr double medianOfNormal = 0.6744897501960817; // of |x|
  constexpr double squaresOfWeights = 6.0 * 6.0 * 6.0;
  return *middle / (medianOfNormal * std::sqrt(squaresOfWeights));
}

// Along an axis the squares of the weights of a Gaussian add up to h / (2 sqrt(pi) sigma).
double SmoothedNoise(const ImageGrid& grid, double sigma)
{
  const double halfRootOfPi = 0.5 / std::sqrt(std::acos(-1.0));
  double variance = 1.0;
  for (int i = 0; i < 3; ++i)
  {
    variance *= std::min(1.0, halfRootOfPi * grid.spacing[i] / sigma);
  }
  return std::sqrt(variance);
}

} // namespace ridges
