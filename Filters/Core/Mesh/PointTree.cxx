// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/PointTree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ridges
{

PointTree::PointTree(const std::vector<Eigen::Vector3d>& points)
  : Points_(points)
  , Axes_(points.size(), 0)
  , Numbers_(points.size())
  , Places_(points.size())
{
  std::iota(this->Numbers_.begin(), this->Numbers_.end(), std::size_t(0));
  this->Build(0, points.size());
  for (std::size_t place = 0; place < points.size(); ++place)
  {
    this->Places_[this->Numbers_[place]] = place;
  }
  std::vector<Eigen::Vector3d> ordered;
  ordered.reserve(points.size());
  for (const std::size_t number : this->Numbers_)
  {
    ordered.push_back(points[number]);
  }
  this->Points_ = std::move(ordered);
}

// Only the numbers are moved: the points follow when all is done.
void PointTree::Build(std::size_t begin, std::size_t end)
{
  if (end - begin < 2)
  {
    return;
  }
  const auto first = this->Numbers_.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto last = this->Numbers_.begin() + static_cast<std::ptrdiff_t>(end);
  Eigen::AlignedBox3d box;
  std::for_each(
    first, last, [this, &box](std::size_t number) { box.extend(this->Points_[number]); });
  int axis = 0;
  box.sizes().maxCoeff(&axis);
  const std::size_t middle = begin + (end - begin) / 2;
  std::nth_element(first, this->Numbers_.begin() + static_cast<std::ptrdiff_t>(middle), last,
    [this, &axis](std::size_t a, std::size_t b)
    { return this->Points_[a][axis] < this->Points_[b][axis]; });
  this->Axes_[middle] = static_cast<std::uint8_t>(axis);
  this->Build(begin, middle);
  this->Build(middle + 1, end);
}

double PointTree::DistanceToNearestOther(std::size_t point) const
{
  double leastSquare = std::numeric_limits<double>::max();
  const std::size_t place = this->Places_[point];
  this->FindNearestOther(0, this->Points_.size(), this->Points_[place], place, leastSquare);
  return leastSquare < std::numeric_limits<double>::max() ? std::sqrt(leastSquare) : leastSquare;
}

void PointTree::FindNearestOther(std::size_t begin, std::size_t end,
  const Eigen::Vector3d& position, std::size_t point, double& leastSquare) const
{
  if (begin == end)
  {
    return;
  }
  const std::size_t middle = begin + (end - begin) / 2;
  const double offset = position[this->Axes_[middle]] - this->Points_[middle][this->Axes_[middle]];
  if (middle != point)
  {
    leastSquare = std::min(leastSquare, (this->Points_[middle] - position).squaredNorm());
  }
  // The side of the point first: what is found there may save the other one.
  const bool isBefore = offset < 0.0;
  this->FindNearestOther(
    isBefore ? begin : middle + 1, isBefore ? middle : end, position, point, leastSquare);
  if (offset * offset < leastSquare)
  {
    this->FindNearestOther(
      isBefore ? middle + 1 : begin, isBefore ? end : middle, position, point, leastSquare);
  }
}

} // namespace ridges
