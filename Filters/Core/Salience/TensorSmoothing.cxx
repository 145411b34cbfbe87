// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Salience/TensorSmoothing.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace ridges
{
namespace
{

void AddNormalAndSecondOrder(const MongeField& field, Id p, double* values)
{
  const Eigen::Vector3d d1 = field.D1(p);
  const Eigen::Vector3d d2 = field.D2(p);
  const Eigen::Vector3d n = d1.cross(d2);
  for (int i = 0; i < 3; ++i)
  {
    values[i] = n[i];
  }
  int at = 3;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = i; j < 3; ++j)
    {
      values[at++] = field.k1[p] * d1[i] * d1[j] + field.k2[p] * d2[i] * d2[j];
    }
  }
}

bool FrameFromSpace(const double* values, MongeForm& form)
{
  const Eigen::Vector3d sum(values[0], values[1], values[2]);
  const double length = sum.norm();
  if (!(length > 0.0))
  {
    return false;
  }
  form.n = sum / length;
  Eigen::Matrix3d T;
  T << values[3], values[4], values[5], values[4], values[6], values[7], values[5], values[7],
    values[8];
  const Eigen::Vector3d u = form.n.unitOrthogonal();
  const Eigen::Vector3d v = form.n.cross(u);
  const double uu = u.dot(T * u);
  const double uv = u.dot(T * v);
  const double vv = v.dot(T * v);
  const double mean = 0.5 * (uu + vv);
  const double along = 0.5 * (uu - vv);
  const double deviation = std::hypot(along, uv);
  // Half the angle of (along, uv), without cancellation.
  double cosine = along >= 0.0 ? deviation + along : std::abs(uv);
  double sine = along >= 0.0 ? uv : std::copysign(deviation - along, uv);
  const double norm = std::hypot(cosine, sine);
  cosine = norm > 0.0 ? cosine / norm : 1.0;
  sine = norm > 0.0 ? sine / norm : 0.0;
  form.d1 = cosine * u + sine * v;
  form.d2 = form.n.cross(form.d1);
  form.k1 = mean + deviation;
  form.k2 = mean - deviation;
  return true;
}

/// Frames take part in products of their vectors only.
using Frame = std::array<Eigen::Vector3d, 2>;

/// The next in the order of components, whose indices do not descend; false after the last.
template <int Order>
bool Advance(std::array<int, Order>& index)
{
  int last = Order - 1;
  while (last >= 0 && index[last] == 2)
  {
    --last;
  }
  if (last < 0)
  {
    return false;
  }
  std::fill(index.begin() + last, index.end(), index[last] + 1);
  return true;
}

/// The tensor whose component along i times d1 and order - i times d2, in any order, is
/// form[order - i], as its components with indices that do not descend.
template <int Order>
void AddTensor(const double* form, const Frame& frame, double* values)
{
  std::array<int, Order> index{};
  do
  {
    double sum = 0.0;
    for (unsigned choice = 0; choice < (1U << Order); ++choice)
    {
      double product = 1.0;
      int seconds = 0;
      for (int i = 0; i < Order; ++i)
      {
        const unsigned which = (choice >> i) & 1U;
        product *= frame[which][index[i]];
        seconds += static_cast<int>(which);
      }
      sum += form[seconds] * product;
    }
    *values++ = sum;
  } while (Advance<Order>(index));
}

/// The other way round.
template <int Order>
void TakeForm(const double* values, const Frame& frame, double* form)
{
  std::array<int, Order> index{};
  std::fill_n(form, Order + 1, 0.0);
  do
  {
    // A component stands for all orders of its indices. Of these each is one of the products that
    // a polynomial in t, the product of d1[i] + t d2[i], has: its coefficients are those of the
    // form, but for the binomials.
    std::array<double, Order + 1> polynomial{ 1.0 };
    std::array<int, 3> counts{};
    double orders = 1.0;
    for (int i = 0; i < Order; ++i)
    {
      for (int k = i; k >= 0; --k)
      {
        polynomial[k + 1] += polynomial[k] * frame[1][index[i]];
        polynomial[k] *= frame[0][index[i]];
      }
      ++counts[index[i]];
      orders *= static_cast<double>(i + 1) / counts[index[i]];
    }
    for (int k = 0; k <= Order; ++k)
    {
      form[k] += orders * *values * polynomial[k];
    }
    ++values;
  } while (Advance<Order>(index));
  double binomial = 1.0;
  for (int k = 0; k <= Order; ++k)
  {
    form[k] /= binomial;
    binomial *= static_cast<double>(Order - k) / (k + 1);
  }
}

} // namespace

SecondOrderValues SecondOrderToSpace(const MongeField& field, Id p)
{
  SecondOrderValues values{};
  AddNormalAndSecondOrder(field, p, values.data());
  return values;
}

ThirdOrderValues ThirdOrderToSpace(const MongeField& field, Id p)
{
  ThirdOrderValues values{};
  AddNormalAndSecondOrder(field, p, values.data());
  AddTensor<3>(field.ThirdOrder(p), { field.D1(p), field.D2(p) }, values.data() + 9);
  if (field.P1 && field.P2)
  {
    values[19] = field.P(Color::Blue, p);
    values[20] = field.P(Color::Red, p);
  }
  return values;
}

FourthOrderValues FourthOrderToSpace(const MongeField& field, Id p)
{
  FourthOrderValues values{};
  AddNormalAndSecondOrder(field, p, values.data());
  const Frame frame{ field.D1(p), field.D2(p) };
  AddTensor<3>(field.ThirdOrder(p), frame, values.data() + 9);
  AddTensor<4>(field.c + 5 * static_cast<std::size_t>(p), frame, values.data() + 19);
  return values;
}

bool SecondOrderFromSpace(const SecondOrderValues& values, MongeForm& form)
{
  return FrameFromSpace(values.data(), form);
}

bool ThirdOrderFromSpace(const ThirdOrderValues& values, MongeForm& form)
{
  if (!FrameFromSpace(values.data(), form))
  {
    return false;
  }
  TakeForm<3>(values.data() + 9, { form.d1, form.d2 }, form.b.data());
  return true;
}

bool FourthOrderFromSpace(const FourthOrderValues& values, MongeForm& form)
{
  if (!FrameFromSpace(values.data(), form))
  {
    return false;
  }
  const Frame frame{ form.d1, form.d2 };
  TakeForm<3>(values.data() + 9, frame, form.b.data());
  TakeForm<4>(values.data() + 19, frame, form.c.data());
  return true;
}

} // namespace ridges
