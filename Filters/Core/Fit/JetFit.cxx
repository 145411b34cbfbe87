// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fit/JetFit.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

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

/// From coefficients of monomials in units of the radius to derivatives.
void SetDerivatives(const Eigen::VectorXd& coefficients, int degree, JetFit& fit)
{
  double scale = fit.radius;
  for (int d = 0; d <= degree; ++d, scale /= fit.radius)
  {
    for (int j = 0; j <= d; ++j)
    {
      const int i = HeightJet::Index(d - j, j);
      fit.jet.derivatives[i] =
        coefficients[i] * HeightJet::Factorial(d - j) * HeightJet::Factorial(j) * scale;
    }
  }
}

} // namespace

// The points in the frame and in units of the radius: their heights, and the monomials of u and v.
void JetFitter::SetMonomials(
  const Eigen::Ref<const Eigen::Matrix3Xd>& offsets, const JetFit& fit, int degree)
{
  const Eigen::Index count = offsets.cols();
  this->Matrix_.resize(count, HeightJet::Size(degree));
  this->Heights_.resize(count);
  for (Eigen::Index row = 0; row < count; ++row)
  {
    const Eigen::Vector3d local = fit.frame.transpose() * offsets.col(row) / fit.radius;
    this->Heights_[row] = local[2];
    this->Matrix_(row, 0) = 1.0;
    for (int d = 1; d <= degree; ++d)
    {
      for (int j = 0; j < d; ++j)
      {
        this->Matrix_(row, HeightJet::Index(d - j, j)) =
          this->Matrix_(row, HeightJet::Index(d - 1 - j, j)) * local[0];
      }
      this->Matrix_(row, HeightJet::Index(0, d)) =
        this->Matrix_(row, HeightJet::Index(0, d - 1)) * local[1];
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

JetFit JetFitter::Fit(const Eigen::Ref<const Eigen::Matrix3Xd>& offsets, int degree,
  const Eigen::Vector3d& side, Weighting weighting)
{
  JetFit fit;
  const Eigen::Index count = offsets.cols();
  while (degree > 0 && count < HeightJet::Size(degree))
  {
    --degree;
    fit.status |= FitTooFewPoints;
  }
  if (degree == 0)
  {
    return fit;
  }
  fit.radius = std::sqrt(offsets.colwise().squaredNorm().maxCoeff());
  if (!(fit.radius > 0.0) || !std::isfinite(fit.radius) ||
    !PrincipalFrame(offsets / fit.radius, side, fit.frame))
  {
    return fit;
  }

  const int size = HeightJet::Size(degree);
  this->SetMonomials(offsets, fit, degree);
  double totalWeight = static_cast<double>(count);
  this->RootWeights_.resize(0);
  if (weighting == Weighting::Gaussian)
  {
    this->Weigh(offsets, fit.radius);
    totalWeight = this->RootWeights_.squaredNorm();
  }

  this->Solver_.compute(this->Matrix_);
  const Eigen::VectorXd solution = this->Solver_.solve(this->Heights_);
  const auto pivots = this->Solver_.matrixQTZ().diagonal().cwiseAbs();
  fit.rank = static_cast<int>(this->Solver_.rank());
  fit.conditionNumber =
    pivots[size - 1] > 0.0 ? pivots[0] / pivots[size - 1] : std::numeric_limits<double>::max();
  fit.residual = (this->Matrix_ * solution - this->Heights_).norm() / std::sqrt(totalWeight);

  SetDerivatives(solution, degree, fit);
  fit.degree = degree;
  fit.status = static_cast<std::uint8_t>(fit.status & ~FitInvalid);
  if (fit.rank < size || fit.conditionNumber > IllConditionedAbove)
  {
    fit.status |= FitIllConditioned;
  }
  return fit;
}

} // namespace ridges
