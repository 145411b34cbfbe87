// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_Series2_h
#define ridges_Series2_h

#include <array>
#include <cmath>

namespace ridges
{

/// A polynomial of two variables, truncated beyond the total degree D. Coefficients are in the
/// order of HeightJet. Number is double or Interval.
template <int D, typename Number>
class Series2
{
public:
  static constexpr int Size = (D + 1) * (D + 2) / 2;
  static constexpr int Index(int i, int j) { return (i + j) * (i + j + 1) / 2 + j; }

  Series2() { this->C_.fill(Number(0.0)); }
  Series2(const Number& constant) // implicit, so that formulas read as formulas
    : Series2()
  {
    this->C_[0] = constant;
  }

  /// Of u^i v^j.
  const Number& operator()(int i, int j) const { return this->C_[Index(i, j)]; }
  Number& operator()(int i, int j) { return this->C_[Index(i, j)]; }

  const Number& Constant() const { return this->C_[0]; }
  const Number& U() const { return this->C_[1]; }
  const Number& V() const { return this->C_[2]; }

  Series2& operator+=(const Series2& other)
  {
    for (int i = 0; i < Size; ++i)
    {
      this->C_[i] += other.C_[i];
    }
    return *this;
  }
  Series2& operator-=(const Series2& other)
  {
    for (int i = 0; i < Size; ++i)
    {
      this->C_[i] -= other.C_[i];
    }
    return *this;
  }
  Series2& operator*=(const Number& factor)
  {
    for (Number& c : this->C_)
    {
      c *= factor;
    }
    return *this;
  }

  friend Series2 operator+(Series2 a, const Series2& b) { return a += b; }
  friend Series2 operator-(Series2 a, const Series2& b) { return a -= b; }
  friend Series2 operator-(Series2 a) { return a *= Number(-1.0); }
  friend Series2 operator*(const Number& factor, Series2 a) { return a *= factor; }
  friend Series2 operator*(const Series2& a, const Series2& b)
  {
    Series2 result;
    for (int da = 0; da <= D; ++da)
    {
      for (int db = 0; da + db <= D; ++db)
      {
        result.AddProduct(a, da, b, db);
      }
    }
    return result;
  }

  /// Not where the constant of b can be 0.
  friend Series2 operator/(const Series2& a, const Series2& b)
  {
    Series2 f;
    for (int d = 0; d <= D; ++d)
    {
      Series2 rest;
      for (int k = 1; k <= d; ++k)
      {
        rest.AddProduct(b, k, f, d - k);
      }
      for (int i = Offset(d); i < Offset(d + 1); ++i)
      {
        f.C_[i] = (a.C_[i] - rest.C_[i]) / b.C_[0];
      }
    }
    return f;
  }

  /// Where the constant is positive.
  friend Series2 Root(const Series2& a)
  {
    using std::sqrt;
    Series2 f(sqrt(a.C_[0]));
    for (int d = 1; d <= D; ++d)
    {
      Series2 rest;
      for (int k = 1; k < d; ++k)
      {
        rest.AddProduct(f, k, f, d - k);
      }
      for (int i = Offset(d); i < Offset(d + 1); ++i)
      {
        f.C_[i] = (a.C_[i] - rest.C_[i]) / (Number(2.0) * f.C_[0]);
      }
    }
    return f;
  }

private:
  static constexpr int Offset(int degree) { return degree * (degree + 1) / 2; }

  void AddProduct(const Series2& a, int da, const Series2& b, int db)
  {
    for (int i = 0; i <= da; ++i)
    {
      for (int j = 0; j <= db; ++j)
      {
        this->C_[Offset(da + db) + i + j] += a.C_[Offset(da) + i] * b.C_[Offset(db) + j];
      }
    }
  }

  std::array<Number, Size> C_;
};

/// d^(i+j) / du^i dv^j of a series, as one of lower degree.
template <int D, int From, typename Number>
Series2<D, Number> Derivative(const Series2<From, Number>& a, int i, int j)
{
  Series2<D, Number> result;
  for (int p = 0; p <= D; ++p)
  {
    for (int q = 0; p + q <= D; ++q)
    {
      double factor = 1.0;
      for (int k = 1; k <= i; ++k)
      {
        factor *= p + k;
      }
      for (int k = 1; k <= j; ++k)
      {
        factor *= q + k;
      }
      result(p, q) = Number(factor) * a(p + i, q + j);
    }
  }
  return result;
}

} // namespace ridges

#endif
