// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_PatchPaths_h
#define ridges_PatchPaths_h

#include "Monge/MongeField.h"
#include "Ridges/Patch/PatchContour.h"

namespace ridges
{

/// Where a path crosses an edge: at a fraction of the way from the first of EndsInOrder.
struct EdgeCrossing
{
  Id edge;
  double parameter;
};

/**
 * Paths inside a patch that do not cross each other: straight ones from its contour to one point,
 * and others that follow the contour closely from one edge of it to another.
 */
class PatchPaths
{
public:
  PatchPaths(const TriangleMesh& mesh, const MongeField& field, const PatchContour& contour);

  /**
   * Straight paths, seen along the normal of the triangle `target`, from points on these sides of
   * the contour to a point in it. If they cannot be straight, as the patch is folded or indented,
   * they lead from triangle to triangle over the fewest.
   */
  std::vector<std::vector<EdgeCrossing>> ToPoint(const std::vector<std::size_t>& sides,
    const std::vector<Eigen::Vector3d>& points, Id target, const Eigen::Vector3d& position);

  /**
   * A path along the contour from one side to another, in the order of the walk. It is to enclose
   * those asked for before between the same sides, and stays clear of the paths to the point.
   */
  std::vector<EdgeCrossing> AlongContour(std::size_t first, std::size_t last);

private:
  struct Range
  {
    double least;
    double greatest;
  };

  void TakeCorners(Id target, const Eigen::Vector3d& position);
  bool Straight(std::size_t side, const Eigen::Vector3d& from, Id target,
    const Eigen::Vector3d& position, std::vector<EdgeCrossing>& path) const;
  std::vector<std::vector<EdgeCrossing>> OverFewest(
    const std::vector<std::size_t>& sides, Id target) const;

  const TriangleMesh& Mesh_;
  MongeField Field_;
  const PatchContour& Contour_;
  std::unordered_map<Id, Range> Taken_; ///< By edge, of the point and the paths to it.
  std::vector<int> Depth_;              ///< By side: of paths along the contour at its end.
};

} // namespace ridges

#endif
