// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_MongeField_h
#define ridges_MongeField_h

#include "Base/Types.h"

#include <Eigen/Core>

#include <cstddef>

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

} // namespace ridges

#endif
