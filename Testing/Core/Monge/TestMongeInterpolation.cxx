// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// Monge forms between two points: the forms behind the coefficients are interpolated.

#include "Fixtures/MongeComparison.h"
#include "Fixtures/TestFields.h"

#include "Monge/MongeInterpolation.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

namespace
{

using namespace ridges;
using namespace ridges::testing;
using Eigen::Vector3d;

const double RoundOff = 1e-13; // On values of up to 10, after two changes of frame.

// The terms of degree 2, 3 and 4 of the height along a tangent vector.
std::array<double, 3> TermsAlong(const MongeForm& form, const Vector3d& w)
{
  const double x = w.dot(form.d1);
  const double y = w.dot(form.d2);
  const auto& b = form.b;
  const auto& c = form.c;
  return { form.k1 * x * x + form.k2 * y * y,
    b[0] * x * x * x + 3.0 * b[1] * x * x * y + 3.0 * b[2] * x * y * y + b[3] * y * y * y,
    c[0] * std::pow(x, 4) + 4.0 * c[1] * std::pow(x, 3) * y + 6.0 * c[2] * x * x * y * y +
      4.0 * c[3] * x * std::pow(y, 3) + c[4] * std::pow(y, 4) };
}

template <typename Generator>
MongeForm RandomForm(const Vector3d& normal, Generator& generator)
{
  MongeForm form;
  form.n = normal;
  form.d1 = normal.cross(InBall(generator)).normalized();
  form.d2 = normal.cross(form.d1);
  const double a = Symmetric(generator);
  const double b = Symmetric(generator);
  form.k1 = std::max(a, b);
  form.k2 = std::min(a, b);
  for (double& value : form.b)
  {
    value = 3.0 * Symmetric(generator);
  }
  for (double& value : form.c)
  {
    value = 10.0 * Symmetric(generator);
  }
  return form;
}

} // namespace

//------------------------------------------------------------------------------
// To the last digit: ridges must not depend on which of the two was asked.
TEST(MongeInterpolation, ExtremumIsThatOfTheWholeForm)
{
  std::mt19937_64 generator(72);
  for (int trial = 0; trial < 200; ++trial)
  {
    FieldArrays arrays(2);
    arrays.Set(0, RandomForm(InBall(generator).normalized(), generator));
    arrays.Set(1, RandomForm(InBall(generator).normalized(), generator));
    const MongeInterpolation between(arrays.View(), 0, 1);
    const double t = 0.5 * (1.0 + Symmetric(generator));
    const MongeForm form = between.At(t);
    const auto blue = between.ExtremumAt(Color::Blue, t);
    const auto red = between.ExtremumAt(Color::Red, t);
    EXPECT_EQ(blue.k1, form.k1);
    EXPECT_EQ(blue.k2, form.k2);
    EXPECT_EQ(blue.P, form.P1());
    EXPECT_EQ(red.k1, form.k1);
    EXPECT_EQ(red.P, form.P2());
  }
}

//------------------------------------------------------------------------------
TEST(MongeInterpolation, StepToCrossingIsNewtons)
{
  // Of a difference quotient of this width, relative: the square of the width, times a third
  // derivative of some thousands near umbilics.
  const double width = 1e-6;
  const double tolerance = 1e-5;
  std::mt19937_64 generator(73);
  int pastTheDiagonal = 0;
  for (int trial = 0; trial < 500; ++trial)
  {
    FieldArrays arrays(2);
    arrays.Set(0, RandomForm(InBall(generator).normalized(), generator));
    arrays.Set(1, RandomForm(InBall(generator).normalized(), generator));
    const MongeInterpolation between(arrays.View(), 0, 1);
    const double t = 0.5 * (1.0 + Symmetric(generator));
    pastTheDiagonal += std::abs(between.At(t).d1.dot(arrays.View().D1(0))) < std::sqrt(0.5) ? 1 : 0;
    for (const Color color : { Color::Blue, Color::Red })
    {
      const double value = between.Extremality(color, t);
      const double slope =
        (between.Extremality(color, t + width) - between.Extremality(color, t - width)) /
        (2.0 * width);
      const auto newton = between.StepToCrossing(color, t);
      EXPECT_EQ(std::signbit(newton.value), std::signbit(value));
      EXPECT_NEAR(-newton.step * slope, value, tolerance * (std::abs(value) + std::abs(slope)));
    }
  }
  EXPECT_GT(pastTheDiagonal, 50);
}

//------------------------------------------------------------------------------
TEST(MongeInterpolation, IsLinearInTheFormsOfACommonTangentPlane)
{
  std::mt19937_64 generator(71);
  for (int trial = 0; trial < 200; ++trial)
  {
    const Vector3d normal = InBall(generator).normalized();
    FieldArrays arrays(2);
    const MongeForm ends[2] = { RandomForm(normal, generator), RandomForm(normal, generator) };
    arrays.Set(0, ends[0]);
    arrays.Set(1, ends[1]);
    const double t = Uniform(generator);
    const MongeForm between = MongeInterpolation(arrays.View(), 0, 1).At(t);
    EXPECT_GE(between.k1, between.k2);
    EXPECT_NEAR(between.d1.cross(between.d2).dot(normal), 1.0, RoundOff);
    for (int i = 0; i < 5; ++i)
    {
      const Vector3d w = normal.cross(InBall(generator)).normalized();
      const auto found = TermsAlong(between, w);
      const auto atP = TermsAlong(ends[0], w);
      const auto atQ = TermsAlong(ends[1], w);
      for (int degree = 0; degree < 3; ++degree)
      {
        EXPECT_NEAR(found[degree], (1.0 - t) * atP[degree] + t * atQ[degree], 10.0 * RoundOff);
      }
    }
    // Seen from the other end, and with frames turned by half a turn, it is the same.
    const MongeForm back = MongeInterpolation(arrays.View(), 1, 0).At(1.0 - t);
    arrays.Turn(1);
    const MongeForm turned = MongeInterpolation(arrays.View(), 0, 1).At(t);
    const double certainty = std::min(1.0, between.k1 - between.k2);
    EXPECT_LT(LargestDifference(back, between) * certainty, 10.0 * RoundOff);
    EXPECT_LT(LargestDifference(turned, between) * certainty, 10.0 * RoundOff);
  }
}

//------------------------------------------------------------------------------
TEST(MongeInterpolation, AtTheEndsHasTheirCoefficients)
{
  const MeshedSurface surface(EllipsoidMesh(5, 1.0, 0.8, 0.6));
  const FieldArrays arrays = ExactField(surface.Triangles(), MakeEllipsoid(1.0, 0.8, 0.6));
  const MongeField field = arrays.View();
  for (Id e = 0; e < surface.Triangles().NumberOfEdges(); ++e)
  {
    const Edge& edge = surface.Triangles().EdgeAt(e);
    for (const double t : { 0.0, 1.0 })
    {
      const Id p = t == 0.0 ? edge.v0 : edge.v1;
      const MongeForm form = MongeInterpolation(field, edge.v0, edge.v1).At(t);
      EXPECT_NEAR(form.k1, field.k1[p], RoundOff);
      EXPECT_NEAR(form.k2, field.k2[p], RoundOff);
      // Relative to P's largest value on this ellipsoid, about 50.
      EXPECT_NEAR(form.P1(), field.P1[p], 50.0 * RoundOff);
      EXPECT_NEAR(form.P2(), field.P2[p], 50.0 * RoundOff);
      EXPECT_NEAR(std::abs(form.b[0]), std::abs(field.ThirdOrder(p)[0]), 10.0 * RoundOff);
      EXPECT_NEAR(std::abs(form.b[3]), std::abs(field.ThirdOrder(p)[3]), 10.0 * RoundOff);
    }
  }
}

//------------------------------------------------------------------------------
TEST(MongeInterpolation, IsSecondOrderAccurateUpToUmbilics)
{
  // The forms at the middles of all edges against the exact ones: k at umbilics too, where it is
  // not smooth but the form is. Errors relative to the largest curvature.
  const AnalyticSurface ellipsoid = MakeEllipsoid(1.0, 0.8, 0.6);
  std::vector<double> errors;
  for (const int frequency : { 10, 20, 40 })
  {
    const MeshedSurface surface(EllipsoidMesh(frequency, 1.0, 0.8, 0.6));
    const TriangleMesh& mesh = surface.Triangles();
    const FieldArrays arrays = ExactField(mesh, ellipsoid);
    double largest = 0.0;
    for (Id e = 0; e < mesh.NumberOfEdges(); ++e)
    {
      const Edge& edge = mesh.EdgeAt(e);
      const ExactMonge exact =
        ellipsoid.Monge(ellipsoid.Project(0.5 * (mesh.Point(edge.v0) + mesh.Point(edge.v1))));
      const MongeForm form = MongeInterpolation(arrays.View(), edge.v0, edge.v1).At(0.5);
      largest = std::max({ largest, std::abs(form.k1 - exact.k1), std::abs(form.k2 - exact.k2) });
    }
    errors.push_back(largest);
  }
  std::printf("k at the middles of edges, largest errors at frequency 10, 20, 40: %.2e %.2e %.2e\n",
    errors[0], errors[1], errors[2]);
  // 4 each time by theory; 3.2, an order of 1.7, leaves room for the worst edge's position.
  EXPECT_LT(errors[1], errors[0] / 3.2);
  EXPECT_LT(errors[2], errors[1] / 3.2);
}
