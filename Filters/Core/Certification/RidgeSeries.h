// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_RidgeSeries_h
#define ridges_RidgeSeries_h

#include "Certification/Series2.h"
#include "Formula/Taylor3.h"

#include <array>

namespace ridges
{

/**
 * The surface f(u, v, w) = 0 as a height w over the plane of u and v, by its Taylor polynomial at a
 * point of the surface: f is given by its polynomial there. Unlike HeightOfImplicit, the plane need
 * not be the tangent plane; with intervals, the result holds for all points of a box at once.
 */
template <typename Number>
Series2<4, Number> HeightSeries(const Taylor3<4, Number>& f)
{
  std::array<Series2<4, Number>, 5> parts; // f = sum of parts[k] w^k
  for (int k = 0; k <= 4; ++k)
  {
    for (int i = 0; i + k <= 4; ++i)
    {
      for (int j = 0; i + j + k <= 4; ++j)
      {
        parts[k](i, j) = f(i, j, k);
      }
    }
  }
  parts[0](0, 0) = Number(0.0);
  parts[1](0, 0) = Number(0.0);
  const Number factor = Number(-1.0) / f(0, 0, 1);
  Series2<4, Number> w;
  for (int degree = 1; degree <= 4; ++degree) // is right after this round
  {
    Series2<4, Number> sum = parts[4];
    for (int k = 3; k >= 0; --k)
    {
      sum = sum * w + parts[k];
    }
    w = factor * sum;
  }
  return w;
}

/**
 * The second and third fundamental forms of a graph, as Taylor polynomials of degree D in u and v.
 * They are taken in the orthonormal frame of the tangent plane that is nearest to the axes u and v,
 * which T maps to tangent vectors.
 */
template <int D, typename Number>
struct GraphSeries
{
  using Series = Series2<D, Number>;
  std::array<Series, 2> slope;
  std::array<Series, 3> second; ///< Derivatives uu, uv, vv of the height.
  Series squaredArea;           ///< 1 + slope²
  std::array<Series, 3> T;      ///< 00, 01 = 10, 11

  explicit GraphSeries(const Series2<4, Number>& height)
  {
    this->slope = { Derivative<D>(height, 1, 0), Derivative<D>(height, 0, 1) };
    this->second = { Derivative<D>(height, 2, 0), Derivative<D>(height, 1, 1),
      Derivative<D>(height, 0, 2) };
    const auto& [gu, gv] = this->slope;
    const Series one(Number(1.0));
    const Series guu = gu * gu;
    const Series gvv = gv * gv;
    this->squaredArea = one + guu + gvv;
    const Series q = one / (this->squaredArea + Root(this->squaredArea));
    this->T = { one - q * guu, -(q * (gu * gv)), one - q * gvv };
  }

  /**
   * (k1 - k2) (cos 2t, sin 2t), where t is the angle from the frame to d1, times the area element:
   * the difference of the diagonal of the second fundamental form and twice its other element.
   */
  std::array<Series, 2> Anisotropy() const
  {
    const auto& [h00, h01, h11] = this->second;
    const auto& [t00, t01, t11] = this->T;
    const Series a00 = h00 * t00 + h01 * t01;
    const Series a01 = h00 * t01 + h01 * t11;
    const Series a10 = h01 * t00 + h11 * t01;
    const Series a11 = h01 * t01 + h11 * t11;
    const Series m01 = t00 * a01 + t01 * a11;
    return { t00 * a00 + t01 * a10 - (t01 * a01 + t11 * a11), m01 + m01 };
  }
};

/// The third derivatives of the height, with their gradients.
template <typename Number>
struct CubicSeries
{
  using Series = Series2<1, Number>;
  std::array<Series, 4> third; ///< Derivatives uuu, uuv, uvv, vvv of the height.

  explicit CubicSeries(const Series2<4, Number>& height)
    : third{ Derivative<1>(height, 3, 0), Derivative<1>(height, 2, 1), Derivative<1>(height, 1, 2),
      Derivative<1>(height, 0, 3) }
  {
  }
};

/// The extremality in the direction (d0, d1) of a graph's frame, times a positive factor: with a
/// the tangent vector T d and g the slope, (1 + g²) h_ijk aaa - 3 (h_ij aa) (g_i h_ij a).
template <typename Series>
Series ExtremalityAlong(const std::array<Series, 2>& slope, const std::array<Series, 3>& second,
  const std::array<Series, 4>& third, const Series& squaredArea, const std::array<Series, 3>& T,
  const std::array<Series, 2>& d)
{
  const Series a0 = T[0] * d[0] + T[1] * d[1];
  const Series a1 = T[1] * d[0] + T[2] * d[1];
  const Series a00 = a0 * a0;
  const Series a01 = a0 * a1;
  const Series a11 = a1 * a1;
  const Series three(3.0);
  const Series cubic =
    third[0] * a00 * a0 + three * (third[1] * a00 * a1 + third[2] * a0 * a11) + third[3] * a11 * a1;
  const Series quadratic = second[0] * a00 + second[1] * (a01 + a01) + second[2] * a11;
  const Series bend0 = slope[0] * second[0] + slope[1] * second[1];
  const Series bend1 = slope[0] * second[1] + slope[1] * second[2];
  return squaredArea * cubic - three * (quadratic * (bend0 * a0 + bend1 * a1));
}

} // namespace ridges

#endif
