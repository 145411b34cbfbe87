// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_RidgeMeasures_h
#define ridges_RidgeMeasures_h

#include "Mesh/PointTree.h"
#include "Ridges/RidgePoint.h"
#include "Ridges/RidgeType.h"

#include <vector>

namespace ridges
{

/// How salient a ridge is.
struct RidgeMeasures
{
  double length = 0.0;   ///< In the unit of the points.
  double strength = 0.0; ///< Integral of |k| of the ridge's colour: no unit.

  /// Integral of |k''| = |P / (k1 - k2)| (observation 3), in 1 / length^2. Times the square of
  /// the model size it is the sharpness, which has no unit.
  double rawSharpness = 0.0;
};

/**
 * Balls around umbilics whose inside the sharpness of hyperbolic ridges leaves out: there k'' grows
 * like one over the distance to the umbilic, so that its integral up to the umbilic is infinite.
 */
class UmbilicCutOff
{
public:
  UmbilicCutOff() = default;
  UmbilicCutOff(const std::vector<Eigen::Vector3d>& umbilics, double radius);

  /// A part of a segment, by fractions of it.
  struct Part
  {
    double begin;
    double end;
  };

  /// The parts of the segment from a to b outside all balls, in order.
  std::vector<Part> Outside(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;

private:
  PointTree Umbilics_;
  double Radius_ = 0.0;
};

/**
 * Measures of the polyline through points of one type. Along a segment k, P and k1 - k2 are taken
 * as linear; the quotient of the last two is integrated by Gauss-Legendre's rule of four points.
 */
RidgeMeasures MeasureRidge(
  const std::vector<RidgePoint>& points, RidgeType type, const UmbilicCutOff& cutOff);

} // namespace ridges

#endif
