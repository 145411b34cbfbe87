// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_JetFit_h
#define ridges_JetFit_h

#include "Fit/Weighting.h"
#include "Monge/MongeForm.h"

#include <Eigen/Core>
#include <Eigen/QR>

#include <cstdint>

namespace ridges
{

/// What is to be known about a fit, as bits: 0 is a good fit.
enum FitStatus : std::uint8_t
{
  FitGood = 0,
  FitBoundary = 1,       ///< The vertex lies on the border: the neighbourhood is one-sided.
  FitTooFewPoints = 2,   ///< Fewer points than coefficients: fitted in a lower degree.
  FitIllConditioned = 4, ///< The points hardly determine the polynomial: see JetFit.
  FitInvalid = 8,        ///< There is no fit: all its values are zero.
  FitFolded = 16         ///< The surface folds over within the neighbourhood: see PointFitter.
};

/// A polynomial height function fitted to the points around a vertex.
struct JetFit
{
  HeightJet jet; ///< Over `frame`, from the vertex; what it has of the degree.
  Eigen::Matrix3d frame = Eigen::Matrix3d::Identity(); ///< Columns u, v, height; direct.
  int degree = 0;                                      ///< Degree that was fitted, 0 if invalid.
  int rank = 0;                                        ///< Numerical rank of the least squares.
  double conditionNumber = 0.0;
  double residual = 0.0; ///< (Weighted) rms of the heights left over, in units of the radius.
  double radius = 0.0;   ///< Distance of the farthest point from the vertex.

  /// Extents of the points along u and v, as parts of the radius: the units of the monomials.
  Eigen::Vector2d extents = Eigen::Vector2d::Ones();

  /**
   * How much noise is magnified in third derivatives: times the residual, over the squared radius,
   * this is the standard error of the third-order form, b0 x^3 + 3 b1 x^2 y + 3 b2 x y^2 + b3 y^3
   * as a tensor. 0 where there is no third order.
   */
  double noiseGain = 0.0;
  std::uint8_t status = FitInvalid;

  /// What a coefficient of the monomial u^i v^j is to be multiplied by to make it a derivative.
  double DerivativePerCoefficient(int i, int j) const;
};

/**
 * Least-squares fit of a polynomial of degree 1 to 8 to points given as offsets from a vertex
 * (the vertex itself, an offset of zero, included): "jet fitting".
 *
 * The height axis is the direction in which the points spread least (principal component analysis
 * about their mean), on the side of `side`. Offsets are divided by the radius, and those along u
 * and v by their extents, so that the linear system, and with it the condition number, has no unit,
 * and is the same for points that lie fifty times as densely in one direction as in the other. It
 * is solved by a complete orthogonal decomposition, the column-pivoted QR factorisation that also
 * gives the solution of least norm where the points leave the polynomial undetermined.
 *
 * The condition number is the ratio of the first to the last pivot of that factorisation, an
 * estimate of the ratio of the extreme singular values. From degree 5 on it is that of the same
 * problem in polynomials that are orthonormal over the unit disk, because monomials of such degrees
 * are nearly dependent anywhere. From `IllConditionedAbove` on the fit is
 * flagged: derivatives of the surface beyond the degree, and noise, are then magnified beyond use.
 * So it is between `WellConditionedBelow` and that, and where the points lie in a narrow strip, if
 * the residual makes the curvature uncertain by `MostTurnOfWeak` within the radius.
 *
 * Weights change the least squares, but not the height axis.
 *
 * Holds scratch memory: use one per thread.
 */
class JetFitter
{
public:
  static constexpr int MaximumDegree = 8;

  /// As few points as a neighbourhood should have: the coefficients, and from degree 5 on a fifth
  /// more, because fits that interpolate are hardly ever well conditioned there.
  static constexpr int FewestPoints(int degree)
  {
    constexpr int fewest[] = { 1, 3, 6, 10, 15, 26, 34, 45, 56 };
    return fewest[degree];
  }

  static constexpr double IllConditionedAbove = 1e5;
  static constexpr double WellConditionedBelow = 2000.0;

  /// Of UncertainTurn, in radians: where the surface is steep, and where the points determine the
  /// polynomial weakly.
  static constexpr double MostTurn = 0.3;
  static constexpr double MostTurnOfWeak = 0.03;

  /// `offsets` has a column per point.
  JetFit Fit(const Eigen::Ref<const Eigen::Matrix3Xd>& offsets, int degree,
    const Eigen::Vector3d& side, Weighting weighting = Weighting::Uniform);

  /// The same along a given axis, of any length.
  JetFit FitAlong(const Eigen::Vector3d& axis, const Eigen::Ref<const Eigen::Matrix3Xd>& offsets,
    int degree, Weighting weighting = Weighting::Uniform);

  /// By what angle the normal may turn within the radius for all that the residual says: the
  /// standard error of the second-order form, times the radius. Of the last fit only.
  double UncertainTurn(const JetFit& fit) const { return this->NoiseGain(fit, 2) * fit.residual; }

  /// The factorisation of the last fit that was not invalid: of the monomials in units of the
  /// extents, a row per point, which is multiplied by the point's root weight.
  using Factorization = Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>;
  const Factorization& LastFactorization() const { return this->Solver_; }

  /// The square roots of the weights of that fit; empty if they were all 1.
  const Eigen::VectorXd& LastRootWeights() const { return this->RootWeights_; }

private:
  JetFit Begin(const Eigen::Ref<const Eigen::Matrix3Xd>& offsets, int degree) const;
  void FitInFrame(
    const Eigen::Ref<const Eigen::Matrix3Xd>& offsets, Weighting weighting, JetFit& fit);
  void SetMonomials(const Eigen::Ref<const Eigen::Matrix3Xd>& offsets, JetFit& fit);
  double ConditionNumber(int degree) const;
  double NoiseGain(const JetFit& fit, int order) const;
  void Weigh(const Eigen::Ref<const Eigen::Matrix3Xd>& offsets, double radius);

  Eigen::Matrix3Xd Local_;
  Eigen::MatrixXd Matrix_;
  Eigen::VectorXd Heights_;
  Eigen::VectorXd RootWeights_;
  Factorization Solver_;
};

} // namespace ridges

#endif
