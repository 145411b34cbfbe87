// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The fold angles of ridges of analytic surfaces, on the surface itself and not on a mesh.

#ifndef RIDGES_TESTING_EXACT_FOLDS_H
#define RIDGES_TESTING_EXACT_FOLDS_H

#include "AnalyticSurface.h"

#include <Eigen/Core>

namespace ridges
{
namespace testing
{

// In radians, of the rim z = 0 of the ellipsoid with semi-axes a > b > c, which is its only
// elliptic ridge that folds outward: by quadrature along the curvature line in ellipsoidal
// coordinates, as far as `reach` to both sides. Relative error about 1e-9.
double EllipsoidRimFold(
  double a, double b, double c, const Eigen::Vector3d& pointOfRim, double reach);

// The same at a point of any elliptic ridge of k1 (maximum) or k2: the curvature line is followed
// on the surface by the classical method of Runge and Kutta, in steps of this length.
double SurfaceFold(const AnalyticSurface& surface, bool maximum, const Eigen::Vector3d& point,
  double reach, double step);

} // namespace testing
} // namespace ridges

#endif
