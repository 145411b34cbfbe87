// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ExactUmbilics.h"

#include "ParallelFor.h"
#include "SurfaceSampling.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

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
// In Monge coordinates the second derivatives of the height are, to first order,
//   k1 + b0 x + b1 y, b1 x + b2 y, k2 + b2 x + b3 y,
// and the slopes are small of the first order: this is where the traceless part vanishes.
Vector2d NewtonStep(const ExactMonge& monge)
{
  const std::array<double, 4>& b = monge.b;
  Eigen::Matrix2d derivative;
  derivative << b[0] - b[2], b[1] - b[3], 2 * b[1], 2 * b[2];
  return derivative.fullPivLu().solve(Vector2d(monge.k2 - monge.k1, 0.0));
}

//------------------------------------------------------------------------------
// The squared norm of f0 x^3 + 3 f1 x^2 y + 3 f2 x y^2 + f3 y^3, the same in any orthonormal frame.
double SquaredNorm(const std::array<double, 4>& f)
{
  return f[0] * f[0] + 3 * f[1] * f[1] + 3 * f[2] * f[2] + f[3] * f[3];
}

//------------------------------------------------------------------------------
// Of the sign of the discriminant, positive for three real roots; at most 1/4.
double RootMargin(const std::array<double, 4>& f)
{
  const double discriminant = 3 * f[1] * f[1] * f[2] * f[2] + 6 * f[0] * f[1] * f[2] * f[3] -
    f[0] * f[0] * f[3] * f[3] - 4 * f[0] * f[2] * f[2] * f[2] - 4 * f[1] * f[1] * f[1] * f[3];
  return discriminant / std::pow(SquaredNorm(f), 2);
}

//------------------------------------------------------------------------------
// The corners from which to search.
std::vector<bool> Seeds(const Mesh& mesh, const std::vector<ExactMonge>& forms)
{
  const double reach = 3.0 * MeanEdgeLength(mesh);
  std::vector<bool> seeds(mesh.PointCount());
  std::vector<double> gaps(mesh.PointCount());
  std::vector<bool> isMinimum(mesh.PointCount(), true);
  for (std::size_t p = 0; p < mesh.PointCount(); ++p)
  {
    gaps[p] = forms[p].k1 - forms[p].k2;
    seeds[p] = NewtonStep(forms[p]).norm() < reach; // false for NaN
  }
  for (std::size_t t = 0; t < mesh.TriangleCount(); ++t)
  {
    int sign = 1;
    for (int i = 0; i < 3; ++i)
    {
      const std::int32_t p = mesh.triangles[3 * t + i];
      const std::int32_t q = mesh.triangles[3 * t + (i + 1) % 3];
      sign *= forms[p].d1.dot(forms[q].d1) < 0.0 ? -1 : 1;
      isMinimum[gaps[p] > gaps[q] ? p : q] = false;
    }
    for (int i = 0; sign < 0 && i < 3; ++i)
    {
      seeds[mesh.triangles[3 * t + i]] = true;
    }
  }
  for (std::size_t p = 0; p < mesh.PointCount(); ++p)
  {
    seeds[p] = seeds[p] || isMinimum[p];
  }
  return seeds;
}

} // namespace

//------------------------------------------------------------------------------
void ClassifyByForm(ExactUmbilic& umbilic)
{
  const std::array<double, 4>& b = umbilic.b;
  umbilic.indexMargin = ((b[0] - b[2]) * b[2] - b[1] * (b[1] - b[3])) / SquaredNorm(b);
  umbilic.ridgeMargin = RootMargin(b);
  umbilic.ridgeCount = umbilic.ridgeMargin > 0.0 ? 3 : 1;

  // Radial directions (x, y) that are principal: (h_xx - h_yy) x y = h_xy (x^2 - y^2).
  const std::array<double, 4> lines = { -b[1], (b[0] - 2 * b[2]) / 3, (2 * b[1] - b[3]) / 3, b[2] };
  umbilic.lineMargin = RootMargin(lines);
  if (umbilic.index < 0.0)
  {
    umbilic.kind = UmbilicKind::Star;
  }
  else
  {
    umbilic.kind = umbilic.lineMargin > 0.0 ? UmbilicKind::Monstar : UmbilicKind::Lemon;
  }
}

//------------------------------------------------------------------------------
bool ConvergeToUmbilic(const AnalyticSurface& surface, Vector3d& point)
{
  ExactMonge monge = surface.Monge(point);
  for (int iteration = 0; iteration < 50; ++iteration)
  {
    Vector2d step = NewtonStep(monge);
    const double length = LocalLength(monge);
    if (!step.allFinite())
    {
      return false;
    }
    if (step.norm() < 1e-10 * length)
    {
      return (monge.k1 - monge.k2) * length < 1e-6; // not so where all derivatives vanish
    }
    step *= std::min(1.0, 0.3 * length / step.norm());

    // k1 - k2 is the norm of what is to vanish: it has to get smaller.
    const double gap = monge.k1 - monge.k2;
    bool smaller = false;
    for (int halving = 0; halving < 12 && !smaller; ++halving, step *= 0.5)
    {
      const Vector3d next = surface.Project(point + step[0] * monge.d1 + step[1] * monge.d2);
      const ExactMonge there = surface.Monge(next);
      if (there.k1 - there.k2 < gap)
      {
        point = next;
        monge = there;
        smaller = true;
      }
    }
    if (!smaller)
    {
      return gap * length < 1e-9; // no better point can be represented
    }
  }
  return false;
}

//------------------------------------------------------------------------------
double IndexOnCircle(const AnalyticSurface& surface, const Vector3d& center, double radius)
{
  const Vector3d n = surface.Gradient(center).normalized();
  const Vector3d t1 = n.unitOrthogonal();
  const Vector3d t2 = n.cross(t1);
  const int count = 96;
  const auto angleAt = [&](int i)
  {
    const double turn = 2 * Pi * i / count;
    const Vector3d d1 =
      surface.Monge(surface.Project(center + radius * (std::cos(turn) * t1 + std::sin(turn) * t2)))
        .d1;
    return std::atan2(d1.dot(t2), d1.dot(t1));
  };
  double turned = 0.0;
  double from = angleAt(0);
  for (int i = 1; i <= count; ++i)
  {
    const double to = angleAt(i % count);
    turned += std::remainder(to - from, Pi);
    from = to;
  }
  return 0.5 * std::round(turned / Pi);
}

//------------------------------------------------------------------------------
std::vector<ExactUmbilic> FindUmbilics(const AnalyticSurface& surface, const Mesh& mesh)
{
  std::vector<ExactMonge> forms(mesh.PointCount());
  ParallelFor(forms.size(), [&](std::size_t p) { forms[p] = surface.Monge(mesh.Point(p)); });
  const std::vector<bool> seeds = Seeds(mesh, forms);
  std::vector<Vector3d> ends(mesh.PointCount());
  std::vector<char> converged(mesh.PointCount(), 0);
  ParallelFor(ends.size(),
    [&](std::size_t p)
    {
      ends[p] = mesh.Point(p);
      converged[p] = seeds[p] && ConvergeToUmbilic(surface, ends[p]) ? 1 : 0;
    });

  const double same = 1e-3 * MeanEdgeLength(mesh);
  std::vector<ExactUmbilic> umbilics;
  for (std::size_t p = 0; p < ends.size(); ++p)
  {
    const bool known = std::any_of(umbilics.begin(), umbilics.end(),
      [&](const ExactUmbilic& umbilic) { return (umbilic.position - ends[p]).norm() < same; });
    if (converged[p] && !known)
    {
      const ExactMonge monge = surface.Monge(ends[p]);
      ExactUmbilic umbilic;
      umbilic.position = ends[p];
      umbilic.normal = monge.n;
      umbilic.curvature = 0.5 * (monge.k1 + monge.k2);
      umbilic.b = monge.b;
      umbilics.push_back(umbilic);
    }
  }
  std::sort(umbilics.begin(), umbilics.end(),
    [](const ExactUmbilic& a, const ExactUmbilic& b)
    {
      return std::lexicographical_compare(
        a.position.data(), a.position.data() + 3, b.position.data(), b.position.data() + 3);
    });

  const double closest = ClosestDistance(umbilics);
  for (ExactUmbilic& umbilic : umbilics)
  {
    const double length = LocalLength(surface.Monge(umbilic.position));
    umbilic.index =
      IndexOnCircle(surface, umbilic.position, std::min(1e-3 * length, 0.1 * closest));
    if (std::abs(umbilic.index) != 0.5)
    {
      throw std::runtime_error("FindUmbilics: a degenerate umbilic");
    }
    ClassifyByForm(umbilic);
  }
  return umbilics;
}

//------------------------------------------------------------------------------
double IndexSum(const std::vector<ExactUmbilic>& umbilics)
{
  double sum = 0.0;
  for (const ExactUmbilic& umbilic : umbilics)
  {
    sum += umbilic.index;
  }
  return sum;
}

//------------------------------------------------------------------------------
double ClosestDistance(const std::vector<ExactUmbilic>& umbilics)
{
  double closest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < umbilics.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      closest = std::min(closest, (umbilics[i].position - umbilics[j].position).norm());
    }
  }
  return closest;
}

} // namespace testing
} // namespace ridges
