// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_EnclosingSphere_h
#define ridges_EnclosingSphere_h

#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

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

} // namespace ridges

#endif
