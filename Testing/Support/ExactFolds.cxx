// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ExactFolds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace ridges
{
namespace testing
{

using Eigen::Vector3d;

//------------------------------------------------------------------------------
// With the roots c^2 <= mu <= b^2 <= nu <= a^2 of
//   x^2 / (a^2 - t) + y^2 / (b^2 - t) + z^2 / (c^2 - t) = 1
// the normal curvature along a line nu = const is a b c / sqrt(mu^3 nu), and with
// mu = c^2 + (b^2 - c^2) sin^2(angle) its length is ds = sqrt((nu - mu) mu / (a^2 - mu)) dangle.
// The rim is mu = c^2, and the curvature falls until the line meets the plane y = 0 at mu = b^2.
double EllipsoidRimFold(double a, double b, double c, const Vector3d& pointOfRim, double reach)
{
  // On the rim, b^2 <= nu: x = a sqrt((a^2 - nu) / (a^2 - b^2)).
  const double cosine = pointOfRim[0] / a;
  const double nu = a * a - cosine * cosine * (a * a - b * b);
  constexpr int steps = 200000;
  const double pi = std::acos(-1.0);
  const double part = 0.5 * pi / steps;
  double length = 0.0;
  double turn = 0.0; // the integral of the curvature
  double curvature = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    const double sine = std::sin((i + 0.5) * part);
    const double mu = c * c + (b * b - c * c) * sine * sine;
    const double ds = std::sqrt((nu - mu) * mu / (a * a - mu)) * part;
    curvature = a * b * c / std::sqrt(mu * mu * mu * nu);
    if (length + ds > reach)
    {
      turn += curvature * (reach - length);
      length = reach;
      break;
    }
    length += ds;
    turn += curvature * ds;
  }
  return 2.0 * (turn - curvature * length);
}

//------------------------------------------------------------------------------
namespace
{

struct SideOfFold
{
  std::vector<double> f; // at equal steps
  double least = 0.0;
};

class LineOfCurvature
{
public:
  LineOfCurvature(const AnalyticSurface& surface, bool maximum)
    : Surface_(surface)
    , Maximum_(maximum)
  {
  }

  // k1, or -k2.
  double Height(const Vector3d& x) const
  {
    const ExactMonge monge = this->Surface_.Monge(x);
    return this->Maximum_ ? monge.k1 : -monge.k2;
  }

  // The direction at a point near the surface, on the side of `along`.
  Vector3d Direction(const Vector3d& x, const Vector3d& along) const
  {
    const ExactMonge monge = this->Surface_.Monge(this->Surface_.Project(x));
    const Vector3d d = this->Maximum_ ? monge.d1 : monge.d2;
    return d.dot(along) < 0.0 ? Vector3d(-d) : d;
  }

  void Step(Vector3d& x, Vector3d& along, double step) const
  {
    const Vector3d d1 = this->Direction(x, along);
    const Vector3d d2 = this->Direction(x + 0.5 * step * d1, d1);
    const Vector3d d3 = this->Direction(x + 0.5 * step * d2, d2);
    const Vector3d d4 = this->Direction(x + step * d3, d3);
    x = this->Surface_.Project(x + step / 6.0 * (d1 + 2.0 * d2 + 2.0 * d3 + d4));
    along = d4;
  }

private:
  const AnalyticSurface& Surface_;
  bool Maximum_;
};

} // namespace

double SurfaceFold(
  const AnalyticSurface& surface, bool maximum, const Vector3d& point, double reach, double step)
{
  const LineOfCurvature line(surface, maximum);
  const ExactMonge start = surface.Monge(point);
  const double top = maximum ? start.k1 : -start.k2;
  std::array<SideOfFold, 2> sides;
  const int steps = static_cast<int>(std::lround(reach / step));
  for (int i = 0; i < 2; ++i)
  {
    Vector3d x = point;
    const Vector3d own = maximum ? start.d1 : start.d2;
    Vector3d along = i == 0 ? own : Vector3d(-own);
    sides[i].f = { top };
    sides[i].least = top;
    for (int j = 0; j < steps; ++j)
    {
      line.Step(x, along, reach / steps);
      const double f = line.Height(x);
      if (f > top)
      {
        break; // a higher peak
      }
      sides[i].f.push_back(f);
      sides[i].least = std::min(sides[i].least, f);
    }
  }
  const double foot = std::max({ 0.0, sides[0].least, sides[1].least });
  double fold = 0.0;
  for (const SideOfFold& side : sides)
  {
    for (std::size_t j = 1; j < side.f.size() && side.f[j - 1] > foot; ++j)
    {
      const double a = side.f[j - 1] - foot;
      const double b = side.f[j] - foot;
      const double part = b >= 0.0 ? 1.0 : a / (a - b);
      fold += 0.5 * part * reach / steps * (a + std::max(0.0, b));
    }
  }
  return fold;
}

} // namespace testing
} // namespace ridges
