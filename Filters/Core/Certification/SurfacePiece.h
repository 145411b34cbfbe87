// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_SurfacePiece_h
#define ridges_SurfacePiece_h

#include "Certification/RidgeSeries.h"
#include "Certification/SurfaceBounds.h"
#include "Monge/MongeField.h"

#include <Eigen/Core>

#include <array>

namespace ridges
{

/**
 * How an edge or a triangle is mapped to the surface: its point with the weights l goes along the
 * normal with these weights, l0 n0 + l1 n1 + l2 n2, until it meets the surface. This image takes
 * the place of the paper's nearest points (definition 2): it is as continuous across edges, it ends
 * at the same points, and it can be differentiated.
 */
struct MappedTriangle
{
  std::array<Eigen::Vector3d, 3> point;
  std::array<Eigen::Vector3d, 3> normal;

  Eigen::Vector3d Position(const Eigen::Vector3d& weights) const;
  Eigen::Vector3d Normal(const Eigen::Vector3d& weights) const;
};

/// A part of an edge or a triangle: the convex hull of points that are given by their weights.
struct Part
{
  std::array<Eigen::Vector3d, 3> corner;
  int count; ///< 1: a vertex, 2: a part of an edge, 3: of a triangle.

  Eigen::Vector3d Center() const;
  static Part WholeTriangle();
};

/// A triangle cut into four by the middles of its sides; the one between them comes last.
template <typename Vector>
std::array<std::array<Vector, 3>, 4> Quarters(const std::array<Vector, 3>& corners)
{
  const Vector m01 = 0.5 * (corners[0] + corners[1]);
  const Vector m12 = 0.5 * (corners[1] + corners[2]);
  const Vector m20 = 0.5 * (corners[2] + corners[0]);
  return { { { corners[0], m01, m20 }, { m01, corners[1], m12 }, { m20, m12, corners[2] },
    { m01, m12, m20 } } };
}

/// An extremality over a part: with the frame at the part's center, times positive factors.
struct ExtremalityBounds
{
  Interval value;
  std::array<Interval, 2>
    slope; ///< Along corner 1 - corner 0 and corner 2 - corner 0 of the whole.
};

/// What is known of the image of a part.
struct PartBounds
{
  bool isMapped = false;  ///< The image is where it is looked for, and the map is one-to-one.
  bool hasGap = false;    ///< k1 - k2 is positive everywhere.
  bool isNarrow = false;  ///< d1 is nowhere more than 27 degrees away from that at the center.
  double height = 0.0;    ///< Along the normal, at the center.
  Eigen::Vector3d center; ///< On the surface.
  Eigen::Matrix3d frame;  ///< d1, d2 and the normal at the center.
  IntervalVector box;     ///< In the frame, where the image is.
  std::array<ExtremalityBounds, 2> extremality; ///< Blue and red; if hasGap and isNarrow.
};

/// `height` is a guess. Finite inputs only.
PartBounds BoundPart(
  const SurfaceBounds& surface, const MappedTriangle& whole, const Part& part, double height);

/// The point of the surface from x along a direction: how far it is, from a guess. Not a number if
/// there is none nearby.
double HeightAlong(const SurfaceBounds& surface, const Eigen::Vector3d& x,
  const Eigen::Vector3d& direction, double guess);

/// d1, d2 and the normal at a point of the surface, and the curvatures k1 and k2.
struct PrincipalFrame
{
  Eigen::Matrix3d axes;
  std::array<double, 2> curvature;
};
PrincipalFrame PrincipalFrameAt(const SurfaceBounds& surface, const Eigen::Vector3d& x);

/// b0 or b3, in floating point, with d1 turned to an acute angle with a direction.
double ExtremalityAt(
  const SurfaceBounds& surface, const Eigen::Vector3d& x, int color, const Eigen::Vector3d& d1);

} // namespace ridges

#endif
