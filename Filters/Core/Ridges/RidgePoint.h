// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_RidgePoint_h
#define ridges_RidgePoint_h

#include "Mesh/TriangleMesh.h"
#include "Monge/MongeField.h"
#include "Ridges/RidgeRules.h"

namespace ridges
{

/// A point of a ridge, with the quantities of its colour interpolated there.
struct RidgePoint
{
  double parameter; ///< Fraction of the way from the edge's smaller point id to its larger.
  Eigen::Vector3d position;
  double curvature;   ///< k1 or k2
  double gap;         ///< k1 - k2
  double P;           ///< P1 or P2, or 0 where the field has no fourth order
  double crestMargin; ///< |own curvature| - |other curvature|
  Color color = Color::Blue;
};

/// The crossing of a ridge of the colour on an edge that IsCrossed; see MongeInterpolation.h.
RidgePoint RidgePointOnEdge(
  const TriangleMesh& mesh, const MongeField& field, Color color, CrossingRule rule, Id edge);

/// A point on an edge, at this fraction of the way from the first of EndsInOrder.
RidgePoint RidgePointAt(
  const TriangleMesh& mesh, const MongeField& field, Color color, Id edge, double parameter);

/**
 * The end of a ridge at an umbilic in a triangle. P, which has a limit there that depends on the
 * ridge, is that of the ridge's next point.
 */
RidgePoint RidgePointAtUmbilic(const TriangleMesh& mesh, const MongeField& field, Id triangle,
  const Eigen::Vector3d& position, const RidgePoint& next);

} // namespace ridges

#endif
