// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_FormulaOperations_h
#define ridges_FormulaOperations_h

#include "Formula/Lanes.h"
#include "Formula/Taylor3Functions.h"

#include <cmath>
#include <cstdlib>

namespace ridges
{

/// What formulas are made of. All functions are smooth wherever they are finite: abs, min and max
/// are left out, as a surface has no curvature where they have a kink.
enum class FormulaOperation
{
  Variable,
  // With a constant c
  AddConstant,
  SubtractFromConstant, // c - a
  Scale,
  DivideByConstant,
  DivideConstant, // c / a
  IntegerPower,
  ConstantPower, // a ^ c
  // Of two operands
  Add,
  Subtract,
  Multiply,
  Divide,
  Power,
  // Functions
  Exp,
  Log,
  Sqrt,
  Cbrt,
  Sin,
  Cos,
  Tan,
  Asin,
  Acos,
  Atan,
  Sinh,
  Cosh,
  Tanh
};

constexpr bool HasConstant(FormulaOperation operation)
{
  return operation >= FormulaOperation::AddConstant && operation <= FormulaOperation::ConstantPower;
}

constexpr bool IsBinary(FormulaOperation operation)
{
  return operation >= FormulaOperation::Add && operation <= FormulaOperation::Power;
}

/// a^n by squaring: exact derivatives where a is 0, too.
template <typename T>
T IntegerPower(const T& base, int n)
{
  T a = base;
  T result(1.0);
  for (int left = std::abs(n); left > 0; left /= 2)
  {
    if (left % 2 == 1)
    {
      result = left == std::abs(n) ? a : result * a;
    }
    if (left > 1)
    {
      a = a * a;
    }
  }
  return n < 0 ? T(1.0) / result : result;
}

template <typename T>
void ApplyBinary(FormulaOperation operation, T& a, const T& b)
{
  using std::exp;
  using std::log;
  switch (operation)
  {
    case FormulaOperation::Add:
      a += b;
      break;
    case FormulaOperation::Subtract:
      a -= b;
      break;
    case FormulaOperation::Multiply:
      a = a * b;
      break;
    case FormulaOperation::Divide:
      a = a / b;
      break;
    default:
      a = exp(b * log(a));
  }
}

template <typename T>
void ApplyWithConstant(FormulaOperation operation, T& a, double constant, int exponent)
{
  using std::pow;
  switch (operation)
  {
    case FormulaOperation::AddConstant:
      a += T(constant);
      break;
    case FormulaOperation::SubtractFromConstant:
      a *= -1.0;
      a += T(constant);
      break;
    case FormulaOperation::Scale:
      a *= constant;
      break;
    case FormulaOperation::DivideByConstant:
      a /= constant;
      break;
    case FormulaOperation::DivideConstant:
      a = T(constant) / a;
      break;
    case FormulaOperation::IntegerPower:
      a = IntegerPower(a, exponent);
      break;
    default:
      a = pow(a, constant);
  }
}

template <typename T>
void ApplyFunction(FormulaOperation operation, T& a)
{
  // clang-format off
  using std::exp; using std::log; using std::sqrt; using std::cbrt;
  using std::sin; using std::cos; using std::tan; using std::asin; using std::acos; using std::atan;
  using std::sinh; using std::cosh; using std::tanh;
  switch (operation)
  {
    case FormulaOperation::Exp: a = exp(a); break;
    case FormulaOperation::Log: a = log(a); break;
    case FormulaOperation::Sqrt: a = sqrt(a); break;
    case FormulaOperation::Cbrt: a = cbrt(a); break;
    case FormulaOperation::Sin: a = sin(a); break;
    case FormulaOperation::Cos: a = cos(a); break;
    case FormulaOperation::Tan: a = tan(a); break;
    case FormulaOperation::Asin: a = asin(a); break;
    case FormulaOperation::Acos: a = acos(a); break;
    case FormulaOperation::Atan: a = atan(a); break;
    case FormulaOperation::Sinh: a = sinh(a); break;
    case FormulaOperation::Cosh: a = cosh(a); break;
    default: a = tanh(a);
  }
  // clang-format on
}

} // namespace ridges

#endif
