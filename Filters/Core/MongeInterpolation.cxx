// SPDX-License-Identifier: BSD-3-Clause
#include "MongeInterpolation.h"

#include "SymmetricTensor.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace ridges
{
namespace
{

/// The form of an order in the frame turned by an angle from the one it is given in.
template <int Order>
SymmetricTensor<Order> Turned(const SymmetricTensor<Order>& form, double angle)
{
  const double x = std::cos(angle);
  const double y = std::sin(angle);
  return InBasis(form, { x, y }, { -y, x });
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
 * The angle by which the frame of q, turned by half a turn if the acute rule says so, is turned
 * from that of p: the one that brings both directions closest together. Swapping p and q, and
 * looking from the other side of the surface, change nothing but its sign.
 */
double AngleBetween(const MongeField& field, Id p, Id q)
{
  const double sign = AcuteSign(field, p, q);
  const double cosine = field.D1(p).dot(field.D1(q)) + field.D2(p).dot(field.D2(q));
  const double sine = field.D2(p).dot(field.D1(q)) - field.D1(p).dot(field.D2(q));
  constexpr double rightAngle = 1.57079632679489662;
  return std::clamp(std::atan2(sign * sine, sign * cosine), -rightAngle, rightAngle);
}

} // namespace

MongeInterpolation::MongeInterpolation(const MongeField& field, Id p, Id q)
  : Field_(field)
  , P_(p)
  , Q_(q)
  , Angle_(AngleBetween(field, p, q))
  , ThirdOrderOfQ_(Turned<3>(FormAt<3>(field.b, q), -Angle_))
{
  // The stored frame of q may be the other one by the acute rule.
  if (AcuteSign(field, p, q) < 0)
  {
    for (double& value : this->ThirdOrderOfQ_)
    {
      value = -value;
    }
  }
}

MongeInterpolation::SecondOrder MongeInterpolation::SecondOrderAt(double t) const
{
  const MongeField& field = this->Field_;
  const auto between = [t](double atP, double atQ) { return (1.0 - t) * atP + t * atQ; };
  const double gapP = field.k1[this->P_] - field.k2[this->P_];
  const double gapQ = field.k1[this->Q_] - field.k2[this->Q_];
  // The traceless form: a vector as long as the gap, at twice the angle of d1.
  const double along = between(gapP, gapQ * std::cos(2.0 * this->Angle_));
  const double across = between(0.0, gapQ * std::sin(2.0 * this->Angle_));
  const double gap = std::hypot(along, across);
  const double sum =
    between(field.k1[this->P_] + field.k2[this->P_], field.k1[this->Q_] + field.k2[this->Q_]);
  return { 0.5 * (sum + gap), 0.5 * (sum - gap), 0.5 * std::atan2(across, along) };
}

MongeForm MongeInterpolation::At(double t) const
{
  const SecondOrder second = this->SecondOrderAt(t);
  const Eigen::Vector3d d1 = this->Field_.D1(this->P_);
  const Eigen::Vector3d d2 = this->Field_.D2(this->P_);
  const double cosine = std::cos(second.turn);
  const double sine = std::sin(second.turn);

  MongeForm form;
  form.d1 = cosine * d1 + sine * d2;
  form.d2 = cosine * d2 - sine * d1;
  form.n = d1.cross(d2);
  form.k1 = second.k1;
  form.k2 = second.k2;
  form.b = Turned<3>(
    Between<3>(FormAt<3>(this->Field_.b, this->P_), this->ThirdOrderOfQ_, t), second.turn);
  if (this->Field_.c)
  {
    const auto atQ = Turned<4>(FormAt<4>(this->Field_.c, this->Q_), -this->Angle_);
    form.c = Turned<4>(Between<4>(FormAt<4>(this->Field_.c, this->P_), atQ, t), second.turn);
  }
  return form;
}

double MongeInterpolation::Extremality(Color color, double t) const
{
  const auto b = Between<3>(FormAt<3>(this->Field_.b, this->P_), this->ThirdOrderOfQ_, t);
  const double turn = this->SecondOrderAt(t).turn;
  const double x = color == Color::Blue ? std::cos(turn) : -std::sin(turn);
  const double y = color == Color::Blue ? std::sin(turn) : std::cos(turn);
  return x * x * (b[0] * x + 3.0 * b[1] * y) + y * y * (3.0 * b[2] * x + b[3] * y);
}

} // namespace ridges
