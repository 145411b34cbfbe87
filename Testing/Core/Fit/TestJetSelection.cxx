// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// The degree and the rings chosen on clean and on noisy meshes, against the errors that all choices
// really have.

#include "Fixtures/TestFields.h"

#include "Fit/Batch/JetBatch.h"
#include "Fit/JetFit.h"
#include "Fit/JetSelection.h"
#include "Mesh/ShapeSample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

namespace
{

using namespace ridges;
using namespace ridges::testing;
using Eigen::Vector3d;

std::vector<JetTrial> TrialsOf(
  const TriangleMesh& mesh, int numberOfRings, int bands = JetTrial::NumberOfBands)
{
  const OrderedRings rings = RingsOf(mesh);
  JetProbe probe(mesh, rings);
  std::vector<JetTrial> trials;
  for (const Id p : ShapeSample(mesh, 300.0))
  {
    trials.push_back(probe.Try(p, numberOfRings, bands));
  }
  return trials;
}

JetChoice Choose(const Mesh& mesh, int order, int degree = 0)
{
  const MeshedSurface surface(mesh);
  JetSelection selection(order, degree);
  while (selection.NextRings() > 0)
  {
    selection.Add(TrialsOf(surface.Triangles(), selection.NextRings(), selection.NextBands()));
  }
  return selection.Choice();
}

// Of the curvatures, or of b as a tensor in space, which has no sign to choose.
double ErrorOf(const MongeForm& form, const MongeForm& exact, int order)
{
  if (order == 2)
  {
    return std::abs(form.k1 - exact.k1) + std::abs(form.k2 - exact.k2);
  }
  const auto component = [](const MongeForm& of, int i, int j, int k)
  {
    double sum = 0.0;
    for (int choice = 0; choice < 8; ++choice)
    {
      const int seconds[] = { choice & 1, (choice >> 1) & 1, choice >> 2 };
      const auto along = [&of](int second, int axis) { return second ? of.d2[axis] : of.d1[axis]; };
      sum += of.b[seconds[0] + seconds[1] + seconds[2]] * along(seconds[0], i) *
        along(seconds[1], j) * along(seconds[2], k);
    }
    return sum;
  };
  double square = 0.0;
  for (int i = 0; i < 27; ++i)
  {
    const double off =
      component(form, i % 3, (i / 3) % 3, i / 9) - component(exact, i % 3, (i / 3) % 3, i / 9);
    square += off * off;
  }
  return std::sqrt(square);
}

struct Errors
{
  double ofChoice = 0.0;
  double least = std::numeric_limits<double>::infinity();
  bool isAveraged = false;
};

// The mean errors of the choice, and the least of all degrees and up to 19 rings.
Errors MeasureErrors(const Mesh& mesh, const Mesh& clean, const AnalyticSurface& surface, int order)
{
  const MeshedSurface meshed(mesh);
  const MeshedSurface exactly(clean);
  const TriangleMesh& triangles = meshed.Triangles();
  const OrderedRings rings = RingsOf(triangles);
  RingNeighborhood neighborhood(triangles, rings);
  JetFitter fitter;
  const JetChoice choice = Choose(mesh, order);
  Errors errors;
  errors.isAveraged = choice.numberOfAverages > 0;
  const std::vector<Id> sample = ShapeSample(triangles, 150.0);
  for (const int r : { 2, 3, 4, 5, 6, 7, 8, 10, 12, 15, 19 })
  {
    NeighborhoodRule rule;
    rule.kind = NeighborhoodRule::Kind::Rings;
    rule.numberOfRings = r;
    for (const int degree : { 2, 4, 6, 8 })
    {
      double sum = 0.0;
      int count = 0;
      for (const Id p : sample)
      {
        const Eigen::Matrix3Xd offsets = OffsetsAround(triangles, p, neighborhood, rule);
        const JetFit fit = fitter.Fit(offsets, degree, triangles.PointNormal(p));
        if (fit.degree == degree && degree >= order &&
          offsets.cols() >= JetProbe::FewestPoints(degree))
        {
          sum += ErrorOf(MongeFormOfHeightJet(fit.jet, fit.frame),
            ToMongeForm(surface.Monge(exactly.Triangles().Point(p))), order);
          ++count;
        }
      }
      if (2 * count > static_cast<int>(sample.size()))
      {
        errors.least = std::min(errors.least, sum / count);
        if (degree == choice.degree && r == choice.numberOfRings)
        {
          errors.ofChoice = sum / count;
        }
      }
    }
  }
  std::printf("order %d: degree %d, %d rings, %d averages, noise %.2g: %.2g, least %.2g (%.2f)\n",
    order, choice.degree, choice.numberOfRings, choice.numberOfAverages, choice.noise,
    errors.ofChoice, errors.least, errors.ofChoice / errors.least);
  return errors;
}

Mesh Ellipsoid(int frequency)
{
  return EllipsoidMesh(frequency, 1.4, 1.0, 0.6);
}

} // namespace

//------------------------------------------------------------------------------
// The choice is made for a geometric mean, and for less variance; that of fits that are averaged
// afterwards may be larger.
TEST(JetSelection, IsNearlyAsGoodAsTheBestChoice)
{
  const AnalyticSurface ellipsoid = MakeEllipsoid(1.4, 1.0, 0.6);
  const Mesh mesh = Ellipsoid(32);
  const double edge = MeanEdgeLength(mesh);
  for (const double noise : { 0.0, 1e-4, 1e-3, 0.01 })
  {
    const Mesh noisy = noise > 0.0 ? AddNormalNoise(mesh, noise * edge, 3) : mesh;
    for (const int order : { 2, 3 })
    {
      const Errors errors = MeasureErrors(noisy, mesh, ellipsoid, order);
      EXPECT_GT(errors.ofChoice, 0.0);
      EXPECT_LE(errors.ofChoice, (errors.isAveraged ? 2.5 : 1.75) * errors.least)
        << noise << " " << order;
    }
  }
}

//------------------------------------------------------------------------------
TEST(JetSelection, KnowsTheNoise)
{
  const Mesh mesh = Ellipsoid(32);
  const double edge = MeanEdgeLength(mesh);
  for (const double noise : { 1e-4, 1e-3, 0.01, 0.05 })
  {
    EXPECT_NEAR(
      Choose(AddNormalNoise(mesh, noise * edge, 3), 3).noise, noise * edge, 0.15 * noise * edge);
  }
  EXPECT_LT(Choose(mesh, 3).noise, 1e-6 * edge);
}

//------------------------------------------------------------------------------
// For fits of the third order only, and not if a degree is given.
TEST(JetSelection, BlendsWhereThereIsHardlyAnyNoise)
{
  for (const int frequency : { 12, 24 })
  {
    const Mesh mesh = Ellipsoid(frequency);
    const double edge = MeanEdgeLength(mesh);
    EXPECT_FALSE(Choose(mesh, 3).blend.empty()) << frequency;
    EXPECT_TRUE(Choose(mesh, 2).blend.empty()) << frequency;
    EXPECT_TRUE(Choose(mesh, 3, 6).blend.empty()) << frequency;
    for (const double noise : { 1e-3, 0.01 })
    {
      EXPECT_TRUE(Choose(AddNormalNoise(mesh, noise * edge, 3), 3).blend.empty())
        << frequency << " " << noise;
    }
  }
}

//------------------------------------------------------------------------------
TEST(JetBlend, WeightIsOneOverTheSquareOfTheError)
{
  const BlendedJet jet{ 8, 4 };
  const double weight = WeightInBlend(jet, 1e-3, 0.5, 100.0);
  EXPECT_NEAR(weight, 6.25, 1e-12); // of an error of 100 * 1e-3 / 0.25
  EXPECT_NEAR(WeightInBlend(jet, 2e-3, 0.5, 100.0), weight / 4.0, 1e-12);
  EXPECT_NEAR(WeightInBlend(jet, 1e-3, 0.25, 100.0), weight / 16.0, 1e-12);
  // A low degree is taken to be worse than it looks; no residual at all is no division by zero.
  EXPECT_LT(WeightInBlend({ 4, 2 }, 1e-3, 0.5, 100.0), weight);
  EXPECT_TRUE(std::isfinite(WeightInBlend(jet, 0.0, 0.5, 100.0)));
}

//------------------------------------------------------------------------------
TEST(JetBlend, WeightInNoisyBlendIsOneOverTheSquareOfTheError)
{
  // 61 points and 45 coefficients: the residual that the noise leaves has 16 of 61 degrees of
  // freedom. Where all of it is noise, the error is the standard error.
  const BlendedJet jet{ 8, 4 };
  const double residual = 1e-3;
  const double radius = 0.5;
  const double noise = radius * residual * std::sqrt(61.0 / 16.0);
  const double weight = WeightInNoisyBlend(jet, noise, residual, radius, 100.0);
  EXPECT_NEAR(weight, 6.25, 1e-9); // of an error of 100 * 1e-3 / 0.25
  // What is left over of the surface counts for more: per point 0.05, thus 61 * 0.05 in all.
  const double ofSurface = WeightInNoisyBlend(jet, 0.0, residual, radius, 100.0);
  EXPECT_NEAR(ofSurface, 6.25 / (61.0 * 0.05), 1e-9);
  EXPECT_NEAR(WeightInNoisyBlend(jet, 0.0, 2.0 * residual, radius, 100.0), ofSurface / 4.0, 1e-9);
  // A low degree is worse than it looks; no residual at all is no division by zero.
  EXPECT_LT(WeightInNoisyBlend({ 4, 4 }, 0.0, residual, radius, 100.0), ofSurface);
  EXPECT_TRUE(std::isfinite(WeightInNoisyBlend(jet, 0.0, 0.0, radius, 100.0)));
}

//------------------------------------------------------------------------------
// Fewer rings, and more, than those that are best for the mesh as a whole, the highest degree last.
TEST(JetBlend, FitsWithNoiseHaveRingsAroundTheBest)
{
  for (const int best : { 3, 5, 12, 24 })
  {
    const std::vector<BlendedJet> jets = JetsWithNoise(best);
    ASSERT_EQ(jets.size(), 3u);
    EXPECT_LT(jets[0].numberOfRings, best);
    EXPECT_GT(jets[1].numberOfRings, std::min(best, 23));
    EXPECT_LE(jets[2].numberOfRings, 28); // as more take long
    EXPECT_GT(jets[2].numberOfRings, jets[1].numberOfRings);
    EXPECT_EQ(jets[0].degree, 4);
    EXPECT_EQ(jets[1].degree, 4);
    EXPECT_EQ(jets[2].degree, 6);
  }
}

//------------------------------------------------------------------------------
// Larger neighborhoods are fitted one by one, in ten times the time; irregular meshes have more
// points in as many rings.
TEST(JetSelection, ItsNeighborhoodsAreFittedInBatches)
{
  const int most = std::max(JetSelection::MostRings, JetsWithNoise(1000).back().numberOfRings);
  const int points = 1 + 3 * most * (most + 1);
  EXPECT_LE(1.25 * points, JetBatch::MaximumRows);
}

//------------------------------------------------------------------------------
// Exact data want high degrees, noise many rings and averages.
TEST(JetSelection, NoiseTakesMoreRings)
{
  const Mesh mesh = Ellipsoid(24);
  const double edge = MeanEdgeLength(mesh);
  const JetChoice clean = Choose(mesh, 3);
  EXPECT_GE(clean.degree, 6);
  EXPECT_EQ(clean.numberOfAverages, 0);
  // Of single precision, which no averages are for.
  EXPECT_EQ(Choose(AddNormalNoise(mesh, 5e-6 * edge, 3), 3).numberOfAverages, 0);
  int rings = clean.numberOfRings;
  for (const double noise : { 1e-3, 0.01, 0.05 })
  {
    const JetChoice choice = Choose(AddNormalNoise(mesh, noise * edge, 3), 3);
    // Averages, and a lower degree, may stand for a ring.
    EXPECT_GE(choice.numberOfRings, rings - 1) << noise;
    EXPECT_LE(choice.degree, clean.degree);
    rings = choice.numberOfRings;
  }
  EXPECT_GE(rings, clean.numberOfRings + 3);
}

//------------------------------------------------------------------------------
// z = x^2 + 3 x y + 5 x^2 y: all derivatives are in the first bands, and none above.
TEST(JetTrial, BandsAddWhatTheirDegreesHave)
{
  Mesh mesh;
  constexpr int half = 8;
  const auto at = [](int i, int j) { return (2 * half + 1) * (j + half) + i + half; };
  for (int j = -half; j <= half; ++j)
  {
    for (int i = -half; i <= half; ++i)
    {
      const double x = 0.1 * (i + 0.5 * j);
      const double y = 0.1 * j;
      mesh.AddPoint({ x, y, 1e-3 * (x * x + 3.0 * x * y + 5.0 * x * x * y) });
    }
  }
  for (int j = -half; j < half; ++j)
  {
    for (int i = -half; i < half; ++i)
    {
      mesh.AddTriangle(at(i, j), at(i + 1, j), at(i, j + 1));
      mesh.AddTriangle(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  const MeshedSurface surface(mesh);
  const OrderedRings rings = RingsOf(surface.Triangles());
  JetProbe probe(surface.Triangles(), rings);
  const JetTrial trial = probe.Try(at(0, 0), 5);
  ASSERT_EQ(trial.bands, JetTrial::NumberOfBands);
  EXPECT_NEAR(trial.radius, std::hypot(0.25, 0.5), 1e-6);
  // Norms, as the axes of the trial are turned: of the second derivatives all, of the third ones
  // what the first band, without cubic terms, lacks.
  const auto norm = [](const JetTrial::Derivative& of, int order)
  {
    const double times[] = { 1.0, order == 2 ? 2.0 : 3.0, order == 2 ? 1.0 : 3.0, 1.0 };
    double sum = 0.0;
    for (int i = 0; i <= order; ++i)
    {
      sum += times[i] * of.values[i] * of.values[i];
    }
    return std::sqrt(sum);
  };
  EXPECT_NEAR(norm(trial.band[0].second, 2), 1e-3 * std::sqrt(4.0 + 2.0 * 9.0), 1e-8);
  EXPECT_NEAR(norm(trial.band[1].third, 3), 1e-3 * std::sqrt(3.0) * 10.0, 1e-6);
  for (int band = 2; band < JetTrial::NumberOfBands; ++band)
  {
    EXPECT_LT(std::sqrt(trial.band[band].meanSquare), 1e-9);
    EXPECT_LT(norm(trial.band[band].third, 3), 1e-5);
  }
  // Higher degrees have more variance, and fewer points allow fewer of them.
  EXPECT_GT(trial.band[2].third.variance, trial.band[1].third.variance);
  EXPECT_EQ(probe.Try(at(0, 0), 2).bands, 2);
  EXPECT_EQ(probe.Try(at(0, 0), 1).bands, 1); // 7 points, 6 coefficients
}

//------------------------------------------------------------------------------
TEST(JetSelection, DoesNotDependOnTheNumbering)
{
  const Mesh mesh = AddNormalNoise(Ellipsoid(20), 1e-3, 7); // 4,002 points: a sample is drawn
  const MeshedSurface surface(mesh);
  const std::vector<JetTrial> expected = TrialsOf(surface.Triangles(), 4);
  EXPECT_GT(expected.size(), 200U);
  EXPECT_LT(expected.size(), 400U);
  for (const std::uint64_t seed : { 1U, 2U })
  {
    const MeshedSurface permuted(Permute(mesh, seed));
    const std::vector<JetTrial> trials = TrialsOf(permuted.Triangles(), 4);
    ASSERT_EQ(trials.size(), expected.size());
    for (std::size_t i = 0; i < trials.size(); ++i)
    {
      ASSERT_EQ(trials[i].bands, expected[i].bands);
      for (int band = 0; band < trials[i].bands; ++band)
      {
        ASSERT_EQ(trials[i].band[band].third.values, expected[i].band[band].third.values);
        ASSERT_EQ(trials[i].band[band].meanSquare, expected[i].band[band].meanSquare);
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(JetSelection, AcceptsMeshesWithoutAnyUsablePoint)
{
  Mesh triangle;
  triangle.AddPoint({ 0, 0, 0 });
  triangle.AddPoint({ 1, 0, 0 });
  triangle.AddPoint({ 0, 1, 0 });
  triangle.AddTriangle(0, 1, 2);
  const JetChoice choice = Choose(triangle, 3);
  EXPECT_EQ(choice.degree, 4);
  EXPECT_EQ(choice.numberOfRings, 2);
  EXPECT_EQ(choice.numberOfAverages, 0);
}
