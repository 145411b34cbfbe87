// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_PositionBisection_h
#define ridges_PositionBisection_h

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace ridges
{

/**
 * Space cut into parts that hold about as many points each, by planes across the longest extent of
 * a sample. Where many points lie in a plane, it is cut as well, by the other coordinates: any two
 * points at different places can come into different parts, and those at one place never do.
 */
class PositionBisection
{
public:
  /// Points that are not finite are passed over.
  PositionBisection(std::vector<Eigen::Vector3d> sample, int parts);

  int PartOf(const Eigen::Vector3d& x) const;

private:
  struct Node
  {
    int axis = 0;
    Eigen::Vector3d cut = Eigen::Vector3d::Zero();
    int before = 0; ///< A node, or -1 - part.
    int after = 0;
  };

  int Build(std::size_t begin, std::size_t end, int firstPart, int parts);

  std::vector<Eigen::Vector3d> Sample_;
  std::vector<Node> Nodes_;
  int Root_;
};

} // namespace ridges

#endif
