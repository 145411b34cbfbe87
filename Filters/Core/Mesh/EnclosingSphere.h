// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_EnclosingSphere_h
#define ridges_EnclosingSphere_h

#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <array>
#include <functional>

namespace ridges
{

struct Sphere
{
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double radius = 0.0;
};

/**
 * The smallest sphere that encloses all points (columns), exact up to round-off. Its radius is
 * the model size by which sharpness is made scale-independent: unlike the bounding box it does
 * not change under rotation. All coordinates must be finite; no point gives radius 0.
 */
Sphere SmallestEnclosingSphere(const Eigen::Ref<const Eigen::Matrix3Xd>& points);

/// The same around the points that triangles have.
Sphere SmallestEnclosingSphere(const TriangleMesh& mesh);

/// A point that is far from some place; none if its distance is negative.
struct FarPoint
{
  double squaredDistance = -1.0;
  std::array<double, 3> x{};
};

/// The farther one; if they are equally far, the one that comes first by position.
FarPoint FartherOf(const FarPoint& a, const FarPoint& b);

/**
 * How those who have the pieces of a mesh find its sphere together, each calling the function below
 * at the same time: from one's own value that of all.
 */
struct SphereOfPieces
{
  std::function<FarPoint(const FarPoint&)> farthest; ///< By FartherOf.
  std::function<std::array<double, 6>(const std::array<double, 6>&)> leastOfEach;
};

/// The same, to the last digit, as of the whole mesh.
Sphere SmallestEnclosingSphere(const TriangleMesh& piece, const SphereOfPieces& ofAll);

} // namespace ridges

#endif
