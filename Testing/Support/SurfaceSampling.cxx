// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceSampling.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace ridges
{
namespace testing
{

using Eigen::Vector3d;

//------------------------------------------------------------------------------
std::vector<NamedSurface> GenericSurfaces()
{
  return { { "ellipsoid", MakeEllipsoid(1.0, 0.8, 0.6), Vector3d::Zero() },
    { "blend", MakeBlend(), BlendCenter() },
    { "perturbed sphere", MakePerturbedSphere(0.1), Vector3d::Zero() },
    { "double torus", MakeDoubleTorus(), Vector3d(0.05, 0.02, 0.0) } };
}

//------------------------------------------------------------------------------
double LocalLength(const ExactMonge& monge)
{
  double inverse = std::max(std::abs(monge.k1), std::abs(monge.k2));
  for (const double b : monge.b)
  {
    inverse = std::max(inverse, std::sqrt(std::abs(b)));
  }
  for (const double c : monge.c)
  {
    inverse = std::max(inverse, std::cbrt(std::abs(c)));
  }
  return 1.0 / inverse;
}

//------------------------------------------------------------------------------
std::vector<Vector3d> RandomPoints(const NamedSurface& item, int count)
{
  std::mt19937_64 generator(7);
  std::vector<Vector3d> points;
  while (static_cast<int>(points.size()) < count)
  {
    Vector3d direction;
    for (int i = 0; i < 3; ++i)
    {
      direction[i] = 2 * Uniform(generator) - 1;
    }
    const Vector3d point = item.surface.IntersectRay(item.center, direction.normalized());
    const ExactMonge monge = item.surface.Monge(point);
    if ((monge.k1 - monge.k2) * LocalLength(monge) > 0.1)
    {
      points.push_back(point);
    }
  }
  return points;
}

//------------------------------------------------------------------------------
// Runge-Kutta of order 4.
Vector3d OnCurvatureLine(const AnalyticSurface& surface, const Vector3d& start,
  const Vector3d& direction, bool maximum, double s)
{
  const auto field = [&](const Vector3d& p) -> Vector3d
  {
    const ExactMonge monge = surface.Monge(surface.Project(p));
    const Vector3d d = maximum ? monge.d1 : monge.d2;
    return d.dot(direction) < 0.0 ? Vector3d(-d) : d;
  };
  const int steps = 4;
  const double h = s / steps;
  Vector3d p = start;
  for (int i = 0; i < steps; ++i)
  {
    const Vector3d v1 = field(p);
    const Vector3d v2 = field(p + 0.5 * h * v1);
    const Vector3d v3 = field(p + 0.5 * h * v2);
    const Vector3d v4 = field(p + h * v3);
    p = surface.Project(p + h / 6 * (v1 + 2 * v2 + 2 * v3 + v4));
  }
  return p;
}

//------------------------------------------------------------------------------
double FirstDerivative(const std::function<double(double)>& f, double h)
{
  return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h);
}

//------------------------------------------------------------------------------
double SecondDerivative(const std::function<double(double)>& f, double h)
{
  return (16 * (f(h) + f(-h)) - (f(2 * h) + f(-2 * h)) - 30 * f(0)) / (12 * h * h);
}

} // namespace testing
} // namespace ridges
