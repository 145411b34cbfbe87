// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Certification/SurfaceBounds.h"

#include <algorithm>

namespace ridges
{
namespace
{

using Box4 = Taylor3<4, Interval>;

/// Calls body(i, j, k) for all monomials up to a degree.
template <typename Body>
void ForMonomials(int degree, const Body& body)
{
  for (int i = 0; i <= degree; ++i)
  {
    for (int j = 0; i + j <= degree; ++j)
    {
      for (int k = 0; i + j + k <= degree; ++k)
      {
        body(i, j, k);
      }
    }
  }
}

constexpr double Binomials[5][5] = { { 1, 0, 0, 0, 0 }, { 1, 1, 0, 0, 0 }, { 1, 2, 1, 0, 0 },
  { 1, 3, 3, 1, 0 }, { 1, 4, 6, 4, 1 } };

std::array<std::array<Interval, 5>, 3> PowersOf(const IntervalVector& box)
{
  std::array<std::array<Interval, 5>, 3> powers;
  for (int axis = 0; axis < 3; ++axis)
  {
    powers[axis][0] = Interval(1.0);
    for (int n = 1; n <= 4; ++n)
    {
      powers[axis][n] = boost::numeric::pow(box[axis], n);
    }
  }
  return powers;
}

/// The coefficients at all points of the box: by Taylor's formula around the origin, with what the
/// box says about degree 4 as the remainder.
Box4 Expanded(const JetBounds& raw, const IntervalVector& box)
{
  const auto powers = PowersOf(box);
  Box4 result = raw.inBox;
  ForMonomials(3,
    [&raw, &powers, &result](int i, int j, int k)
    {
      Interval sum(0.0);
      ForMonomials(4 - i - j - k,
        [&raw, &powers, &sum, i, j, k](int p, int q, int r)
        {
          const double factor = Binomials[i + p][i] * Binomials[j + q][j] * Binomials[k + r][k];
          const bool isRemainder = i + j + k + p + q + r == 4;
          sum += Interval(factor) * (isRemainder ? raw.inBox : raw.atOrigin)(i + p, j + q, k + r) *
            (powers[0][p] * powers[1][q] * powers[2][r]);
        });
      result.Set(i, j, k, sum);
    });
  return result;
}

/// Coefficients of degree 4 in the box by those at the origin and those of degree 5 in the box,
/// which is better in small boxes. Formulas hide from interval arithmetic how much in them cancels
/// out.
Box4 WithFifthOrder(
  const Taylor3<5, Interval>& inBox, const Box4& atOrigin, const IntervalVector& box)
{
  Box4 result;
  ForMonomials(4,
    [&inBox, &atOrigin, &box, &result](int i, int j, int k)
    {
      Interval value = inBox(i, j, k);
      if (i + j + k == 4)
      {
        const Interval moved = atOrigin(i, j, k) + Interval(i + 1.0) * inBox(i + 1, j, k) * box[0] +
          Interval(j + 1.0) * inBox(i, j + 1, k) * box[1] +
          Interval(k + 1.0) * inBox(i, j, k + 1) * box[2];
        value = intersect(value, moved);
      }
      result.Set(i, j, k, value);
    });
  return result;
}

/// The coordinates of points of a box as polynomials of u, v and w.
template <int Degree>
std::array<Taylor3<Degree, Interval>, 3> Variables(
  const LocalFrame& frame, const IntervalVector& at)
{
  // The axes are orthonormal up to round-off: intervals of this size contain axes that are.
  constexpr double roundOff = 8.0 * std::numeric_limits<double>::epsilon();
  std::array<Taylor3<Degree, Interval>, 3> variables;
  for (int i = 0; i < 3; ++i)
  {
    std::array<Interval, 3> slopes;
    Interval constant = frame.origin[i];
    for (int axis = 0; axis < 3; ++axis)
    {
      slopes[axis] = Around(frame.axes(i, axis), roundOff);
      constant += slopes[axis] * at[axis];
    }
    variables[i] = Taylor3<Degree, Interval>::Linear(constant, slopes[0], slopes[1], slopes[2]);
  }
  return variables;
}

template <int Degree>
std::array<Taylor3<Degree>, 3> VariablesAt(const Eigen::Vector3d& x)
{
  using Jet = Taylor3<Degree>;
  return { Jet::Linear(x[0], 1.0, 0.0, 0.0), Jet::Linear(x[1], 0.0, 1.0, 0.0),
    Jet::Linear(x[2], 0.0, 0.0, 1.0) };
}

/// The middles of a box and the places where it is sampled; the first is the origin.
std::array<Eigen::Vector3d, Lanes::Count> Samples(const IntervalVector& box)
{
  const auto at = [&box](double u, double v, double w) -> Eigen::Vector3d
  {
    const auto between = [](const Interval& range, double share)
    { return 0.5 * ((1.0 - share) * range.lower() + (1.0 + share) * range.upper()); };
    return { between(box[0], u), between(box[1], v), between(box[2], w) };
  };
  return { Eigen::Vector3d::Zero(), at(-1, -1, -1), at(1, -1, 1), at(-1, 1, 1), at(1, 1, -1),
    at(0, 0, -1), at(0, 0, 1), at(0, 0, 0) };
}

} // namespace

JetBounds SurfaceBounds::In(const LocalFrame& frame, const IntervalVector& box) const
{
  JetBounds bounds = this->Raw(frame, box);
  bounds.inBox = Expanded(bounds, box);
  return bounds;
}

Taylor3<4> IntervalBounds::At(const Eigen::Vector3d& x) const
{
  return this->Sign() * this->Function_.Evaluate(VariablesAt<4>(x));
}

Taylor3<2> IntervalBounds::CurvatureAt(const Eigen::Vector3d& x) const
{
  return this->Sign() * this->Function_.Evaluate(VariablesAt<2>(x));
}

JetBounds IntervalBounds::Raw(const LocalFrame& frame, const IntervalVector& box) const
{
  const Interval zero(0.0);
  JetBounds bounds;
  bounds.atOrigin = this->Function_.Evaluate(Variables<4>(frame, { zero, zero, zero }));
  bounds.inBox =
    WithFifthOrder(this->Function_.Evaluate(Variables<5>(frame, box)), bounds.atOrigin, box);
  if (this->Sign() < 0.0)
  {
    bounds.atOrigin = -bounds.atOrigin;
    bounds.inBox = -bounds.inBox;
  }
  return bounds;
}

Taylor3<4> SampledBounds::At(const Eigen::Vector3d& x) const
{
  std::array<LaneVector3, 3> axes;
  LaneVector3 position;
  for (int i = 0; i < 3; ++i)
  {
    position[i] = Lanes(x[i]);
    axes[i].fill(Lanes(0.0));
    axes[i][i] = Lanes(1.0);
  }
  const JetFunction::Jet4 jets = this->Function_.Full(position, axes);
  Taylor3<4> jet;
  ForMonomials(4, [&jets, &jet](int i, int j, int k) { jet.Set(i, j, k, jets(i, j, k)[0]); });
  jet *= this->Sign();
  return jet;
}

Taylor3<2> SampledBounds::CurvatureAt(const Eigen::Vector3d& x) const
{
  const Taylor3<4> full = this->At(x);
  Taylor3<2> jet;
  ForMonomials(2, [&full, &jet](int i, int j, int k) { jet.Set(i, j, k, full(i, j, k)); });
  return jet;
}

JetBounds SampledBounds::Raw(const LocalFrame& frame, const IntervalVector& box) const
{
  const std::array<Eigen::Vector3d, Lanes::Count> samples = Samples(box);
  std::array<LaneVector3, 3> axes;
  LaneVector3 position;
  for (int i = 0; i < 3; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      axes[axis][i] = Lanes(frame.axes(i, axis));
    }
    for (int lane = 0; lane < Lanes::Count; ++lane)
    {
      position[i][lane] =
        boost::numeric::median(frame.origin[i]) + frame.axes.row(i).dot(samples[lane]);
    }
  }
  const JetFunction::Jet4 jets = this->Function_.Full(position, axes);
  JetBounds bounds;
  ForMonomials(4,
    [this, &jets, &bounds](int i, int j, int k)
    {
      const Lanes values = jets(i, j, k) * Lanes(this->Sign());
      // In floating point, what the origin's coefficients are worth.
      const double error = 64.0 * std::numeric_limits<double>::epsilon() * std::abs(values[0]);
      bounds.atOrigin.Set(i, j, k, Around(values[0], error));
      const auto [least, most] = std::minmax_element(values.values.begin(), values.values.end());
      const bool isFinite = std::all_of(
        values.values.begin(), values.values.end(), [](double x) { return std::isfinite(x); });
      const double margin = *most - *least + error;
      bounds.inBox.Set(
        i, j, k, isFinite ? Interval(*least - margin, *most + margin) : Interval::whole());
    });
  return bounds;
}

} // namespace ridges
