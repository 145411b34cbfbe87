// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Points of the ridges of an analytic surface, found on the surface itself and not on a mesh.

#ifndef RIDGES_TESTING_EXACT_RIDGES_H
#define RIDGES_TESTING_EXACT_RIDGES_H

#include "AnalyticSurface.h"

#include <Eigen/Core>

namespace ridges
{
namespace testing
{

// The derivatives of b0 (maximum) or b3 along d1 and d2, where the frame turns as the principal
// directions do. That along the colour's own direction is P1 / (k1 - k2) or P2 / (k2 - k1) of
// equation (3).
Eigen::Vector2d ExtremalityGradient(const ExactMonge& monge, bool maximum);

struct ExactRidgePoint
{
  bool found = false;
  ExactMonge monge; // at the point found
  double Distance(const Eigen::Vector3d& from) const { return (this->monge.origin - from).norm(); }
  // A maximum of k1 or a minimum of k2: by the sign of P there.
  bool IsElliptic(bool maximum) const { return (maximum ? monge.P1 : monge.P2) < 0.0; }
};

// The ridge of k1 (maximum) or k2 next to a point near the surface, but not farther than reach: the
// foot found by Newton's method on b = 0 along its gradient. Where that fails, or leaves the reach,
// the nearest zero that is met on straight ways in eight directions on the surface. Not at an
// umbilic, where the ridges of both colours end and b has no value.
ExactRidgePoint NearestRidgePoint(
  const AnalyticSurface& surface, bool maximum, const Eigen::Vector3d& point, double reach);

} // namespace testing
} // namespace ridges

#endif
