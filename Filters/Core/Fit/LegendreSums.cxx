// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fit/LegendreSums.h"

#include "Monge/MongeForm.h"

#include <algorithm>
#include <cmath>

namespace ridges
{
namespace
{

constexpr int Highest = LegendreSums::HighestDegree;
using Polynomials = std::array<double, Highest + 1>;

/// Roots of 2 n + 1.
const std::array<double, Highest + 1>& Scale()
{
  static const auto scale = []()
  {
    std::array<double, Highest + 1> roots{};
    for (int n = 0; n <= Highest; ++n)
    {
      roots[n] = std::sqrt(2.0 * n + 1.0);
    }
    return roots;
  }();
  return scale;
}

/// P_i P_k as a sum of P_m.
using Products =
  std::array<std::array<std::array<double, 2 * Highest + 1>, Highest + 1>, Highest + 1>;

Products ProductsOfPolynomials()
{
  Products product{};
  for (int k = 0; k <= Highest; ++k)
  {
    product[0][k][k] = 1.0;
    for (int i = 0; i < Highest; ++i)
    {
      // By (i + 1) P_i+1 = (2 i + 1) x P_i - i P_i-1, and the same for x P_m.
      auto& next = product[i + 1][k];
      for (int m = 0; m <= i + k; ++m)
      {
        const double ofX = (2 * i + 1) * product[i][k][m] / ((i + 1) * (2 * m + 1));
        next[m + 1] += ofX * (m + 1);
        if (m > 0)
        {
          next[m - 1] += ofX * m;
        }
      }
      for (int m = 0; i > 0 && m <= i - 1 + k; ++m)
      {
        next[m] -= i * product[i - 1][k][m] / (i + 1);
      }
    }
  }
  return product;
}

} // namespace

void LegendreSums::Values(double x, int degree, double* values)
{
  values[0] = 1.0;
  values[1] = x;
  for (int n = 1; n < degree; ++n)
  {
    values[n + 1] = ((2 * n + 1) * x * values[n] - n * values[n - 1]) / (n + 1);
  }
  for (int n = 1; n <= degree; ++n)
  {
    values[n] *= Scale()[n];
  }
}

Eigen::MatrixXd LegendreSums::DerivativesAtZero(const int (*orders)[2], int count)
{
  std::array<Polynomials, 4> at{};
  at[0][0] = 1.0;
  at[1][1] = 1.0;
  for (int n = 1; n < Highest; ++n)
  {
    for (int k = 0; k < 4; ++k)
    {
      // Of x times a polynomial at 0, the derivative of order k is k times that of order k - 1.
      const double ofProduct = k > 0 ? k * at[k - 1][n] : 0.0;
      at[k][n + 1] = ((2 * n + 1) * ofProduct - n * at[k][n - 1]) / (n + 1);
    }
  }
  Eigen::MatrixXd derivatives(HeightJet::Size(Highest), count);
  for (int d = 0, row = 0; d <= Highest; ++d)
  {
    for (int j = 0; j <= d; ++j, ++row)
    {
      for (int f = 0; f < count; ++f)
      {
        derivatives(row, f) =
          at[orders[f][0]][d - j] * Scale()[d - j] * (at[orders[f][1]][j] * Scale()[j]);
      }
    }
  }
  return derivatives;
}

void LegendreSums::SetColumns(const Eigen::Array<double, Block, 1>& x, int degree, Columns& columns)
{
  columns.col(0).setOnes();
  columns.col(1) = x;
  for (int n = 1; n < degree; ++n)
  {
    columns.col(n + 1) = ((2 * n + 1.0) / (n + 1)) * x * columns.col(n).array() -
      (n / (n + 1.0)) * columns.col(n - 1).array();
  }
}

void LegendreSums::Add(const Eigen::Matrix3Xd& points, int degree)
{
  this->Degree_ = degree;
  this->Sums_.setZero();
  this->HeightSums_.setZero();
  for (Eigen::Index first = 0; first < points.cols(); first += Block)
  {
    const Eigen::Index count = std::min<Eigen::Index>(Block, points.cols() - first);
    Eigen::Array<double, Block, 3> part = Eigen::Array<double, Block, 3>::Zero();
    part.topRows(count) = points.middleCols(first, count).transpose();
    SetColumns(part.col(0), 2 * degree, this->U_);
    SetColumns(part.col(1), 2 * degree, this->V_);
    this->V_.bottomRows(Block - count).setZero();
    for (int a = 0; a <= 2 * degree; ++a)
    {
      const int size = 2 * degree - a + 1;
      this->Sums_.row(a).head(size).noalias() +=
        this->U_.col(a).transpose() * this->V_.leftCols(size);
    }
    for (int a = 0; a <= degree; ++a)
    {
      const int size = degree - a + 1;
      this->HeightSums_.row(a).head(size).noalias() +=
        (this->U_.col(a).array() * part.col(2)).matrix().transpose() * this->V_.leftCols(size);
    }
  }
}

Eigen::MatrixXd LegendreSums::Gram() const
{
  static const Products products = ProductsOfPolynomials();
  const auto& scale = Scale();
  const int degree = this->Degree_;
  Eigen::MatrixXd gram(HeightJet::Size(degree), HeightJet::Size(degree));
  // Entries whose polynomials in u are P_i and P_k.
  for (int i = 0; i <= degree; ++i)
  {
    for (int k = 0; k <= i; ++k)
    {
      Eigen::Matrix<double, 1, Size> inU = Eigen::Matrix<double, 1, Size>::Zero();
      for (int m = i - k; m <= i + k; m += 2)
      {
        inU.head(2 * degree - m + 1) +=
          products[i][k][m] * this->Sums_.row(m).head(2 * degree - m + 1);
      }
      for (int j = 0; j <= degree - i; ++j)
      {
        for (int l = 0; l <= degree - k; ++l)
        {
          double sum = 0.0;
          for (int n = std::abs(j - l); n <= j + l; n += 2)
          {
            sum += products[j][l][n] * inU[n];
          }
          const int row = HeightJet::Size(i + j - 1) + j;
          const int column = HeightJet::Size(k + l - 1) + l;
          gram(std::max(row, column), std::min(row, column)) =
            scale[i] * scale[k] * (scale[j] * scale[l]) * sum;
        }
      }
    }
  }
  return gram;
}

Eigen::VectorXd LegendreSums::Heights() const
{
  Eigen::VectorXd sums(HeightJet::Size(this->Degree_));
  for (int d = 0, row = 0; d <= this->Degree_; ++d)
  {
    for (int j = 0; j <= d; ++j, ++row)
    {
      sums[row] = Scale()[d - j] * Scale()[j] * this->HeightSums_(d - j, j);
    }
  }
  return sums;
}

} // namespace ridges
