// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Elementary functions of truncated Taylor polynomials.
#ifndef ridges_Taylor3Functions_h
#define ridges_Taylor3Functions_h

#include "Formula/TaylorEquations.h"

#include <cmath>

namespace ridges
{

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
  return taylor::SineAndCosine(N(sin(a.Constant())), N(cos(a.Constant())), -1.0, a).first;
}

template <int D, typename N>
Taylor3<D, N> cos(const Taylor3<D, N>& a)
{
  using std::cos;
  using std::sin;
  return taylor::SineAndCosine(N(sin(a.Constant())), N(cos(a.Constant())), -1.0, a).second;
}

template <int D, typename N>
Taylor3<D, N> sinh(const Taylor3<D, N>& a)
{
  using std::cosh;
  using std::sinh;
  return taylor::SineAndCosine(N(sinh(a.Constant())), N(cosh(a.Constant())), 1.0, a).first;
}

template <int D, typename N>
Taylor3<D, N> cosh(const Taylor3<D, N>& a)
{
  using std::cosh;
  using std::sinh;
  return taylor::SineAndCosine(N(sinh(a.Constant())), N(cosh(a.Constant())), 1.0, a).second;
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
  return taylor::Integral(N(acos(a.Constant())), pow(Taylor3<D, N>(N(1.0)) - a * a, -0.5), a, -1.0);
}

} // namespace ridges

#endif
