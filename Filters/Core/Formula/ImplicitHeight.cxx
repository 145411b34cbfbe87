// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Formula/ImplicitHeight.h"

#include <cstddef>

namespace ridges
{
namespace
{

/// A polynomial in u and v of which all terms are of degree D; value j belongs to u^(D - j) v^j.
template <int D>
using Part = std::array<double, D + 1>;

/// The terms of f of degree D in u and v and of degree k in w.
template <int D>
Part<D> PartOf(const Taylor3<4>& f, int k)
{
  Part<D> part;
  for (int j = 0; j <= D; ++j)
  {
    part[j] = f(D - j, j, k);
  }
  return part;
}

template <std::size_t A, std::size_t B>
std::array<double, A + B - 1> operator*(
  const std::array<double, A>& a, const std::array<double, B>& b)
{
  std::array<double, A + B - 1> product{};
  for (std::size_t i = 0; i < A; ++i)
  {
    for (std::size_t j = 0; j < B; ++j)
    {
      product[i + j] += a[i] * b[j];
    }
  }
  return product;
}

template <std::size_t N>
std::array<double, N> operator+(std::array<double, N> a, const std::array<double, N>& b)
{
  for (std::size_t i = 0; i < N; ++i)
  {
    a[i] += b[i];
  }
  return a;
}

template <std::size_t N>
std::array<double, N> operator*(double factor, std::array<double, N> a)
{
  for (double& value : a)
  {
    value *= factor;
  }
  return a;
}

/// Coefficients become derivatives.
template <int D>
void Store(const Part<D>& part, HeightJet& jet)
{
  for (int j = 0; j <= D; ++j)
  {
    jet.derivatives[HeightJet::Index(D - j, j)] =
      HeightJet::Factorial(D - j) * HeightJet::Factorial(j) * part[j];
  }
}

HeightJet JetOf(const Part<2>& w2, const Part<3>& w3, const Part<4>& w4)
{
  HeightJet jet;
  Store<2>(w2, jet);
  Store<3>(w3, jet);
  Store<4>(w4, jet);
  return jet;
}

} // namespace

// With g the coefficient of w alone, and F(d, k) the terms of degree d in u and v and k in w, the
// surface is -g w = F(2, 0) + F(3, 0) + F(4, 0) + (F(1, 1) + F(2, 1)) w + F(0, 2) w² + ... Since w
// begins with degree 2, putting its parts in degree by degree gives each from those before it.
HeightJet HeightOfImplicit(const Taylor3<4>& f)
{
  const double factor = -1.0 / f(0, 0, 1);
  const Part<2> w2 = factor * PartOf<2>(f, 0);
  const Part<1> tilt = PartOf<1>(f, 1);
  const Part<3> w3 = factor * (PartOf<3>(f, 0) + tilt * w2);
  const Part<4> w4 =
    factor * (PartOf<4>(f, 0) + tilt * w3 + PartOf<2>(f, 1) * w2 + PartOf<0>(f, 2) * (w2 * w2));
  return JetOf(w2, w3, w4);
}

// With h the height sought, z(s, t) = h(x(s, t), y(s, t)), where x = s + x2 + x3 + ... and
// y = t + y2 + y3 + ...: again degree by degree.
HeightJet HeightOfParametric(const std::array<Taylor3<4>, 3>& xyz)
{
  const Part<2> x2 = PartOf<2>(xyz[0], 0);
  const Part<2> y2 = PartOf<2>(xyz[1], 0);
  const Part<3> x3 = PartOf<3>(xyz[0], 0);
  const Part<3> y3 = PartOf<3>(xyz[1], 0);

  const Part<2> h2 = PartOf<2>(xyz[2], 0);
  // The derivatives of h2 by its two arguments.
  const Part<1> h2x{ 2.0 * h2[0], h2[1] };
  const Part<1> h2y{ h2[1], 2.0 * h2[2] };
  const Part<3> h3 = PartOf<3>(xyz[2], 0) + (-1.0) * (h2x * x2 + h2y * y2);

  const Part<2> h3x{ 3.0 * h3[0], 2.0 * h3[1], h3[2] };
  const Part<2> h3y{ h3[1], 2.0 * h3[2], 3.0 * h3[3] };
  const Part<4> ofSecond =
    h2[0] * (x2 * x2) + h2[1] * (x2 * y2) + h2[2] * (y2 * y2) + h2x * x3 + h2y * y3;
  const Part<4> h4 = PartOf<4>(xyz[2], 0) + (-1.0) * (ofSecond + h3x * x2 + h3y * y2);
  return JetOf(h2, h3, h4);
}

} // namespace ridges
