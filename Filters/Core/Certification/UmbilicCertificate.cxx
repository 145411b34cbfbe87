// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Certification/UmbilicCertificate.h"

#include "Certification/UmbilicRing.h"
#include "Certification/UmbilicSectors.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace ridges
{
namespace
{

constexpr double Slack = 1e-12;

Eigen::Matrix3d AnyFrame(const SurfaceBounds& surface, const Eigen::Vector3d& x)
{
  const Taylor3<2> f = surface.CurvatureAt(x);
  Eigen::Matrix3d frame;
  frame.col(2) = Eigen::Vector3d(f(1, 0, 0), f(0, 1, 0), f(0, 0, 1)).normalized();
  frame.col(0) = frame.col(2).unitOrthogonal();
  frame.col(1) = frame.col(2).cross(frame.col(0)).normalized();
  return frame;
}

/// The surface over a box of a frame, or nothing if it is not a graph within the box's height.
struct Graph
{
  JetBounds jets;
  Series2<4, Interval> height;
  Interval foot; ///< The height over the origin.
  double highest = 0.0;
};

std::optional<Graph> GraphOver(
  const SurfaceBounds& surface, const LocalFrame& frame, const IntervalVector& box)
{
  Graph graph;
  graph.jets = surface.In(frame, box);
  const Interval& steep = graph.jets.inBox(0, 0, 1);
  if (!HasSign(steep))
  {
    return std::nullopt;
  }
  graph.height = HeightSeries(graph.jets.inBox);
  graph.foot = -graph.jets.atOrigin.Constant() / steep;
  const Interval range = graph.foot + graph.height(1, 0) * box[0] + graph.height(0, 1) * box[1];
  graph.highest = Magnitude(range);
  return graph.highest < Magnitude(box[2]) ? std::optional<Graph>(graph) : std::nullopt;
}

IntervalVector Points(const Eigen::Vector3d& x)
{
  return { Interval(x[0]), Interval(x[1]), Interval(x[2]) };
}

double CurvatureScale(const SurfaceBounds& surface, const Eigen::Vector3d& x)
{
  const PrincipalFrame frame = PrincipalFrameAt(surface, x);
  return std::max(std::abs(frame.curvature[0]), std::abs(frame.curvature[1]));
}

using Matrix = std::array<std::array<Interval, 2>, 2>;

Matrix Gradients(const std::array<Series2<2, Interval>, 2>& w)
{
  return { { { w[0].U(), w[0].V() }, { w[1].U(), w[1].V() } } };
}

/// Krawczyk's test; on success `origin` becomes a box that contains the umbilic.
bool Isolate(const SurfaceBounds& surface, const Eigen::Vector3d& position,
  const Eigen::Matrix3d& axes, double radius, IntervalVector& origin, double& error)
{
  const LocalFrame frame{ Points(position), axes };
  const Interval side = Around(0.0, radius);
  const Interval zero(0.0);
  const auto whole = GraphOver(surface, frame, { side, side, side });
  const double thin = 1e-6 * radius;
  const auto center = GraphOver(
    surface, frame, { Around(0.0, thin * 1e-6), Around(0.0, thin * 1e-6), Around(0.0, thin) });
  if (!whole || !center)
  {
    return false;
  }
  const auto w = GraphSeries<2, Interval>(whole->height).Anisotropy();
  const auto w0 = GraphSeries<2, Interval>(center->height).Anisotropy();
  const Matrix slope = Gradients(w);
  Eigen::Matrix2d middle;
  for (int i = 0; i < 2; ++i)
  {
    for (int j = 0; j < 2; ++j)
    {
      middle(i, j) = boost::numeric::median(slope[i][j]);
    }
  }
  const Eigen::Matrix2d inverse = middle.inverse();
  if (!inverse.allFinite())
  {
    return false;
  }
  std::array<Interval, 3> found;
  for (int i = 0; i < 2; ++i)
  {
    found[i] = zero;
    for (int j = 0; j < 2; ++j)
    {
      found[i] -= Interval(inverse(i, j)) * w0[j].Constant();
      Interval rest(i == j ? 1.0 : 0.0);
      for (int k = 0; k < 2; ++k)
      {
        rest -= Interval(inverse(i, k)) * slope[k][j];
      }
      found[i] += rest * side;
    }
    if (!(Magnitude(found[i]) < radius))
    {
      return false;
    }
  }
  found[2] = whole->foot + whole->height(1, 0) * found[0] + whole->height(0, 1) * found[1];
  error = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    origin[i] = Interval(position[i]);
    for (int axis = 0; axis < 3; ++axis)
    {
      origin[i] += Around(axes(i, axis), Slack) * found[axis];
    }
    error = std::max(error, Magnitude(found[i]));
  }
  return true;
}

/// Whether all ridges in a disk end at the umbilic.
bool CertifyDisk(const SurfaceBounds& surface, const LocalFrame& frame, double radius,
  double curvature, UmbilicCertificate& result)
{
  const double height = 2.0 * curvature * radius * radius + 1e-3 * radius;
  const Interval side = Around(0.0, radius);
  const auto graph = GraphOver(surface, frame, { side, side, Around(0.0, height) });
  if (!graph)
  {
    return false;
  }
  const auto anisotropy = GraphSeries<2, Interval>(graph->height).Anisotropy();
  const Interval determinant =
    anisotropy[0].U() * anisotropy[1].V() - anisotropy[0].V() * anisotropy[1].U();
  if (!HasSign(determinant))
  {
    return false;
  }
  const auto ridgeCount = RidgesAroundUmbilic(radius, graph->height);
  if (!ridgeCount)
  {
    return false;
  }
  result.ridgeCount = *ridgeCount;
  result.index = IsPositive(determinant) ? 0.5 : -0.5;
  result.radius = radius;
  result.height = height;
  return true;
}

/// Whether the surface is a graph over the disk, as far as it is in the box.
bool IsGraph(const SurfaceBounds& surface, const LocalFrame& frame, double radius, double height)
{
  const Interval side = Around(0.0, radius);
  return HasSign(surface.In(frame, { side, side, Around(0.0, height) }).inBox(0, 0, 1));
}

/// Makes the disk larger, ring by ring.
void Enlarge(const SurfaceBounds& surface, const LocalFrame& frame, double largest,
  double curvature, UmbilicCertificate& result)
{
  constexpr double step = 1.4;
  for (double radius = step * result.radius; radius <= largest; radius *= step)
  {
    const double height = 2.0 * curvature * radius * radius + 1e-3 * radius;
    if (!IsGraph(surface, frame, radius, height) ||
      !IsCrossedTransversally(surface, result, result.radius, radius))
    {
      return;
    }
    result.radius = radius;
    result.height = height;
  }
}

} // namespace

bool FindUmbilic(const SurfaceBounds& surface, double reach, Eigen::Vector3d& position)
{
  constexpr int mostSteps = 20;
  const Eigen::Vector3d start = position;
  for (int step = 0; step < mostSteps; ++step)
  {
    const Eigen::Matrix3d axes = AnyFrame(surface, position);
    const double height = HeightAlong(surface, position, axes.col(2), 0.0);
    if (!std::isfinite(height))
    {
      return false;
    }
    position += height * axes.col(2);
    const LocalFrame frame{ Points(position), axes };
    const Interval zero(0.0);
    const auto jets = surface.In(frame, { zero, zero, zero });
    Taylor3<4> f;
    for (int i = 0; i <= 4; ++i)
    {
      for (int j = 0; i + j <= 4; ++j)
      {
        for (int k = 0; i + j + k <= 4; ++k)
        {
          f.Set(i, j, k, boost::numeric::median(jets.atOrigin(i, j, k)));
        }
      }
    }
    const auto w = GraphSeries<1, double>(HeightSeries(f)).Anisotropy();
    const Eigen::Vector2d value(w[0].Constant(), w[1].Constant());
    if (value.norm() <= 1e-14 * CurvatureScale(surface, position))
    {
      return true; // also where umbilics are not isolated
    }
    Eigen::Matrix2d slope;
    slope << w[0].U(), w[0].V(), w[1].U(), w[1].V();
    const Eigen::Vector2d move = -slope.inverse() * value;
    if (!move.allFinite() || move.norm() > reach)
    {
      return false;
    }
    position += axes.leftCols<2>() * move;
    if ((position - start).norm() > reach)
    {
      return false;
    }
    if (move.norm() <= 1e-11 * reach)
    {
      const double last = HeightAlong(surface, position, axes.col(2), 0.0);
      position += last * axes.col(2);
      return std::isfinite(last);
    }
  }
  return false;
}

UmbilicCertificate CertifyUmbilic(
  const SurfaceBounds& surface, const Eigen::Vector3d& position, double largest)
{
  UmbilicCertificate result;
  result.position = position;
  result.frame = AnyFrame(surface, position);
  const double curvature = CurvatureScale(surface, position);
  const double scale = std::min(largest, 1.0 / curvature);
  LocalFrame frame{ {}, result.frame };
  for (double radius = 1e-8 * scale; radius < 1e-2 * scale && !result.isIsolated; radius *= 10.0)
  {
    result.isIsolated =
      Isolate(surface, position, result.frame, radius, frame.origin, result.error);
  }
  if (!result.isIsolated)
  {
    return result;
  }
  constexpr int mostHalvings = 26;
  double radius = std::min(largest, 0.1 / curvature);
  for (int i = 0; i < mostHalvings; ++i, radius *= 0.5)
  {
    if (CertifyDisk(surface, frame, radius, curvature, result))
    {
      Enlarge(surface, frame, std::min(largest, 0.5 / curvature), curvature, result);
      return result;
    }
  }
  return result;
}

} // namespace ridges
