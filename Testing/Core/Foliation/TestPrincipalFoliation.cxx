// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// Curvature lines: are they evenly spaced, and are they always the same.

#include "Fixtures/FoliationTools.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

using namespace ridges;
using namespace ridges::testing;

double DistanceToLine(const Eigen::Vector3d& x, const CurvatureLine& line)
{
  double square = std::numeric_limits<double>::infinity();
  for (std::size_t i = line.closed ? 0 : 1; i < line.points.size(); ++i)
  {
    const std::size_t before = i == 0 ? line.points.size() - 1 : i - 1;
    square = std::min(square, SquaredDistance(x, line.points[before], line.points[i]));
  }
  return std::sqrt(square);
}

} // namespace

//------------------------------------------------------------------------------
TEST(PrincipalFoliation, LinesAreEvenlySpacedAndLeaveNoGap)
{
  const EllipsoidLines ellipsoid(24);
  const TriangleMesh& mesh = ellipsoid.surface.Triangles();
  for (const double separation : { 0.2, 0.06 })
  {
    for (const Color color : { Color::Blue, Color::Red })
    {
      const FoliationRule rule = RuleFor(color, separation);
      const auto lines = LinesOf(mesh, ellipsoid.field, rule);
      CheckLines(lines, rule);
      // At the points lines keep the least distance; between them, over a step, a little less.
      double least = 1.0;
      for (std::size_t i = 0; i < lines.size(); ++i)
      {
        for (std::size_t j = 0; j < i; ++j)
        {
          for (std::size_t p = 0; p < lines[i].points.size(); p += 5)
          {
            least = std::min(least, DistanceToLine(lines[i].points[p], lines[j]));
          }
        }
      }
      EXPECT_GT(least, 0.97 * rule.leastDistance);

      double greatest = 0.0;
      double sum = 0.0;
      int count = 0;
      for (Id t = 0; t < mesh.NumberOfTriangles(); t += 7)
      {
        const Eigen::Vector3d x = mesh.Centroid(t);
        if (DistanceToUmbilics(x) > 3.0 * separation)
        {
          double distance = 10.0;
          for (const CurvatureLine& line : lines)
          {
            distance = std::min(distance, DistanceToLine(x, line));
          }
          greatest = std::max(greatest, distance);
          sum += distance;
          ++count;
        }
      }
      // A strip that no line fits in is up to two separations wide; the mean distance in strips of
      // one separation is a quarter of it.
      EXPECT_LT(greatest, 1.05 * separation);
      EXPECT_GT(sum / count, 0.15 * separation);
      EXPECT_LT(sum / count, 0.4 * separation);
    }
  }
}

TEST(PrincipalFoliation, IsTheSameToTheBitHoweverTheMeshIsNumberedAndSigned)
{
  for (const bool noise : { false, true })
  {
    const Mesh mesh = noise ? AddNormalNoise(Icosphere(10), 0.02, 1) : TorusMesh(2.0, 0.7, 60, 21);
    std::vector<std::int32_t> newToOld;
    const MeshedSurface surface(mesh);
    const MeshedSurface permuted(Permute(mesh, 7, &newToOld));
    const FieldArrays field =
      noise ? FitField(surface.Triangles()) : ExactField(surface.Triangles(), MakeTorus(2.0, 0.7));
    FieldArrays other(surface.Triangles().NumberOfPoints());
    for (Id p = 0; p < surface.Triangles().NumberOfPoints(); ++p)
    {
      const std::size_t old = newToOld[p];
      other.k1[p] = field.k1[old];
      other.k2[p] = field.k2[old];
      std::copy_n(&field.d1[3 * old], 3, &other.d1[3 * p]);
      std::copy_n(&field.d2[3 * old], 3, &other.d2[3 * p]);
      if (p % 3 == 0)
      {
        other.Turn(p);
      }
    }
    for (const Color color : { Color::Blue, Color::Red })
    {
      const FoliationRule rule = RuleFor(color, noise ? 0.1 : 0.25);
      const auto expected = LinesOf(surface.Triangles(), field, rule);
      const auto actual = LinesOf(permuted.Triangles(), other, rule);
      ASSERT_EQ(actual.size(), expected.size());
      for (std::size_t i = 0; i < actual.size(); ++i)
      {
        EXPECT_TRUE(actual[i].points == expected[i].points) << i;
        EXPECT_TRUE(actual[i].curvatures == expected[i].curvatures) << i;
        EXPECT_EQ(actual[i].closed, expected[i].closed);
      }
    }
  }
}

// Two sheets at a hundredth of the separation: each has the lines it has alone.
TEST(PrincipalFoliation, TheOtherSideOfAThinWallIsNoObstacle)
{
  const AnalyticSurface surface([](auto x, auto, auto z) { return z - 0.4 * x * x; });
  const Mesh lower = GraphPatch([](double x, double) { return 0.4 * x * x; }, 1.0, 20, 0.2);
  Mesh both = lower;
  for (std::size_t p = 0; p < lower.PointCount(); ++p)
  {
    both.AddPoint(lower.Point(p) + Eigen::Vector3d(0.0, 0.0, 0.001));
  }
  const auto n = static_cast<std::int32_t>(lower.PointCount());
  for (std::size_t i = 0; i < lower.triangles.size(); i += 3)
  {
    both.AddTriangle(
      lower.triangles[i] + n, lower.triangles[i + 1] + n, lower.triangles[i + 2] + n);
  }
  const MeshedSurface one(lower);
  const MeshedSurface two(both);
  const FieldArrays field = ExactField(one.Triangles(), surface);
  FieldArrays twice(2 * n);
  for (Id p = 0; p < 2 * n; ++p)
  {
    const std::size_t old = p % n;
    twice.k1[p] = field.k1[old];
    twice.k2[p] = field.k2[old];
    std::copy_n(&field.d1[3 * old], 3, &twice.d1[3 * p]);
    std::copy_n(&field.d2[3 * old], 3, &twice.d2[3 * p]);
  }
  const FoliationRule rule = RuleFor(Color::Blue, 0.1);
  const auto expected = LinesOf(one.Triangles(), field, rule);
  const auto actual = LinesOf(two.Triangles(), twice, rule);
  const auto total = [](const std::vector<CurvatureLine>& lines)
  {
    double sum = 0.0;
    for (const CurvatureLine& line : lines)
    {
      sum += line.length;
    }
    return sum;
  };
  // Both at some 0.1: 20 lines from border to border, 2.2 long each.
  EXPECT_NEAR(static_cast<double>(expected.size()), 20.0, 4.0);
  EXPECT_NEAR(total(actual), 2.0 * total(expected), 0.1 * total(expected));
  EXPECT_NEAR(total(expected), 2.0 * 2.2 / 0.1, 8.0);
}

TEST(PrincipalFoliation, LinesKeepOutOfClosedAndSingularTriangles)
{
  const EllipsoidLines ellipsoid(16);
  const TriangleMesh& mesh = ellipsoid.surface.Triangles();
  std::vector<std::uint8_t> closed(mesh.NumberOfTriangles(), 0);
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    closed[t] = DistanceToUmbilics(mesh.Centroid(t)) < 0.2 || mesh.Centroid(t)[2] < 0.0 ? 1 : 0;
  }
  const FoliationRule rule = RuleFor(Color::Red, 0.08);
  const auto lines = LinesOf(mesh, ellipsoid.field, rule, closed);
  ASSERT_GT(lines.size(), 10u);
  const double edge = mesh.MeanEdgeLength();
  for (const CurvatureLine& line : lines)
  {
    for (const Eigen::Vector3d& x : line.points)
    {
      EXPECT_GT(DistanceToUmbilics(x), 0.2 - edge);
      EXPECT_GT(x[2], -edge);
    }
  }
  EXPECT_TRUE(
    LinesOf(mesh, ellipsoid.field, rule, std::vector<std::uint8_t>(mesh.NumberOfTriangles(), 1))
      .empty());
}

TEST(PrincipalFoliation, TerminatesWithAnyFieldOnAnyMesh)
{
  const Mesh meshes[] = { Icosphere(6), TorusMesh(2.0, 0.7, 21, 11),
    CylinderPatch(1.0, 2.0, 1.0, 13, 9), AddNormalNoise(Icosphere(6), 0.3, 1) };
  for (const Mesh& mesh : meshes)
  {
    const MeshedSurface surface(mesh);
    for (const std::uint64_t seed : { 1u, 2u })
    {
      const FieldArrays field = RandomField(surface.Triangles(), seed);
      for (const double separation : { 1.0, 0.1 })
      {
        FoliationRule rule = RuleFor(Color::Blue, separation);
        rule.minimumLength = 0.0;
        CheckLines(LinesOf(surface.Triangles(), field, rule), rule);
      }
    }
  }
}

TEST(PrincipalFoliation, HasNoLinesWhereAllCurvaturesAreEqual)
{
  const MeshedSurface sphere(Icosphere(12));
  const FieldArrays field = ExactField(sphere.Triangles(), MakeSphere(1.0));
  FieldArrays umbilical = field;
  umbilical.k1.assign(field.k1.size(), -1.0);
  umbilical.k2 = umbilical.k1;
  EXPECT_TRUE(LinesOf(sphere.Triangles(), umbilical, RuleFor(Color::Blue, 0.1)).empty());
  EXPECT_TRUE(LinesOf(TriangleMesh(), FieldArrays(0), RuleFor(Color::Blue, 0.1)).empty());
}

TEST(PrincipalFoliation, CutsLinesAtTheMaximumLength)
{
  const TorusLines torus(24);
  FoliationRule rule = RuleFor(Color::Blue, 0.2);
  rule.maximumLength = 1.5;
  const auto lines = LinesOf(torus.surface.Triangles(), torus.field, rule);
  CheckLines(lines, rule);
  ASSERT_GT(lines.size(), 100u);
  EXPECT_TRUE(
    std::none_of(lines.begin(), lines.end(), [](const auto& line) { return line.closed; }));
}

TEST(PrincipalFoliation, StopsOnRequest)
{
  const TorusLines torus(48);
  PrincipalFoliation foliation(
    torus.surface.Triangles(), torus.field.View(), RuleFor(Color::Red, 0.05));
  int calls = 0;
  double last = 0.0;
  EXPECT_TRUE(foliation.Trace(
    [&](double done)
    {
      EXPECT_GE(done, last);
      last = done;
      ++calls;
      return true;
    }));
  EXPECT_LE(last, 1.0);
  EXPECT_GT(last, 0.9);
  EXPECT_GT(calls, 50);

  PrincipalFoliation stopped(
    torus.surface.Triangles(), torus.field.View(), RuleFor(Color::Red, 0.05));
  int left = 40;
  EXPECT_FALSE(stopped.Trace([&left](double) { return --left > 0; }));
  EXPECT_EQ(left, 0);
}
