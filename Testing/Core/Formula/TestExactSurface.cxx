// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "AnalyticSurface.h"
#include "Formula/ExactReferences.h"
#include "Formula/ExactSurface.h"
#include "Formula/FormulaParser.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

using namespace ridges;

namespace
{

const std::vector<std::string> Space{ "x", "y", "z" };

SurfacePoints PointsAt(const std::vector<Eigen::Vector3d>& positions)
{
  SurfacePoints points;
  points.count = static_cast<int>(positions.size());
  std::copy(positions.begin(), positions.end(), points.position.begin());
  return points;
}

SurfacePoints ExactAt(const std::string& formula, const std::vector<Eigen::Vector3d>& positions,
  FormulaFunction::Kind kind = FormulaFunction::Kind::Implicit)
{
  const auto variables =
    kind == FormulaFunction::Kind::Graph ? std::vector<std::string>{ "x", "y" } : Space;
  const ParsedFormula parsed = ParseFormula(formula, variables);
  EXPECT_EQ(parsed.error, "");
  const FormulaFunction function(parsed.program, kind);
  const ImplicitExactSurface surface(function);
  SurfacePoints points = PointsAt(positions);
  surface.Locate(points);
  surface.Differentiate(points);
  return points;
}

SurfacePoints ParametricAt(
  const std::array<std::string, 3>& formulas, const std::vector<Eigen::Vector2d>& parameters)
{
  std::array<FormulaProgram, 3> programs;
  for (int i = 0; i < 3; ++i)
  {
    const ParsedFormula parsed = ParseFormula(formulas[i], { "u", "v" }, true);
    EXPECT_EQ(parsed.error, "");
    programs[i] = parsed.program;
  }
  const ParametricExactSurface surface(programs);
  SurfacePoints points;
  points.count = static_cast<int>(parameters.size());
  std::copy(parameters.begin(), parameters.end(), points.parameters.begin());
  surface.Locate(points);
  surface.Differentiate(points);
  return points;
}

// Relative to the greatest of its kind; of P to its terms, as these cancel at turning points.
void ExpectSameForm(const MongeForm& form, const Eigen::Vector3d& d1, double k1, double k2,
  const double* b, double P1, double P2, double ofK, double ofB, double ofP)
{
  const double k = std::max(std::abs(k1), std::abs(k2));
  EXPECT_NEAR(form.k1, k1, ofK * k);
  EXPECT_NEAR(form.k2, k2, ofK * k);
  const double sign = form.d1.dot(d1) > 0.0 ? 1.0 : -1.0;
  EXPECT_NEAR((sign * form.d1 - d1).norm(), 0.0, ofB);
  double greatest = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    greatest = std::max(greatest, std::abs(b[i]));
  }
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(sign * form.b[i], b[i], ofB * greatest) << i;
  }
  EXPECT_NEAR(form.P1(), P1, ofP * std::abs(P1));
  EXPECT_NEAR(form.P2(), P2, ofP * std::abs(P2));
}

} // namespace

TEST(ExactSurface, AgreesWithReferencesOfFiftyDigits)
{
  for (const ExactReference& reference : ExactReferences)
  {
    SCOPED_TRACE(reference.formula);
    const Eigen::Map<const Eigen::Vector3d> point(reference.point);
    const SurfacePoints points = ExactAt(reference.formula, { point });
    ASSERT_EQ(points.fault[0], ExactFault::None);
    EXPECT_LT((points.position[0] - point).norm(), 1e-15 * (1.0 + point.norm()));
    EXPECT_LT((points.normal[0] - Eigen::Map<const Eigen::Vector3d>(reference.n)).norm(), 1e-14);
    ExpectSameForm(points.form[0], Eigen::Map<const Eigen::Vector3d>(reference.d1), reference.k1,
      reference.k2, reference.b, reference.P1, reference.P2, 1e-12, 1e-10, 1e-8);
  }
}

// The whole form, c as well, against the independent code of the test surfaces.
TEST(ExactSurface, AgreesWithTheTestSurfaces)
{
  const auto surface = ridges::testing::MakeTorus(1.0, 0.4);
  std::vector<Eigen::Vector3d> positions;
  for (int i = 0; i < Lanes::Count; ++i)
  {
    const double a = 0.3 + 0.7 * i;
    const double b = 0.2 + 0.5 * i;
    positions.emplace_back((1.0 + 0.42 * std::cos(b)) * std::cos(a),
      (1.0 + 0.38 * std::cos(b)) * std::sin(a), 0.41 * std::sin(b));
  }
  const SurfacePoints points = ExactAt("((x^2+y^2+z^2+0.84)^2 - 4*(x^2+y^2))/3.2", positions);
  for (int i = 0; i < Lanes::Count; ++i)
  {
    ASSERT_EQ(points.fault[i], ExactFault::None);
    EXPECT_LT((points.position[i] - surface.Project(positions[i])).norm(), 1e-14);
    const ridges::testing::ExactMonge exact = surface.Monge(points.position[i]);
    const MongeForm& form = points.form[i];
    const double sign = form.d1.dot(exact.d1) > 0.0 ? 1.0 : -1.0;
    for (int j = 0; j < 4; ++j)
    {
      EXPECT_NEAR(sign * form.b[j], exact.b[j], 1e-12);
    }
    for (int j = 0; j < 5; ++j)
    {
      EXPECT_NEAR(form.c[j], exact.c[j], 1e-10);
    }
  }
}

// A value does not depend on the lane, nor on what is in the others.
TEST(ExactSurface, LanesDoNotDependOnEachOther)
{
  const std::string formula = "exp(x*y) + z^2 - 1.7*cos(z) + x^4";
  const Eigen::Vector3d p(0.4, 0.3, 0.5);
  const SurfacePoints single = ExactAt(formula, { p });
  const double none = std::numeric_limits<double>::quiet_NaN();
  const SurfacePoints several =
    ExactAt(formula, { { 0.5, 0.2, 0.6 }, { none, 0.0, 0.0 }, p, { 3.0, 3.0, 3.0 } });
  ASSERT_EQ(single.fault[0], ExactFault::None);
  EXPECT_EQ(several.fault[1], ExactFault::NotFinite);
  EXPECT_EQ(single.position[0], several.position[2]);
  EXPECT_EQ(single.form[0].b, several.form[2].b);
  EXPECT_EQ(single.form[0].c, several.form[2].c);
}

// z = g(x, y), f = z - g and (u, v, g(u, v)) are one surface; so is it with other parameters.
TEST(ExactSurface, GraphsAndParametricSurfacesAreTheSame)
{
  const double x = 0.3;
  const double y = -0.4;
  const double z = std::sin(x) * std::exp(y) + 0.5 * x * x * y;
  const SurfacePoints implicit = ExactAt("z - sin(x)*exp(y) - 0.5*x^2*y", { { x, y, z } });
  const SurfacePoints graph =
    ExactAt("sin(x)*exp(y) + 0.5*x^2*y", { { x, y, z } }, FormulaFunction::Kind::Graph);
  const SurfacePoints parametric =
    ParametricAt({ "u", "v", "sin(u)*exp(v) + 0.5*u^2*v" }, { { x, y } });
  // u = x + y / 2, v = y exp(x).
  const SurfacePoints bent = ParametricAt({ "u + 0.2*v^2", "v*exp(0.3*u)",
                                            "sin(u+0.2*v^2)*exp(v*exp(0.3*u))"
                                            " + 0.5*(u+0.2*v^2)^2*v*exp(0.3*u)" },
    { { 0.28133, -0.37 } });
  const MongeForm& form = implicit.form[0];
  for (const SurfacePoints* points : { &graph, &parametric })
  {
    ASSERT_EQ(points->fault[0], ExactFault::None);
    const MongeForm& other = points->form[0];
    ExpectSameForm(
      other, form.d1, form.k1, form.k2, form.b.data(), form.P1(), form.P2(), 1e-13, 1e-13, 1e-13);
  }
  ASSERT_EQ(bent.fault[0], ExactFault::None);
  const SurfacePoints there = ExactAt("z - sin(x)*exp(y) - 0.5*x^2*y", { bent.position[0] });
  const MongeForm& expected = there.form[0];
  ExpectSameForm(bent.form[0], expected.d1, expected.k1, expected.k2, expected.b.data(),
    expected.P1(), expected.P2(), 1e-12, 1e-12, 1e-12);
  for (int i = 0; i < 5; ++i)
  {
    EXPECT_NEAR(bent.form[0].c[i], expected.c[i], 1e-12);
  }
}

TEST(ExactSurface, ScaleAndPlaceChangeOnlyUnits)
{
  const SurfacePoints unit = ExactAt("x^2/1.96 + y^2 + z^2/0.36 - 1", { { 0.7, 0.6, 0.4 } });
  const SurfacePoints small =
    ExactAt("x^2/1.96e-20 + y^2/1e-20 + z^2/0.36e-20 - 1", { { 0.7e-10, 0.6e-10, 0.4e-10 } });
  const SurfacePoints far =
    ExactAt("(x-1000)^2/1.96 + (y+2000)^2 + (z-3000)^2/0.36 - 1", { { 1000.7, -1999.4, 3000.4 } });
  ASSERT_EQ(small.fault[0], ExactFault::None);
  ASSERT_EQ(far.fault[0], ExactFault::None);
  EXPECT_NEAR(small.form[0].k1 * 1e-10, unit.form[0].k1, 1e-13);
  EXPECT_NEAR(small.form[0].P1() * 1e-40, unit.form[0].P1(), 1e-11 * std::abs(unit.form[0].P1()));
  EXPECT_NEAR(far.form[0].k1, unit.form[0].k1, 1e-11); // coordinates are to 5e-13
}

// Where coordinates are 0 they do not limit the precision; constants that cancel do.
TEST(ExactSurface, TheOriginIsAPointLikeOthers)
{
  const SurfacePoints points =
    ExactAt("1 - exp(-z) + x^2/2 + y^2 + 0.1*x^3", { { 0.0, 0.0, 0.0 }, { 1e-3, 0.0, 1e-3 } });
  EXPECT_EQ(points.fault[0], ExactFault::None);
  EXPECT_EQ(points.fault[1], ExactFault::None);
  EXPECT_NEAR(points.form[0].k1, -1.0, 1e-14);
  EXPECT_NEAR(points.form[0].k2, -2.0, 1e-14);
}

TEST(ExactSurface, PointsWithoutASurfaceAreReported)
{
  // Nothing to converge to; beyond the domain of the root; the apex of a cone; twice the surface.
  EXPECT_EQ(ExactAt("x^2+y^2+z^2+1", { { 0.5, 0.6, 0.7 } }).fault[0], ExactFault::NoConvergence);
  EXPECT_EQ(ExactAt("x^2+1", { { 0.5, 0.6, 0.7 } }).fault[0], ExactFault::NoConvergence);
  EXPECT_EQ(ExactAt("x^2+1", { { 0.0, 0.6, 0.7 } }).fault[0], ExactFault::NoConvergence);
  EXPECT_EQ(ExactAt("sqrt(x)+y+z", { { -1.0, 0.5, 0.5 } }).fault[0], ExactFault::NotFinite);
  EXPECT_EQ(ExactAt("x^2+y^2-z^2", { { 0.0, 0.0, 0.0 } }).fault[0], ExactFault::Singular);
  EXPECT_EQ(ExactAt("(x^2+y^2+z^2-1)^2", { { 0.5, 0.6, 0.7 } }).fault[0], ExactFault::Singular);
  // The root has no derivatives on the axis, where its square is harmless.
  EXPECT_EQ(ExactAt("sqrt(x^2+y^2)+z-1", { { 0.0, 0.0, 1.0 } }).fault[0], ExactFault::NotFinite);
  EXPECT_EQ(ParametricAt({ "cos(u)*sin(v)", "sin(u)*sin(v)", "cos(v)" }, { { 0.5, 0.0 } }).fault[0],
    ExactFault::Singular);
}
