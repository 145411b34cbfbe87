// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// Curvature lines: are they such.

#include "Fixtures/FoliationTools.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace
{

using namespace ridges;
using namespace ridges::testing;

/// The spread of a function along all lines.
template <typename Function>
double GreatestSpread(const std::vector<CurvatureLine>& lines, const Function& function)
{
  double greatest = 0.0;
  for (const CurvatureLine& line : lines)
  {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Eigen::Vector3d& x : line.points)
    {
      low = std::min(low, function(x));
      high = std::max(high, function(x));
    }
    greatest = std::max(greatest, high - low);
  }
  return greatest;
}

/// The elliptic coordinates of a point on the ellipsoid of the fixtures' axes, of its radial
/// projection if it is off it: curvature lines are where one of them is constant.
std::array<double, 2> EllipticCoordinates(Eigen::Vector3d x)
{
  const Eigen::Array3d squares = Eigen::Array3d(1.0, 0.8, 0.6).square();
  x /= std::sqrt((x.array().square() / squares).sum());
  // Zero and these are the roots of the sum of x^2 / (a^2 - l) = 1.
  const Eigen::Array3d x2 = x.array().square();
  const double sum = squares.sum() - x2.sum();
  const double product = squares[0] * squares[1] + squares[1] * squares[2] +
    squares[2] * squares[0] - (x2 * (squares.sum() - squares)).sum();
  const double root = std::sqrt(std::max(0.0, sum * sum - 4.0 * product));
  return { 0.5 * (sum - root), 0.5 * (sum + root) };
}

/// How fast an elliptic coordinate changes at a point, by distance on the surface.
double SlopeOf(int coordinate, const Eigen::Vector3d& x)
{
  constexpr double h = 1e-5;
  Eigen::Vector3d slope;
  for (int i = 0; i < 3; ++i)
  {
    const Eigen::Vector3d offset = h * Eigen::Vector3d::Unit(i);
    slope[i] =
      (EllipticCoordinates(x + offset)[coordinate] - EllipticCoordinates(x - offset)[coordinate]) /
      (2.0 * h);
  }
  return slope.norm();
}

} // namespace

//------------------------------------------------------------------------------
// k2 = -1 / 0.7 around the tube, k1 around the axis.
TEST(PrincipalFoliationAccuracy, OfATorusIsItsCirclesToSecondOrder)
{
  double spread[2][2] = {};
  for (const int i : { 0, 1 })
  {
    const TorusLines torus(24 << i);
    const FoliationRule blueRule = RuleFor(Color::Blue, 0.2);
    const auto blue = LinesOf(torus.surface.Triangles(), torus.field, blueRule);
    CheckLines(blue, blueRule);
    const FoliationRule redRule = RuleFor(Color::Red, 0.2);
    const auto red = LinesOf(torus.surface.Triangles(), torus.field, redRule);
    CheckLines(red, redRule);

    // Around the tube is 4.4: room for 22 lines; some fewer, where the last gap is too narrow.
    EXPECT_GE(blue.size(), 17u);
    EXPECT_LE(blue.size(), 22u);
    for (const CurvatureLine& line : blue)
    {
      // On the coarse mesh some miss their seed by more than 0.02.
      EXPECT_TRUE(line.closed || i == 0);
      const double around = TorusLines::AroundTube(line.points[0]);
      EXPECT_NEAR(line.length, 2.0 * EIGEN_PI * (2.0 + 0.7 * std::cos(around)), 2.0 * torus.edge);
      EXPECT_NEAR(line.curvatures[0], -std::cos(around) / (2.0 + 0.7 * std::cos(around)),
        torus.edge * torus.edge);
    }
    for (const CurvatureLine& line : red)
    {
      EXPECT_NEAR(line.curvatures[0], -1.0 / 0.7, torus.edge * torus.edge);
      if (line.closed)
      {
        EXPECT_NEAR(line.length, 2.0 * EIGEN_PI * 0.7, torus.edge * torus.edge);
      }
    }
    // Meridians come together inside: of 68 outside, 32 are far enough apart.
    EXPECT_GE(
      std::count_if(red.begin(), red.end(), [](const auto& line) { return line.closed; }), 30);

    spread[0][i] = GreatestSpread(blue, TorusLines::AroundTube);
    // In the frame of the line's first point, where the angle does not jump.
    for (const CurvatureLine& line : red)
    {
      const Eigen::Vector2d radial = line.points[0].head<2>().normalized();
      const double angle = GreatestSpread({ line },
        [&](const Eigen::Vector3d& x)
        { return std::atan2(radial[0] * x[1] - radial[1] * x[0], radial.dot(x.head<2>())); });
      spread[1][i] = std::max(spread[1][i], angle);
    }
  }
  // Angles; the mean edge is 0.2 and 0.1.
  EXPECT_LT(spread[0][0], 0.05);
  EXPECT_LT(spread[1][0], 0.05);
  EXPECT_LT(spread[0][1], 0.35 * spread[0][0]);
  EXPECT_LT(spread[1][1], 0.35 * spread[1][0]);
}

TEST(PrincipalFoliationAccuracy, OfAnEllipsoidKeepsAnEllipticCoordinateToSecondOrder)
{
  for (const Color color : { Color::Blue, Color::Red })
  {
    double rms[3];
    for (const int i : { 0, 1, 2 })
    {
      const EllipsoidLines ellipsoid(23 << i);
      const FoliationRule rule = RuleFor(color, 0.06);
      // The nearer a line passes an umbilic the farther it strays: a distance is kept.
      const TriangleMesh& mesh = ellipsoid.surface.Triangles();
      std::vector<std::uint8_t> closed(mesh.NumberOfTriangles());
      for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
      {
        closed[t] = DistanceToUmbilics(mesh.Centroid(t)) < 0.15 ? 1 : 0;
      }
      const auto lines = LinesOf(mesh, ellipsoid.field, rule, closed);
      CheckLines(lines, rule);
      EXPECT_GE(lines.size(), 30u);
      EXPECT_LE(lines.size(), 80u);
      // Distance of points from where the coordinate has the line's median.
      double sum = 0.0;
      double greatest = 0.0;
      int count = 0;
      for (const CurvatureLine& line : lines)
      {
        std::array<std::vector<double>, 2> values;
        for (const Eigen::Vector3d& x : line.points)
        {
          values[0].push_back(EllipticCoordinates(x)[0]);
          values[1].push_back(EllipticCoordinates(x)[1]);
        }
        const auto spread = [](const std::vector<double>& v)
        { return *std::max_element(v.begin(), v.end()) - *std::min_element(v.begin(), v.end()); };
        const int constant = spread(values[0]) < spread(values[1]) ? 0 : 1;
        std::vector<double> sorted = values[constant];
        std::sort(sorted.begin(), sorted.end());
        for (std::size_t p = 0; p < line.points.size(); ++p)
        {
          const double distance = std::abs(values[constant][p] - sorted[sorted.size() / 2]) /
            SlopeOf(constant, line.points[p]);
          sum += distance * distance;
          greatest = std::max(greatest, distance);
          ++count;
        }
      }
      rms[i] = std::sqrt(sum / count);
      const double edge = ellipsoid.surface.Triangles().MeanEdgeLength();
      std::printf("%s, %d points: lines stray by %.2e (rms), %.2e (most); in edges %.4f, %.4f\n",
        color == Color::Blue ? "blue" : "red", ellipsoid.surface.Triangles().NumberOfPoints(),
        rms[i], greatest, rms[i] / edge, greatest / edge);
      EXPECT_LT(greatest, 0.01 * edge);
    }
    EXPECT_LT(rms[1], 0.35 * rms[0]);
    EXPECT_LT(rms[2], 0.35 * rms[1]);
  }
}
