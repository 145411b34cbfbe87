// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ExactRidges.h"

#include "SurfaceSampling.h"

#include <algorithm>
#include <cmath>

namespace ridges
{
namespace testing
{

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace
{

const double Pi = 3.14159265358979323846;

//------------------------------------------------------------------------------
double Extremality(const ExactMonge& monge, bool maximum)
{
  return maximum ? monge.b[0] : monge.b[3];
}

//------------------------------------------------------------------------------
ExactRidgePoint NewtonFoot(
  const AnalyticSurface& surface, bool maximum, const Vector3d& start, double reach)
{
  ExactRidgePoint foot;
  foot.monge = surface.Monge(start);
  for (int iteration = 0; iteration < 12; ++iteration)
  {
    const ExactMonge& monge = foot.monge;
    const Vector2d gradient = ExtremalityGradient(monge, maximum);
    const Vector2d step = -Extremality(monge, maximum) / gradient.squaredNorm() * gradient;
    if (!step.allFinite() || step.norm() > reach || foot.Distance(start) > reach)
    {
      return foot;
    }
    if (step.norm() < 1e-6 * reach)
    {
      foot.found = true;
      return foot;
    }
    foot.monge =
      surface.Monge(surface.Project(monge.origin + step[0] * monge.d1 + step[1] * monge.d2));
  }
  return foot;
}

//------------------------------------------------------------------------------
// The first sign change of the extremality on the way out; d1 is kept from turning about.
ExactRidgePoint FirstZero(const AnalyticSurface& surface, bool maximum, const ExactMonge& start,
  const Vector3d& direction, double reach)
{
  const int steps = 32;
  ExactMonge before = start;
  const auto formAt = [&](double s)
  { return surface.Monge(surface.Project(start.origin + s * direction)); };
  ExactRidgePoint zero;
  for (int i = 1; i <= steps && !zero.found; ++i)
  {
    const ExactMonge after = formAt(reach * i / steps);
    const auto changes = [&](const ExactMonge& from, const ExactMonge& to)
    { return Extremality(from, maximum) * Extremality(to, maximum) * from.d1.dot(to.d1) < 0.0; };
    if (changes(before, after))
    {
      double begin = reach * (i - 1) / steps;
      double end = reach * i / steps;
      for (int bisection = 0; bisection < 30; ++bisection)
      {
        const double middle = 0.5 * (begin + end);
        (changes(before, formAt(middle)) ? end : begin) = middle;
      }
      zero.monge = formAt(end);
      // Otherwise d1 has turned about, next to an umbilic.
      zero.found = std::abs(Extremality(zero.monge, maximum)) * reach <
        1e-3 * std::max(std::abs(zero.monge.k1), std::abs(zero.monge.k2));
    }
    before = after;
  }
  return zero;
}

} // namespace

//------------------------------------------------------------------------------
Vector2d ExtremalityGradient(const ExactMonge& monge, bool maximum)
{
  const std::array<double, 4>& b = monge.b;
  const double gap = monge.k1 - monge.k2;
  if (maximum)
  {
    return { monge.P1 / gap, monge.c[1] + 3 * b[1] * b[2] / gap };
  }
  return { monge.c[3] - 3 * b[1] * b[2] / gap, -monge.P2 / gap };
}

//------------------------------------------------------------------------------
ExactRidgePoint NearestRidgePoint(
  const AnalyticSurface& surface, bool maximum, const Vector3d& point, double reach)
{
  const Vector3d start = surface.Project(point);
  ExactRidgePoint nearest = NewtonFoot(surface, maximum, start, reach);
  if (nearest.found)
  {
    return nearest;
  }
  const ExactMonge monge = surface.Monge(start);
  for (int i = 0; i < 8; ++i)
  {
    const double angle = 2 * Pi * (i + 0.5) / 8;
    const Vector3d direction = std::cos(angle) * monge.d1 + std::sin(angle) * monge.d2;
    const ExactRidgePoint zero = FirstZero(surface, maximum, monge, direction, reach);
    if (zero.found && !(nearest.found && nearest.Distance(start) < zero.Distance(start)))
    {
      nearest = zero;
    }
  }
  return nearest;
}

} // namespace testing
} // namespace ridges
