// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Certification/SurfacePiece.h"

#include "Formula/ImplicitHeight.h"
#include "Monge/MongeForm.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace ridges
{
namespace
{

using boost::numeric::hull;

/// Covers the round-off of what is computed without intervals.
constexpr double Slack = 1e-12;

/// Coordinates in the frame, and how they change along a part, as far as it is linear.
struct PartShape
{
  std::array<Eigen::Vector3d, 3> offset; ///< Of the corners, in the tangent plane.
  double length = 0.0;                   ///< Of the longest.
  double bend = 0.0;                     ///< How far the image of a plane part is from plane.
  double turn = 0.0;                     ///< Of the direction of projection.
  double thickness = 0.0;                ///< How far along that direction the image is looked for.
  Eigen::Vector3d direction;             ///< Of projection, in the frame.
};

PartShape ShapeOf(const MappedTriangle& whole, const Part& part, const PartBounds& bounds,
  double curvature, const Eigen::Vector3d& normal)
{
  PartShape shape;
  shape.direction = bounds.frame.transpose() * normal;
  const Eigen::Vector3d center = part.Center();
  double steepest = 0.0;
  for (int i = 0; i < part.count; ++i)
  {
    const Eigen::Vector3d change = part.corner[i] - center;
    const Eigen::Vector3d turn = whole.Normal(change);
    const Eigen::Vector3d move =
      bounds.frame.transpose() * (whole.Position(change) + bounds.height * turn);
    const double rise = -move[2] / shape.direction[2];
    shape.offset[i] = move + rise * shape.direction;
    shape.length = std::max(shape.length, shape.offset[i].norm());
    shape.turn = std::max(shape.turn, turn.norm());
    steepest = std::max(steepest, std::abs(rise));
  }
  const double resolution = Slack * (bounds.center.norm() + std::abs(bounds.height));
  shape.bend = steepest * shape.turn + resolution;
  shape.thickness = curvature * shape.length * shape.length + 3.0 * shape.bend;
  return shape;
}

IntervalVector BoxOf(const PartShape& shape, int count)
{
  const double tilt = shape.direction.head<2>().norm() + shape.turn;
  const double margin = (shape.bend + shape.thickness * tilt) * (1.0 + Slack);
  IntervalVector box;
  for (int axis = 0; axis < 2; ++axis)
  {
    box[axis] = Interval(0.0);
    for (int i = 0; i < count; ++i)
    {
      box[axis] = hull(box[axis], Interval(shape.offset[i][axis]));
    }
    box[axis] += Around(0.0, margin + Slack * shape.length);
  }
  box[2] = Around(0.0, shape.bend + shape.thickness * (std::abs(shape.direction[2]) + shape.turn));
  return box;
}

/// The height of the surface over the box, if it is a graph there.
Interval HeightRange(
  const JetBounds& jets, const Series2<4, Interval>& height, const IntervalVector& box)
{
  const auto& f = jets.atOrigin;
  const Interval& steep = jets.inBox(0, 0, 1);
  const Interval offset = -f.Constant() / steep;
  const Interval slack = Around(0.0, Magnitude(offset));
  // The slope over the origin is that at the origin, up to its change on the way there.
  const Interval su = -(f(1, 0, 0) + slack * jets.inBox(1, 0, 1)) / steep;
  const Interval sv = -(f(0, 1, 0) + slack * jets.inBox(0, 1, 1)) / steep;
  return offset + su * box[0] + sv * box[1] + height(2, 0) * boost::numeric::square(box[0]) +
    height(1, 1) * box[0] * box[1] + height(0, 2) * boost::numeric::square(box[1]);
}

/// Whether every line of projection meets the surface exactly once within the thickness, and at
/// an angle.
bool IsMapped(const PartShape& shape, const JetBounds& jets, const Series2<4, Interval>& height,
  const IntervalVector& box)
{
  if (!HasSign(jets.inBox(0, 0, 1)))
  {
    return false;
  }
  const double lid = shape.thickness * (std::abs(shape.direction[2]) - shape.turn) - shape.bend;
  const double tilt = shape.direction.head<2>().norm() + shape.turn;
  const double slope = Magnitude(height(1, 0)) + Magnitude(height(0, 1));
  return Magnitude(HeightRange(jets, height, box)) < lid * (1.0 - Slack) &&
    std::abs(shape.direction[2]) - shape.turn > slope * tilt;
}

/// How u and v change on the surface where the weights do in a direction.
std::array<Interval, 2> VelocityAlong(const MappedTriangle& whole, const PartShape& shape,
  const PartBounds& bounds, const std::array<Interval, 2>& slope, const Eigen::Vector3d& change)
{
  const Eigen::Vector3d along = bounds.frame.transpose() * whole.Position(change);
  const Eigen::Vector3d turning = bounds.frame.transpose() * whole.Normal(change);
  const double reach = shape.thickness + shape.bend +
    shape.length * shape.direction.norm() / std::abs(shape.direction[2]);
  std::array<Interval, 3> move;
  std::array<Interval, 3> normal;
  const double error = Slack * (along.norm() + shape.direction.norm());
  for (int i = 0; i < 3; ++i)
  {
    move[i] = Interval(along[i]) + Around(bounds.height, reach) * turning[i] + Around(0.0, error);
    normal[i] = Around(shape.direction[i], shape.turn + error);
  }
  const Interval rise = -(move[2] - slope[0] * move[0] - slope[1] * move[1]) /
    (normal[2] - slope[0] * normal[0] - slope[1] * normal[1]);
  return { move[0] + rise * normal[0], move[1] + rise * normal[1] };
}

/// The direction of d1 or d2 in the frame, times a positive factor; `tangent` is that of the angle
/// between d1 and the first axis.
template <typename Series>
std::array<Series, 2> DirectionOf(int color, const Series& tangent)
{
  const Series one(Interval(1.0));
  return color == 0 ? std::array<Series, 2>{ one, tangent }
                    : std::array<Series, 2>{ -tangent, one };
}

/// The tangent of half the angle of the anisotropy.
template <typename Series>
Series TangentOf(const std::array<Series, 2>& anisotropy)
{
  return anisotropy[1] /
    (anisotropy[0] + Root(anisotropy[0] * anisotropy[0] + anisotropy[1] * anisotropy[1]));
}

/// The extremalities where the normal through the center meets the surface.
std::array<Interval, 2> ExtremalitiesAtFoot(const JetBounds& jets)
{
  using Series = Series2<0, Interval>;
  const Interval foot = -jets.atOrigin.Constant() / jets.inBox(0, 0, 1);
  Taylor3<4, Interval> f = jets.inBox;
  for (int i = 0; i <= 3; ++i)
  {
    for (int j = 0; i + j <= 3; ++j)
    {
      for (int k = 0; i + j + k <= 3; ++k)
      {
        f.Set(i, j, k, jets.atOrigin(i, j, k) + Interval(k + 1.0) * jets.inBox(i, j, k + 1) * foot);
      }
    }
  }
  const Series2<4, Interval> height = HeightSeries(f);
  const GraphSeries<0, Interval> graph(height);
  const Series tangent = TangentOf(graph.Anisotropy());
  const std::array<Series, 4> third{ Derivative<0>(height, 3, 0), Derivative<0>(height, 2, 1),
    Derivative<0>(height, 1, 2), Derivative<0>(height, 0, 3) };
  std::array<Interval, 2> result;
  for (int color = 0; color < 2; ++color)
  {
    result[color] = ExtremalityAlong(
      graph.slope, graph.second, third, graph.squaredArea, graph.T, DirectionOf(color, tangent))
                      .Constant();
  }
  return result;
}

void SetExtremalities(const MappedTriangle& whole, int count, const PartShape& shape,
  const JetBounds& jets, const GraphSeries<1, Interval>& graph, const CubicSeries<Interval>& cubic,
  const Series2<1, Interval>& tangent, PartBounds& bounds)
{
  const std::array<Eigen::Vector3d, 2> changes{ Eigen::Vector3d(-1.0, 1.0, 0.0),
    Eigen::Vector3d(-1.0, 0.0, 1.0) };
  const std::array<Interval, 2> slope{ graph.slope[0].Constant(), graph.slope[1].Constant() };
  const std::array<Interval, 2> atFoot = ExtremalitiesAtFoot(jets);
  for (int color = 0; color < 2; ++color)
  {
    const Series2<1, Interval> b = ExtremalityAlong(graph.slope, graph.second, cubic.third,
      graph.squaredArea, graph.T, DirectionOf(color, tangent));
    ExtremalityBounds& extremality = bounds.extremality[color];
    // Two bounds, of which the second is the better one in small boxes.
    const Interval fromFoot = atFoot[color] + b.U() * bounds.box[0] + b.V() * bounds.box[1];
    extremality.value = intersect(b.Constant(), fromFoot);
    for (int i = 0; i + 1 < count; ++i)
    {
      const auto velocity = VelocityAlong(whole, shape, bounds, slope, changes[i]);
      extremality.slope[i] = b.U() * velocity[0] + b.V() * velocity[1];
    }
  }
}

/// A polynomial of x, y and z as one of the coordinates along three axes, by Horner's rule.
Taylor3<4> Turned(const Taylor3<4>& f, const Eigen::Matrix3d& axes)
{
  std::array<Taylor3<4>, 3> x;
  for (int i = 0; i < 3; ++i)
  {
    x[i] = Taylor3<4>::Linear(0.0, axes(i, 0), axes(i, 1), axes(i, 2));
  }
  Taylor3<4> inX;
  for (int i = 4; i >= 0; --i)
  {
    Taylor3<4> inY;
    for (int j = 4 - i; j >= 0; --j)
    {
      Taylor3<4> inZ;
      for (int k = 4 - i - j; k >= 0; --k)
      {
        inZ = inZ * x[2] + Taylor3<4>(f(i, j, k));
      }
      inY = inY * x[1] + inZ;
    }
    inX = inX * x[0] + inY;
  }
  return inX;
}

} // namespace

Eigen::Vector3d MappedTriangle::Position(const Eigen::Vector3d& weights) const
{
  return weights[0] * this->point[0] + weights[1] * this->point[1] + weights[2] * this->point[2];
}

Eigen::Vector3d MappedTriangle::Normal(const Eigen::Vector3d& weights) const
{
  return weights[0] * this->normal[0] + weights[1] * this->normal[1] + weights[2] * this->normal[2];
}

Eigen::Vector3d Part::Center() const
{
  Eigen::Vector3d sum = this->corner[0];
  for (int i = 1; i < this->count; ++i)
  {
    sum += this->corner[i];
  }
  return sum / this->count;
}

Part Part::WholeTriangle()
{
  return { { Eigen::Vector3d(1.0, 0.0, 0.0), Eigen::Vector3d(0.0, 1.0, 0.0),
             Eigen::Vector3d(0.0, 0.0, 1.0) },
    3 };
}

double HeightAlong(const SurfaceBounds& surface, const Eigen::Vector3d& x,
  const Eigen::Vector3d& direction, double guess)
{
  constexpr int mostSteps = 12;
  double height = guess;
  for (int step = 0; step < mostSteps; ++step)
  {
    const Taylor3<2> f = surface.CurvatureAt(x + height * direction);
    const Eigen::Vector3d gradient(f(1, 0, 0), f(0, 1, 0), f(0, 0, 1));
    const double move = -f.Constant() / gradient.dot(direction);
    height += move;
    const double size = x.cwiseAbs().maxCoeff() + std::abs(height);
    if (!std::isfinite(height) || std::abs(move) <= 1e-14 * size)
    {
      return height;
    }
    if (step > 4 && std::abs(move) <= 1e-12 * size)
    {
      return height;
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

PrincipalFrame PrincipalFrameAt(const SurfaceBounds& surface, const Eigen::Vector3d& x)
{
  const Taylor3<2> f = surface.CurvatureAt(x);
  const Eigen::Vector3d gradient(f(1, 0, 0), f(0, 1, 0), f(0, 0, 1));
  Eigen::Matrix3d hessian;
  hessian << 2.0 * f(2, 0, 0), f(1, 1, 0), f(1, 0, 1), f(1, 1, 0), 2.0 * f(0, 2, 0), f(0, 1, 1),
    f(1, 0, 1), f(0, 1, 1), 2.0 * f(0, 0, 2);
  PrincipalFrame result;
  const Eigen::Vector3d normal = gradient.normalized();
  Eigen::Matrix<double, 3, 2> tangents;
  tangents.col(0) = normal.unitOrthogonal();
  tangents.col(1) = normal.cross(tangents.col(0));
  const Eigen::Matrix2d shape = -tangents.transpose() * hessian * tangents / gradient.norm();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(shape);
  result.curvature = { solver.eigenvalues()[1], solver.eigenvalues()[0] };
  result.axes.col(0) = (tangents * solver.eigenvectors().col(1)).normalized();
  result.axes.col(2) = normal;
  result.axes.col(1) = normal.cross(result.axes.col(0)).normalized();
  return result;
}

double ExtremalityAt(
  const SurfaceBounds& surface, const Eigen::Vector3d& x, int color, const Eigen::Vector3d& d1)
{
  const Taylor3<4> f = surface.At(x);
  const Eigen::Vector3d normal = Eigen::Vector3d(f(1, 0, 0), f(0, 1, 0), f(0, 0, 1)).normalized();
  Eigen::Matrix3d axes;
  axes.col(2) = normal;
  axes.col(0) = (d1 - d1.dot(normal) * normal).normalized();
  axes.col(1) = normal.cross(axes.col(0));
  const MongeForm form = MongeFormOfHeightJet(HeightOfImplicit(Turned(f, axes)), axes);
  const int turn = form.d1.dot(d1) < 0.0 ? -1 : 1;
  return turn * form.b[color == 0 ? 0 : 3];
}

PartBounds BoundPart(
  const SurfaceBounds& surface, const MappedTriangle& whole, const Part& part, double height)
{
  PartBounds bounds;
  const Eigen::Vector3d weights = part.Center();
  const Eigen::Vector3d normal = whole.Normal(weights);
  const Eigen::Vector3d flat = whole.Position(weights);
  bounds.height = HeightAlong(surface, flat, normal, height);
  if (!std::isfinite(bounds.height))
  {
    bounds.center = flat;
    return bounds;
  }
  bounds.center = flat + bounds.height * normal;
  const PrincipalFrame principal = PrincipalFrameAt(surface, bounds.center);
  bounds.frame = principal.axes;
  const double curvature =
    std::max(std::abs(principal.curvature[0]), std::abs(principal.curvature[1]));
  if (!bounds.frame.allFinite() || !std::isfinite(curvature))
  {
    return bounds;
  }
  const PartShape shape = ShapeOf(whole, part, bounds, curvature, normal);
  bounds.box = BoxOf(shape, part.count);
  const LocalFrame frame{ { Interval(bounds.center[0]), Interval(bounds.center[1]),
                            Interval(bounds.center[2]) },
    bounds.frame };
  const JetBounds jets = surface.In(frame, bounds.box);
  if (!HasSign(jets.inBox(0, 0, 1)))
  {
    return bounds;
  }
  const Series2<4, Interval> heights = HeightSeries(jets.inBox);
  bounds.isMapped = IsMapped(shape, jets, heights, bounds.box);
  const GraphSeries<1, Interval> graph(heights);
  const auto anisotropy = graph.Anisotropy();
  bounds.hasGap = bounds.isMapped && IsPositive(anisotropy[0].Constant());
  if (!bounds.hasGap)
  {
    return bounds;
  }
  const Series2<1, Interval> tangent = TangentOf(anisotropy);
  bounds.isNarrow = Magnitude(tangent.Constant()) < 0.5;
  if (bounds.isNarrow)
  {
    SetExtremalities(
      whole, part.count, shape, jets, graph, CubicSeries<Interval>(heights), tangent, bounds);
  }
  return bounds;
}

} // namespace ridges
