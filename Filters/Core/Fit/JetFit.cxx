// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fit/JetFit.h"

#include "Fit/DiskMoment.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ridges
{
namespace
{

/// Axes by growing spread in the columns 2, 1, 0; false where the points lie on a line.
bool PrincipalFrame(const Eigen::Ref<const Eigen::Matrix3Xd>& offsets, const Eigen::Vector3d& side,
  Eigen::Matrix3d& frame)
{
  const Eigen::Vector3d mean = offsets.rowwise().mean();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (Eigen::Index i = 0; i < offsets.cols(); ++i)
  {
    const Eigen::Vector3d d = offsets.col(i) - mean;
    covariance.noalias() += d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Eigen::Vector3d& spread = solver.eigenvalues();
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  if (!(spread[1] > 16.0 * epsilon * spread[2]))
  {
    return false;
  }
  frame.col(2) = solver.eigenvectors().col(0);
  if (frame.col(2).dot(side) < 0.0)
  {
    frame.col(2) = -frame.col(2);
  }
  frame.col(0) = solver.eigenvectors().col(2);
  frame.col(1) = frame.col(2).cross(frame.col(0));
  return true;
}

/// Axes by falling spread in the plane across an axis, which is the column 2; false where the
/// points lie on a line in it.
bool FrameAlong(const Eigen::Vector3d& axis, const Eigen::Ref<const Eigen::Matrix3Xd>& offsets,
  Eigen::Matrix3d& frame)
{
  const Eigen::Vector3d u = axis.unitOrthogonal();
  const Eigen::Vector3d v = axis.cross(u);
  const Eigen::Vector3d mean = offsets.rowwise().mean();
  double uu = 0.0;
  double uv = 0.0;
  double vv = 0.0;
  for (Eigen::Index i = 0; i < offsets.cols(); ++i)
  {
    const Eigen::Vector3d d = offsets.col(i) - mean;
    uu += d.dot(u) * d.dot(u);
    uv += d.dot(u) * d.dot(v);
    vv += d.dot(v) * d.dot(v);
  }
  const double angle = 0.5 * std::atan2(2.0 * uv, uu - vv);
  frame.col(2) = axis;
  frame.col(0) = std::cos(angle) * u + std::sin(angle) * v;
  frame.col(1) = axis.cross(frame.col(0));
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const double mean2 = 0.5 * (uu + vv);
  const double least = mean2 - std::hypot(0.5 * (uu - vv), uv);
  return axis.squaredNorm() > 0.5 && least > 16.0 * epsilon * mean2;
}

/// The scalar products over the unit disk of all monomials of a degree and less.
Eigen::MatrixXd ProductsOverDisk(int degree)
{
  const int size = HeightJet::Size(degree);
  Eigen::VectorXi powersOfU(size);
  Eigen::VectorXi powersOfV(size);
  for (int d = 0; d <= degree; ++d)
  {
    for (int j = 0; j <= d; ++j)
    {
      powersOfU[HeightJet::Index(d - j, j)] = d - j;
      powersOfV[HeightJet::Index(d - j, j)] = j;
    }
  }
  return Eigen::MatrixXd::NullaryExpr(size, size,
    [&powersOfU, &powersOfV](Eigen::Index row, Eigen::Index column)
    { return DiskMoment(powersOfU[row] + powersOfU[column], powersOfV[row] + powersOfV[column]); });
}

} // namespace

double JetFit::DerivativePerCoefficient(int i, int j) const
{
  return HeightJet::Factorial(i) * HeightJet::Factorial(j) * std::pow(this->extents[0], -i) *
    std::pow(this->extents[1], -j) * std::pow(this->radius, 1 - i - j);
}

/// The matrix and the right-hand side of the least squares, and the extents.
void JetFitter::SetMonomials(const Eigen::Ref<const Eigen::Matrix3Xd>& offsets, JetFit& fit)
{
  const int degree = fit.degree;
  const Eigen::Index count = offsets.cols();
  this->Local_.noalias() = (fit.frame.transpose() / fit.radius) * offsets;
  fit.extents = this->Local_.topRows<2>().cwiseAbs().rowwise().maxCoeff();
  this->Heights_ = this->Local_.row(2);
  this->Matrix_.resize(count, HeightJet::Size(degree));
  for (Eigen::Index row = 0; row < count; ++row)
  {
    const double u = this->Local_(0, row) / fit.extents[0];
    const double v = this->Local_(1, row) / fit.extents[1];
    this->Matrix_(row, 0) = 1.0;
    for (int d = 1; d <= degree; ++d)
    {
      for (int j = 0; j < d; ++j)
      {
        this->Matrix_(row, HeightJet::Index(d - j, j)) =
          this->Matrix_(row, HeightJet::Index(d - 1 - j, j)) * u;
      }
      this->Matrix_(row, HeightJet::Index(0, d)) =
        this->Matrix_(row, HeightJet::Index(0, d - 1)) * v;
    }
  }
}

void JetFitter::Weigh(const Eigen::Ref<const Eigen::Matrix3Xd>& offsets, double radius)
{
  this->RootWeights_.resize(offsets.cols());
  for (Eigen::Index row = 0; row < offsets.cols(); ++row)
  {
    this->RootWeights_[row] =
      std::sqrt(GaussianWeight(offsets.col(row).squaredNorm(), radius * radius));
  }
  this->Matrix_.array().colwise() *= this->RootWeights_.array();
  this->Heights_.array() *= this->RootWeights_.array();
}

// With A P = Q R, the covariance of the coefficients is (R P^T)^-1 times its transpose, for heights
// of unit variance.
double JetFitter::NoiseGain(const JetFit& fit, int order) const
{
  const int size = HeightJet::Size(fit.degree);
  Eigen::MatrixXd derivatives = Eigen::MatrixXd::Zero(size, order + 1);
  double binomial = 1.0;
  for (int j = 0; j <= order; ++j)
  {
    derivatives(HeightJet::Index(order - j, j), j) = std::sqrt(binomial) *
      fit.DerivativePerCoefficient(order - j, j) * std::pow(fit.radius, order - 1);
    binomial *= static_cast<double>(order - j) / (j + 1);
  }
  derivatives.applyOnTheLeft(this->Solver_.colsPermutation().transpose());
  this->Solver_.matrixQTZ()
    .topLeftCorner(size, size)
    .triangularView<Eigen::Upper>()
    .transpose()
    .solveInPlace(derivatives);
  const auto count = static_cast<double>(this->Solver_.rows());
  return derivatives.norm() * std::sqrt(count / std::max(1.0, count - size));
}

// With A P = Q R, and M = L L^T the products over the disk of the monomials, the columns of A L^-T
// are orthonormal polynomials at the points, and those of R P^T L^-T have the same singular values.
double JetFitter::ConditionNumber(int degree) const
{
  constexpr int orthonormalFrom = 5;
  const int size = HeightJet::Size(degree);
  const auto ratio = [size](const auto& pivots)
  {
    return std::abs(pivots[size - 1]) > 0.0 ? std::abs(pivots[0] / pivots[size - 1])
                                            : std::numeric_limits<double>::max();
  };
  if (degree < orthonormalFrom)
  {
    return ratio(this->Solver_.matrixQTZ().diagonal());
  }
  if (this->Solver_.rank() < size)
  {
    return std::numeric_limits<double>::max();
  }
  static const std::array<Eigen::MatrixXd, MaximumDegree + 1> factors = []
  {
    std::array<Eigen::MatrixXd, MaximumDegree + 1> all;
    for (int d = orthonormalFrom; d <= MaximumDegree; ++d)
    {
      all[d] = ProductsOverDisk(d).llt().matrixL();
    }
    return all;
  }();
  Eigen::MatrixXd matrix = this->Solver_.matrixQTZ().topLeftCorner(size, size);
  matrix.triangularView<Eigen::StrictlyLower>().setZero();
  matrix = matrix * this->Solver_.colsPermutation().transpose();
  factors[degree].triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(
    matrix);
  return ratio(Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(matrix).matrixQR().diagonal());
}

/// The degree and the radius; the degree is 0 if nothing can be fitted.
JetFit JetFitter::Begin(const Eigen::Ref<const Eigen::Matrix3Xd>& offsets, int degree) const
{
  JetFit fit;
  while (degree > 0 && offsets.cols() < HeightJet::Size(degree))
  {
    --degree;
    fit.status |= FitTooFewPoints;
  }
  if (degree > 0)
  {
    fit.radius = std::sqrt(offsets.colwise().squaredNorm().maxCoeff());
    fit.degree = fit.radius > 0.0 && std::isfinite(fit.radius) ? degree : 0;
  }
  return fit;
}

JetFit JetFitter::Fit(const Eigen::Ref<const Eigen::Matrix3Xd>& offsets, int degree,
  const Eigen::Vector3d& side, Weighting weighting)
{
  JetFit fit = this->Begin(offsets, degree);
  if (fit.degree > 0 && !PrincipalFrame(offsets / fit.radius, side, fit.frame))
  {
    fit.degree = 0;
  }
  if (fit.degree > 0)
  {
    this->FitInFrame(offsets, weighting, fit);
  }
  return fit;
}

JetFit JetFitter::FitAlong(const Eigen::Vector3d& axis,
  const Eigen::Ref<const Eigen::Matrix3Xd>& offsets, int degree, Weighting weighting)
{
  JetFit fit = this->Begin(offsets, degree);
  if (fit.degree > 0 && !FrameAlong(axis.stableNormalized(), offsets / fit.radius, fit.frame))
  {
    fit.degree = 0;
  }
  if (fit.degree > 0)
  {
    this->FitInFrame(offsets, weighting, fit);
  }
  return fit;
}

void JetFitter::FitInFrame(
  const Eigen::Ref<const Eigen::Matrix3Xd>& offsets, Weighting weighting, JetFit& fit)
{
  const int degree = fit.degree;
  const Eigen::Index count = offsets.cols();
  const int size = HeightJet::Size(degree);
  this->SetMonomials(offsets, fit);

  double totalWeight = static_cast<double>(count);
  this->RootWeights_.resize(0);
  if (weighting == Weighting::Gaussian)
  {
    this->Weigh(offsets, fit.radius);
    totalWeight = this->RootWeights_.squaredNorm();
  }

  this->Solver_.compute(this->Matrix_);
  const Eigen::VectorXd solution = this->Solver_.solve(this->Heights_);
  fit.rank = static_cast<int>(this->Solver_.rank());
  fit.conditionNumber = this->ConditionNumber(degree);
  fit.residual = (this->Matrix_ * solution - this->Heights_).norm() / std::sqrt(totalWeight);

  for (int d = 0; d <= std::min(degree, HeightJet::MaximumDegree); ++d)
  {
    for (int j = 0; j <= d; ++j)
    {
      const int i = HeightJet::Index(d - j, j);
      fit.jet.derivatives[i] = solution[i] * fit.DerivativePerCoefficient(d - j, j);
    }
  }
  const bool isDetermined = fit.rank == size && fit.conditionNumber <= IllConditionedAbove;
  if (degree >= 3 && fit.rank == size)
  {
    fit.noiseGain = this->NoiseGain(fit, 3);
  }
  fit.status = static_cast<std::uint8_t>(fit.status & ~FitInvalid);
  // Where points lie in a narrow strip, or nearly on a curve that is a zero of the polynomial, what
  // is left over may be large against what the surface curves.
  constexpr double narrow = 0.2;
  const bool isWeak = fit.extents.minCoeff() < narrow || fit.conditionNumber > WellConditionedBelow;
  const bool isLost =
    isDetermined && degree >= 2 && isWeak && this->UncertainTurn(fit) > MostTurnOfWeak;
  if (!isDetermined || isLost)
  {
    fit.status |= FitIllConditioned;
  }
}

} // namespace ridges
