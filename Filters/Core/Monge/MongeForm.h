// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_MongeForm_h
#define ridges_MongeForm_h

#include <Eigen/Core>

#include <array>

namespace ridges
{

/**
 * A height z = f(u, v) over some plane, by its derivatives at (0, 0) up to degree 4.
 *
 * Derivative(i, j) is d^(i+j) f / du^i dv^j. Coefficients stand by degree, and in a degree by
 * growing power of v, so that the first (d + 1)(d + 2) / 2 of them are a jet of degree d.
 */
struct HeightJet
{
  static constexpr int MaximumDegree = 4;
  static constexpr int MaximumSize = 15;

  static constexpr int Size(int degree) { return (degree + 1) * (degree + 2) / 2; }
  static constexpr int Index(int i, int j) { return (i + j) * (i + j + 1) / 2 + j; }

  static constexpr double Factorial(int n) { return n < 2 ? 1.0 : n * Factorial(n - 1); }

  double Derivative(int i, int j) const { return this->derivatives[Index(i, j)]; }

  /// The derivatives of one degree: a symmetric tensor of that order.
  const double* Tensor(int degree) const { return this->derivatives.data() + Size(degree - 1); }

  std::array<double, MaximumSize> derivatives{};
};

/**
 * The Monge form of a surface at a point, equations (1) and (2) of RR-5294, section 3:
 *
 *   z = 1/2 (k1 x^2 + k2 y^2) + 1/6 (b0 x^3 + 3 b1 x^2 y + 3 b2 x y^2 + b3 y^3)
 *     + 1/24 (c0 x^4 + 4 c1 x^3 y + 6 c2 x^2 y^2 + 4 c3 x y^3 + c4 y^4) + ...
 *
 * with x along d1, y along d2 and z along n; k1 >= k2 are the principal curvatures, and
 * (d1, d2, n) is a direct orthonormal frame. Turning the frame by half a turn about n gives an
 * equally good one and changes the sign of every b.
 */
struct MongeForm
{
  Eigen::Vector3d d1 = Eigen::Vector3d::Zero();
  Eigen::Vector3d d2 = Eigen::Vector3d::Zero();
  Eigen::Vector3d n = Eigen::Vector3d::Zero();
  double k1 = 0.0;
  double k2 = 0.0;
  std::array<double, 4> b{};
  std::array<double, 5> c{};

  /// Of the sign of k1'' along the blue curvature line at a blue ridge, equation (3).
  double P1() const { return 3.0 * b[1] * b[1] + (k1 - k2) * (c[0] - 3.0 * k1 * k1 * k1); }

  /// The dual of P1 for k2 and the red curvature line: k2'' = P2 / (k2 - k1).
  double P2() const { return 3.0 * b[2] * b[2] + (k2 - k1) * (c[4] - 3.0 * k2 * k2 * k2); }
};

/**
 * The Monge form of the graph of `jet` at (0, 0, f(0, 0)). The columns of `frame`, orthonormal
 * and direct, are the axes u, v and height; the normal is on the side of the height axis.
 * Coefficients of degrees that the jet does not have come out as if these were zero.
 */
MongeForm MongeFormOfHeightJet(const HeightJet& jet, const Eigen::Matrix3d& frame);

/// The same surface seen from its other side: n, k and the roles of maximum and minimum change.
MongeForm Flipped(const MongeForm& form);

} // namespace ridges

#endif
