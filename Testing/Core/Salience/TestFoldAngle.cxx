// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Fixtures/FoliationTools.h"
#include "Fixtures/TestFields.h"

#include "Salience/FoldAngle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

using namespace ridges;
using namespace ridges::testing;

/// The graph z = -slope sqrt(x^2 + a^2), a roof with a rounded ridge along y, seen from above.
struct Roof
{
  static constexpr double Slope = 1.0;
  static constexpr double Round = 0.1;
  static constexpr double HalfSize = 1.0;

  explicit Roof(int n, double jitter = 0.2)
    : surface(GraphPatch(
        [](double x, double) { return -Slope * std::hypot(x, Round); }, HalfSize, n, jitter))
    , field(ExactField(surface.Triangles(),
        AnalyticSurface(
          [](auto x, auto, auto z) { return z + Slope * sqrt(x * x + Round * Round); })))
  {
  }

  static double Curvature(double x)
  {
    const double root = std::hypot(x, Round);
    const double first = Slope * x / root;
    return Slope * Round * Round / std::pow(root, 3) / std::pow(1.0 + first * first, 1.5);
  }

  /// By quadrature, up to a distance to both sides of the ridge, over a foot as high as there.
  static double Angle(double to, double floor = 0.0)
  {
    const double foot = Curvature(to) + floor;
    double angle = 0.0;
    const int steps = 100000;
    for (int i = 0; i < steps; ++i)
    {
      const double x = to * (i + 0.5) / steps;
      const double first = Slope * x / std::hypot(x, Round);
      angle +=
        2.0 * to / steps * std::sqrt(1.0 + first * first) * std::max(0.0, Curvature(x) - foot);
    }
    return angle;
  }

  /// The folds at all edges that the ridge, x = 0, crosses.
  std::vector<Fold> Folds(const FoldRule& rule) const
  {
    const TriangleMesh& mesh = this->surface.Triangles();
    const MongeField view = this->field.View();
    FoldMeter meter(mesh, view, rule);
    std::vector<Fold> folds;
    for (Id e = 0; e < mesh.NumberOfEdges(); ++e)
    {
      const Eigen::Vector3d a = mesh.Point(mesh.EdgeAt(e).v0);
      const Eigen::Vector3d b = mesh.Point(mesh.EdgeAt(e).v1);
      if (a[0] * b[0] < 0.0 && std::abs(a[1]) < 0.6)
      {
        const double t = a[0] / (a[0] - b[0]);
        folds.push_back(meter.Measure(Color::Red, e, (1.0 - t) * a + t * b));
      }
    }
    return folds;
  }

  MeshedSurface surface;
  FieldArrays field;
};

double LargestError(const std::vector<Fold>& folds, double expected)
{
  double error = 0.0;
  for (const Fold& fold : folds)
  {
    error = std::max(error, std::abs(fold.angle / expected - 1.0));
  }
  return error;
}

/// At the middles of edges, wherever these are.
double LargestFold(const MeshedSurface& surface, const FieldArrays& field)
{
  FoldRule rule;
  rule.reach = 5.0;
  const MongeField view = field.View();
  FoldMeter meter(surface.Triangles(), view, rule);
  double largest = 0.0;
  for (Id e = 0; e < surface.Triangles().NumberOfEdges(); e += 7)
  {
    const Edge& edge = surface.Triangles().EdgeAt(e);
    const Eigen::Vector3d middle =
      0.5 * (surface.Triangles().Point(edge.v0) + surface.Triangles().Point(edge.v1));
    for (const Color color : { Color::Blue, Color::Red })
    {
      largest = std::max(largest, meter.Measure(color, e, middle).angle);
    }
  }
  return largest;
}

} // namespace

//------------------------------------------------------------------------------
TEST(CurvatureWalk, GoesAroundATubeAtConstantCurvature)
{
  const TorusLines torus(24);
  const TriangleMesh& mesh = torus.surface.Triangles();
  const MongeField view = torus.field.View();
  CurvatureWalk walk(mesh, view);
  // Outward normals: the tube's own curvature, -1 / 0.7, is the smaller one.
  const Edge& edge = mesh.EdgeAt(100);
  const Eigen::Vector3d start = 0.5 * (mesh.Point(edge.v0) + mesh.Point(edge.v1));
  ASSERT_TRUE(walk.Start(Color::Red, edge.t0, 100, start));
  double length = 0.0;
  while (length < 2.0 * 2.0 * EIGEN_PI * 0.7 && walk.Step())
  {
    length += walk.StepLength();
    ASSERT_NEAR(walk.Curvature(), -1.0 / 0.7, 1e-4); // the tube's triangles are not flat
  }
  EXPECT_GE(length, 2.0 * 2.0 * EIGEN_PI * 0.7);
}

TEST(CurvatureWalk, EndsAtTheBorder)
{
  const MeshedSurface surface(CylinderPatch(1.0, 2.0, 3.0, 20, 17));
  const FieldArrays field = ExactField(surface.Triangles(), MakeCylinder(1.0));
  const MongeField view = field.View();
  CurvatureWalk walk(surface.Triangles(), view);
  const Edge& edge = surface.Triangles().EdgeAt(333);
  const Eigen::Vector3d middle =
    0.5 * (surface.Triangles().Point(edge.v0) + surface.Triangles().Point(edge.v1));
  double length = 0.0;
  for (const Id t : { edge.t0, edge.t1 })
  {
    ASSERT_TRUE(walk.Start(Color::Red, t, 333, middle));
    while (walk.Step())
    {
      length += walk.StepLength();
    }
  }
  // Both ways together go around the whole patch, 20 chords.
  EXPECT_NEAR(length, 20.0 * 2.0 * std::sin(0.05), 1e-4);
}

TEST(CurvatureWalk, EndsInAnyField)
{
  const MeshedSurface surface(AddNormalNoise(Icosphere(6), 0.05, 3));
  const FieldArrays field = RandomField(surface.Triangles(), 5);
  const MongeField view = field.View();
  CurvatureWalk walk(surface.Triangles(), view);
  for (Id e = 0; e < surface.Triangles().NumberOfEdges(); ++e)
  {
    const Edge& edge = surface.Triangles().EdgeAt(e);
    const Eigen::Vector3d start = surface.Triangles().Point(edge.v0);
    ASSERT_TRUE(walk.Start(Color::Blue, edge.t0, e, start));
    double length = 0.0;
    for (int i = 0; i < 2000 && length < 3.0 && walk.Step(); ++i)
    {
      ASSERT_TRUE(std::isfinite(walk.StepLength()) && std::isfinite(walk.Curvature()));
      length += walk.StepLength();
    }
  }
}

//------------------------------------------------------------------------------
TEST(FoldAngle, OfARoofIsThatBetweenItsSides)
{
  FoldRule rule;
  rule.reach = 0.7;
  rule.slack = 0.02;
  // Up to the reach along the surface: x there, by bisection.
  double x = 0.5;
  const auto arc = [](double to)
  {
    double length = 0.0;
    for (int i = 0; i < 10000; ++i)
    {
      const double at = to * (i + 0.5) / 10000;
      length += to / 10000 * std::hypot(1.0, Roof::Slope * at / std::hypot(at, Roof::Round));
    }
    return length;
  };
  for (double step = 0.25; step > 1e-6; step *= 0.5)
  {
    x += arc(x) > rule.reach ? -step : step;
  }
  const double expected = Roof::Angle(x);
  EXPECT_NEAR(expected, 2.0 * std::atan(Roof::Slope), 0.1); // the surface turns by nearly this

  const Roof coarse(40);
  const Roof fine(80);
  const double errorOfCoarse = LargestError(coarse.Folds(rule), expected);
  const double errorOfFine = LargestError(fine.Folds(rule), expected);
  // 0.05 and 0.025 long edges over a bend of radius 0.1; of second order, half of that with jitter.
  EXPECT_LT(errorOfCoarse, 0.1);
  EXPECT_LT(errorOfFine, 0.03);
  EXPECT_GT(fine.Folds(rule).size(), 80u);

  // The floor is taken off like the foot.
  rule.floor = 0.5;
  EXPECT_LT(LargestError(fine.Folds(rule), Roof::Angle(x, 0.5)), 0.03);
}

TEST(FoldAngle, WidthAndHeightAreThoseOfTheBend)
{
  FoldRule rule;
  rule.reach = 0.7;
  rule.slack = 0.02;
  rule.floor = 0.5 * Roof::Curvature(0.0);
  const Roof roof(80);
  double half = 0.0; // where the curvature is half of that at the ridge, as an arc length
  for (double x = 0.0; Roof::Curvature(x) > rule.floor + Roof::Curvature(0.5); x += 1e-4)
  {
    half += 1e-4 * std::hypot(1.0, Roof::Slope * x / std::hypot(x, Roof::Round));
  }
  for (const Fold& fold : roof.Folds(rule))
  {
    EXPECT_NEAR(fold.height, Roof::Curvature(0.0), 0.05 * Roof::Curvature(0.0));
    EXPECT_NEAR(fold.width, 2.0 * half, 0.1 * half);
  }
}

// Everything is a ridge there, or nothing, and no feature has a height.
TEST(FoldAngle, IsZeroOnSurfacesOfConstantCurvature)
{
  const MeshedSurface sphere(Icosphere(8));
  EXPECT_LT(LargestFold(sphere, ExactField(sphere.Triangles(), MakeSphere(1.0))), 1e-9);
  const MeshedSurface cylinder(CylinderPatch(1.0, 3.0, 3.0, 30, 30));
  EXPECT_LT(LargestFold(cylinder, ExactField(cylinder.Triangles(), MakeCylinder(1.0))), 1e-9);
  // On a torus only the other curvature changes along its line, and that is no fold of the tube.
  const TorusLines torus(20);
  EXPECT_LT(LargestFold(torus.surface, torus.field), 0.05);
}

// Around a tube there is nothing that ends a walk but the number of its triangles.
TEST(FoldAngle, EndsWhateverTheReach)
{
  const MeshedSurface surface(TorusMesh(1.0, 0.4, 20, 10));
  const FieldArrays field = ExactField(surface.Triangles(), MakeTorus(1.0, 0.4));
  FoldRule rule;
  rule.reach = std::numeric_limits<double>::infinity();
  rule.slack = rule.reach;
  const MongeField view = field.View();
  FoldMeter meter(surface.Triangles(), view, rule);
  for (const Color color : { Color::Blue, Color::Red })
  {
    const Edge& edge = surface.Triangles().EdgeAt(7);
    const Eigen::Vector3d middle =
      0.5 * (surface.Triangles().Point(edge.v0) + surface.Triangles().Point(edge.v1));
    EXPECT_TRUE(std::isfinite(meter.Measure(color, 7, middle).angle));
  }
}

// A higher peak on the way ends the walk, and the saddle before it is the foot.
TEST(FoldAngle, OfALowerPeakEndsAtTheSaddle)
{
  // Curvature along x of a tower and a hill, as if on a plane.
  const MeshedSurface surface(GraphPatch([](double, double) { return 0.0; }, 1.0, 100, 0.2));
  const TriangleMesh& mesh = surface.Triangles();
  FieldArrays field(mesh.NumberOfPoints());
  const auto curvature = [](double x)
  {
    return std::max(0.0, 1.0 - 10.0 * std::abs(x + 0.3)) +
      std::max(0.2 - 0.2 * x, 2.0 - 10.0 * std::abs(x - 0.3));
  };
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    MongeForm form;
    form.n = Eigen::Vector3d::UnitZ();
    form.d1 = Eigen::Vector3d::UnitX();
    form.d2 = Eigen::Vector3d::UnitY();
    form.k1 = curvature(mesh.Point(p)[0]);
    field.Set(p, form);
  }
  FoldRule rule;
  rule.reach = 2.0;
  rule.slack = 0.03; // an edge: the peak of the interpolated curvature is not just at x = -0.3
  const MongeField view = field.View();
  FoldMeter meter(mesh, view, rule);
  for (Id e = 0; e < mesh.NumberOfEdges(); ++e)
  {
    const Eigen::Vector3d a = mesh.Point(mesh.EdgeAt(e).v0);
    const Eigen::Vector3d b = mesh.Point(mesh.EdgeAt(e).v1);
    if ((a[0] + 0.3) * (b[0] + 0.3) < 0.0 && std::abs(a[1]) < 0.5)
    {
      const double t = (a[0] + 0.3) / (a[0] - b[0]);
      const Fold fold = meter.Measure(Color::Blue, e, (1.0 - t) * a + t * b);
      // From 1.26 down to 0.28 on the left, and from there the slope rises; on the right it falls
      // to 0.18 before the tower. Edges are a fifth of the hill's half width long.
      EXPECT_NEAR(fold.height, 1.26 - 0.28, 0.15);
      EXPECT_NEAR(fold.angle, 0.096, 0.01);
    }
  }
}
