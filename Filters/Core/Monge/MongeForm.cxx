// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Monge/MongeForm.h"

#include "Base/SymmetricTensor.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace ridges
{
namespace
{

template <int Order>
SymmetricTensor<Order> TensorOf(const HeightJet& jet)
{
  SymmetricTensor<Order> tensor;
  std::copy_n(jet.Tensor(Order), tensor.size(), tensor.begin());
  return tensor;
}

} // namespace

// With P = (u, v, w) = x d1 + y d2 + z n from the point of the surface, g = |(-fu, -fv, 1)| and N
// the part of f of degree 2 and more, the surface w = fu u + fv v + N(u, v) reads
// g z = N(x d1 + y d2 + z n). Putting the series of z into the right-hand side, degree by degree,
// gives z in closed form. In the names below p, q and s are what n contracts out of N's tensors.
MongeForm MongeFormOfHeightJet(const HeightJet& jet, const Eigen::Matrix3d& frame)
{
  const double fu = jet.Derivative(1, 0);
  const double fv = jet.Derivative(0, 1);
  const double g = std::sqrt(1.0 + fu * fu + fv * fv);
  const Eigen::Vector3d n = Eigen::Vector3d(-fu, -fv, 1.0) / g;
  const Eigen::Vector3d t1 = Eigen::Vector3d(1.0, 0.0, fu).normalized();
  const Eigen::Vector3d t2 = n.cross(t1);

  const auto second = TensorOf<2>(jet);
  const auto fundamental = InBasis(second, t1.head<2>(), t2.head<2>());
  const double mean = 0.5 * (fundamental[0] + fundamental[2]) / g;
  const double difference = 0.5 * (fundamental[0] - fundamental[2]) / g;
  const double mixed = fundamental[1] / g;
  const double deviation = std::hypot(difference, mixed);
  const double angle = 0.5 * std::atan2(mixed, difference);
  const Eigen::Vector3d d1 = std::cos(angle) * t1 + std::sin(angle) * t2;
  const Eigen::Vector3d d2 = n.cross(d1);

  MongeForm form;
  form.d1 = frame * d1;
  form.d2 = frame * d2;
  form.n = frame * n;
  form.k1 = mean + deviation;
  form.k2 = mean - deviation;

  const Eigen::Vector2d e1 = d1.head<2>();
  const Eigen::Vector2d e2 = d2.head<2>();
  const Eigen::Vector2d m = n.head<2>();
  const double k1 = form.k1;
  const double k2 = form.k2;

  const auto p = InBasis(Contract(second, m), e1, e2);
  const auto third = TensorOf<3>(jet);
  auto& b = form.b;
  b = InBasis(third, e1, e2);
  b[0] = (b[0] + 3.0 * p[0] * k1) / g;
  b[1] = (b[1] + p[1] * k1) / g;
  b[2] = (b[2] + p[0] * k2) / g;
  b[3] = (b[3] + 3.0 * p[1] * k2) / g;

  const auto q = InBasis(Contract(third, m), e1, e2);
  const double s = 0.5 * Contract(Contract(second, m), m)[0];
  auto& c = form.c;
  c = InBasis(TensorOf<4>(jet), e1, e2);
  c[0] = (c[0] + 6.0 * q[0] * k1 + 4.0 * p[0] * b[0] + 6.0 * s * k1 * k1) / g;
  c[1] = (c[1] + 3.0 * q[1] * k1 + 3.0 * p[0] * b[1] + p[1] * b[0]) / g;
  c[2] = (c[2] + q[0] * k2 + q[2] * k1 + 2.0 * (p[0] * b[2] + p[1] * b[1]) + 2.0 * s * k1 * k2) / g;
  c[3] = (c[3] + 3.0 * q[1] * k2 + p[0] * b[3] + 3.0 * p[1] * b[2]) / g;
  c[4] = (c[4] + 6.0 * q[2] * k2 + 4.0 * p[1] * b[3] + 6.0 * s * k2 * k2) / g;
  return form;
}

MongeForm Flipped(const MongeForm& form)
{
  MongeForm flipped;
  flipped.d1 = form.d2;
  flipped.d2 = form.d1;
  flipped.n = -form.n;
  flipped.k1 = -form.k2;
  flipped.k2 = -form.k1;
  for (std::size_t i = 0; i < form.b.size(); ++i)
  {
    flipped.b[i] = -form.b[form.b.size() - 1 - i];
  }
  for (std::size_t i = 0; i < form.c.size(); ++i)
  {
    flipped.c[i] = -form.c[form.c.size() - 1 - i];
  }
  return flipped;
}

} // namespace ridges
