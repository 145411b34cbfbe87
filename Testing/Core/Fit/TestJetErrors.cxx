// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// Standard errors of Monge forms: their gradients against finite differences, and how often the
// intervals they give hold what noise has moved.

#include "Fixtures/TestFields.h"

#include "Fit/JetErrors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>

namespace
{

using namespace ridges;
using namespace ridges::testing;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr int NumberOfQuantities = 8;
const char* const Names[NumberOfQuantities] = { "k1", "k2", "b0", "b1", "b2", "b3", "P1", "P2" };
using Quantities = std::array<double, NumberOfQuantities>;

Quantities QuantitiesOf(const MongeForm& form, const Vector3d& d1)
{
  const double sign = form.d1.dot(d1) < 0.0 ? -1.0 : 1.0;
  return { form.k1, form.k2, sign * form.b[0], sign * form.b[1], sign * form.b[2], sign * form.b[3],
    form.P1(), form.P2() };
}

Quantities QuantitiesOf(const JetErrors& errors)
{
  return { errors.k1, errors.k2, errors.b[0], errors.b[1], errors.b[2], errors.b[3], errors.P1,
    errors.P2 };
}

HeightJet RandomJet(std::mt19937_64& generator, double slope)
{
  HeightJet jet;
  for (double& derivative : jet.derivatives)
  {
    derivative = Symmetric(generator);
  }
  jet.derivatives[HeightJet::Index(1, 0)] *= slope;
  jet.derivatives[HeightJet::Index(0, 1)] *= slope;
  jet.derivatives[HeightJet::Index(2, 0)] += 1.5; // So that k1 - k2 is not small.
  return jet;
}

// The largest difference between the gradient and central differences, relative to the largest
// element for each quantity.
double LargestGradientError(const HeightJet& jet)
{
  const Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();
  const Vector3d d1 = MongeFormOfHeightJet(jet, frame).d1;
  MongeGradient differences;
  for (int i = 0; i < HeightJet::MaximumSize; ++i)
  {
    const double step = 1e-5;
    HeightJet above = jet;
    HeightJet below = jet;
    above.derivatives[i] += step;
    below.derivatives[i] -= step;
    const Quantities high = QuantitiesOf(MongeFormOfHeightJet(above, frame), d1);
    const Quantities low = QuantitiesOf(MongeFormOfHeightJet(below, frame), d1);
    for (int j = 0; j < NumberOfQuantities; ++j)
    {
      differences(i, j) = (high[j] - low[j]) / (2.0 * step);
    }
  }
  const MongeGradient error = GradientOfMongeForm(jet) - differences;
  double largest = 0.0;
  for (int j = 0; j < NumberOfQuantities; ++j)
  {
    largest = std::max(
      largest, error.col(j).cwiseAbs().maxCoeff() / differences.col(j).cwiseAbs().maxCoeff());
  }
  return largest;
}

// The 97.5 % quantile of Student's distribution, by the expansion about the normal one's: right to
// 1e-4 from 15 degrees of freedom on.
double StudentQuantile(double freedom)
{
  const double z = 1.959964;
  const double z3 = z * z * z;
  const double z5 = z3 * z * z;
  const double z7 = z5 * z * z;
  return z + (z3 + z) / (4.0 * freedom) +
    (5.0 * z5 + 16.0 * z3 + 3.0 * z) / (96.0 * freedom * freedom) +
    (3.0 * z7 + 19.0 * z5 + 17.0 * z3 - 15.0 * z) / (384.0 * std::pow(freedom, 3));
}

// How often 95 % intervals hold the value without noise, over draws of noise at some points.
void ExpectCoverage(const std::string& name, const Mesh& input, double noiseInEdges,
  Weighting weighting, double least, int degree = 4, int numberOfRings = 3, int draws = 250)
{
  const MeshedSurface clean(input);
  const OrderedRings rings = RingsOf(clean.Triangles());
  NeighborhoodRule rule;
  rule.kind = NeighborhoodRule::Kind::Rings;
  rule.numberOfRings = numberOfRings;
  constexpr int points = 40;
  RingNeighborhood neighborhood(clean.Triangles(), rings);
  JetFitter fitter;
  std::vector<Id> vertices;
  std::vector<MongeForm> expected;
  for (Id i = 0; i < 10 * points && static_cast<int>(vertices.size()) < points; ++i)
  {
    const Id p = static_cast<Id>(7919L * i % clean.Triangles().NumberOfPoints());
    const JetFit fit = fitter.Fit(OffsetsAround(clean.Triangles(), p, neighborhood, rule), degree,
      clean.Triangles().PointNormal(p), weighting);
    const MongeForm form = MongeFormOfHeightJet(fit.jet, fit.frame);
    // Directions have to be known for the errors to be small, which is what they are for.
    if (form.k1 - form.k2 > 0.4)
    {
      vertices.push_back(p);
      expected.push_back(form);
    }
  }
  ASSERT_EQ(vertices.size(), static_cast<std::size_t>(points));

  std::array<int, NumberOfQuantities> held{};
  int intervals = 0;
  for (int draw = 0; draw < draws; ++draw)
  {
    const MeshedSurface noisy(
      AddNormalNoise(input, noiseInEdges * clean.Triangles().MeanEdgeLength(), 100 + draw));
    RingNeighborhood around(noisy.Triangles(), rings);
    for (int i = 0; i < points; ++i)
    {
      const Id p = vertices[i];
      const Matrix3Xd offsets = OffsetsAround(noisy.Triangles(), p, around, rule);
      const JetFit fit = fitter.Fit(offsets, degree, noisy.Triangles().PointNormal(p), weighting);
      const Quantities errors = QuantitiesOf(StandardErrors(fitter, fit));
      const Quantities values =
        QuantitiesOf(MongeFormOfHeightJet(fit.jet, fit.frame), expected[i].d1);
      const Quantities truth = QuantitiesOf(expected[i], expected[i].d1);
      const double t =
        StudentQuantile(static_cast<double>(offsets.cols() - HeightJet::Size(degree)));
      for (int j = 0; j < NumberOfQuantities; ++j)
      {
        ASSERT_GT(errors[j], 0.0) << Names[j];
        held[j] += std::abs(values[j] - truth[j]) <= t * errors[j] ? 1 : 0;
      }
      ++intervals;
    }
  }
  std::printf("%-28s noise %.4f edges, coverage:", name.c_str(), noiseInEdges);
  for (int j = 0; j < NumberOfQuantities; ++j)
  {
    const double coverage = static_cast<double>(held[j]) / intervals;
    std::printf(" %s %.1f %%", Names[j], 100.0 * coverage);
    EXPECT_GT(coverage, least) << Names[j];
    EXPECT_LT(coverage, 0.98) << Names[j];
  }
  std::printf("\n");
}

} // namespace

//------------------------------------------------------------------------------
TEST(JetErrors, GradientIsThatOfTheMongeForm)
{
  std::mt19937_64 generator(81);
  for (int trial = 0; trial < 100; ++trial)
  {
    // Central differences: step^2 = 1e-10 times third derivatives, and 1e-16 / step of round-off.
    EXPECT_LT(LargestGradientError(RandomJet(generator, 0.0)), 1e-7) << trial;
  }
}

//------------------------------------------------------------------------------
TEST(JetErrors, GradientMissesTermsOfTheSlopeOnly)
{
  // In fits slopes are of some hundredths. Curvatures and the radius are about 1 here.
  for (const double slope : { 0.01, 0.1 })
  {
    std::mt19937_64 generator(82);
    double largest = 0.0;
    for (int trial = 0; trial < 100; ++trial)
    {
      largest = std::max(largest, LargestGradientError(RandomJet(generator, slope)));
    }
    EXPECT_LT(largest, 10.0 * slope);
  }
}

//------------------------------------------------------------------------------
// 10,000 intervals each; those at points that share neighbours are not independent, but all in one
// draw are as good as 10, so that 95 % are found within 1 %.
TEST(JetErrors, IntervalsHoldTheValueWithoutNoise)
{
  const Mesh ellipsoid = EllipsoidMesh(16, 1.4, 1.0, 0.6);
  ExpectCoverage("ellipsoid", ellipsoid, 0.001, Weighting::Uniform, 0.90);
  ExpectCoverage("ellipsoid", ellipsoid, 0.005, Weighting::Uniform, 0.90);
  const Mesh torus = TorusMesh(2.0, 0.8, 80, 32);
  ExpectCoverage("torus", torus, 0.005, Weighting::Uniform, 0.90);
  ExpectCoverage("torus", torus, 0.01, Weighting::Uniform, 0.90);
}

//------------------------------------------------------------------------------
// With weights the variance has fewer degrees of freedom than t is taken for.
TEST(JetErrors, IntervalsOfWeightedFitsHoldItToo)
{
  const Mesh ellipsoid = EllipsoidMesh(16, 1.4, 1.0, 0.6);
  ExpectCoverage("ellipsoid, Gaussian weights", ellipsoid, 0.002, Weighting::Gaussian, 0.90);
}

//------------------------------------------------------------------------------
// Fewer draws, as these fits take longer: 95 % are found within 2 %.
TEST(JetErrors, IntervalsOfHighDegreesHoldItToo)
{
  const Mesh ellipsoid = EllipsoidMesh(16, 1.4, 1.0, 0.6);
  ExpectCoverage(
    "ellipsoid, degree 6, 4 rings", ellipsoid, 0.002, Weighting::Uniform, 0.92, 6, 4, 40);
  ExpectCoverage(
    "ellipsoid, degree 8, 5 rings", ellipsoid, 0.002, Weighting::Uniform, 0.92, 8, 5, 40);
}

//------------------------------------------------------------------------------
TEST(JetErrors, ScaleAsTheQuantities)
{
  const Mesh mesh = AddNormalNoise(EllipsoidMesh(10, 1.4, 1.0, 0.6), 1e-3, 3);
  const double scale = 1e6;
  const MeshedSurface surface(mesh);
  const MeshedSurface large(Transform(mesh, Eigen::Matrix3d::Identity(), Vector3d::Zero(), scale));
  const OrderedRings rings = RingsOf(surface.Triangles());
  RingNeighborhood neighborhood(surface.Triangles(), rings);
  JetFitter fitter;
  const std::array<int, NumberOfQuantities> order = { 1, 1, 2, 2, 2, 2, 4, 4 };
  for (Id p = 0; p < 50; ++p)
  {
    const auto errorsOf = [&](const TriangleMesh& triangles)
    {
      const JetFit fit =
        fitter.Fit(OffsetsAround(triangles, p, neighborhood, {}), 4, triangles.PointNormal(p));
      return QuantitiesOf(StandardErrors(fitter, fit));
    };
    const Quantities small = errorsOf(surface.Triangles());
    // The neighbourhood knows ids; offsets are of the mesh that is given.
    const Quantities big = errorsOf(large.Triangles());
    for (int j = 0; j < NumberOfQuantities; ++j)
    {
      EXPECT_NEAR(big[j] * std::pow(scale, order[j]) / small[j], 1.0, 1e-6) << Names[j];
    }
  }
}

//------------------------------------------------------------------------------
TEST(JetErrors, AreUnknownWithoutFreedomAndAboveTheDegree)
{
  std::mt19937_64 generator(83);
  JetFitter fitter;
  for (int count = 2; count <= 20; ++count)
  {
    Matrix3Xd offsets = Matrix3Xd::Zero(3, count);
    for (int i = 1; i < count; ++i)
    {
      offsets.col(i) = InBall(generator);
      offsets(2, i) *= 0.1;
    }
    const JetFit fit = fitter.Fit(offsets, 4, Vector3d::UnitZ());
    const JetErrors errors = StandardErrors(fitter, fit);
    const bool free = fit.degree > 0 && count > HeightJet::Size(fit.degree);
    const double unknown = JetErrors::Unknown;
    EXPECT_EQ(errors.k1 == unknown, !free || fit.degree < 2) << count;
    EXPECT_EQ(errors.k2 == unknown, !free || fit.degree < 2) << count;
    EXPECT_EQ(errors.b[0] == unknown, !free || fit.degree < 3) << count;
    EXPECT_EQ(errors.b[3] == unknown, !free || fit.degree < 3) << count;
    EXPECT_EQ(errors.P1 == unknown, !free || fit.degree < 4) << count;
    EXPECT_EQ(errors.P2 == unknown, !free || fit.degree < 4) << count;
  }
  // Points in one place count as often as they are there, but do not determine more.
  EXPECT_EQ(
    StandardErrors(fitter, fitter.Fit(Matrix3Xd::Zero(3, 20), 4, Vector3d::UnitZ())).k1, -1.0);
}
