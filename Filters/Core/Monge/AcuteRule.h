// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_AcuteRule_h
#define ridges_AcuteRule_h

#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

namespace ridges
{

/// Blue belongs to the maximum principal curvature k1, red to the minimum k2.
enum class Color
{
  Blue,
  Red
};

/**
 * Monge coefficients at the points of a mesh, in arrays that the caller keeps. The frame of each
 * point is stored up to half a turn: (d1, b) and (-d1, -b) mean the same.
 */
struct MongeField
{
  const double* k1 = nullptr;
  const double* k2 = nullptr;
  const double* d1 = nullptr; ///< 3 values a point.
  const double* d2 = nullptr; ///< 3 values a point.
  const double* b = nullptr;  ///< 4 values a point.
  const double* c = nullptr;  ///< 5 values a point, may be missing.
  const double* P1 = nullptr; ///< Used in place of c, if that is missing; may be missing too.
  const double* P2 = nullptr;

  Eigen::Map<const Eigen::Vector3d> D1(Id p) const { return Vector(this->d1, p); }
  Eigen::Map<const Eigen::Vector3d> D2(Id p) const { return Vector(this->d2, p); }
  Eigen::Map<const Eigen::Vector3d> Direction(Color color, Id p) const
  {
    return color == Color::Blue ? this->D1(p) : this->D2(p);
  }
  const double* ThirdOrder(Id p) const { return this->b + 4 * static_cast<std::size_t>(p); }

  /// The derivative of the colour's curvature along its direction: b0 for blue, b3 for red.
  double Extremality(Color color, Id p) const
  {
    return this->ThirdOrder(p)[color == Color::Blue ? 0 : 3];
  }
  double Curvature(Color color, Id p) const { return color == Color::Blue ? k1[p] : k2[p]; }
  double P(Color color, Id p) const { return color == Color::Blue ? P1[p] : P2[p]; }
  bool HasFourthOrder() const { return this->c || (this->P1 && this->P2); }

private:
  static Eigen::Map<const Eigen::Vector3d> Vector(const double* values, Id p)
  {
    return Eigen::Map<const Eigen::Vector3d>(values + 3 * static_cast<std::size_t>(p));
  }
};

/**
 * The acute rule (RR-5294, definition 3): the frames at the ends of an edge are turned so that
 * their d1 make an acute angle. +1 where the stored ones already do, -1 where one of them is to
 * be turned. A right angle counts as acute: then every edge has a sign, and the crossings of an
 * edge do not depend on the side from which it is looked at.
 */
inline int AcuteSign(const MongeField& field, Id p, Id q)
{
  return field.D1(p).dot(field.D1(q)) >= 0.0 ? 1 : -1;
}

/// Sign of an extremality. Zero counts as positive in the stored frame, so that no crossing of
/// the edges around such a point is lost.
inline int ExtremalitySign(double b)
{
  return b >= 0.0 ? 1 : -1;
}

/// Whether a ridge of the colour crosses the edge between p and q (observation 2).
inline bool IsCrossed(const MongeField& field, Color color, Id p, Id q)
{
  return AcuteSign(field, p, q) * ExtremalitySign(field.Extremality(color, p)) *
    ExtremalitySign(field.Extremality(color, q)) <
    0;
}

/// Where the crossing lies, as a fraction of the way from p to q: equation (4).
double CrossingParameter(double extremalityAtP, double extremalityAtQ);

/**
 * Whether the acute rule is coherent around a triangle: the product of the signs of its edges is
 * +1. Each colour crosses a regular triangle's edges 0 or 2 times, a singular one's 1 or 3 times:
 * the signs of the extremality cancel in the product over the three edges. A singular triangle is
 * thus a discrete umbilic of index +1/2 or -1/2.
 */
bool IsRegular(const TriangleMesh& mesh, const MongeField& field, Id triangle);

} // namespace ridges

#endif
