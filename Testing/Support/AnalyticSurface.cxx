// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "AnalyticSurface.h"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace ridges
{
namespace testing
{

using Eigen::Vector3d;

//------------------------------------------------------------------------------
AnalyticSurface::Jet1 AnalyticSurface::Linearization(const Vector3d& point) const
{
  return this->FirstOrder(Jet1::Linear(point.x(), 1, 0, 0), Jet1::Linear(point.y(), 0, 1, 0),
    Jet1::Linear(point.z(), 0, 0, 1));
}

//------------------------------------------------------------------------------
double AnalyticSurface::Value(const Vector3d& point) const
{
  return this->Linearization(point).Constant();
}

//------------------------------------------------------------------------------
Vector3d AnalyticSurface::Gradient(const Vector3d& point) const
{
  const Jet1 jet = this->Linearization(point);
  return { jet(1, 0, 0), jet(0, 1, 0), jet(0, 0, 1) };
}

//------------------------------------------------------------------------------
Vector3d AnalyticSurface::Project(const Vector3d& point) const
{
  const double epsilon = std::numeric_limits<double>::epsilon();
  Vector3d p = point;
  double value = this->Value(p);
  for (int iteration = 0; iteration < 200; ++iteration)
  {
    const Vector3d gradient = this->Gradient(p);
    Vector3d step = -value / gradient.squaredNorm() * gradient;
    if (!step.allFinite())
    {
      throw std::runtime_error("AnalyticSurface::Project: the gradient vanishes");
    }
    const double resolution = epsilon * p.cwiseAbs().maxCoeff();
    if (step.norm() <= 2 * resolution)
    {
      return p;
    }
    double next = this->Value(p + step);
    while (!(std::abs(next) < std::abs(value)))
    {
      if (step.norm() <= 1e3 * resolution)
      {
        return p; // no better point can be represented
      }
      step *= 0.5;
      next = this->Value(p + step);
    }
    p += step;
    value = next;
  }
  throw std::runtime_error("AnalyticSurface::Project: no convergence");
}

//------------------------------------------------------------------------------
Vector3d AnalyticSurface::IntersectRay(const Vector3d& center, const Vector3d& direction) const
{
  double inside = 0.0;
  double outside = 1.0;
  if (!(this->Value(center) < 0.0))
  {
    throw std::runtime_error("AnalyticSurface::IntersectRay: the center is not inside");
  }
  while (this->Value(center + outside * direction) < 0.0)
  {
    inside = outside;
    outside *= 1.25; // not more: other components may lie beyond
    if (!std::isfinite(outside))
    {
      throw std::runtime_error("AnalyticSurface::IntersectRay: the ray never leaves");
    }
  }
  for (int i = 0; i < 60; ++i)
  {
    const double middle = 0.5 * (inside + outside);
    (this->Value(center + middle * direction) < 0.0 ? inside : outside) = middle;
  }
  return this->Project(center + 0.5 * (inside + outside) * direction);
}

//------------------------------------------------------------------------------
// The surface as a graph w(u, v) over its tangent plane, to order 4. With f = A0 + A1 w + ... + A4
// w^4 and g the coefficient of w alone, w = -(f - g w) / g is iterated as a power series: each pass
// makes one more order exact, starting with order 2.
AnalyticSurface::Jet4 AnalyticSurface::HeightFunction(
  const Vector3d& point, const Vector3d& t1, const Vector3d& t2, const Vector3d& n) const
{
  const Jet4 f = this->FullOrder(Jet4::Linear(point.x(), t1.x(), t2.x(), n.x()),
    Jet4::Linear(point.y(), t1.y(), t2.y(), n.y()), Jet4::Linear(point.z(), t1.z(), t2.z(), n.z()));

  std::array<Jet4, 5> powers;
  const double g = f(0, 0, 1);
  for (int k = 0; k <= 4; ++k)
  {
    for (int i = 0; i + k <= 4; ++i)
    {
      for (int j = 0; i + j + k <= 4; ++j)
      {
        powers[k].Set(i, j, 0, -f(i, j, k) / g);
      }
    }
  }
  powers[0].Set(0, 0, 0, 0.0); // the round-off of the point and of the normal
  powers[0].Set(1, 0, 0, 0.0);
  powers[0].Set(0, 1, 0, 0.0);
  powers[1].Set(0, 0, 0, 0.0); // the term taken to the left-hand side

  Jet4 w;
  for (int pass = 0; pass < 3; ++pass)
  {
    Jet4 next = powers[4];
    for (int k = 3; k >= 0; --k)
    {
      next = next * w + powers[k];
    }
    w = next;
  }
  return w;
}

//------------------------------------------------------------------------------
ExactMonge AnalyticSurface::Monge(const Vector3d& pointOnSurface) const
{
  const Vector3d gradient = this->Gradient(pointOnSurface);
  if (!(gradient.norm() > 0.0))
  {
    throw std::runtime_error("AnalyticSurface::Monge: the gradient vanishes");
  }

  ExactMonge monge;
  monge.origin = pointOnSurface;
  monge.n = gradient.normalized();

  // Principal directions from any tangent frame; then the jet is taken again in the principal
  // frame, which is more accurate than rotating its coefficients.
  const Vector3d t1 = monge.n.unitOrthogonal();
  const Vector3d t2 = monge.n.cross(t1);
  const Jet4 any = this->HeightFunction(pointOnSurface, t1, t2, monge.n);
  const double angle = 0.5 * std::atan2(any(1, 1, 0), any(2, 0, 0) - any(0, 2, 0));
  monge.d1 = (std::cos(angle) * t1 + std::sin(angle) * t2).normalized();
  monge.d2 = monge.n.cross(monge.d1);

  const Jet4 w = this->HeightFunction(pointOnSurface, monge.d1, monge.d2, monge.n);
  monge.k1 = 2 * w(2, 0, 0);
  monge.k2 = std::min(2 * w(0, 2, 0), monge.k1); // round-off may swap them at an umbilic
  monge.b = { 6 * w(3, 0, 0), 2 * w(2, 1, 0), 2 * w(1, 2, 0), 6 * w(0, 3, 0) };
  monge.c = { 24 * w(4, 0, 0), 6 * w(3, 1, 0), 4 * w(2, 2, 0), 6 * w(1, 3, 0), 24 * w(0, 4, 0) };

  const double k1 = monge.k1;
  const double k2 = monge.k2;
  monge.P1 = 3 * monge.b[1] * monge.b[1] + (k1 - k2) * (monge.c[0] - 3 * k1 * k1 * k1);
  monge.P2 = 3 * monge.b[2] * monge.b[2] + (k2 - k1) * (monge.c[4] - 3 * k2 * k2 * k2);
  return monge;
}

//------------------------------------------------------------------------------
AnalyticSurface MakeSphere(double r)
{
  return MakeEllipsoid(r, r, r);
}

//------------------------------------------------------------------------------
AnalyticSurface MakeCylinder(double r)
{
  return AnalyticSurface([r](auto x, auto y, auto) { return (x * x + y * y) / (r * r) - 1.0; });
}

//------------------------------------------------------------------------------
AnalyticSurface MakeTorus(double R, double r)
{
  // The polynomial form is smooth on the axis too.
  return AnalyticSurface(
    [R, r](auto x, auto y, auto z)
    {
      const auto h = x * x + y * y;
      const auto s = h + z * z + (R * R - r * r);
      return (s * s - 4 * R * R * h) / (8 * R * R * r);
    });
}

//------------------------------------------------------------------------------
AnalyticSurface MakeEllipsoid(double a, double b, double c)
{
  return AnalyticSurface([a, b, c](auto x, auto y, auto z)
    { return x * x / (a * a) + y * y / (b * b) + z * z / (c * c) - 1.0; });
}

//------------------------------------------------------------------------------
AnalyticSurface MakeBlend()
{
  return AnalyticSurface(
    [](auto x, auto y, auto z)
    {
      const auto A = x * x / (0.15 * 0.15) + y * y / (0.25 * 0.25) + z * z / (0.35 * 0.35);
      const auto u = x - 0.25;
      const auto v = y - 0.1;
      const auto w = z - 0.1;
      const auto B = u * u / (0.1 * 0.1) + v * v / (0.2 * 0.2) + w * w / (0.3 * 0.3);
      return 1.0 - exp(-0.7 * (A - 1.0)) - exp(-0.7 * (B - 1.0));
    });
}

//------------------------------------------------------------------------------
Vector3d BlendCenter()
{
  return { 0.13, 0.05, 0.05 };
}

//------------------------------------------------------------------------------
AnalyticSurface MakePerturbedSphere(double epsilon, std::uint64_t seed)
{
  struct Term
  {
    int i, j, k;
    double factor;
  };
  std::mt19937_64 generator(seed);
  std::vector<Term> terms;
  for (int degree = 3; degree <= 4; ++degree)
  {
    for (int i = 0; i <= degree; ++i)
    {
      for (int j = 0; i + j <= degree; ++j)
      {
        terms.push_back({ i, j, degree - i - j, 2 * Uniform(generator) - 1 });
      }
    }
  }
  return AnalyticSurface(
    [epsilon, terms](auto x, auto y, auto z)
    {
      using Number = decltype(x);
      std::array<std::array<Number, 5>, 3> powers;
      for (int n = 0; n <= 4; ++n)
      {
        powers[0][n] = n == 0 ? Number(1.0) : powers[0][n - 1] * x;
        powers[1][n] = n == 0 ? Number(1.0) : powers[1][n - 1] * y;
        powers[2][n] = n == 0 ? Number(1.0) : powers[2][n - 1] * z;
      }
      Number q(0.0);
      for (const Term& term : terms)
      {
        q += term.factor * (powers[0][term.i] * powers[1][term.j] * powers[2][term.k]);
      }
      return powers[0][2] + powers[1][2] + powers[2][2] - 1.0 - epsilon * q;
    });
}

//------------------------------------------------------------------------------
AnalyticSurface MakeDoubleTorus()
{
  return AnalyticSurface(
    [](auto x, auto y, auto z)
    {
      // A tube around the figure eight x^2 (x^2 - 1) + y^2 = 0; the last terms break its
      // symmetries.
      const auto e = x * x * (x * x - 1.0) + y * y;
      const auto q = 0.6 * x + 0.4 * y * z - 0.5 * x * y + 0.7 * x * x * z + 0.3 * y;
      return e * e + 0.3 * z * z - 0.02 - 0.005 * q;
    });
}

//------------------------------------------------------------------------------
Vector3d DoubleTorusHalfSize()
{
  return { 1.2, 0.75, 0.4 };
}

} // namespace testing
} // namespace ridges
