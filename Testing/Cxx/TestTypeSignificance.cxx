// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Types of ridges by their significance, and the confidence in them.

#include "FilterTestTools.h"
#include "RidgeGraph.h"

#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRidgeExtraction.h"
#include "vtkRidgesArrayNames.h"

#include <gtest/gtest.h>

#include <map>
#include <sstream>
#include <string>
#include <vector>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

Mesh NoisyEllipsoid(double noise)
{
  const Mesh mesh = EllipsoidMesh(32, 1.4, 1.0, 0.6);
  return AddNormalNoise(mesh, noise * MeanEdgeLength(mesh), 3);
}

vtkSmartPointer<vtkPolyData> Extract(const Outputs& outputs, double significance)
{
  vtkNew<vtkRidgeExtraction> extraction;
  extraction->SetInputData(outputs.marked);
  extraction->SetTypeSignificance(significance);
  extraction->Update();
  return extraction->GetOutput();
}

double TotalLength(vtkPolyData* ridges)
{
  double sum = 0.0;
  for (vtkIdType line = 0; line < ridges->GetNumberOfLines(); ++line)
  {
    sum += Value(ridges->GetCellData(), names::Length, line);
  }
  return sum;
}

/// The mean over the length.
double Confidence(vtkPolyData* ridges)
{
  double sum = 0.0;
  for (vtkIdType line = 0; line < ridges->GetNumberOfLines(); ++line)
  {
    const double confidence = Value(ridges->GetCellData(), names::Confidence, line);
    EXPECT_GE(confidence, 0.0);
    EXPECT_LE(confidence, 1.0);
    sum += confidence * Value(ridges->GetCellData(), names::Length, line);
  }
  return sum / TotalLength(ridges);
}

} // namespace

//------------------------------------------------------------------------------
// Of the six ridges of an ellipsoid each has one type, as four of them end at umbilics.
TEST(TypeSignificance, RemovesWhatNoiseMakesOfTypes)
{
  const Outputs outputs =
    RunFilters(ToPolyData(NoisyEllipsoid(0.003)), vtkJetFitting::BY_POINT_COUNT);
  const auto all = Extract(outputs, 0.0);
  const auto significant = Extract(outputs, 1.0);
  EXPECT_LT(2 * significant->GetNumberOfLines(), all->GetNumberOfLines());
  EXPECT_NEAR(TotalLength(significant), TotalLength(all), 1e-12 * TotalLength(all));

  const Outputs best = RunFilters(ToPolyData(NoisyEllipsoid(0.003)));
  EXPECT_EQ(Extract(best, 1.0)->GetNumberOfLines(), 6);
}

//------------------------------------------------------------------------------
TEST(TypeSignificance, KeepsTheTypesOfExactData)
{
  for (const auto& mesh : { EllipsoidData(32), BlendData(63) })
  {
    const Outputs outputs = RunFilters(mesh);
    EXPECT_EQ(FirstDifference(Extract(outputs, 0.0), Extract(outputs, 1.0)), "");
  }
}

//------------------------------------------------------------------------------
TEST(TypeSignificance, TakesTurningPointsInPairs)
{
  const Outputs outputs =
    RunFilters(ToPolyData(NoisyEllipsoid(0.003)), vtkJetFitting::BY_POINT_COUNT);
  const auto turnsOf = [](vtkPolyData* ridges)
  {
    std::map<vtkIdType, std::vector<double>> types;
    std::map<vtkIdType, bool> isLoop;
    for (vtkIdType line = 0; line < ridges->GetNumberOfLines(); ++line)
    {
      const auto id = static_cast<vtkIdType>(Value(ridges->GetCellData(), names::RidgeId, line));
      types[id].push_back(Value(ridges->GetCellData(), names::RidgeType, line));
      isLoop[id] = Value(ridges->GetCellData(), names::Closed, line) != 0.0;
    }
    int odd = 0;
    for (const auto& [id, ofRidge] : types)
    {
      int turns = isLoop[id] && ofRidge.front() != ofRidge.back() ? 1 : 0;
      for (std::size_t i = 1; i < ofRidge.size(); ++i)
      {
        turns += ofRidge[i] != ofRidge[i - 1] ? 1 : 0;
      }
      odd += turns % 2;
    }
    return odd;
  };
  for (const double significance : { 0.5, 1.0, 3.0, 100.0 })
  {
    const auto ridges = Extract(outputs, significance);
    EXPECT_EQ(turnsOf(ridges), 0) << significance;
    vtkNew<vtkRidgeExtraction> extraction;
    extraction->SetInputData(outputs.marked);
    extraction->SetLoopSignificance(0.0);
    extraction->SetTypeSignificance(significance);
    extraction->Update();
    ExpectCompleteRidgeGraph(outputs.marked, extraction->GetOutput());
  }
}

//------------------------------------------------------------------------------
TEST(TypeSignificance, ConfidenceFallsWithNoise)
{
  const double clean = Confidence(RunFilters(BlendData(63)).ridges);
  EXPECT_GT(clean, 0.97);
  double before = 1.0;
  for (const double noise : { 1e-4, 1e-3, 1e-2 })
  {
    const double confidence = Confidence(
      RunFilters(ToPolyData(NoisyEllipsoid(noise)), vtkJetFitting::BY_POINT_COUNT).ridges);
    EXPECT_LT(confidence, before) << noise;
    before = confidence;
  }
  EXPECT_LT(before, 0.3);
}

//------------------------------------------------------------------------------
TEST(TypeSignificance, IsClampedAndPrinted)
{
  vtkNew<vtkRidgeExtraction> extraction;
  EXPECT_EQ(extraction->GetTypeSignificance(), 1.0);
  extraction->SetTypeSignificance(-1.0);
  EXPECT_EQ(extraction->GetTypeSignificance(), 0.0);
  extraction->SetTypeSignificance(1e9);
  EXPECT_EQ(extraction->GetTypeSignificance(), 100.0);
  std::ostringstream text;
  extraction->Print(text);
  EXPECT_NE(text.str().find("TypeSignificance: 100"), std::string::npos);
}
