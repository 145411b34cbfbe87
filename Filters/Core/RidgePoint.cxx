// SPDX-License-Identifier: BSD-3-Clause
#include "RidgePoint.h"

#include "MongeInterpolation.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

namespace ridges
{
namespace
{

/// The zero of the extremality between the two ends, where it has opposite signs: regula falsi in
/// its Illinois form, whose first step is equation (4).
double FindCrossing(const MongeInterpolation& interpolation, Color color)
{
  constexpr double tolerance = 1e-8; // of the edge
  double begin = 0.0;
  double end = 1.0;
  double atBegin = interpolation.Extremality(color, begin);
  double atEnd = interpolation.Extremality(color, end);
  double t = CrossingParameter(atBegin, atEnd);
  double step = 1.0;
  int lastSide = 0;
  for (int i = 0; i < 50 && step > tolerance; ++i)
  {
    const double value = interpolation.Extremality(color, t);
    const int side = ExtremalitySign(value) == ExtremalitySign(atBegin) ? -1 : 1;
    if (value == 0.0)
    {
      break;
    }
    (side < 0 ? begin : end) = t;
    (side < 0 ? atBegin : atEnd) = value;
    if (side == lastSide)
    {
      (side < 0 ? atEnd : atBegin) *= 0.5;
    }
    lastSide = side;
    const double next = begin + (end - begin) * CrossingParameter(atBegin, atEnd);
    step = std::abs(next - t);
    t = next;
  }
  return t;
}

} // namespace

RidgePoint RidgePointOnEdge(
  const TriangleMesh& mesh, const MongeField& field, Color color, CrossingRule rule, Id edge)
{
  // From the end that comes first in space: the result does not depend on the numbering.
  const Id v0 = mesh.EdgeAt(edge).v0;
  const Id v1 = mesh.EdgeAt(edge).v1;
  const auto x0 = mesh.Point(v0);
  const auto x1 = mesh.Point(v1);
  const bool swaps =
    std::lexicographical_compare(x1.data(), x1.data() + 3, x0.data(), x0.data() + 3);
  const Id p = swaps ? v1 : v0;
  const Id q = swaps ? v0 : v1;
  const MongeInterpolation interpolation(field, p, q);
  const double t = rule == CrossingRule::Form
    ? FindCrossing(interpolation, color)
    : CrossingParameter(field.Extremality(color, p), field.Extremality(color, q));
  const MongeForm form = interpolation.At(t);
  const bool blue = color == Color::Blue;

  RidgePoint point;
  point.parameter = swaps ? 1.0 - t : t;
  point.position = (1.0 - t) * mesh.Point(p) + t * mesh.Point(q);
  point.curvature = blue ? form.k1 : form.k2;
  point.gap = form.k1 - form.k2;
  point.crestMargin = std::abs(point.curvature) - std::abs(blue ? form.k2 : form.k1);
  point.P = 0.0;
  if (field.c)
  {
    point.P = blue ? form.P1() : form.P2();
  }
  else if (field.HasFourthOrder())
  {
    point.P = (1.0 - t) * field.P(color, p) + t * field.P(color, q);
  }
  return point;
}

Eigen::Vector3d UmbilicWeights(const TriangleMesh& mesh, const MongeField& field, Id triangle)
{
  const Triangle& corners = mesh.Corners(triangle);
  Eigen::Vector3d centroid = Eigen::Vector3d::Constant(1.0 / 3.0);
  const Eigen::Vector3d normal = mesh.AreaNormal(triangle);
  const Eigen::Vector3d e1 = (mesh.Point(corners[1]) - mesh.Point(corners[0])).normalized();
  const Eigen::Vector3d e2 = normal.cross(e1).normalized();

  // The traceless form (k1 - k2) / 2 (cos 2a, sin 2a), a the angle of d1, is a vector that turns
  // twice as fast as d1 and vanishes at the umbilic; here at each corner, in one frame.
  Eigen::Matrix3d system;
  for (int i = 0; i < 3; ++i)
  {
    const Id v = corners[i];
    const double x1 = field.D1(v).dot(e1);
    const double y1 = field.D1(v).dot(e2);
    const double x2 = field.D2(v).dot(e1);
    const double y2 = field.D2(v).dot(e2);
    // From both directions, so that it is the same seen from the other side of the surface.
    const double gap = field.k1[v] - field.k2[v];
    system.col(i) << gap * (x1 * x1 - y1 * y1 - x2 * x2 + y2 * y2), 2.0 * gap * (x1 * y1 - x2 * y2),
      0.0;
  }
  const double magnitude = system.cwiseAbs().maxCoeff();
  if (!(magnitude > 0.0) || !std::isfinite(magnitude))
  {
    return centroid;
  }
  system /= magnitude;
  system.row(2).setOnes();
  const Eigen::FullPivLU<Eigen::Matrix3d> solver(system);
  const Eigen::Vector3d weights = solver.solve(Eigen::Vector3d(0.0, 0.0, 1.0));
  const bool inside = solver.isInvertible() && weights.minCoeff() >= 0.0;
  return inside ? weights : centroid;
}

Eigen::Vector3d UmbilicInTriangle(const TriangleMesh& mesh, const MongeField& field, Id triangle)
{
  const Triangle& corners = mesh.Corners(triangle);
  const Eigen::Vector3d weights = UmbilicWeights(mesh, field, triangle);
  return weights[0] * mesh.Point(corners[0]) + weights[1] * mesh.Point(corners[1]) +
    weights[2] * mesh.Point(corners[2]);
}

RidgePoint RidgePointAtUmbilic(
  const TriangleMesh& mesh, const MongeField& field, Id triangle, const RidgePoint& next)
{
  const Triangle& corners = mesh.Corners(triangle);
  const Eigen::Vector3d weights = UmbilicWeights(mesh, field, triangle);
  RidgePoint point = next;
  point.parameter = 0.0;
  point.position = UmbilicInTriangle(mesh, field, triangle);
  point.curvature = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    point.curvature += weights[i] * 0.5 * (field.k1[corners[i]] + field.k2[corners[i]]);
  }
  point.gap = 0.0;
  point.crestMargin = 0.0;
  return point;
}

} // namespace ridges
