// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// Comparison of Monge forms, whose frames are known up to half a turn.

#ifndef RIDGES_TESTING_MONGE_COMPARISON_H
#define RIDGES_TESTING_MONGE_COMPARISON_H

#include "AnalyticSurface.h"

#include "Monge/MongeForm.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace ridges
{
namespace testing
{

// The graph z = p(x, y) of a jet with p(0, 0) = 0, upward.
inline AnalyticSurface GraphSurface(const HeightJet& jet)
{
  return AnalyticSurface(
    [jet](auto x, auto y, auto z)
    {
      const double factorial[5] = { 1.0, 1.0, 2.0, 6.0, 24.0 };
      auto f = z;
      auto xPower = 0.0 * x + 1.0;
      for (int i = 0; i <= 4; ++i, xPower = xPower * x)
      {
        auto monomial = xPower;
        for (int j = 0; i + j <= 4; ++j, monomial = monomial * y)
        {
          f = f - jet.Derivative(i, j) / (factorial[i] * factorial[j]) * monomial;
        }
      }
      return f;
    });
}

// +1 if the frames agree, -1 if one is turned by half a turn.
inline double CommonSign(const MongeForm& form, const MongeForm& reference,
  const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity())
{
  return form.d1.dot(turn * reference.d1) < 0.0 ? -1.0 : 1.0;
}

// Of the coefficients of one degree (2 to 4), b up to its common sign.
inline double DifferenceOfDegree(
  int degree, const MongeForm& form, const MongeForm& reference, double sign)
{
  double largest = 0.0;
  const auto take = [&largest](double a, double b)
  { largest = std::max(largest, std::abs(a - b)); };
  if (degree == 2)
  {
    take(form.k1, reference.k1);
    take(form.k2, reference.k2);
  }
  for (std::size_t i = 0; degree == 3 && i < 4; ++i)
  {
    take(sign * form.b[i], reference.b[i]);
  }
  for (std::size_t i = 0; degree == 4 && i < 5; ++i)
  {
    take(form.c[i], reference.c[i]);
  }
  return largest;
}

// Of all coefficients and of the axes; the reference is turned first.
inline double LargestDifference(const MongeForm& form, const MongeForm& reference,
  const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity())
{
  const double sign = CommonSign(form, reference, turn);
  double largest = std::max({ (form.n - turn * reference.n).norm(),
    (sign * form.d1 - turn * reference.d1).norm(), (sign * form.d2 - turn * reference.d2).norm() });
  for (int degree = 2; degree <= 4; ++degree)
  {
    largest = std::max(largest, DifferenceOfDegree(degree, form, reference, sign));
  }
  return largest;
}

// The largest differences, relative to the largest coefficient of their order.
struct RelativeErrors
{
  double k = 0.0;
  double b = 0.0;
  double P = 0.0;

  void Add(const MongeForm& form, const MongeForm& expected)
  {
    const double sign = form.d1.dot(expected.d1) < 0.0 ? -1.0 : 1.0;
    const double scaleK = std::max(std::abs(expected.k1), std::abs(expected.k2));
    double scaleB = 0.0;
    double scaleC = 0.0;
    for (const double value : expected.b)
    {
      scaleB = std::max(scaleB, std::abs(value));
    }
    for (const double value : expected.c)
    {
      scaleC = std::max(scaleC, std::abs(value));
    }
    const double scaleP =
      3.0 * scaleB * scaleB + 2.0 * scaleK * (scaleC + 3.0 * std::pow(scaleK, 3));
    this->k = std::max({ this->k, std::abs(form.k1 - expected.k1) / scaleK,
      std::abs(form.k2 - expected.k2) / scaleK });
    this->P = std::max({ this->P, std::abs(form.P1() - expected.P1()) / scaleP,
      std::abs(form.P2() - expected.P2()) / scaleP });
    for (int i = 0; i < 4; ++i)
    {
      this->b = std::max(this->b, std::abs(sign * form.b[i] - expected.b[i]) / scaleB);
    }
  }
};

} // namespace testing
} // namespace ridges

#endif
