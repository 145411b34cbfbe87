// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Elementary functions of truncated Taylor polynomials.
//
// Each function satisfies a differential equation, in which E = u d/du + v d/dv + w d/dw multiplies
// the part of degree d of a polynomial by d. For f = exp(a) it is E f = f E a, and comparing parts
// of degree d gives d f_d = sum over k = 1..d of k a_k f_(d-k): each function costs about as much
// as one product or two, in any number of variables.
#ifndef ridges_Taylor3Functions_h
#define ridges_Taylor3Functions_h

#include "Formula/Taylor3.h"

#include <cmath>

namespace ridges
{

namespace taylor
{

/// Part d of a function f with E f = g E a; parts of g below d are known.
template <int D, typename N>
void AddIntegralPart(
  Taylor3<D, N>& f, double sign, const Taylor3<D, N>& g, const Taylor3<D, N>& a, int d)
{
  for (int k = 1; k <= std::min(d, a.Top()); ++k)
  {
    if (d - k <= g.Top())
    {
      f.AddProduct(sign * k / d, a, k, g, d - k);
    }
  }
}

/// f with E f = g E a and the constant term f0.
template <int D, typename N>
Taylor3<D, N> Integral(
  const N& f0, const Taylor3<D, N>& g, const Taylor3<D, N>& a, double sign = 1.0)
{
  Taylor3<D, N> f(f0);
  f.SetTop(a.Top() > 0 ? D : 0);
  for (int d = 1; d <= f.Top(); ++d)
  {
    AddIntegralPart(f, sign, g, a, d);
  }
  return f;
}

/// s and c with E s = c E a and E c = sign s E a: sine and cosine, hyperbolic for sign +1.
template <int D, typename N>
void SineAndCosine(const Taylor3<D, N>& a, double sign, Taylor3<D, N>& s, Taylor3<D, N>& c)
{
  const int top = a.Top() > 0 ? D : 0;
  s.SetTop(top);
  c.SetTop(top);
  for (int d = 1; d <= top; ++d)
  {
    AddIntegralPart(s, 1.0, c, a, d);
    AddIntegralPart(c, sign, s, a, d);
  }
}

/// f with E f = (1 + sign f²) E a: tangent, hyperbolic for sign -1.
template <int D, typename N>
Taylor3<D, N> Tangent(const N& f0, double sign, const Taylor3<D, N>& a)
{
  Taylor3<D, N> f(f0);
  Taylor3<D, N> g(N(1.0) + N(sign) * f0 * f0);
  const int top = a.Top() > 0 ? D : 0;
  f.SetTop(top);
  g.SetTop(top);
  for (int d = 1; d <= top; ++d)
  {
    AddIntegralPart(f, 1.0, g, a, d);
    for (int i = 0; i <= d; ++i)
    {
      g.AddProduct(sign, f, i, f, d - i);
    }
  }
  return f;
}

/// f = a^p with the constant term f0, from a E f = p f E a.
template <int D, typename N>
Taylor3<D, N> Power(const N& f0, double p, const Taylor3<D, N>& a)
{
  Taylor3<D, N> f(f0);
  f.SetTop(a.Top() > 0 ? D : 0);
  for (int d = 1; d <= f.Top(); ++d)
  {
    for (int k = 1; k <= std::min(d, a.Top()); ++k)
    {
      f.AddProduct((p * k - (d - k)) / d, a, k, f, d - k);
    }
    f.DividePart(d, a.Constant());
  }
  return f;
}

} // namespace taylor

template <int D, typename N>
Taylor3<D, N> operator/(const Taylor3<D, N>& a, const Taylor3<D, N>& b)
{
  Taylor3<D, N> f(a.Constant() / b.Constant());
  f.SetTop(b.Top() > 0 ? D : a.Top());
  for (int d = 1; d <= f.Top(); ++d)
  {
    f.AddPart(1.0, a, d);
    for (int k = 1; k <= std::min(d, b.Top()); ++k)
    {
      f.AddProduct(-1.0, b, k, f, d - k);
    }
    f.DividePart(d, b.Constant());
  }
  return f;
}

template <int D, typename N>
Taylor3<D, N> exp(const Taylor3<D, N>& a)
{
  using std::exp;
  Taylor3<D, N> f(exp(a.Constant()));
  f.SetTop(a.Top() > 0 ? D : 0);
  for (int d = 1; d <= f.Top(); ++d)
  {
    taylor::AddIntegralPart(f, 1.0, f, a, d);
  }
  return f;
}

template <int D, typename N>
Taylor3<D, N> log(const Taylor3<D, N>& a)
{
  using std::log;
  return taylor::Integral(log(a.Constant()), Taylor3<D, N>(N(1.0)) / a, a);
}

/// The constant term must be positive, or not zero if the exponent is an integer.
template <int D, typename N>
Taylor3<D, N> pow(const Taylor3<D, N>& a, double exponent)
{
  using std::pow;
  return taylor::Power(N(pow(a.Constant(), exponent)), exponent, a);
}

template <int D, typename N>
Taylor3<D, N> sqrt(const Taylor3<D, N>& a)
{
  using std::sqrt;
  return taylor::Power(N(sqrt(a.Constant())), 0.5, a);
}

template <int D, typename N>
Taylor3<D, N> cbrt(const Taylor3<D, N>& a)
{
  using std::cbrt;
  return taylor::Power(N(cbrt(a.Constant())), 1.0 / 3.0, a);
}

template <int D, typename N>
Taylor3<D, N> sin(const Taylor3<D, N>& a)
{
  using std::cos;
  using std::sin;
  Taylor3<D, N> s(sin(a.Constant()));
  Taylor3<D, N> c(cos(a.Constant()));
  taylor::SineAndCosine(a, -1.0, s, c);
  return s;
}

template <int D, typename N>
Taylor3<D, N> cos(const Taylor3<D, N>& a)
{
  using std::cos;
  using std::sin;
  Taylor3<D, N> s(sin(a.Constant()));
  Taylor3<D, N> c(cos(a.Constant()));
  taylor::SineAndCosine(a, -1.0, s, c);
  return c;
}

template <int D, typename N>
Taylor3<D, N> sinh(const Taylor3<D, N>& a)
{
  using std::cosh;
  using std::sinh;
  Taylor3<D, N> s(sinh(a.Constant()));
  Taylor3<D, N> c(cosh(a.Constant()));
  taylor::SineAndCosine(a, 1.0, s, c);
  return s;
}

template <int D, typename N>
Taylor3<D, N> cosh(const Taylor3<D, N>& a)
{
  using std::cosh;
  using std::sinh;
  Taylor3<D, N> s(sinh(a.Constant()));
  Taylor3<D, N> c(cosh(a.Constant()));
  taylor::SineAndCosine(a, 1.0, s, c);
  return c;
}

template <int D, typename N>
Taylor3<D, N> tan(const Taylor3<D, N>& a)
{
  using std::tan;
  return taylor::Tangent(N(tan(a.Constant())), 1.0, a);
}

template <int D, typename N>
Taylor3<D, N> tanh(const Taylor3<D, N>& a)
{
  using std::tanh;
  return taylor::Tangent(N(tanh(a.Constant())), -1.0, a);
}

template <int D, typename N>
Taylor3<D, N> atan(const Taylor3<D, N>& a)
{
  using std::atan;
  const Taylor3<D, N> one(N(1.0));
  return taylor::Integral(N(atan(a.Constant())), one / (one + a * a), a);
}

template <int D, typename N>
Taylor3<D, N> asin(const Taylor3<D, N>& a)
{
  using std::asin;
  return taylor::Integral(N(asin(a.Constant())), pow(Taylor3<D, N>(N(1.0)) - a * a, -0.5), a);
}

template <int D, typename N>
Taylor3<D, N> acos(const Taylor3<D, N>& a)
{
  using std::acos;
  return taylor::Integral(
    N(acos(a.Constant())), pow(Taylor3<D, N>(N(1.0)) - a * a, -0.5), a, -1.0);
}

} // namespace ridges

#endif
