// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// The number of rings chosen on clean and on noisy meshes, against the errors that all of them
// really have.

#include "Fixtures/TestFields.h"

#include "Fit/ScaleSelection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace
{

using namespace ridges;
using namespace ridges::testing;
using Eigen::Vector3d;

std::vector<ScaleTrial> TrialsOf(const TriangleMesh& mesh, int degree)
{
  const OrderedRings rings = RingsOf(mesh);
  ScaleProbe probe(mesh, rings, degree, degree == 4 ? 18 : HeightJet::Size(degree));
  std::vector<ScaleTrial> trials;
  for (const Id p : ScaleSample(mesh))
  {
    trials.push_back(probe.Try(p));
  }
  return trials;
}

int ChosenRings(const Mesh& mesh, int degree = 4)
{
  const MeshedSurface surface(mesh);
  return SelectNumberOfRings(TrialsOf(surface.Triangles(), degree), degree);
}

// Mean errors of k1, and of k1 and k2, by number of rings.
struct CurvatureErrors
{
  std::array<double, ScaleTrial::MostRings + 1> k1{};
  std::array<double, ScaleTrial::MostRings + 1> both{};
};

CurvatureErrors MeasureErrors(const TriangleMesh& mesh, const std::vector<ExactMonge>& exact)
{
  const OrderedRings rings = RingsOf(mesh);
  RingNeighborhood neighborhood(mesh, rings);
  JetFitter fitter;
  CurvatureErrors errors;
  const Id step = std::max(1, mesh.NumberOfPoints() / 2000);
  for (int r = ScaleTrial::FewestRings; r <= ScaleTrial::MostRings; ++r)
  {
    NeighborhoodRule rule;
    rule.kind = NeighborhoodRule::Kind::Rings;
    rule.numberOfRings = r;
    int count = 0;
    for (Id p = 0; p < mesh.NumberOfPoints(); p += step, ++count)
    {
      const JetFit fit =
        fitter.Fit(OffsetsAround(mesh, p, neighborhood, rule), 4, mesh.PointNormal(p));
      const MongeForm form = MongeFormOfHeightJet(fit.jet, fit.frame);
      errors.k1[r] += std::abs(form.k1 - exact[p].k1);
      errors.both[r] += std::abs(form.k1 - exact[p].k1) + std::abs(form.k2 - exact[p].k2);
    }
    errors.k1[r] /= count;
    errors.both[r] /= count;
  }
  return errors;
}

// Prints the errors of all numbers of rings, and how much worse than the best the chosen one is.
struct Excess
{
  double k1;
  double both;
};

Excess MeasureExcess(const std::string& name, const Mesh& clean, const AnalyticSurface& surface,
  double noiseInEdges, std::uint64_t seed)
{
  const MeshedSurface cleanMesh(clean);
  std::vector<ExactMonge> exact;
  exact.reserve(cleanMesh.Triangles().NumberOfPoints());
  for (Id p = 0; p < cleanMesh.Triangles().NumberOfPoints(); ++p)
  {
    exact.push_back(surface.Monge(cleanMesh.Triangles().Point(p)));
  }
  const Mesh mesh =
    noiseInEdges > 0.0 ? AddNormalNoise(clean, noiseInEdges * cleanMesh.MeanEdge(), seed) : clean;
  const MeshedSurface meshed(mesh);
  const CurvatureErrors errors = MeasureErrors(meshed.Triangles(), exact);
  const int chosen = SelectNumberOfRings(TrialsOf(meshed.Triangles(), 4), 4);
  const auto least = [](const auto& values)
  { return *std::min_element(values.begin() + ScaleTrial::FewestRings, values.end()); };
  const Excess excess{ errors.k1[chosen] / least(errors.k1),
    errors.both[chosen] / least(errors.both) };

  std::printf("%-16s%7d%7.3f", name.c_str(), cleanMesh.Triangles().NumberOfPoints(), noiseInEdges);
  for (int r = ScaleTrial::FewestRings; r <= ScaleTrial::MostRings; ++r)
  {
    std::printf("%9.1e", errors.k1[r]);
  }
  std::printf("%8d%7.2f%7.2f\n", chosen, excess.k1, excess.both);
  return excess;
}

void PrintHeader()
{
  std::printf("%-16s%7s%7s%37s%26s%8s%7s%7s\n", "surface", "points", "noise",
    "mean error of k1 with 2 ", "to 8 rings", "chosen", "k1", "k1+k2");
}

const double SemiAxes[3] = { 1.4, 1.0, 0.6 };

Mesh Ellipsoid(int frequency)
{
  return EllipsoidMesh(frequency, SemiAxes[0], SemiAxes[1], SemiAxes[2]);
}

} // namespace

//------------------------------------------------------------------------------
TEST(ScaleSelection, IsAsGoodAsTheBestNumberOfRingsOnTheEllipsoid)
{
  const AnalyticSurface surface = MakeEllipsoid(SemiAxes[0], SemiAxes[1], SemiAxes[2]);
  PrintHeader();
  for (const int frequency : { 32, 63 }) // 10 and 40 thousand points
  {
    const Mesh mesh = Ellipsoid(frequency);
    EXPECT_LE(MeasureExcess("ellipsoid", mesh, surface, 0.0, 0).k1, 1.2);
    for (const double noise : { 1e-4, 1e-3, 0.01, 0.05 })
    {
      for (std::uint64_t seed = 1; seed <= 3; ++seed)
      {
        EXPECT_LE(MeasureExcess("ellipsoid", mesh, surface, noise, seed).k1, 1.2) << seed;
      }
    }
  }
}

//------------------------------------------------------------------------------
// The number is one for k1 and k2, the larger of whose errors decides.
TEST(ScaleSelection, IsGoodOnOtherSurfaces)
{
  PrintHeader();
  const AnalyticSurface blend = MakeBlend();
  const Mesh blendMesh = StarShapedMesh(32, blend, BlendCenter());
  const AnalyticSurface torus = MakeTorus(2.0, 0.8);
  const Mesh torusMesh = TorusMesh(2.0, 0.8, 120, 48);
  const AnalyticSurface perturbed = MakePerturbedSphere(0.1);
  const Mesh perturbedMesh = StarShapedMesh(24, perturbed, Vector3d::Zero());
  const AnalyticSurface ellipsoid = MakeEllipsoid(SemiAxes[0], SemiAxes[1], SemiAxes[2]);
  const Mesh coarse = Ellipsoid(10);
  for (const double noise : { 0.0, 1e-3, 0.01, 0.05 })
  {
    EXPECT_LE(MeasureExcess("blend", blendMesh, blend, noise, 1).both, 1.2);
    EXPECT_LE(MeasureExcess("torus", torusMesh, torus, noise, 1).both, 1.2);
    EXPECT_LE(MeasureExcess("perturbed sphere", perturbedMesh, perturbed, noise, 1).both, 1.2);
    EXPECT_LE(MeasureExcess("ellipsoid", coarse, ellipsoid, noise, 1).both, 1.2);
  }
}

//------------------------------------------------------------------------------
TEST(ScaleSelection, DoesNotDependOnTheNumbering)
{
  const Mesh mesh = AddNormalNoise(Ellipsoid(20), 1e-3, 7); // 4,002 points: a sample is drawn
  const MeshedSurface surface(mesh);
  const std::vector<ScaleTrial> expected = TrialsOf(surface.Triangles(), 4);
  EXPECT_GT(expected.size(), 1800U);
  EXPECT_LT(expected.size(), 2200U);
  for (const std::uint64_t seed : { 1U, 2U })
  {
    const MeshedSurface permuted(Permute(mesh, seed));
    const std::vector<ScaleTrial> trials = TrialsOf(permuted.Triangles(), 4);
    ASSERT_EQ(trials.size(), expected.size());
    for (std::size_t i = 0; i < trials.size(); ++i)
    {
      ASSERT_EQ(trials[i].usable, expected[i].usable);
      for (int scale = 0; scale < ScaleTrial::NumberOfScales; ++scale)
      {
        ASSERT_EQ(trials[i].fits[scale].second, expected[i].fits[scale].second);
        ASSERT_EQ(trials[i].fits[scale].squares, expected[i].fits[scale].squares);
        ASSERT_EQ(trials[i].fits[scale].spread, expected[i].fits[scale].spread);
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(ScaleSelection, DoesNotDependOnTheUnitOrThePlace)
{
  // All points are taken here, as which are sampled of a larger mesh depends on coordinates.
  const Mesh mesh = AddNormalNoise(Ellipsoid(10), 2e-3, 7);
  const int expected = ChosenRings(mesh);
  EXPECT_GT(expected, ScaleTrial::FewestRings);
  EXPECT_LT(expected, ScaleTrial::MostRings);
  for (const double scale : { 1e-12, 1e-3, 1e3, 1e12 })
  {
    EXPECT_EQ(ChosenRings(Transform(mesh, GenericRotation(), Vector3d::Zero(), scale)), expected);
  }
}

//------------------------------------------------------------------------------
TEST(ScaleSelection, TrialsAreTheFitsOfThatManyRings)
{
  const MeshedSurface surface(AddNormalNoise(Ellipsoid(20), 1e-3, 7));
  const TriangleMesh& mesh = surface.Triangles();
  const OrderedRings rings = RingsOf(mesh);
  RingNeighborhood neighborhood(mesh, rings);
  ScaleProbe probe(mesh, rings, 4, 18);
  JetFitter fitter;
  for (Id p = 0; p < mesh.NumberOfPoints(); p += 101)
  {
    const ScaleTrial trial = probe.Try(p);
    ASSERT_TRUE(trial.usable);
    NeighborhoodRule rule;
    rule.kind = NeighborhoodRule::Kind::RingsAndPointCount;
    for (int scale = 0; scale < ScaleTrial::NumberOfScales; ++scale)
    {
      rule.numberOfRings = ScaleTrial::FewestRings + scale;
      const Eigen::Matrix3Xd offsets = OffsetsAround(mesh, p, neighborhood, rule);
      const ScaleTrial::Fit& tried = trial.fits[scale];
      EXPECT_EQ(tried.freedom, offsets.cols() - 15);
      EXPECT_NEAR(tried.radius, offsets.colwise().norm().maxCoeff(), 1e-12);
      if (scale == 0) // The plane is that of this one.
      {
        const JetFit fit = fitter.Fit(offsets, 4, mesh.PointNormal(p));
        // Round-off times a squared condition number of up to some thousands.
        EXPECT_NEAR(tried.second[0], fit.jet.Derivative(2, 0), 1e-8);
        EXPECT_NEAR(tried.second[1], fit.jet.Derivative(1, 1), 1e-8);
        EXPECT_NEAR(tried.second[2], fit.jet.Derivative(0, 2), 1e-8);
        const double height = fit.residual * fit.radius;
        EXPECT_NEAR(tried.squares, height * height * static_cast<double>(offsets.cols()), 1e-12);
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(ScaleSelection, IsDefinedForWhateverThereIs)
{
  EXPECT_EQ(SelectNumberOfRings({}, 4), 2);
  EXPECT_EQ(SelectNumberOfRings(std::vector<ScaleTrial>(5), 4), 2);
  EXPECT_EQ(ChosenRings(Icosphere(1)), 2); // 12 points: no fit of degree 4
  EXPECT_EQ(ChosenRings(GraphPatch([](double, double) { return 0.0; }, 1.0, 12)), 2);
  for (int degree = 1; degree <= 3; ++degree)
  {
    const int rings = ChosenRings(AddNormalNoise(Ellipsoid(10), 2e-3, 7), degree);
    EXPECT_GE(rings, ScaleTrial::FewestRings) << degree;
    EXPECT_LE(rings, ScaleTrial::MostRings) << degree;
  }

  // Points that coincide are told apart by nothing but their numbers.
  Mesh twice = Icosphere(4);
  const Mesh once = twice;
  for (std::size_t p = 0; p < once.PointCount(); ++p)
  {
    twice.AddPoint(once.Point(p));
  }
  const MeshedSurface surface(twice);
  EXPECT_TRUE(ScaleSample(surface.Triangles()).empty());
}
