// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Some hundred umbilics of a random Gaussian surface, one by one. RidgesCensus has thousands.

#include "ExactUmbilics.h"
#include "TestMeshes.h"
#include "UmbilicCensus.h"
#include "WaveSurface.h"

#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkUmbilicDetection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace ridges::testing;

namespace
{

//------------------------------------------------------------------------------
CensusCase SmallCase()
{
  CensusCase settings;
  settings.size = 26.0;
  settings.numberOfWaves = 300;
  return settings;
}

} // namespace

//------------------------------------------------------------------------------
// Against differences: each derivative is that of the one before.
TEST(WaveSurface, HasTheDerivativesOfItsHeight)
{
  const WaveSurface surface(20, 0.3, 5);
  const double h = 1e-4;
  const ridges::HeightJet jet = surface.Derivatives(0.7, -1.3, 4);
  EXPECT_NEAR(jet.Derivative(0, 0), surface.Height(0.7, -1.3), 1e-14);
  for (int i = 0; i <= 3; ++i)
  {
    for (int j = 0; i + j <= 3; ++j)
    {
      // Second-order differences of waves with |k| < 3: h^2 |k|^6 amplitude.
      EXPECT_NEAR(jet.Derivative(i + 1, j),
        (surface.Derivatives(0.7 + h, -1.3, 4).Derivative(i, j) -
          surface.Derivatives(0.7 - h, -1.3, 4).Derivative(i, j)) /
          (2 * h),
        1e-5);
      EXPECT_NEAR(jet.Derivative(i, j + 1),
        (surface.Derivatives(0.7, -1.3 + h, 4).Derivative(i, j) -
          surface.Derivatives(0.7, -1.3 - h, 4).Derivative(i, j)) /
          (2 * h),
        1e-5);
    }
  }
}

//------------------------------------------------------------------------------
// A steep surface, with slopes of about 1, whose umbilics another method finds by Monge forms.
TEST(WaveSurface, HasTheUmbilicsThatMongeFormsTell)
{
  const WaveSurface waves(40, 0.7, 3);
  constexpr double halfSize = 3.0;
  const auto umbilics = FindUmbilics(waves, halfSize, 0.1);
  ASSERT_GE(umbilics.size(), 10u);
  for (const ExactUmbilic& umbilic : umbilics)
  {
    const Eigen::Vector3d& at = umbilic.position;
    const ridges::MongeForm form = ridges::MongeFormOfHeightJet(
      waves.Derivatives(at.x(), at.y(), 4), Eigen::Matrix3d::Identity());
    // The gap is the square root of what vanishes, in numbers of order 1.
    EXPECT_LT(form.k1 - form.k2, 1e-7);
    EXPECT_NEAR(form.k1, umbilic.curvature, 1e-7);
    ExactUmbilic other = umbilic;
    other.b = form.b; // in another frame
    ClassifyByForm(other);
    EXPECT_NEAR(other.indexMargin, umbilic.indexMargin, 1e-9);
    EXPECT_NEAR(other.ridgeMargin, umbilic.ridgeMargin, 1e-9);
    EXPECT_NEAR(other.lineMargin, umbilic.lineMargin, 1e-9);
    EXPECT_GT(umbilic.indexMargin * umbilic.index, 0.0);
  }
}

//------------------------------------------------------------------------------
// Counts that the theory knows, within four standard errors of these.
TEST(UmbilicCensus, AgreesWithTheTheoryOfGaussianSurfaces)
{
  const UmbilicCensus census(SmallCase());
  const auto measure = [&census](Trait trait)
  {
    SquareCounts counts;
    census.Count(trait, counts);
    return counts.Ratio();
  };
  for (const Trait trait : { Trait::Star, Trait::Lemon, Trait::Monstar, Trait::ThreeRidges })
  {
    const Estimate estimate = measure(trait);
    EXPECT_NEAR(estimate.value, TheoryOf(trait), 4.0 * estimate.error);
    EXPECT_LT(estimate.error, 0.06);
  }
  const Estimate density = measure(Trait::All);
  EXPECT_NEAR(density.value, census.ExpectedDensity(), 4.0 * density.error);
  EXPECT_NEAR(census.ExpectedDensity(), TheoryOf(Trait::All), 0.05 * TheoryOf(Trait::All));
  EXPECT_EQ(measure(Trait::ThreeRidgesOfIndexPlus).value, 0.0);
}

//------------------------------------------------------------------------------
TEST(UmbilicCensus, EachUmbilicIsReportedAsItIs)
{
  const UmbilicCensus census(SmallCase());
  vtkNew<vtkUmbilicDetection> exact;
  exact->SetInputData(census.MeshWithExactForms());
  exact->Update();
  vtkNew<vtkJetFitting> jets;
  jets->SetInputData(census.Mesh());
  vtkNew<vtkUmbilicDetection> fitted;
  fitted->SetInputConnection(jets->GetOutputPort());
  fitted->Update();
  for (vtkUmbilicDetection* detection : { exact.Get(), fitted.Get() })
  {
    const CensusScore score = census.Compare(detection->GetOutput(1));
    EXPECT_GE(score.umbilics, 250u);
    EXPECT_EQ(score.found, score.umbilics);
    EXPECT_EQ(score.spurious, 0u);
    EXPECT_EQ(score.rightIndex, score.found);
    EXPECT_EQ(score.rightPattern, score.found);
    // Of the two that are wrong one has another umbilic two spacings away, the other has nearly a
    // double root; the margin is at most 1/4.
    EXPECT_GE(score.rightRidgeCount + 2, score.found);
    EXPECT_LT(score.largestMargin, 0.001);
    EXPECT_LT(score.ErrorAt(1.0), 0.5);
  }
}
