// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fit/FieldErrors.h"

#include <algorithm>
#include <cmath>

namespace ridges
{
namespace
{

/// Covariance of the derivatives of orders a and b of a stationary process along an axis, whose own
/// covariance is exp(-r^2 / (4 sigma^2)).
double AxisCovariance(int a, int b, double sigma)
{
  if ((a + b) % 2 != 0)
  {
    return 0.0;
  }
  double value = (a - b) % 4 == 0 ? 1.0 : -1.0;
  for (int odd = a + b - 1; odd > 0; odd -= 2)
  {
    value *= odd / (2.0 * sigma * sigma);
  }
  return value;
}

using Covariance = Eigen::Matrix<double, HeightJet::MaximumSize, HeightJet::MaximumSize>;

Covariance CovarianceOfHeight(double sigma)
{
  Covariance covariance;
  for (int d = 0; d <= HeightJet::MaximumDegree; ++d)
  {
    for (int j = 0; j <= d; ++j)
    {
      for (int e = 0; e <= HeightJet::MaximumDegree; ++e)
      {
        for (int k = 0; k <= e; ++k)
        {
          covariance(HeightJet::Index(d - j, j), HeightJet::Index(e - k, k)) =
            AxisCovariance(d - j, e - k, sigma) * AxisCovariance(j, k, sigma);
        }
      }
    }
  }
  return covariance;
}

/// The height over the tangent plane, along the principal directions.
HeightJet HeightOf(const MongeForm& form)
{
  HeightJet jet;
  jet.derivatives[HeightJet::Index(2, 0)] = form.k1;
  jet.derivatives[HeightJet::Index(0, 2)] = form.k2;
  std::copy(form.b.begin(), form.b.end(), &jet.derivatives[HeightJet::Index(3, 0)]);
  std::copy(form.c.begin(), form.c.end(), &jet.derivatives[HeightJet::Index(4, 0)]);
  return jet;
}

} // namespace

JetErrors ErrorsOfDisplacement(const MongeForm& form, double deviation, double sigma)
{
  const MongeGradient gradient = GradientOfMongeForm(HeightOf(form));
  const Covariance covariance = CovarianceOfHeight(sigma);
  std::array<double, MongeGradient::ColsAtCompileTime> errors{};
  for (int i = 0; i < MongeGradient::ColsAtCompileTime; ++i)
  {
    const double variance = gradient.col(i).dot(covariance * gradient.col(i));
    const double error = deviation * std::sqrt(std::max(variance, 0.0));
    errors[i] = std::isfinite(error) ? error : JetErrors::Unknown;
  }
  return { errors[0], errors[1], { errors[2], errors[3], errors[4], errors[5] }, errors[6],
    errors[7] };
}

} // namespace ridges
