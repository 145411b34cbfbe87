// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_RidgeType_h
#define ridges_RidgeType_h

#include "Mesh/TriangleMesh.h"
#include "Monge/MongeField.h"

namespace ridges
{

/// Colour and type of a ridge in one number, as RR-5294 paints them: blue, green, red, yellow.
enum class RidgeType : std::uint8_t
{
  Undecided = 0,
  MaximumElliptic = 1,   ///< k1 is a maximum along its curvature line: blue.
  MaximumHyperbolic = 2, ///< k1 is a minimum: green.
  MinimumElliptic = 3,   ///< k2 is a minimum along its curvature line: red.
  MinimumHyperbolic = 4  ///< k2 is a maximum: yellow.
};

RidgeType TypeOf(Color color, bool elliptic);

bool IsElliptic(RidgeType type);

/**
 * Elliptic or hyperbolic from third-order quantities only (section 5.3). The ridge segment from
 * `r1`, on the edge of corners (v1, v2), to `r2`, on that of (v1, v3), crosses `triangle`, whose
 * corner number `apex` is v1. Looking from each corner towards the segment the curvature of the
 * colour rises or falls; what at least two corners say decides.
 */
bool IsEllipticByThirdOrder(const TriangleMesh& mesh, const MongeField& field, Color color,
  Id triangle, int apex, const Eigen::Vector3d& r1, const Eigen::Vector3d& r2);

} // namespace ridges

#endif
