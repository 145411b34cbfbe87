// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// Neighbourhoods that are no graph of a height function, or only along another axis than that of
// least spread.

#include "Fixtures/TestFields.h"

#include "Fit/PointFitter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{

using namespace ridges;
using namespace ridges::testing;
using Eigen::Vector3d;

struct Fits
{
  explicit Fits(const Mesh& mesh, int minimumNumberOfPoints = 18)
    : surface(mesh)
    , rings(RingsOf(this->surface.Triangles()))
    , fitter(
        this->surface.Triangles(), this->rings, Rule(minimumNumberOfPoints), 4, Weighting::Uniform)
  {
  }

  static NeighborhoodRule Rule(int minimumNumberOfPoints)
  {
    NeighborhoodRule rule;
    rule.minimumNumberOfPoints = minimumNumberOfPoints;
    return rule;
  }

  Id Size() const { return this->surface.Triangles().NumberOfPoints(); }

  MeshedSurface surface;
  OrderedRings rings;
  PointFitter fitter;
};

MongeForm FormOf(const JetFit& fit)
{
  return MongeFormOfHeightJet(fit.jet, fit.frame);
}

// A tube of so many sides around the z axis, with no ends: radius 1, edges of 1 along it.
Mesh Rod(int sides, int length)
{
  Mesh mesh;
  for (int i = 0; i <= length; ++i)
  {
    for (int j = 0; j < sides; ++j)
    {
      const double angle = 2.0 * std::acos(-1.0) * j / sides;
      mesh.AddPoint(Vector3d(std::cos(angle), std::sin(angle), i));
    }
  }
  for (int i = 0; i < length; ++i)
  {
    for (int j = 0; j < sides; ++j)
    {
      const std::int32_t a = i * sides + j;
      const std::int32_t b = i * sides + (j + 1) % sides;
      mesh.AddTriangle(a, b, b + sides);
      mesh.AddTriangle(a, b + sides, a + sides);
    }
  }
  return mesh;
}

} // namespace

//------------------------------------------------------------------------------
// On 42 points 18 reach to the equator at least. Fitted are then caps of up to 63 degrees: within
// them a quartic is off by a few percent of the curvature, and so is a quadric through the 6 points
// of an icosahedron's cap by 1 / cos^2(63 / 2) - 1. What is not flagged is right to a quarter.
TEST(PointFitter, ACoarseSphereHasTheRightSign)
{
  for (const int frequency : { 1, 2 })
  {
    Fits fits(Icosphere(frequency));
    for (Id p = 0; p < fits.Size(); ++p)
    {
      const JetFit fit = fits.fitter.Fit(p);
      const bool isFlagged = (fit.status & FitFolded) != 0;
      EXPECT_TRUE(frequency > 1 || isFlagged) << p;
      const double tolerance = isFlagged ? 0.4 : 0.25;
      const MongeForm form = FormOf(fit);
      EXPECT_NEAR(form.k1, -1.0, tolerance) << p;
      EXPECT_NEAR(form.k2, -1.0, tolerance) << p;
    }
  }
  Fits finer(Icosphere(4));
  for (Id p = 0; p < finer.Size(); ++p)
  {
    EXPECT_EQ(finer.fitter.Fit(p).status, FitGood) << p;
  }
}

//------------------------------------------------------------------------------
// A parabola through the neighbours at an angle of a has a curvature of 1 / cos^2(a / 2).
TEST(PointFitter, AThinRodHasTheRightSign)
{
  for (const int sides : { 5, 6, 8 })
  {
    SCOPED_TRACE(sides);
    Fits fits(Rod(sides, 20));
    const double half = std::acos(-1.0) / sides;
    for (Id p = 6 * sides; p < 14 * sides; ++p)
    {
      const JetFit fit = fits.fitter.Fit(p);
      ASSERT_TRUE(fit.status & FitFolded) << p;
      const MongeForm form = FormOf(fit);
      EXPECT_NEAR(form.k1, 0.0, 1e-12) << p;
      EXPECT_NEAR(form.k2, -1.0 / std::pow(std::cos(half), 2), 0.05) << p;
    }
  }
}

//------------------------------------------------------------------------------
// With 50 points along the axis where one is across it, points spread least along the axis. A
// quartic over 90 degrees of the circle is off by 1 %.
TEST(PointFitter, TheHeightAxisIsAcrossTheSurfaceOfAStrip)
{
  const double pi = std::acos(-1.0);
  Fits fits(CylinderPatch(1.0, 1.5 * pi, 2.0, 12, 255));
  int inside = 0;
  for (Id p = 0; p < fits.Size(); p += 7)
  {
    const Vector3d at = fits.surface.Triangles().Point(p);
    const JetFit fit = fits.fitter.Fit(p);
    if (std::abs(at.z() - 1.0) > 0.9 || fits.rings.OnBorder(p))
    {
      continue;
    }
    ++inside;
    const MongeForm form = FormOf(fit);
    EXPECT_GT(std::abs(form.n.dot(Vector3d(at.x(), at.y(), 0.0))), 0.99) << at.transpose();
    if (fit.status == FitGood)
    {
      EXPECT_NEAR(form.k2 + form.k1, -1.0, 0.1) << at.transpose();
    }
  }
  EXPECT_GT(inside, 200);
}

//------------------------------------------------------------------------------
// The points of a fan lie on one circle and in its middle: no quartic is determined, but a quadric.
TEST(PointFitter, WhatStaysIllConditionedIsFittedInALowerDegree)
{
  Mesh mesh;
  mesh.AddPoint(Vector3d::Zero());
  const int count = 24;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * std::acos(-1.0) * i / count;
    mesh.AddPoint(Vector3d(std::cos(angle), std::sin(angle), -0.05));
  }
  for (int i = 0; i < count; ++i)
  {
    mesh.AddTriangle(0, 1 + i, 1 + (i + 1) % count);
  }
  Fits fits(mesh);
  const JetFit fit = fits.fitter.Fit(0);
  EXPECT_EQ(fit.status, FitIllConditioned);
  EXPECT_EQ(fit.degree, 2);
  EXPECT_NEAR(FormOf(fit).k1, -0.1, 1e-12);
  EXPECT_NEAR(FormOf(fit).k2, -0.1, 1e-12);
}

//------------------------------------------------------------------------------
// Of heights that are noise only, third derivatives have the mean square that the gain says: by
// 2000 draws to within a few percent.
TEST(PointFitter, NoiseGainIsTheErrorOfTheThirdOrder)
{
  std::mt19937_64 generator(5);
  std::normal_distribution<double> normal;
  Eigen::Matrix3Xd offsets = Eigen::Matrix3Xd::Zero(3, 28);
  for (Eigen::Index i = 1; i < offsets.cols(); ++i)
  {
    offsets(0, i) = 3.0 * Symmetric(generator);
    offsets(1, i) = Symmetric(generator);
  }
  constexpr double noise = 1e-5;
  constexpr int draws = 2000;
  double squares = 0.0;
  double expected = 0.0;
  JetFitter fitter;
  for (int i = 0; i < draws; ++i)
  {
    for (Eigen::Index j = 0; j < offsets.cols(); ++j)
    {
      offsets(2, j) = noise * normal(generator);
    }
    const JetFit fit = fitter.Fit(offsets, 4, Vector3d::UnitZ());
    const double* third = fit.jet.derivatives.data() + HeightJet::Index(3, 0);
    squares += third[0] * third[0] + 3.0 * third[1] * third[1] + 3.0 * third[2] * third[2] +
      third[3] * third[3];
    const double error = fit.noiseGain * fit.residual / (fit.radius * fit.radius);
    expected += error * error;
  }
  EXPECT_NEAR(std::sqrt(squares / expected), 1.0, 0.1);
}
