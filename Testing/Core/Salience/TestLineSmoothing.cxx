// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Fixtures/TestFields.h"
#include "Salience/LineSmoothing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace
{

using namespace ridges;
using namespace ridges::testing;

/// The edges on which a function is 0, sorted by another, with crossings that are off by up to
/// `noise` of the edge.
std::vector<RidgeVertex> Cross(const TriangleMesh& mesh,
  const std::function<double(const Eigen::Vector3d&)>& level,
  const std::function<double(const Eigen::Vector3d&)>& order, double noise = 0.0)
{
  std::mt19937_64 generator(3);
  std::vector<RidgeVertex> line;
  for (Id e = 0; e < mesh.NumberOfEdges(); ++e)
  {
    const Eigen::Vector3d p = mesh.Point(mesh.EdgeAt(e).v0);
    const Eigen::Vector3d q = mesh.Point(mesh.EdgeAt(e).v1);
    const double atP = level(p);
    const double atQ = level(q);
    if ((atP < 0.0) != (atQ < 0.0))
    {
      const double t = std::clamp(atP / (atP - atQ) + noise * Symmetric(generator), 0.0, 1.0);
      RidgeVertex vertex;
      vertex.edge = e;
      vertex.point = RidgePoint();
      vertex.point.position = (1.0 - t) * p + t * q;
      line.push_back(vertex);
    }
  }
  std::sort(line.begin(), line.end(),
    [&order](const RidgeVertex& a, const RidgeVertex& b)
    { return order(a.point.position) < order(b.point.position); });
  return line;
}

std::vector<RidgeVertex> Smooth(
  const TriangleMesh& mesh, bool closed, double sigma, std::vector<RidgeVertex> line)
{
  const FieldArrays arrays(mesh.NumberOfPoints());
  const MongeField field = arrays.View();
  LineSmoother(mesh, field, sigma).Smooth(closed, line);
  return line;
}

/// Curves y = f(x) on a plane.
class Plane
{
public:
  Plane()
    : Surface_(GraphPatch([](double, double) { return 0.0; }, 1.0, 50, 0.2))
  {
  }

  std::vector<RidgeVertex> Curve(const std::function<double(double)>& f, double noise) const
  {
    return Cross(
      this->Mesh(), [&f](const Eigen::Vector3d& x) { return x.y() - f(x.x()); },
      [](const Eigen::Vector3d& x) { return x.x(); }, noise);
  }

  const TriangleMesh& Mesh() const { return this->Surface_.Triangles(); }

private:
  MeshedSurface Surface_;
};

/// Root mean square of the distance along y, away from the ends.
double Distance(const std::vector<RidgeVertex>& line, const std::function<double(double)>& f)
{
  double sum = 0.0;
  double count = 0.0;
  for (const RidgeVertex& vertex : line)
  {
    const Eigen::Vector3d& x = vertex.point.position;
    if (std::abs(x.x()) < 0.7)
    {
      sum += (x.y() - f(x.x())) * (x.y() - f(x.x()));
      count += 1.0;
    }
  }
  return std::sqrt(sum / count);
}

} // namespace

TEST(LineSmoothing, DampsAWaveAsAGaussianDoes)
{
  const Plane plane;
  const double sigma = 0.08;
  const double length = 0.7;
  const auto wave = [length](double amplitude)
  {
    return [length, amplitude](double x)
    { return 0.01 + amplitude * std::sin(2.0 * EIGEN_PI * x / length); };
  };
  const double amplitude = 0.05;
  const double damped = amplitude * std::exp(-2.0 * std::pow(EIGEN_PI * sigma / length, 2.0));
  const auto before = plane.Curve(wave(amplitude), 0.0);
  const double shift = (amplitude - damped) / std::sqrt(2.0);
  EXPECT_NEAR(Distance(before, wave(damped)), shift, 0.1 * shift);
  EXPECT_LT(Distance(Smooth(plane.Mesh(), false, sigma, before), wave(damped)), 0.1 * shift);
}

TEST(LineSmoothing, TakesZigzagsAway)
{
  const Plane plane;
  const auto straight = [](double x) { return 0.013 + 0.3 * x; };
  const auto before = plane.Curve(straight, 0.3);
  const auto after = Smooth(plane.Mesh(), false, 0.1, before);
  EXPECT_LT(Distance(after, straight), 0.4 * Distance(before, straight));
}

TEST(LineSmoothing, KeepsTheEndsOfOpenLines)
{
  const Plane plane;
  const auto before = plane.Curve([](double x) { return 0.2 * x * x; }, 0.3);
  const auto after = Smooth(plane.Mesh(), false, 0.1, before);
  ASSERT_EQ(after.size(), before.size());
  EXPECT_EQ(after.front().point.position, before.front().point.position);
  EXPECT_EQ(after.back().point.position, before.back().point.position);
  EXPECT_EQ(after.front().edge, before.front().edge);
  EXPECT_EQ(after[1].edge, RidgeVertex::None);
}

TEST(LineSmoothing, StaysOnItsSheet)
{
  // The averages around the outer wall are nearer to the inner one.
  const double radius = 0.5;
  const double sigma = 0.1;
  const double inner = 0.99 * radius * std::exp(-0.5 * sigma * sigma / (radius * radius)) + 0.005;
  Mesh walls = CylinderPatch(radius, 5.0, 1.0, 100, 20);
  const Mesh other = CylinderPatch(inner, 5.0, 1.0, 100, 20);
  const auto first = static_cast<std::int32_t>(walls.PointCount());
  walls.points.insert(walls.points.end(), other.points.begin(), other.points.end());
  for (const std::int32_t corner : other.triangles)
  {
    walls.triangles.push_back(first + corner);
  }
  const MeshedSurface surface(walls);
  const double level = 0.013 + 0.5 * (walls.Point(0).z() + walls.Point(first - 1).z());
  const auto outside = [level, radius](const Eigen::Vector3d& x)
  { return x.head<2>().norm() > 0.999 * radius ? x.z() - level : 1.0; };
  const auto turn = [](const Eigen::Vector3d& x)
  { return std::fmod(std::atan2(x.y(), x.x()) + 2.0 * EIGEN_PI, 2.0 * EIGEN_PI); };
  const auto after =
    Smooth(surface.Triangles(), false, sigma, Cross(surface.Triangles(), outside, turn));
  ASSERT_GT(after.size(), 200u);
  for (const RidgeVertex& vertex : after)
  {
    EXPECT_NEAR(vertex.point.position.head<2>().norm(), radius, 0.001);
  }
}

TEST(LineSmoothing, DoesNotDependOnTheSense)
{
  const Plane plane;
  auto line = plane.Curve([](double x) { return 0.1 * std::sin(3.0 * x); }, 0.3);
  const auto forward = Smooth(plane.Mesh(), false, 0.1, line);
  std::reverse(line.begin(), line.end());
  auto backward = Smooth(plane.Mesh(), false, 0.1, line);
  std::reverse(backward.begin(), backward.end());
  for (std::size_t i = 0; i < forward.size(); ++i)
  {
    EXPECT_NEAR((forward[i].point.position - backward[i].point.position).norm(), 0.0, 1e-12);
  }
}

TEST(LineSmoothing, KeepsClosedLinesClosed)
{
  const Plane plane;
  const double sigma = 0.1;
  const double r = 0.5;
  auto circle = Cross(
    plane.Mesh(), [r](const Eigen::Vector3d& x) { return x.norm() - r; },
    [](const Eigen::Vector3d& x) { return std::atan2(x.y(), x.x()); });
  circle.push_back(circle.front());
  const auto line = Smooth(plane.Mesh(), true, sigma, circle);
  EXPECT_EQ(line.back().point.position, line.front().point.position);
  // By as much as a Gaussian shrinks it.
  const double radius = r * std::exp(-0.5 * sigma * sigma / (r * r));
  for (const RidgeVertex& vertex : line)
  {
    EXPECT_NEAR(vertex.point.position.norm(), radius, 0.002);
  }
}
