// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Formula/SmoothedImage.h"

#include "Formula/AxisWeights.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace ridges
{
namespace
{

/// Narrower first steps alias themselves, and save nothing.
constexpr double LeastStep = 1.2;

} // namespace

SmoothedImage::SmoothedImage(
  const ImageGrid& grid, double sigma, const RangeLoop& loop, double remainder)
  : Grid_(grid)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double whole = sigma / grid.spacing[axis];
    const double before = grid.smoothing[axis];
    const double step =
      std::sqrt(std::max(0.0, whole * whole - before * before - remainder * remainder));
    if (step >= LeastStep)
    {
      this->Smooth(axis, step, loop);
      this->Grid_.smoothing[axis] = std::hypot(before, step);
    }
  }
}

// A row of samples is a run that lies `stride` values apart; `stride` such rows lie side by side.
void SmoothedImage::Smooth(int axis, double deviation, const RangeLoop& loop)
{
  const std::array<int, 3>& size = this->Grid_.size;
  const auto extent = static_cast<std::size_t>(size[axis]);
  std::size_t stride = 1;
  for (int i = 0; i < axis; ++i)
  {
    stride *= static_cast<std::size_t>(size[i]);
  }
  std::size_t blocks = 1;
  for (int i = axis + 1; i < 3; ++i)
  {
    blocks *= static_cast<std::size_t>(size[i]);
  }
  std::vector<AxisWeights> weights;
  weights.reserve(extent);
  for (int i = 0; i < size[axis]; ++i)
  {
    weights.emplace_back(i, deviation, size[axis]);
  }
  Buffer<double> smoothed(blocks * extent * stride);
  const double* from = this->Grid_.values;
  const auto smooth = [&weights, &smoothed, from, extent, stride](std::size_t item)
  {
    const AxisWeights& kernel = weights[item % extent];
    const double* rows = from + (item - item % extent + kernel.first) * stride;
    double* to = smoothed.data() + item * stride;
    std::fill_n(to, stride, 0.0);
    for (int i = 0; i < kernel.count; ++i, rows += stride)
    {
      const double weight = kernel(0, i);
      for (std::size_t s = 0; s < stride; ++s)
      {
        to[s] += weight * rows[s];
      }
    }
  };
  // An item is one sample of all rows of a block; along x all of the block, which is one row.
  const std::size_t group = axis == 0 ? extent : 1;
  loop(static_cast<Id>(blocks * extent / group),
    [&smooth, group](Id begin, Id end)
    {
      for (std::size_t item = begin * group; item < end * group; ++item)
      {
        smooth(item);
      }
    });
  this->Values_ = std::move(smoothed);
  this->Grid_.values = this->Values_.data();
}

} // namespace ridges
