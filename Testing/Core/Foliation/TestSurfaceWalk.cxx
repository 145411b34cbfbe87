// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Fixtures/TestFields.h"

#include "Foliation/SurfaceWalk.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace
{

using namespace ridges;
using namespace ridges::testing;

struct Walked
{
  std::vector<Eigen::Vector3d> points;
  double length = 0.0;
};

Walked WalkFrom(SurfaceWalk& walk, WalkRule rule, const TriangleMesh& mesh, Id triangle,
  const Eigen::Vector2d& along, double longest, int mostSteps)
{
  walk.Start(rule, triangle, mesh.Centroid(triangle), along);
  Walked walked;
  walked.points.push_back(walk.Position());
  while (static_cast<int>(walked.points.size()) <= mostSteps && walk.Step(longest))
  {
    walked.points.push_back(walk.Position());
    walked.length += walk.StepLength();
  }
  return walked;
}

/// Inside, up to round-off.
void ExpectInTriangle(const TriangleMesh& mesh, Id t, const Eigen::Vector3d& x)
{
  const Triangle& corners = mesh.Corners(t);
  const Eigen::Vector3d n = mesh.AreaNormal(t);
  for (int i = 0; i < 3; ++i)
  {
    const Eigen::Vector3d a = mesh.Point(corners[i]);
    const Eigen::Vector3d b = mesh.Point(corners[(i + 1) % 3]);
    ASSERT_GT((b - a).cross(x - a).dot(n), -1e-9 * n.squaredNorm());
  }
  ASSERT_LT(std::abs((x - mesh.Centroid(t)).dot(n)), 1e-12 * std::pow(n.norm(), 1.5));
}

const std::vector<std::uint8_t> NothingClosed(100000, 0);

} // namespace

//------------------------------------------------------------------------------
// A cylinder of flat strips unrolls into a plane, where a straight way is straight.
TEST(SurfaceWalk, StraightWaysUnrollToStraightLines)
{
  const double angle = 5.0;
  const int strips = 40;
  const MeshedSurface surface(CylinderPatch(1.0, angle, 3.0, strips, 17));
  const TriangleMesh& mesh = surface.Triangles();
  const FieldArrays field = ExactField(mesh, MakeCylinder(1.0));
  SurfaceWalk walk(mesh, field.View(), NothingClosed);
  const double chord = 2.0 * std::sin(0.5 * angle / strips);
  for (const Id start : { 0, 101, 700 })
  {
    for (const double direction : { 0.1, 1.0, 2.0, 3.5, 6.0 })
    {
      const Walked walked = WalkFrom(walk, WalkRule::Straight, mesh, start,
        { std::cos(direction), std::sin(direction) }, 0.05, 100000);
      ASSERT_GT(walked.points.size(), 1u);
      std::vector<Eigen::Vector2d> unrolled;
      for (const Eigen::Vector3d& x : walked.points)
      {
        double theta = std::atan2(x[1], x[0]);
        theta += theta < -1e-9 ? 2.0 * EIGEN_PI : 0.0;
        const double strip = std::min<double>(strips - 1, std::floor(theta * strips / angle));
        const double middle = (strip + 0.5) * angle / strips;
        const double within = x[1] * std::cos(middle) - x[0] * std::sin(middle);
        unrolled.emplace_back((strip + 0.5) * chord + within, x[2]);
      }
      const Eigen::Vector2d way = unrolled.back() - unrolled.front();
      EXPECT_NEAR(way.norm(), walked.length, 1e-10);
      for (const Eigen::Vector2d& x : unrolled)
      {
        const Eigen::Vector2d offset = x - unrolled.front();
        // Steps keep a millionth of an edge (0.2) away from the corners.
        EXPECT_LT(std::abs(offset[0] * way[1] - offset[1] * way[0]) / way.norm(), 1e-6);
      }
    }
  }
}

TEST(SurfaceWalk, StaysInItsTriangles)
{
  const MeshedSurface surface(AddNormalNoise(Icosphere(8), 0.05, 3));
  const TriangleMesh& mesh = surface.Triangles();
  const FieldArrays field = RandomField(mesh, 5);
  SurfaceWalk walk(mesh, field.View(), NothingClosed);
  for (Id start = 0; start < mesh.NumberOfTriangles(); start += 10)
  {
    for (const WalkRule rule : { WalkRule::Blue, WalkRule::Red, WalkRule::Straight })
    {
      walk.Start(rule, start, mesh.Centroid(start), Eigen::Vector2d::UnitX());
      Id before = start;
      for (int i = 0; i < 300 && walk.Step(0.03); ++i)
      {
        const Id now = walk.CurrentTriangle();
        ASSERT_NO_FATAL_FAILURE(ExpectInTriangle(mesh, now, walk.Position()));
        ASSERT_NEAR(walk.Direction().norm(), 1.0, 1e-12);
        if (now != before)
        {
          const bool adjacent = mesh.Neighbor(before, 0) == now ||
            mesh.Neighbor(before, 1) == now || mesh.Neighbor(before, 2) == now;
          ASSERT_TRUE(adjacent);
        }
        before = now;
      }
    }
  }
}

// Along the generators k1 = 0 >= k2 = -1: they are the blue lines, and the circles are the red.
TEST(SurfaceWalk, CurvatureLinesOfACylinderAreItsGeneratorsAndCircles)
{
  const MeshedSurface surface(CylinderPatch(1.0, 5.0, 3.0, 40, 17));
  const TriangleMesh& mesh = surface.Triangles();
  const FieldArrays field = ExactField(mesh, MakeCylinder(1.0));
  SurfaceWalk walk(mesh, field.View(), NothingClosed);
  const Id start = 701;
  for (const double sign : { 1.0, -1.0 })
  {
    for (const Eigen::Vector3d& x :
      WalkFrom(walk, WalkRule::Red, mesh, start, sign * Eigen::Vector2d(0.6, 0.8), 1.0, 10000)
        .points)
    {
      EXPECT_NEAR(x[2], mesh.Centroid(start)[2], 1e-12);
    }
    for (const Eigen::Vector3d& x :
      WalkFrom(walk, WalkRule::Blue, mesh, start, sign * Eigen::Vector2d(0.6, 0.8), 1.0, 10000)
        .points)
    {
      EXPECT_LT((x - mesh.Centroid(start)).head<2>().norm(), 1e-12);
    }
  }
  // From border to border, both ways together: the height, and the polygon's length.
  double blue = 0.0;
  double red = 0.0;
  const FlatTriangle face(mesh, field.View(), start);
  for (const double sign : { 1.0, -1.0 })
  {
    const auto lengthOf = [&](WalkRule rule, Color color)
    {
      const Eigen::Vector2d along =
        sign * face.Direction(color, face.Centroid(), Eigen::Vector2d::Zero());
      return WalkFrom(walk, rule, mesh, start, along, 1.0, 10000).length;
    };
    blue += lengthOf(WalkRule::Blue, Color::Blue);
    red += lengthOf(WalkRule::Red, Color::Red);
  }
  EXPECT_NEAR(blue, 3.0, 1e-12);
  EXPECT_NEAR(red, 40.0 * 2.0 * std::sin(0.5 * 5.0 / 40.0), 1e-12);
}

TEST(SurfaceWalk, DoesNotEnterClosedTriangles)
{
  const MeshedSurface surface(Icosphere(10));
  const TriangleMesh& mesh = surface.Triangles();
  const FieldArrays field = RandomField(mesh, 1);
  std::vector<std::uint8_t> closed(mesh.NumberOfTriangles(), 0);
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    closed[t] = mesh.Centroid(t)[2] < 0.0 ? 1 : 0;
  }
  SurfaceWalk walk(mesh, field.View(), closed);
  for (Id start = 0; start < mesh.NumberOfTriangles(); ++start)
  {
    if (!closed[start])
    {
      walk.Start(WalkRule::Straight, start, mesh.Centroid(start), Eigen::Vector2d::UnitY());
      while (walk.Step(1.0))
      {
        ASSERT_FALSE(closed[walk.CurrentTriangle()]);
      }
    }
  }
}

// A long step is cut where the direction turns: around this umbilic the blue lines are parabolas,
// z^(1/2) at half the angle, that is, y^2 = 4 c (c + x) or so. Their invariant is |z| - x.
TEST(SurfaceWalk, ShortensItsStepsWhereTheDirectionTurns)
{
  Mesh plane;
  plane.AddPoint({ -3.0, -3.1, 0.0 });
  plane.AddPoint({ 3.3, -3.0, 0.0 });
  plane.AddPoint({ 0.1, 3.2, 0.0 });
  plane.AddTriangle(0, 1, 2);
  const MeshedSurface surface(plane);
  const TriangleMesh& mesh = surface.Triangles();
  FieldArrays field(3);
  for (Id p = 0; p < 3; ++p)
  {
    const Eigen::Vector3d x = mesh.Point(p);
    const double angle = 0.5 * std::atan2(x[1], x[0]);
    MongeForm form;
    form.d1 = { std::cos(angle), std::sin(angle), 0.0 };
    form.d2 = { -std::sin(angle), std::cos(angle), 0.0 };
    form.n = Eigen::Vector3d::UnitZ();
    form.k1 = x.norm();
    form.k2 = -x.norm();
    field.Set(p, form);
  }
  SurfaceWalk walk(mesh, field.View(), NothingClosed);
  for (const double start : { -0.02, -0.1, -0.3 })
  {
    double greatest = 0.0;
    for (const double sign : { 1.0, -1.0 })
    {
      const Eigen::Vector3d x(start, 0.0, 0.0);
      const FlatTriangle face(mesh, field.View(), 0);
      const Eigen::Vector2d along =
        sign * (face.ToFlat(x + Eigen::Vector3d::UnitY()) - face.ToFlat(x));
      walk.Start(WalkRule::Blue, 0, x, along);
      while (walk.Step(1.0))
      {
        const Eigen::Vector3d& y = walk.Position();
        greatest = std::max(greatest, std::abs(y.norm() - y[0] - 2.0 * std::abs(start)));
      }
    }
    // A step of the midpoint rule that turns by 0.1 errs by 0.1^3 / 24 of its length across, and
    // the turns add up to half a turn, with the lengths to the triangle's radius of 3; what is left
    // is how lines spread on the way out.
    EXPECT_LT(greatest, 2e-3) << start;
  }
}
