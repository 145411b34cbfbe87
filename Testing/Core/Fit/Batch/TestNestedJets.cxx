// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// Three nested fits at once, with every instruction set of this machine, against the solver for
// single points.

#include "Fixtures/BatchFits.h"
#include "Fixtures/MongeComparison.h"
#include "Fixtures/TestFields.h"

#include "Fit/Batch/NestedJetFiller.h"
#include "Fit/JetFit.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace ridges;
using namespace ridges::testing;
using Eigen::Vector3d;

namespace
{

constexpr int Fits = NestedJetFiller::Fits;
using Shares = std::array<double, Fits>;

struct NestedFit
{
  MongeForm form;
  std::array<double, Fits> residual;
  std::array<double, Fits> radius;
  std::array<double, Fits> conditionNumber;
  std::array<double, Fits> noiseGain;
  Vector3d axis; ///< Of heights.
  bool good;
};

NeighborhoodRule InRings(int rings)
{
  NeighborhoodRule rule;
  rule.kind = NeighborhoodRule::Kind::Rings;
  rule.numberOfRings = rings;
  return rule;
}

constexpr std::array<int, Fits> NumberOfRings{ 3, 5, 7 };

/// Of all points from `first` on, blended with these shares.
std::vector<NestedFit> FitNested(
  const TriangleMesh& mesh, const NestedJetKernel& kernel, const Shares& shares, Id first = 0)
{
  const OrderedRings rings = RingsOf(mesh);
  RingNeighborhood neighborhood(mesh, rings);
  NestedJetFiller filler(mesh, rings);
  std::vector<NestedFit> fits(mesh.NumberOfPoints());
  const auto fitAdded = [&]
  {
    filler.Fit(
      kernel,
      [&](NestedJetBatch& batch, const Span<Id>&)
      {
        for (int i = 0; i < Fits; ++i)
        {
          std::fill_n(batch.shares + i * kernel.lanes, kernel.lanes, shares[i]);
        }
      },
      [&](const NestedJetBatch& batch, const Span<Id>& vertices)
      {
        for (int lane = 0; lane < vertices.size(); ++lane)
        {
          NestedFit& fit = fits[vertices[lane]];
          fit.good = TakeResult(batch.fits[Fits - 1], kernel.lanes, lane, fit.form);
          for (int i = 0; i < Fits; ++i)
          {
            fit.residual[i] = batch.fits[i].residual[lane];
            fit.radius[i] = batch.fits[i].radius[lane];
            fit.conditionNumber[i] = batch.fits[i].conditionNumber[lane];
            fit.noiseGain[i] = batch.fits[i].noiseGain[lane];
            fit.good = fit.good && batch.fits[i].good[lane] != 0.0;
            fit.axis[i] = batch.axes[(6 + i) * kernel.lanes + lane];
          }
        }
      });
  };
  for (Id i = 0; i < mesh.NumberOfPoints(); ++i)
  {
    const Id p = (first + i) % mesh.NumberOfPoints();
    NestedJetFiller::Counts counts;
    Span<Id> points = neighborhood.Gather(p, InRings(NumberOfRings[0]));
    counts[0] = points.size();
    for (int fit = 1; fit < Fits; ++fit)
    {
      for (int ring = NumberOfRings[fit - 1]; ring < NumberOfRings[fit]; ++ring)
      {
        points = neighborhood.Grow();
      }
      counts[fit] = points.size();
    }
    if (!filler.Add(p, points, counts))
    {
      ADD_FAILURE() << p;
    }
    if (filler.IsFull())
    {
      fitAdded();
    }
  }
  fitAdded();
  return fits;
}

Mesh NoisyMesh()
{
  return AddNormalNoise(EllipsoidMesh(16, 1.4, 1.0, 0.6), 1e-3, 5);
}

} // namespace

//------------------------------------------------------------------------------
// Without the others, each is the fit of a single point along the same axis.
TEST(NestedJets, AgreeWithTheSolverForSinglePoints)
{
  const MeshedSurface surface(NoisyMesh());
  const TriangleMesh& mesh = surface.Triangles();
  const OrderedRings rings = RingsOf(mesh);
  RingNeighborhood neighborhood(mesh, rings);
  JetFitter fitter;
  for (const NestedJetKernel& kernel : NestedJetKernels())
  {
    for (int i = 0; i < Fits; ++i)
    {
      Shares shares{};
      shares[i] = 1.0;
      const std::vector<NestedFit> fits = FitNested(mesh, kernel, shares);
      RelativeErrors errors;
      for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
      {
        const Eigen::Matrix3Xd offsets =
          OffsetsAround(mesh, p, neighborhood, InRings(NumberOfRings[i]));
        const JetFit fit = fitter.FitAlong(fits[p].axis, offsets, NestedJetBatch::Degrees[i]);
        ASSERT_TRUE(fits[p].good);
        errors.Add(fits[p].form, MongeFormOfHeightJet(fit.jet, fit.frame));
        ASSERT_NEAR(fits[p].radius[i], fit.radius, 1e-14);
        // What is left of squares of heights of up to a half, rounded some hundred times.
        ASSERT_NEAR(fits[p].residual[i], fit.residual, 1e-9 * fit.residual);
        // Of the coefficients up to order 3, exact.
        ASSERT_NEAR(fits[p].noiseGain[i], fit.noiseGain, 1e-7 * fit.noiseGain);
        // An estimate, which depends on the axes: within a factor of nine here.
        ASSERT_LT(fits[p].conditionNumber[i], 10.0 * fit.conditionNumber);
        ASSERT_GT(fits[p].conditionNumber[i], 0.1 * fit.conditionNumber);
      }
      // The squares of condition numbers of up to 50, times round-off.
      EXPECT_LT(errors.k, 1e-11) << kernel.name << ", " << i;
      EXPECT_LT(errors.b, 1e-10) << kernel.name << ", " << i;
      EXPECT_LT(errors.P, 1e-9) << kernel.name << ", " << i;
    }
  }
}

//------------------------------------------------------------------------------
// Three different polynomials of degree 4, in one frame: their mean is that of their forms but for
// the slopes, which are those of noise.
TEST(NestedJets, BlendsByShares)
{
  const MeshedSurface surface(NoisyMesh());
  const TriangleMesh& mesh = surface.Triangles();
  const NestedJetKernel& kernel = NestedJetKernels().front();
  const auto first = FitNested(mesh, kernel, { 1.0, 0.0, 0.0 });
  const auto second = FitNested(mesh, kernel, { 0.0, 1.0, 0.0 });
  const auto third = FitNested(mesh, kernel, { 0.0, 0.0, 1.0 });
  const auto blend = FitNested(mesh, kernel, { 0.5, 0.2, 0.3 });
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    const auto mean = [](const MongeForm& form) { return 0.5 * (form.k1 + form.k2); };
    const double expected =
      0.5 * mean(first[p].form) + 0.2 * mean(second[p].form) + 0.3 * mean(third[p].form);
    ASSERT_NEAR(mean(blend[p].form), expected, 2e-3 * std::abs(expected));
  }
}

//------------------------------------------------------------------------------
TEST(NestedJets, DoNotDependOnTheBatch)
{
  const MeshedSurface surface(NoisyMesh());
  const TriangleMesh& mesh = surface.Triangles();
  for (const NestedJetKernel& kernel : NestedJetKernels())
  {
    const auto fits = FitNested(mesh, kernel, { 0.5, 0.2, 0.3 });
    const auto shifted = FitNested(mesh, kernel, { 0.5, 0.2, 0.3 }, 5);
    for (std::size_t p = 0; p < fits.size(); ++p)
    {
      ASSERT_EQ(fits[p].form.k1, shifted[p].form.k1);
      ASSERT_EQ(fits[p].form.d1, shifted[p].form.d1);
      ASSERT_EQ(fits[p].form.b, shifted[p].form.b);
      ASSERT_EQ(fits[p].form.c, shifted[p].form.c);
      ASSERT_EQ(fits[p].residual, shifted[p].residual);
      ASSERT_EQ(fits[p].conditionNumber, shifted[p].conditionNumber);
      ASSERT_EQ(fits[p].noiseGain, shifted[p].noiseGain);
    }
  }
}

//------------------------------------------------------------------------------
TEST(NestedJets, TakeNoMoreThanABatchHolds)
{
  const MeshedSurface surface(NoisyMesh());
  const TriangleMesh& mesh = surface.Triangles();
  const OrderedRings rings = RingsOf(mesh);
  NestedJetFiller filler(mesh, rings);
  std::vector<Id> points(JetBatch::MaximumRows + 1, 0);
  const auto span = [&points](int count) {
    return Span<Id>{ points.data(), points.data() + count };
  };
  EXPECT_FALSE(
    filler.Add(0, span(JetBatch::MaximumRows + 1), { 37, 91, JetBatch::MaximumRows + 1 }));
  EXPECT_FALSE(filler.Add(0, span(91), { 14, 37, 91 }));
  EXPECT_FALSE(filler.Add(0, span(27), { 15, 20, 27 }));
  EXPECT_TRUE(filler.IsEmpty());
  EXPECT_TRUE(filler.Add(0, span(28), { 15, 20, 28 }));
  EXPECT_FALSE(filler.IsEmpty());
}
