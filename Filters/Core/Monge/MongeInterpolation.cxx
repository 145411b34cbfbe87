// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Monge/MongeInterpolation.h"

#include "Base/SymmetricTensor.h"
#include "Monge/AcuteRule.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace ridges
{
namespace
{

using Turn = MongeInterpolation::Turn;

/// The form of an order in the frame turned from the one it is given in.
template <int Order>
SymmetricTensor<Order> Turned(const SymmetricTensor<Order>& form, const Turn& turn)
{
  return InBasis(form, { turn.cosine, turn.sine }, { -turn.sine, turn.cosine });
}

Turn Back(const Turn& turn)
{
  return { turn.cosine, -turn.sine };
}

/// By half the angle of a vector, in [-90, 90] degrees; none for a zero vector. Without
/// trigonometry, as this is done some times for every crossing.
Turn HalfOf(double x, double y, double length)
{
  if (!(length > 0.0))
  {
    return { 1.0, 0.0 };
  }
  const double larger = std::sqrt(0.5 * (1.0 + std::abs(x) / length));
  const double smaller = 0.5 * std::abs(y) / (length * larger);
  return { x >= 0.0 ? larger : smaller, std::copysign(x >= 0.0 ? smaller : larger, y) };
}

template <int Order>
SymmetricTensor<Order> FormAt(const double* values, Id point)
{
  SymmetricTensor<Order> form;
  std::copy_n(values + (Order + 1) * static_cast<std::size_t>(point), form.size(), form.begin());
  return form;
}

template <int Order>
SymmetricTensor<Order> Between(
  const SymmetricTensor<Order>& atP, const SymmetricTensor<Order>& atQ, double t)
{
  SymmetricTensor<Order> form;
  for (std::size_t j = 0; j < form.size(); ++j)
  {
    form[j] = (1.0 - t) * atP[j] + t * atQ[j];
  }
  return form;
}

/**
 * How the frame of q, turned by half a turn if the acute rule says so, is turned from that of p:
 * the turn that brings both directions closest together. Swapping p and q, and looking from the
 * other side of the surface, change nothing but its sense.
 */
Turn TurnBetween(const MongeField& field, Id p, Id q)
{
  const double sign = AcuteSign(field, p, q);
  const double x = sign * (field.D1(p).dot(field.D1(q)) + field.D2(p).dot(field.D2(q)));
  const double y = sign * (field.D2(p).dot(field.D1(q)) - field.D1(p).dot(field.D2(q)));
  const double length = std::sqrt(x * x + y * y);
  // Where tangent planes are far apart the acute rule may turn by more than a right angle.
  return length > 0.0 && x > 0.0 ? Turn{ x / length, y / length }
                                 : Turn{ 0.0, std::copysign(1.0, y) };
}

} // namespace

MongeInterpolation::MongeInterpolation(const MongeField& field, Id p, Id q)
  : Field_(field)
  , P_(p)
  , Q_(q)
  , Turn_(TurnBetween(field, p, q))
  , SumP_(field.k1[p] + field.k2[p])
  , SumQ_(field.k1[q] + field.k2[q])
  , GapP_(field.k1[p] - field.k2[p])
  , ThirdOrderP_(FormAt<3>(field.b, p))
  , ThirdOrderQ_(Turned<3>(FormAt<3>(field.b, q), Back(Turn_)))
{
  const double gapQ = field.k1[q] - field.k2[q];
  const double cosine = this->Turn_.cosine;
  const double sine = this->Turn_.sine;
  this->AlongQ_ = gapQ * (cosine * cosine - sine * sine);
  this->AcrossQ_ = gapQ * 2.0 * cosine * sine;
  // The stored frame of q may be the other one by the acute rule.
  if (AcuteSign(field, p, q) < 0)
  {
    for (double& value : this->ThirdOrderQ_)
    {
      value = -value;
    }
  }
}

MongeInterpolation::SecondOrder MongeInterpolation::SecondOrderAt(double t) const
{
  const double along = (1.0 - t) * this->GapP_ + t * this->AlongQ_;
  const double across = t * this->AcrossQ_;
  const double gap = std::sqrt(along * along + across * across);
  const double sum = (1.0 - t) * this->SumP_ + t * this->SumQ_;
  return { 0.5 * (sum + gap), 0.5 * (sum - gap), HalfOf(along, across, gap) };
}

MongeForm MongeInterpolation::At(double t) const
{
  const SecondOrder second = this->SecondOrderAt(t);
  const Eigen::Vector3d d1 = this->Field_.D1(this->P_);
  const Eigen::Vector3d d2 = this->Field_.D2(this->P_);
  MongeForm form;
  form.d1 = second.turn.cosine * d1 + second.turn.sine * d2;
  form.d2 = second.turn.cosine * d2 - second.turn.sine * d1;
  form.n = d1.cross(d2);
  form.k1 = second.k1;
  form.k2 = second.k2;
  form.b = Turned<3>(Between<3>(this->ThirdOrderP_, this->ThirdOrderQ_, t), second.turn);
  if (this->Field_.c)
  {
    const auto atQ = Turned<4>(FormAt<4>(this->Field_.c, this->Q_), Back(this->Turn_));
    form.c = Turned<4>(Between<4>(FormAt<4>(this->Field_.c, this->P_), atQ, t), second.turn);
  }
  return form;
}

// The values of At(t), to the last digit.
MongeInterpolation::Extremum MongeInterpolation::ExtremumAt(Color color, double t) const
{
  const SecondOrder second = this->SecondOrderAt(t);
  MongeForm form;
  form.k1 = second.k1;
  form.k2 = second.k2;
  if (!this->Field_.c)
  {
    return { form.k1, form.k2, 0.0 };
  }
  const Eigen::Vector2d e(second.turn.cosine, second.turn.sine);
  const Eigen::Vector2d f(-second.turn.sine, second.turn.cosine);
  const auto third = Between<3>(this->ThirdOrderP_, this->ThirdOrderQ_, t);
  const auto atQ = Turned<4>(FormAt<4>(this->Field_.c, this->Q_), Back(this->Turn_));
  const auto fourth = Between<4>(FormAt<4>(this->Field_.c, this->P_), atQ, t);
  if (color == Color::Blue)
  {
    form.b[1] = ValueInBasis<1>(third, e, f);
    form.c[0] = ValueInBasis<0>(fourth, e, f);
    return { form.k1, form.k2, form.P1() };
  }
  form.b[2] = ValueInBasis<2>(third, e, f);
  form.c[4] = ValueInBasis<4>(fourth, e, f);
  return { form.k1, form.k2, form.P2() };
}

double MongeInterpolation::Extremality(Color color, double t) const
{
  const auto b = Between<3>(this->ThirdOrderP_, this->ThirdOrderQ_, t);
  const Turn turn = this->SecondOrderAt(t).turn;
  const double x = color == Color::Blue ? turn.cosine : -turn.sine;
  const double y = color == Color::Blue ? turn.sine : turn.cosine;
  return x * x * (b[0] * x + 3.0 * b[1] * y) + y * y * (3.0 * b[2] * x + b[3] * y);
}

// The extremality is a cubic form of the direction, whose coefficients are linear in t; divided by
// the cube of one coordinate, it is a polynomial in the tangent or cotangent of the direction's
// angle. The factor has no part in the step, which is that of the extremality itself.
MongeInterpolation::NewtonStep MongeInterpolation::StepToCrossing(Color color, double t) const
{
  const double along = (1.0 - t) * this->GapP_ + t * this->AlongQ_;
  const double across = t * this->AcrossQ_;
  const double square = along * along + across * across;
  const double gap = std::sqrt(square);
  double turning = square > 0.0 ? 0.5 * this->GapP_ * this->AcrossQ_ / square : 0.0; // of d1
  const double tangent = gap > 0.0 ? across / (gap + std::abs(along)) : 0.0;

  SymmetricTensor<3> form = Between<3>(this->ThirdOrderP_, this->ThirdOrderQ_, t);
  SymmetricTensor<3> slope;
  for (std::size_t j = 0; j < slope.size(); ++j)
  {
    slope[j] = this->ThirdOrderQ_[j] - this->ThirdOrderP_[j];
  }
  if (color == Color::Red)
  {
    form = { form[3], -form[2], form[1], -form[0] };
    slope = { slope[3], -slope[2], slope[1], -slope[0] };
  }
  double sign = 1.0;
  if (along < 0.0)
  {
    // d1 is nearer to the second axis: the tangent is its cotangent, which turns the other way.
    std::reverse(form.begin(), form.end());
    std::reverse(slope.begin(), slope.end());
    sign = std::copysign(1.0, across);
    turning = -turning;
  }
  const auto cubic = [tangent](const SymmetricTensor<3>& f)
  { return f[0] + tangent * (3.0 * f[1] + tangent * (3.0 * f[2] + tangent * f[3])); };
  const double value = cubic(form);
  const double inTangent = 3.0 * (form[1] + tangent * (2.0 * form[2] + tangent * form[3]));
  const double change =
    cubic(slope) + turning * (inTangent * (1.0 + tangent * tangent) - 3.0 * value * tangent);
  return { sign * value, -value / change };
}

} // namespace ridges
