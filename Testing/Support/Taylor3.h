// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Truncated Taylor arithmetic: a function of three variables is carried as its polynomial of total
// degree <= Degree, so that evaluating a formula on it gives the exact jet of the formula.

#ifndef RIDGES_TESTING_TAYLOR3_H
#define RIDGES_TESTING_TAYLOR3_H

#include <array>
#include <cmath>
#include <cstddef>

namespace ridges
{
namespace testing
{

// Degree 4 gives 35 coefficients. Coefficients are those of the monomials: derivatives divided by
// the factorials.
template <int Degree>
class Taylor3
{
public:
  static constexpr int Size = (Degree + 1) * (Degree + 2) * (Degree + 3) / 6;

  Taylor3() = default;
  Taylor3(double constant) // implicit, so that formulas read as formulas
  {
    this->Coefficients[0] = constant;
  }

  // constant + du u + dv v + dw w, where (u, v, w) are the variables of the jet.
  static Taylor3 Linear(double constant, double du, double dv, double dw)
  {
    Taylor3 result(constant);
    result.Coefficients[1] = du;
    result.Coefficients[2] = dv;
    result.Coefficients[3] = dw;
    return result;
  }

  // Graded order; index of u^i v^j w^k.
  static constexpr int Index(int i, int j, int k)
  {
    const int d = i + j + k;
    const int r = j + k;
    return d * (d + 1) * (d + 2) / 6 + r * (r + 1) / 2 + k;
  }

  double& operator()(int i, int j, int k) { return this->Coefficients[Index(i, j, k)]; }
  double operator()(int i, int j, int k) const { return this->Coefficients[Index(i, j, k)]; }
  double Constant() const { return this->Coefficients[0]; }

  Taylor3& operator+=(const Taylor3& other)
  {
    for (int i = 0; i < Size; ++i)
    {
      this->Coefficients[i] += other.Coefficients[i];
    }
    return *this;
  }
  Taylor3& operator*=(double factor)
  {
    for (double& coefficient : this->Coefficients)
    {
      coefficient *= factor;
    }
    return *this;
  }

  friend Taylor3 operator-(Taylor3 a) { return a *= -1.0; }
  friend Taylor3 operator+(Taylor3 a, const Taylor3& b) { return a += b; }
  friend Taylor3 operator-(const Taylor3& a, Taylor3 b)
  {
    b *= -1.0;
    return b += a;
  }
  friend Taylor3 operator*(Taylor3 a, double b) { return a *= b; }
  friend Taylor3 operator*(double a, Taylor3 b) { return b *= a; }
  friend Taylor3 operator/(Taylor3 a, double b) { return a *= 1.0 / b; }
  friend Taylor3 operator*(const Taylor3& a, const Taylor3& b)
  {
    Taylor3 result;
    for (const Product& product : Products)
    {
      result.Coefficients[product.to] +=
        a.Coefficients[product.left] * b.Coefficients[product.right];
    }
    return result;
  }
  friend Taylor3 operator/(const Taylor3& a, const Taylor3& b) { return a * pow(b, -1.0); }

  friend Taylor3 exp(const Taylor3& a)
  {
    std::array<double, Degree + 1> series{};
    series[0] = std::exp(a.Constant());
    for (int n = 1; n <= Degree; ++n)
    {
      series[n] = series[n - 1] / n;
    }
    return Compose(series, a);
  }
  // The constant term must be positive, or non-zero for an integer exponent.
  friend Taylor3 pow(const Taylor3& a, double exponent)
  {
    std::array<double, Degree + 1> series{};
    series[0] = std::pow(a.Constant(), exponent);
    for (int n = 1; n <= Degree; ++n)
    {
      series[n] = series[n - 1] * (exponent - n + 1) / (n * a.Constant());
    }
    return Compose(series, a);
  }
  friend Taylor3 sqrt(const Taylor3& a) { return pow(a, 0.5); }

private:
  struct Product
  {
    int left = 0;
    int right = 0;
    int to = 0;
  };
  static constexpr int ProductCount =
    (Degree + 1) * (Degree + 2) * (Degree + 3) * (Degree + 4) * (Degree + 5) * (Degree + 6) / 720;

  static constexpr std::array<Product, ProductCount> MakeProducts()
  {
    std::array<Product, ProductCount> products{};
    int count = 0;
    for (int di = 0; di <= Degree; ++di)
    {
      for (int ri = 0; ri <= di; ++ri)
      {
        for (int ki = 0; ki <= ri; ++ki)
        {
          for (int dj = 0; di + dj <= Degree; ++dj)
          {
            for (int rj = 0; rj <= dj; ++rj)
            {
              for (int kj = 0; kj <= rj; ++kj)
              {
                products[count].left = Index(di - ri, ri - ki, ki);
                products[count].right = Index(dj - rj, rj - kj, kj);
                products[count].to = Index(di - ri + dj - rj, ri - ki + rj - kj, ki + kj);
                ++count;
              }
            }
          }
        }
      }
    }
    return products;
  }

  // Powers of (a - constant) beyond Degree vanish, so Horner's rule is exact.
  static Taylor3 Compose(const std::array<double, Degree + 1>& series, Taylor3 a)
  {
    a.Coefficients[0] = 0.0;
    Taylor3 result(series[Degree]);
    for (int n = Degree - 1; n >= 0; --n)
    {
      result = result * a + Taylor3(series[n]);
    }
    return result;
  }

  static const std::array<Product, ProductCount> Products;
  std::array<double, Size> Coefficients{};
};

template <int Degree>
const std::array<typename Taylor3<Degree>::Product, Taylor3<Degree>::ProductCount>
  Taylor3<Degree>::Products = Taylor3<Degree>::MakeProducts();

} // namespace testing
} // namespace ridges

#endif
