// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_Taylor3_h
#define ridges_Taylor3_h

#include <algorithm>
#include <array>

namespace ridges
{

/**
 * Truncated Taylor arithmetic: a function of three variables, carried as its polynomial of total
 * degree <= Degree. Evaluating a formula on it gives the exact jet of the formula. Coefficients are
 * those of the monomials: derivatives divided by the factorials. Degree 4 has 35 of them.
 *
 * Number is double, or several doubles at once (Lanes). The polynomial knows the highest degree
 * that it may have: most of a formula is of low degree, and products of that are cheap.
 *
 * Taylor3Functions.h has the elementary functions.
 */
template <int Degree, typename Number = double>
class Taylor3
{
public:
  static constexpr int Size = (Degree + 1) * (Degree + 2) * (Degree + 3) / 6;

  Taylor3() = default;
  Taylor3(const Number& constant) // implicit, so that formulas read as formulas
  {
    this->Coefficients_[0] = constant;
  }

  /// constant + du u + dv v + dw w, where (u, v, w) are the variables of the jet.
  static Taylor3 Linear(
    const Number& constant, const Number& du, const Number& dv, const Number& dw)
  {
    Taylor3 result(constant);
    result.Top_ = 1;
    result.Coefficients_[1] = du;
    result.Coefficients_[2] = dv;
    result.Coefficients_[3] = dw;
    return result;
  }

  /// Index of the first coefficient of a degree.
  static constexpr int Offset(int degree) { return degree * (degree + 1) * (degree + 2) / 6; }

  /// Graded order; index of u^i v^j w^k.
  static constexpr int Index(int i, int j, int k)
  {
    const int r = j + k;
    return Offset(i + r) + r * (r + 1) / 2 + k;
  }

  Number operator()(int i, int j, int k) const { return this->Coefficients_[Index(i, j, k)]; }
  void Set(int i, int j, int k, const Number& value)
  {
    this->Top_ = std::max(this->Top_, i + j + k);
    this->Coefficients_[Index(i, j, k)] = value;
  }

  const Number& Constant() const { return this->Coefficients_[0]; }
  void SetConstant(const Number& value) { this->Coefficients_[0] = value; }

  /// All coefficients of degrees above this one are 0.
  int Top() const { return this->Top_; }

  /// In graded order.
  const std::array<Number, Size>& Coefficients() const { return this->Coefficients_; }

  Taylor3& operator+=(const Taylor3& other)
  {
    this->Top_ = std::max(this->Top_, other.Top_);
    for (int i = 0; i < UsedBy(other.Top_); ++i)
    {
      this->Coefficients_[i] += other.Coefficients_[i];
    }
    return *this;
  }
  Taylor3& operator-=(const Taylor3& other)
  {
    this->Top_ = std::max(this->Top_, other.Top_);
    for (int i = 0; i < UsedBy(other.Top_); ++i)
    {
      this->Coefficients_[i] -= other.Coefficients_[i];
    }
    return *this;
  }
  Taylor3& operator*=(const Number& factor)
  {
    for (int i = 0; i < UsedBy(this->Top_); ++i)
    {
      this->Coefficients_[i] *= factor;
    }
    return *this;
  }
  Taylor3& operator/=(const Number& divisor)
  {
    for (int i = 0; i < UsedBy(this->Top_); ++i)
    {
      this->Coefficients_[i] /= divisor;
    }
    return *this;
  }

  friend Taylor3 operator-(Taylor3 a) { return a *= Number(-1.0); }
  friend Taylor3 operator+(Taylor3 a, const Taylor3& b) { return a += b; }
  friend Taylor3 operator-(Taylor3 a, const Taylor3& b) { return a -= b; }
  friend Taylor3 operator*(Taylor3 a, const Number& b) { return a *= b; }
  friend Taylor3 operator*(const Number& a, Taylor3 b) { return b *= a; }
  friend Taylor3 operator/(Taylor3 a, const Number& b) { return a /= b; }
  friend Taylor3 operator*(const Taylor3& a, const Taylor3& b)
  {
    Taylor3 result;
    if constexpr (IsSmall)
    {
      result = b * a.Constant();
      for (int i = 1; i < Size; ++i)
      {
        result.Coefficients_[i] += a.Coefficients_[i] * b.Constant();
      }
      result.Top_ = Degree;
      return result;
    }
    result.SetTop(a.Top_ + b.Top_);
    for (int i = 0; i <= a.Top_; ++i)
    {
      for (int j = 0; j <= b.Top_ && i + j <= Degree; ++j)
      {
        result.AddProduct(1.0, a, i, b, j);
      }
    }
    return result;
  }

  // For the functions, which work degree by degree.

  void SetTop(int degree) { this->Top_ = std::min(degree, Degree); }

  /// Adds, to the part of degree i + j, factor times part i of a times part j of b.
  void AddProduct(double factor, const Taylor3& a, int i, const Taylor3& b, int j)
  {
    for (int ra = 0; ra <= i; ++ra)
    {
      for (int ka = 0; ka <= ra; ++ka)
      {
        const Number left = a.Coefficients_[Offset(i) + ra * (ra + 1) / 2 + ka] * Number(factor);
        for (int rb = 0; rb <= j; ++rb)
        {
          const int r = ra + rb;
          Number* to = &this->Coefficients_[Offset(i + j) + r * (r + 1) / 2 + ka];
          const Number* right = &b.Coefficients_[Offset(j) + rb * (rb + 1) / 2];
          for (int kb = 0; kb <= rb; ++kb)
          {
            to[kb] += left * right[kb];
          }
        }
      }
    }
  }

  /// Adds factor times part d of another polynomial.
  void AddPart(double factor, const Taylor3& a, int d)
  {
    for (int i = Offset(d); i < Offset(d + 1); ++i)
    {
      this->Coefficients_[i] += a.Coefficients_[i] * Number(factor);
    }
  }

  void DividePart(int d, const Number& divisor)
  {
    for (int i = Offset(d); i < Offset(d + 1); ++i)
    {
      this->Coefficients_[i] /= divisor;
    }
  }

private:
  /// Gradients are looked for by the million: their loops are to be unrolled.
  static constexpr bool IsSmall = Degree <= 1;

  static constexpr int UsedBy(int top) { return IsSmall ? Size : Offset(top + 1); }

  int Top_ = 0;
  std::array<Number, Size> Coefficients_{};
};

} // namespace ridges

#endif
