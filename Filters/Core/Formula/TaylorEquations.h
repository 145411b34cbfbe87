// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The differential equations from which functions of Taylor polynomials are computed.
//
// E = u d/du + v d/dv + w d/dw multiplies the part of degree d of a polynomial by d. The function
// f = exp(a) satisfies E f = f E a, and comparing parts of degree d gives
// d f_d = sum over k = 1..d of k a_k f_(d-k). Others are similar. A function costs about as much as
// one product or two.
#ifndef ridges_TaylorEquations_h
#define ridges_TaylorEquations_h

#include "Formula/Taylor3.h"

#include <algorithm>
#include <utility>

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

/// s and c with E s = c E a, E c = sign s E a and these constant terms: sine and cosine, hyperbolic
/// for sign +1.
template <int D, typename N>
std::pair<Taylor3<D, N>, Taylor3<D, N>> SineAndCosine(
  const N& s0, const N& c0, double sign, const Taylor3<D, N>& a)
{
  std::pair<Taylor3<D, N>, Taylor3<D, N>> result{ Taylor3<D, N>(s0), Taylor3<D, N>(c0) };
  auto& [s, c] = result;
  const int top = a.Top() > 0 ? D : 0;
  s.SetTop(top);
  c.SetTop(top);
  for (int d = 1; d <= top; ++d)
  {
    AddIntegralPart(s, 1.0, c, a, d);
    AddIntegralPart(c, sign, s, a, d);
  }
  return result;
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

} // namespace ridges

#endif
