// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fit/JetErrors.h"

#include "Base/SymmetricTensor.h"

#include <algorithm>
#include <cmath>

namespace ridges
{
namespace
{

enum Column
{
  K1 = 0,
  K2 = 1,
  B0 = 2,
  P1 = 6,
  P2 = 7
};

/// A small change of the height over the tangent plane, by its derivatives along d1 and d2.
struct HeightChange
{
  SymmetricTensor<1> first{};
  SymmetricTensor<2> second{};
  SymmetricTensor<3> third{};
  SymmetricTensor<4> fourth{};
};

template <int Order>
void SetUnit(SymmetricTensor<Order>& tensor, int j, const Eigen::Vector2d& e1,
  const Eigen::Vector2d& e2, double g)
{
  SymmetricTensor<Order> unit{};
  unit[j] = 1.0 / g;
  tensor = InBasis(unit, e1, e2);
}

/// What the change does to the Monge form, as a row of the gradient. It tilts the normal by its
/// slope, and turns the principal directions by `turn`, which mixes coefficients of one order.
Eigen::Matrix<double, 1, MongeGradient::ColsAtCompileTime> ChangeOfMongeForm(
  const MongeForm& form, const HeightChange& change)
{
  const double k1 = form.k1;
  const double k2 = form.k2;
  const auto& b = form.b;
  const auto& c = form.c;
  const auto& [slope1, slope2] = change.first;
  const double turn = change.second[1] / (k1 - k2);

  const double dk1 = change.second[0];
  const double dk2 = change.second[2];
  const std::array<double, 4> db = { change.third[0] + 3.0 * b[1] * turn - 3.0 * k1 * k1 * slope1,
    change.third[1] + (2.0 * b[2] - b[0]) * turn - k1 * k2 * slope2,
    change.third[2] + (b[3] - 2.0 * b[1]) * turn - k1 * k2 * slope1,
    change.third[3] - 3.0 * b[2] * turn - 3.0 * k2 * k2 * slope2 };
  const double dc0 =
    change.fourth[0] + 4.0 * c[1] * turn - k1 * (10.0 * b[0] * slope1 + 6.0 * b[1] * slope2);
  const double dc4 =
    change.fourth[4] - 4.0 * c[3] * turn - k2 * (6.0 * b[2] * slope1 + 10.0 * b[3] * slope2);
  const double dP1 = 6.0 * b[1] * db[1] + (dk1 - dk2) * (c[0] - 3.0 * k1 * k1 * k1) +
    (k1 - k2) * (dc0 - 9.0 * k1 * k1 * dk1);
  const double dP2 = 6.0 * b[2] * db[2] + (dk2 - dk1) * (c[4] - 3.0 * k2 * k2 * k2) +
    (k2 - k1) * (dc4 - 9.0 * k2 * k2 * dk2);

  Eigen::Matrix<double, 1, MongeGradient::ColsAtCompileTime> row;
  row << dk1, dk2, db[0], db[1], db[2], db[3], dP1, dP2;
  return row;
}

/// The standard error that a unit variance of the heights gives to `factors`, a column each: the
/// gradients times the inverse of the triangular factor.
Eigen::VectorXd UnitErrors(const JetFitter& fitter, const Eigen::MatrixXd& factors)
{
  const Eigen::VectorXd& rootWeights = fitter.LastRootWeights();
  if (rootWeights.size() == 0)
  {
    return factors.colwise().norm();
  }
  // The estimate is a sum of the heights, each times its weight's root and an element of this.
  Eigen::MatrixXd shares = Eigen::MatrixXd::Zero(rootWeights.size(), factors.cols());
  shares.topRows(factors.rows()) = factors;
  shares.applyOnTheLeft(fitter.LastFactorization().householderQ());
  return (rootWeights.asDiagonal() * shares).colwise().norm();
}

/// Variance of the heights in units of the radius, without bias; negative if it is not known.
double Variance(const JetFitter& fitter, const JetFit& fit, Eigen::Index size)
{
  const JetFitter::Factorization& solver = fitter.LastFactorization();
  const Eigen::VectorXd& rootWeights = fitter.LastRootWeights();
  if (solver.rows() <= size)
  {
    return JetErrors::Unknown;
  }
  double totalWeight = static_cast<double>(solver.rows());
  double freedom = totalWeight - static_cast<double>(size);
  if (rootWeights.size() > 0)
  {
    // Of each weight, the part that its point's leverage does not take.
    Eigen::MatrixXd basis = Eigen::MatrixXd::Identity(solver.rows(), size);
    basis.applyOnTheLeft(solver.householderQ());
    totalWeight = rootWeights.squaredNorm();
    freedom = totalWeight - (rootWeights.asDiagonal() * basis).squaredNorm();
  }
  return fit.residual * fit.residual * totalWeight / freedom;
}

} // namespace

MongeGradient GradientOfMongeForm(const HeightJet& jet)
{
  const MongeForm form = MongeFormOfHeightJet(jet, Eigen::Matrix3d::Identity());
  const double g = 1.0 / form.n.z();
  const Eigen::Vector2d e1 = form.d1.head<2>();
  const Eigen::Vector2d e2 = form.d2.head<2>();

  MongeGradient gradient = MongeGradient::Zero();
  for (int degree = 1; degree <= HeightJet::MaximumDegree; ++degree)
  {
    for (int j = 0; j <= degree; ++j)
    {
      HeightChange change;
      switch (degree)
      {
        case 1:
          SetUnit<1>(change.first, j, e1, e2, g);
          break;
        case 2:
          SetUnit<2>(change.second, j, e1, e2, g);
          break;
        case 3:
          SetUnit<3>(change.third, j, e1, e2, g);
          break;
        default:
          SetUnit<4>(change.fourth, j, e1, e2, g);
      }
      gradient.row(HeightJet::Index(degree - j, j)) = ChangeOfMongeForm(form, change);
    }
  }
  return gradient;
}

// With the weighted least squares W^1/2 A P = Q R, the coefficients are P R^-1 Q^T W^1/2 h, and a
// quantity of gradient g changes by (R^-T P^T g)^T Q^T W^1/2 dh.
JetErrors StandardErrors(const JetFitter& fitter, const JetFit& fit)
{
  JetErrors errors;
  const int size = HeightJet::Size(fit.degree);
  if ((fit.status & FitInvalid) || fit.degree < 2 || fit.rank < size)
  {
    return errors;
  }
  const double variance = Variance(fitter, fit, size);
  if (!(variance >= 0.0))
  {
    return errors;
  }

  const JetFitter::Factorization& solver = fitter.LastFactorization();
  // Coefficients above order 4 do not matter to the Monge form.
  const int order = std::min(fit.degree, HeightJet::MaximumDegree);
  Eigen::MatrixXd factors = Eigen::MatrixXd::Zero(size, MongeGradient::ColsAtCompileTime);
  factors.topRows(HeightJet::Size(order)) =
    GradientOfMongeForm(fit.jet).topRows(HeightJet::Size(order));
  for (int d = 0; d <= order; ++d)
  {
    for (int j = 0; j <= d; ++j)
    {
      factors.row(HeightJet::Index(d - j, j)) *= fit.DerivativePerCoefficient(d - j, j);
    }
  }
  factors.applyOnTheLeft(solver.colsPermutation().transpose());
  solver.matrixQTZ()
    .topLeftCorner(size, size)
    .triangularView<Eigen::Upper>()
    .transpose()
    .solveInPlace(factors);
  const Eigen::VectorXd unit = UnitErrors(fitter, factors);

  const auto error = [&variance, &unit, &fit](int column, int degree)
  {
    const double value = std::sqrt(variance) * unit[column];
    return fit.degree >= degree && std::isfinite(value) ? value : JetErrors::Unknown;
  };
  errors.k1 = error(K1, 2);
  errors.k2 = error(K2, 2);
  for (int i = 0; i < 4; ++i)
  {
    errors.b[i] = error(B0 + i, 3);
  }
  errors.P1 = error(P1, 4);
  errors.P2 = error(P2, 4);
  return errors;
}

} // namespace ridges
