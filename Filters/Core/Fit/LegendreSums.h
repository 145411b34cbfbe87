// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_LegendreSums_h
#define ridges_LegendreSums_h

#include <Eigen/Core>

#include <array>

namespace ridges
{

/**
 * Sums over points for a fit by products of Legendre polynomials, times the root of 2 n + 1 for
 * degree n: on a square these products are orthonormal, and not far from it on other sets of
 * points.
 *
 * A product of two Legendre polynomials in one variable is a short sum of others. So the normal
 * equations of a fit of degree n follow from the (2 n + 1) (n + 1) sums of P_a(u) P_b(v), a + b <=
 * 2 n: for degree 10 there are 231, and 2,211 different entries of the normal equations.
 */
class LegendreSums
{
public:
  static constexpr int HighestDegree = 10;

  /// Values at x for degrees 0 to `degree`.
  static void Values(double x, int degree, double* values);

  /// A column for each pair of orders: the derivatives at 0 of all products of HighestDegree, in
  /// the order of HeightJet.
  static Eigen::MatrixXd DerivativesAtZero(const int (*orders)[2], int count);

  /// `points`: a column of u, v in -1 to 1 and of the height for each of them.
  void Add(const Eigen::Matrix3Xd& points, int degree);

  /// The lower triangle of the sums of products of two of the fit's polynomials.
  Eigen::MatrixXd Gram() const;

  /// The sums of a polynomial times the height.
  Eigen::VectorXd Heights() const;

private:
  static constexpr int Size = 2 * HighestDegree + 1;
  static constexpr int Block = 32; ///< Points whose polynomials are computed side by side.
  using Columns = Eigen::Matrix<double, Block, Size>;

  static void SetColumns(const Eigen::Array<double, Block, 1>& x, int degree, Columns& columns);

  int Degree_ = 0;
  Eigen::Matrix<double, Size, Size> Sums_; ///< Of P_a(u) P_b(v), not scaled.
  Eigen::Matrix<double, HighestDegree + 1, HighestDegree + 1> HeightSums_;
  Columns U_;
  Columns V_;
};

} // namespace ridges

#endif
