// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shares/PositionBisection.h"

#include <algorithm>
#include <utility>

namespace ridges
{
namespace
{

/// By one coordinate, then by the others.
bool ComesBeforeAlong(int axis, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  for (int i = 0; i < 3; ++i)
  {
    const int k = (axis + i) % 3;
    if (a[k] != b[k])
    {
      return a[k] < b[k];
    }
  }
  return false;
}

} // namespace

PositionBisection::PositionBisection(std::vector<Eigen::Vector3d> sample, int parts)
  : Sample_(std::move(sample))
{
  this->Sample_.erase(std::remove_if(this->Sample_.begin(), this->Sample_.end(),
                        [](const Eigen::Vector3d& x) { return !x.allFinite(); }),
    this->Sample_.end());
  this->Root_ = this->Build(0, this->Sample_.size(), 0, parts);
  this->Sample_ = {};
}

int PositionBisection::Build(std::size_t begin, std::size_t end, int firstPart, int parts)
{
  if (parts == 1)
  {
    return -1 - firstPart;
  }
  Node node;
  const int partsBefore = parts / 2;
  const std::size_t middle =
    begin + (end - begin) * static_cast<std::size_t>(partsBefore) / static_cast<std::size_t>(parts);
  if (begin < end)
  {
    Eigen::Vector3d least = this->Sample_[begin];
    Eigen::Vector3d most = least;
    for (std::size_t i = begin; i < end; ++i)
    {
      least = least.cwiseMin(this->Sample_[i]);
      most = most.cwiseMax(this->Sample_[i]);
    }
    (most - least).maxCoeff(&node.axis);
    const auto at = [this](std::size_t i)
    { return this->Sample_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end),
      [&node](const Eigen::Vector3d& a, const Eigen::Vector3d& b)
      { return ComesBeforeAlong(node.axis, a, b); });
    node.cut = this->Sample_[middle];
  }
  node.before = this->Build(begin, middle, firstPart, partsBefore);
  node.after = this->Build(middle, end, firstPart + partsBefore, parts - partsBefore);
  this->Nodes_.push_back(node);
  return static_cast<int>(this->Nodes_.size()) - 1;
}

int PositionBisection::PartOf(const Eigen::Vector3d& x) const
{
  int at = this->Root_;
  while (at >= 0)
  {
    const Node& node = this->Nodes_[at];
    at = ComesBeforeAlong(node.axis, x, node.cut) ? node.before : node.after;
  }
  return -1 - at;
}

} // namespace ridges
