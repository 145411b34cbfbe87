// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// Weights and standard errors of batched fits, against those of the solver for single points.

#include "Fixtures/BatchFits.h"
#include "Fixtures/MongeComparison.h"
#include "Fixtures/TestFields.h"

#include "Fit/JetErrors.h"
#include "Fit/JetFit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

using namespace ridges;
using namespace ridges::testing;

//------------------------------------------------------------------------------
TEST(JetBatch, WeightedFitsAgreeWithTheSolverForSinglePoints)
{
  const MeshedSurface surface(AddNormalNoise(EllipsoidMesh(12, 1.4, 1.0, 0.6), 1e-3, 5));
  const TriangleMesh& mesh = surface.Triangles();
  const OrderedRings rings = RingsOf(mesh);
  RingNeighborhood neighborhood(mesh, rings);
  NeighborhoodRule rule;
  rule.minimumNumberOfPoints = 30;
  JetFitter fitter;
  for (const JetBatchKernel& kernel : JetBatchKernels())
  {
    const auto fits = FitAll(mesh, kernel, 4, 30, 0, Weighting::Gaussian);
    for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
    {
      const JetFit fit = fitter.Fit(
        OffsetsAround(mesh, p, neighborhood, rule), 4, mesh.PointNormal(p), Weighting::Gaussian);
      const MongeForm expected = MongeFormOfHeightJet(fit.jet, fit.frame);
      ASSERT_TRUE(fits[p].good);
      // Round-off, magnified by condition numbers of up to some hundreds.
      const double k = std::abs(expected.k2);
      ASSERT_NEAR(fits[p].form.k1, expected.k1, 1e-10 * k);
      ASSERT_NEAR(fits[p].form.k2, expected.k2, 1e-10 * k);
      ASSERT_NEAR(fits[p].residual, fit.residual, 1e-13);
      ASSERT_NEAR(fits[p].radius, fit.radius, 1e-15);
    }
  }
}

//------------------------------------------------------------------------------
TEST(JetBatch, StandardErrorsAreThoseOfTheSolverForSinglePoints)
{
  const MeshedSurface surface(AddNormalNoise(EllipsoidMesh(10, 1.4, 1.0, 0.6), 1e-3, 5));
  const TriangleMesh& mesh = surface.Triangles();
  const OrderedRings rings = RingsOf(mesh);
  RingNeighborhood neighborhood(mesh, rings);
  for (const Weighting weighting : { Weighting::Uniform, Weighting::Gaussian })
  {
    for (int degree = 2; degree <= JetFitter::MaximumDegree; ++degree)
    {
      const NeighborhoodRule rule = RuleFor(degree);
      JetFitter fitter;
      std::vector<JetErrors> expected(mesh.NumberOfPoints());
      std::vector<bool> isCertain(mesh.NumberOfPoints(), false);
      for (Id p = 0; p < mesh.NumberOfPoints(); p += 7)
      {
        const JetFit fit = fitter.Fit(
          OffsetsAround(mesh, p, neighborhood, rule), degree, mesh.PointNormal(p), weighting);
        expected[p] = StandardErrors(fitter, fit);
        const MongeForm form = MongeFormOfHeightJet(fit.jet, fit.frame);
        isCertain[p] = form.k1 - form.k2 > 1e-2 * std::abs(form.k2);
      }
      for (const JetBatchKernel& kernel : JetBatchKernels())
      {
        const auto plain = FitAll(mesh, kernel, degree, rule.minimumNumberOfPoints, 0, weighting);
        const auto fits =
          FitAll(mesh, kernel, degree, rule.minimumNumberOfPoints, 0, weighting, true);
        for (std::size_t p = 0; p < fits.size(); ++p)
        {
          const JetErrors& e = expected[p];
          const double values[] = { e.k1, e.k2, e.b[0], e.b[1], e.b[2], e.b[3], e.P1, e.P2 };
          for (int i = 0; isCertain[p] && i < JetBatch::NumberOfErrors; ++i)
          {
            // Round-off, magnified by condition numbers and by 1 / (k1 - k2).
            ASSERT_NEAR(fits[p].errors[i], values[i], 1e-6 * std::abs(values[i]))
              << kernel.name << " degree " << degree << " point " << p << " quantity " << i
              << (weighting == Weighting::Gaussian ? " weighted" : "");
          }
          // All else is the same to the last digit.
          ASSERT_EQ(fits[p].form.k1, plain[p].form.k1);
          ASSERT_EQ(fits[p].form.b, plain[p].form.b);
          ASSERT_EQ(fits[p].form.c, plain[p].form.c);
          ASSERT_EQ(fits[p].P2, plain[p].P2);
          ASSERT_EQ(fits[p].conditionNumber, plain[p].conditionNumber);
          ASSERT_EQ(fits[p].noiseGain, plain[p].noiseGain);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(JetBatch, StandardErrorsAreUnknownWithoutFreedomAndAtUmbilics)
{
  // Regular neighbourhoods of 19 points, and 15 of a cap of a sphere are as many as coefficients.
  const MeshedSurface surface(EllipsoidMesh(6, 1.0, 1.0, 1.0));
  const TriangleMesh& mesh = surface.Triangles();
  const OrderedRings rings = RingsOf(mesh);
  RingNeighborhood neighborhood(mesh, rings);
  for (const JetBatchKernel& kernel : JetBatchKernels())
  {
    std::vector<BatchFit> fits(mesh.NumberOfPoints());
    JetBatchFiller filler(mesh, rings, 4, Weighting::Uniform, true);
    for (Id p = 0; p < 8; ++p)
    {
      const Span<Id> points = neighborhood.Gather(p + 50, NeighborhoodRule());
      filler.Add(p, { points.begin(), points.begin() + 15 }, false);
    }
    FitAdded(filler, kernel, fits);
    for (Id p = 0; p < 8; ++p)
    {
      for (const double error : fits[p].errors)
      {
        ASSERT_EQ(error, JetBatch::UnknownError) << kernel.name;
      }
    }
  }
}
