// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The filters with their default properties against the exact umbilics and ridges of a surface of
// each kind. The bounds are counts of what is not resolved at 10,000 points: pairs of ridges nearer
// to each other than a few edges. RidgesTruth prints the details.

#include "FilterPicture.h"
#include "FilterTestTools.h"
#include "RidgeComparison.h"
#include "TruthCache.h"

#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRidgeExtraction.h"
#include "vtkUmbilicDetection.h"

#include <gtest/gtest.h>

#include <ostream>
#include <string>

namespace
{

using namespace ridges::testing;

struct Case
{
  const char* surface;
  int reference;     // points of the mesh that the true ridges are traced on
  int ridges;        // true ones
  int mostNotWhole;  // of these
  int mostSpurious;  // found ridges
  double percentile; // of distances of found ridges from true ones, in edges: 95 %
};

void PrintTo(const Case& item, std::ostream* os)
{
  *os << item.surface;
}

class RidgesTruth : public ::testing::TestWithParam<Case>
{
};

} // namespace

//------------------------------------------------------------------------------
TEST_P(RidgesTruth, UmbilicsAndRidgesAreThoseOfTheSurface)
{
  constexpr int points = 10000;
  const Case& expected = GetParam();
  const ClosedSurface closed = ClosedSurfaceByName(expected.surface);
  // Kept in no file, which might outlive a change.
  const TruthCache cache(closed, "");
  const Mesh mesh = cache.MeshWith(points);
  const Truth truth = cache.TruthWith(expected.reference);
  ASSERT_TRUE(DoubtsAbout(truth.ridges, truth.umbilics).empty());

  vtkNew<vtkJetFitting> jets;
  vtkNew<vtkUmbilicDetection> umbilics;
  vtkNew<vtkRidgeExtraction> ridges;
  jets->SetInputData(ToPolyData(mesh));
  umbilics->SetInputConnection(jets->GetOutputPort());
  ridges->SetInputConnection(umbilics->GetOutputPort());
  ridges->Update();
  const RidgeComparison comparison(
    truth, PictureOf(umbilics->GetOutput(1), ridges->GetOutput()), MeanEdgeLength(mesh));
  const RidgeScore score = comparison.Score();
  EXPECT_EQ(score.rightUmbilics, score.umbilics);
  EXPECT_EQ(score.joinedUmbilics, score.umbilics);
  EXPECT_EQ(score.spuriousUmbilics, 0);
  EXPECT_EQ(score.indexSum, closed.eulerCharacteristic);
  EXPECT_LT(score.farthest, 1.0); // edges
  EXPECT_EQ(score.looseEnds, 0);
  EXPECT_EQ(score.ridges, expected.ridges);
  EXPECT_LE(score.ridges - score.wholeRidges, expected.mostNotWhole);
  EXPECT_LE(score.spuriousRidges, expected.mostSpurious);
  for (const Coverage& color : comparison.FoundToTrue())
  {
    EXPECT_LT(color.percentile95, expected.percentile);
  }
  if (HasFailure())
  {
    comparison.PrintTables(closed.eulerCharacteristic);
  }
}

// The percentiles are twice those measured.
INSTANTIATE_TEST_SUITE_P(OfEachKind, RidgesTruth,
  ::testing::Values(Case{ "ellipsoid", 10000, 6, 0, 0, 0.03 },
    Case{ "blend", 10000, 11, 0, 0, 0.3 }, Case{ "sphere", 30000, 18, 2, 0, 0.1 },
    Case{ "torus", 10000, 13, 0, 0, 0.46 }, Case{ "double torus", 10000, 38, 2, 0, 1.2 },
    Case{ "blob", 10000, 15, 1, 0, 0.1 }, Case{ "metaballs", 10000, 10, 0, 0, 0.15 }),
  [](const ::testing::TestParamInfo<Case>& instance)
  {
    std::string name;
    for (const char* c = instance.param.surface; *c != 0; ++c)
    {
      name += *c == ' ' ? '_' : *c;
    }
    return name;
  });
