// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_PointTree_h
#define ridges_PointTree_h

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace ridges
{

/**
 * Finds the neighbours of places among points: a balanced tree of halves, each split across its
 * longest side. What it finds is exact.
 */
class PointTree
{
public:
  PointTree() = default;
  explicit PointTree(const std::vector<Eigen::Vector3d>& points);

  /// The distance from one of the points to the nearest other one, or the largest double without
  /// another. `point` is the index in the points that the tree was made from.
  double DistanceToNearestOther(std::size_t point) const;

  /// Calls visit(position) for each point within the radius of the center, in no particular order,
  /// until it returns false.
  template <typename Visit>
  void VisitNear(const Eigen::Vector3d& center, double radius, Visit&& visit) const
  {
    this->VisitPart(0, this->Points_.size(), center, radius, visit);
  }

private:
  void Build(std::size_t begin, std::size_t end);
  void FindNearestOther(std::size_t begin, std::size_t end, const Eigen::Vector3d& position,
    std::size_t point, double& leastSquare) const;

  template <typename Visit>
  bool VisitPart(std::size_t begin, std::size_t end, const Eigen::Vector3d& center, double radius,
    Visit&& visit) const
  {
    if (begin == end)
    {
      return true;
    }
    const std::size_t middle = begin + (end - begin) / 2;
    const Eigen::Vector3d& position = this->Points_[middle];
    const double offset = center[this->Axes_[middle]] - position[this->Axes_[middle]];
    return ((position - center).squaredNorm() > radius * radius || visit(position)) &&
      (offset > radius || this->VisitPart(begin, middle, center, radius, visit)) &&
      (-offset > radius || this->VisitPart(middle + 1, end, center, radius, visit));
  }

  // The point in the middle of a range separates what is on both sides of it along its axis.
  std::vector<Eigen::Vector3d> Points_;
  std::vector<std::uint8_t> Axes_;
  std::vector<std::size_t> Numbers_; ///< Of the points, as they were given.
  std::vector<std::size_t> Places_;  ///< The inverse.
};

} // namespace ridges

#endif
