// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// What the cubic form says about an umbilic: forms with known roots, and random ones against
// counting.

#include "Fixtures/TestFields.h"

#include "Umbilics/UmbilicForm.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <random>

namespace
{

using namespace ridges;
using namespace ridges::testing;
using Eigen::Vector3d;

const double Pi = std::acos(-1.0);

// The cubic form whose roots are the three lines at these angles.
SymmetricTensor<3> WithRootsAt(double a, double b, double c)
{
  // Product of (y cos - x sin) by polynomial multiplication, highest power of x first.
  std::array<double, 4> product = { 1.0, 0.0, 0.0, 0.0 };
  int degree = 0;
  for (const double angle : { a, b, c })
  {
    std::array<double, 4> next{};
    for (int j = 0; j <= degree; ++j)
    {
      next[j] -= product[j] * std::sin(angle);
      next[j + 1] += product[j] * std::cos(angle);
    }
    product = next;
    ++degree;
  }
  return { product[0], product[1] / 3.0, product[2] / 3.0, product[3] };
}

double Evaluate(const SymmetricTensor<3>& f, double angle)
{
  const double x = std::cos(angle);
  const double y = std::sin(angle);
  return f[0] * x * x * x + 3.0 * f[1] * x * x * y + 3.0 * f[2] * x * y * y + f[3] * y * y * y;
}

// Turns of the direction of k1 around an umbilic with this cubic form: the traceless part of the
// second derivatives of f / 6 at the points of a circle.
double IndexByTurning(const SymmetricTensor<3>& f)
{
  const int count = 3600;
  double turned = 0.0;
  const auto angleAt = [&f](int i)
  {
    const double x = std::cos(2.0 * Pi * i / count);
    const double y = std::sin(2.0 * Pi * i / count);
    const double xx = f[0] * x + f[1] * y;
    const double xy = f[1] * x + f[2] * y;
    const double yy = f[2] * x + f[3] * y;
    return std::atan2(2.0 * xy, xx - yy);
  };
  for (int i = 0; i < count; ++i)
  {
    turned += std::remainder(angleAt(i + 1) - angleAt(i), 2.0 * Pi);
  }
  return turned / (4.0 * Pi);
}

// Rays from an umbilic with this cubic form along which the direction of k1 points to it, or that
// of k2: around a small circle the direction from the umbilic passes the principal one.
int SeparatricesByCounting(const SymmetricTensor<3>& f, Color color)
{
  const int count = 3600;
  const auto apart = [&f](int i) // Twice the angle between the direction of k1 and the ray.
  {
    const double angle = 2.0 * Pi * i / count + 1e-4;
    const double x = std::cos(angle);
    const double y = std::sin(angle);
    const double xx = f[0] * x + f[1] * y;
    const double xy = f[1] * x + f[2] * y;
    const double yy = f[2] * x + f[3] * y;
    return std::atan2(2.0 * xy, xx - yy) - 2.0 * angle;
  };
  int rays = 0;
  for (int i = 0; i < count; ++i)
  {
    const bool passes = std::sin(apart(i)) * std::sin(apart(i + 1)) < 0.0;
    rays += passes && (std::cos(apart(i)) > 0.0) == (color == Color::Blue) ? 1 : 0;
  }
  return rays;
}

} // namespace

//------------------------------------------------------------------------------
TEST(UmbilicForm, StarsLemonsAndMonstarsHaveTheirRidgesAndIndex)
{
  // Three lines at 60 degrees: x^3 - 3 x y^2, the symmetric star.
  const SymmetricTensor<3> star = { 1.0, 0.0, -1.0, 0.0 };
  EXPECT_EQ(RidgeCountOf(star), 3);
  EXPECT_EQ(ThirdOrderIndexOf(star), -1);
  EXPECT_EQ(RidgeCountOf(WithRootsAt(0.2, 0.2 + Pi / 3.0, 0.2 - Pi / 3.0)), 3);
  EXPECT_EQ(ThirdOrderIndexOf(WithRootsAt(0.2, 0.2 + Pi / 3.0, 0.2 - Pi / 3.0)), -1);
  // x^3 + 3 t x y^2 has one root line for t > 0. Lines of curvature run into the umbilic along
  // y = 0 and (2 t - 1) x^2 = t y^2: one line below t = 1/2, a lemon, and three above, a monstar.
  const SymmetricTensor<3> lemon = { 1.0, 0.0, 0.4, 0.0 };
  EXPECT_EQ(RidgeCountOf(lemon), 1);
  EXPECT_EQ(ThirdOrderIndexOf(lemon), 1);
  const SymmetricTensor<3> monstar = { 1.0, 0.0, 0.6, 0.0 };
  EXPECT_EQ(RidgeCountOf(monstar), 1);
  EXPECT_EQ(ThirdOrderIndexOf(monstar), 1);
  // Above t = 1 a star with one ridge.
  const SymmetricTensor<3> starOfOne = { 1.0, 0.0, 1.5, 0.0 };
  EXPECT_EQ(RidgeCountOf(starOfOne), 1);
  EXPECT_EQ(ThirdOrderIndexOf(starOfOne), -1);
  EXPECT_EQ(ThirdOrderIndexOf({ 0.0, 0.0, 0.0, 0.0 }), 0);
}

//------------------------------------------------------------------------------
TEST(UmbilicForm, RidgeCountAndIndexOfRandomCubicsAreThoseOfCounting)
{
  std::mt19937_64 generator(62);
  int seen[2][2] = { { 0, 0 }, { 0, 0 } };
  for (int trial = 0; trial < 2000; ++trial)
  {
    SymmetricTensor<3> f;
    for (double& value : f)
    {
      value = Symmetric(generator);
    }
    int roots = 0;
    const int steps = 2000;
    for (int i = 0; i < steps; ++i)
    {
      roots += Evaluate(f, Pi * i / steps) * Evaluate(f, Pi * (i + 1) / steps) < 0.0 ? 1 : 0;
    }
    const double index = IndexByTurning(f);
    ASSERT_NEAR(std::abs(index), 0.5, 1e-9); // A sum of round-off.
    EXPECT_EQ(RidgeCountOf(f), roots) << "trial " << trial;
    EXPECT_EQ(ThirdOrderIndexOf(f), index > 0.0 ? 1 : -1) << "trial " << trial;
    EXPECT_FALSE(roots == 3 && index > 0.0);
    ++seen[roots == 3 ? 1 : 0][index > 0.0 ? 1 : 0];
  }
  EXPECT_GT(seen[0][0], 50);
  EXPECT_GT(seen[0][1], 50);
  EXPECT_GT(seen[1][0], 50);
}

//------------------------------------------------------------------------------
TEST(UmbilicForm, PatternsOfRandomCubicsAreThoseOfCounting)
{
  std::mt19937_64 generator(64);
  std::map<UmbilicPattern, int> seen;
  for (int trial = 0; trial < 2000; ++trial)
  {
    SymmetricTensor<3> f;
    for (double& value : f)
    {
      value = Symmetric(generator);
    }
    const double index = IndexByTurning(f);
    const int separatrices = SeparatricesByCounting(f, Color::Blue);
    ASSERT_EQ(separatrices, SeparatricesByCounting(f, Color::Red)) << "trial " << trial;
    const UmbilicPattern expected = index < 0.0
      ? UmbilicPattern::Star
      : (separatrices == 1 ? UmbilicPattern::Lemon : UmbilicPattern::Monstar);
    EXPECT_EQ(separatrices, expected == UmbilicPattern::Lemon ? 1 : 3) << "trial " << trial;
    EXPECT_EQ(PatternOf(f, index), expected) << "trial " << trial;
    ++seen[expected];
  }
  EXPECT_GT(seen[UmbilicPattern::Lemon], 50);
  EXPECT_GT(seen[UmbilicPattern::Monstar], 50);
  EXPECT_GT(seen[UmbilicPattern::Star], 50);
}

//------------------------------------------------------------------------------
TEST(UmbilicForm, CubicFormOfATriangleDoesNotDependOnTheSignsOfFrames)
{
  const MeshedSurface surface(EllipsoidMesh(8, 1.0, 0.8, 0.6));
  const TriangleMesh& mesh = surface.Triangles();
  const FieldArrays before = ExactField(mesh, MakeEllipsoid(1.0, 0.8, 0.6));
  FieldArrays after = before;
  std::mt19937_64 generator(63);
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    if (Uniform(generator) < 0.5)
    {
      after.Turn(p);
    }
  }
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const SymmetricTensor<3> f = CubicFormAt(mesh, before.View(), t, Vector3d::Constant(1.0 / 3.0));
    const SymmetricTensor<3> g = CubicFormAt(mesh, after.View(), t, Vector3d::Constant(1.0 / 3.0));
    for (int i = 0; i < 4; ++i)
    {
      EXPECT_NEAR(f[i], g[i], 1e-13); // Round-off on values of up to 5.
    }
  }
}
