// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fit/LegendreSums.h"

#include "Monge/MongeForm.h"

#include <gtest/gtest.h>

#include <random>

namespace
{

using namespace ridges;

// Columns of u, v and the height.
Eigen::Matrix3Xd RandomPoints(int count)
{
  std::mt19937_64 generator(count);
  std::uniform_real_distribution<double> between(-1.0, 1.0);
  return Eigen::Matrix3Xd::NullaryExpr(3, count, [&]() { return between(generator); });
}

// A column per point, in the order of HeightJet.
Eigen::MatrixXd BasisAt(const Eigen::Matrix3Xd& points, int degree)
{
  Eigen::MatrixXd basis(HeightJet::Size(degree), points.cols());
  Eigen::VectorXd u(degree + 1);
  Eigen::VectorXd v(degree + 1);
  for (Eigen::Index i = 0; i < points.cols(); ++i)
  {
    LegendreSums::Values(points(0, i), degree, u.data());
    LegendreSums::Values(points(1, i), degree, v.data());
    for (int d = 0, row = 0; d <= degree; ++d)
    {
      for (int j = 0; j <= d; ++j, ++row)
      {
        basis(row, i) = u[d - j] * v[j];
      }
    }
  }
  return basis;
}

} // namespace

// For numbers of points below, at and above those that are added side by side.
TEST(LegendreSums, AreThoseOfTheBasis)
{
  LegendreSums sums;
  for (const int count : { 7, 32, 33, 200 })
  {
    for (int degree = 2; degree <= LegendreSums::HighestDegree; degree += 2)
    {
      const Eigen::Matrix3Xd points = RandomPoints(count);
      const Eigen::MatrixXd basis = BasisAt(points, degree);
      sums.Add(points, degree);
      const Eigen::MatrixXd gram = basis * basis.transpose();
      const Eigen::MatrixXd difference = gram - sums.Gram();
      const Eigen::MatrixXd lower = difference.triangularView<Eigen::Lower>();
      EXPECT_LT(lower.cwiseAbs().maxCoeff(), 1e-13 * gram.maxCoeff()) << count << ", " << degree;
      const Eigen::VectorXd heights = basis * points.row(2).transpose();
      EXPECT_LT((heights - sums.Heights()).norm(), 1e-13 * heights.norm())
        << count << ", " << degree;
    }
  }
}

// By the third differences of values at steps of h: an error of order h squared.
TEST(LegendreSums, HaveTheDerivativesOfTheBasis)
{
  constexpr int degree = LegendreSums::HighestDegree;
  constexpr double h = 1e-3;
  constexpr int orders[][2] = { { 2, 0 }, { 0, 3 } };
  const Eigen::MatrixXd derivatives = LegendreSums::DerivativesAtZero(orders, 2);
  Eigen::Matrix3Xd alongU = Eigen::Matrix3Xd::Zero(3, 3);
  alongU.row(0) << -h, 0.0, h;
  Eigen::Matrix3Xd alongV = Eigen::Matrix3Xd::Zero(3, 4);
  alongV.row(1) << -1.5 * h, -0.5 * h, 0.5 * h, 1.5 * h;
  const Eigen::VectorXd second =
    BasisAt(alongU, degree) * Eigen::Vector3d(1.0, -2.0, 1.0) / (h * h);
  const Eigen::VectorXd third =
    BasisAt(alongV, degree) * Eigen::Vector4d(-1.0, 3.0, -3.0, 1.0) / (h * h * h);
  EXPECT_LT((derivatives.col(0) - second).norm(), 1e-3 * second.norm());
  EXPECT_LT((derivatives.col(1) - third).norm(), 1e-3 * third.norm());
}
