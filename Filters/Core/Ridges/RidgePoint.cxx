// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ridges/RidgePoint.h"

#include "Monge/AcuteRule.h"
#include "Monge/FieldOrder.h"
#include "Monge/MongeInterpolation.h"
#include "Umbilics/UmbilicForm.h"

#include <algorithm>
#include <cmath>

namespace ridges
{
namespace
{

/// The zero of the extremality between two ends where it has these values, of opposite signs:
/// Newton's method from the point of equation (4), or halving where that leads astray.
double FindCrossing(
  const MongeInterpolation& interpolation, Color color, double atBegin, double atEnd)
{
  constexpr double tolerance = 1e-8; // of the edge; the last step squares the error
  double begin = 0.0;
  double end = 1.0;
  double t = CrossingParameter(atBegin, atEnd);
  double step = 1.0;
  for (int i = 0; i < 100 && step > tolerance; ++i)
  {
    const auto newton = interpolation.StepToCrossing(color, t);
    if (newton.value == 0.0)
    {
      break;
    }
    (ExtremalitySign(newton.value) == ExtremalitySign(atBegin) ? begin : end) = t;
    double next = t + newton.step;
    if (!(begin <= next && next <= end && std::abs(newton.step) < 0.5 * step))
    {
      next = 0.5 * (begin + end);
    }
    step = std::abs(next - t);
    t = next;
  }
  return t;
}

RidgePoint Interpolate(const TriangleMesh& mesh, const MongeField& field, Color color,
  const OrderedEdge& ends, const MongeInterpolation& interpolation, double t)
{
  const MongeInterpolation::Extremum form = interpolation.ExtremumAt(color, t);
  const bool blue = color == Color::Blue;

  RidgePoint point;
  point.color = color;
  point.parameter = ends.swaps ? 1.0 - t : t;
  point.position = (1.0 - t) * mesh.Point(ends.p) + t * mesh.Point(ends.q);
  point.curvature = blue ? form.k1 : form.k2;
  point.gap = form.k1 - form.k2;
  point.crestMargin = std::abs(point.curvature) - std::abs(blue ? form.k2 : form.k1);
  point.P = form.P;
  if (!field.c && field.HasFourthOrder())
  {
    point.P = (1.0 - t) * field.P(color, ends.p) + t * field.P(color, ends.q);
  }
  return point;
}

} // namespace

RidgePoint RidgePointOnEdge(
  const TriangleMesh& mesh, const MongeField& field, Color color, CrossingRule rule, Id edge)
{
  const OrderedEdge ends = EndsInOrder(mesh, field, edge);
  const MongeInterpolation interpolation(field, ends.p, ends.q);
  const double atP = field.Extremality(color, ends.p);
  const double atQ = field.Extremality(color, ends.q);
  const double t = rule == CrossingRule::Form ? FindCrossing(interpolation, color, atP, atQ)
                                              : CrossingParameter(atP, atQ);
  return Interpolate(mesh, field, color, ends, interpolation, t);
}

RidgePoint RidgePointAt(
  const TriangleMesh& mesh, const MongeField& field, Color color, Id edge, double parameter)
{
  const OrderedEdge ends = EndsInOrder(mesh, field, edge);
  const MongeInterpolation interpolation(field, ends.p, ends.q);
  return Interpolate(mesh, field, color, ends, interpolation, parameter);
}

RidgePoint RidgePointAtUmbilic(const TriangleMesh& mesh, const MongeField& field, Id triangle,
  const Eigen::Vector3d& position, const RidgePoint& next)
{
  const Triangle corners = CornersInOrder(mesh, field, triangle);
  const Eigen::Vector3d weights = UmbilicWeights(mesh, field, triangle);
  RidgePoint point = next;
  point.parameter = 0.0;
  point.position = position;
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
