// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The type rules and the measuring properties of vtkRidgeExtraction.

#include "FilterTestTools.h"
#include "MessageRecorder.h"
#include "RidgePaths.h"

#include "vtkCellData.h"
#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRidgeExtraction.h"
#include "vtkRidgesArrayNames.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <sstream>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

vtkSmartPointer<vtkPolyData> Extract(vtkRidgeExtraction* extraction, vtkPolyData* marked)
{
  extraction->SetInputData(marked);
  extraction->Update();
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(extraction->GetOutput());
  return copy;
}

double SumOfSharpness(vtkPolyData* ridges, bool elliptic)
{
  double sum = 0.0;
  for (vtkIdType line = 0; line < ridges->GetNumberOfLines(); ++line)
  {
    const auto type = static_cast<int>(Value(ridges->GetCellData(), names::RidgeType, line));
    sum += (type % 2 == 1) == elliptic ? Value(ridges->GetCellData(), names::Sharpness, line) : 0.0;
  }
  return sum;
}

} // namespace

TEST(RidgeExtractionProperties, ThirdOrderRuleNeedsNoFourthOrder)
{
  vtkNew<vtkJetFitting> jets;
  jets->SetMongeOrder(3);
  jets->SetInputData(BlendData(32));
  vtkNew<vtkRidgeExtraction> extraction;
  const MessageRecorder recorder(extraction);
  extraction->SetInputConnection(jets->GetOutputPort());
  extraction->SetTypeRuleToThirdOrder();
  extraction->Update();
  vtkPolyData* ridges = extraction->GetOutput();
  EXPECT_EQ(recorder.ErrorText() + recorder.WarningText(), "");
  EXPECT_GT(ridges->GetNumberOfLines(), 0);
  EXPECT_FALSE(ridges->GetCellData()->HasArray(names::Sharpness));
  EXPECT_FALSE(ridges->GetPointData()->HasArray(names::SecondDerivative));
  EXPECT_TRUE(ridges->GetCellData()->HasArray(names::Strength));
  ExpectAllFinite(ridges);
}

TEST(RidgeExtractionProperties, FourthOrderRuleNamesWhatIsMissing)
{
  vtkNew<vtkJetFitting> jets;
  jets->SetMongeOrder(3);
  jets->SetInputData(BlendData(8));
  vtkNew<vtkRidgeExtraction> extraction;
  const MessageRecorder recorder(extraction);
  extraction->SetInputConnection(jets->GetOutputPort());
  extraction->Update();
  EXPECT_EQ(recorder.NumberOfErrors(), 1u);
  EXPECT_NE(recorder.ErrorText().find("FourthOrder (or P1 and P2)"), std::string::npos)
    << recorder.ErrorText();
  EXPECT_TRUE(IsEmpty(extraction->GetOutput()));
}

// Both rules approximate one truth: on a smooth surface they agree about 95% of the length at
// least. They differ near turning points, and where an edge is almost parallel to the ridge.
TEST(RidgeExtractionProperties, BothTypeRulesNearlyAgree)
{
  const Outputs outputs = RunFilters(BlendData(32));
  vtkNew<vtkRidgeExtraction> extraction;
  extraction->SetTypeRuleToThirdOrder();
  const auto third = Extract(extraction, outputs.marked);
  std::map<double, double> lengths[2];
  double all = 0.0;
  int rule = 0;
  for (vtkPolyData* ridges : { outputs.ridges.GetPointer(), third.GetPointer() })
  {
    for (vtkIdType line = 0; line < ridges->GetNumberOfLines(); ++line)
    {
      const double length = Value(ridges->GetCellData(), names::Length, line);
      lengths[rule][Value(ridges->GetCellData(), names::RidgeType, line)] += length;
      all += 0.5 * length;
    }
    ++rule;
  }
  for (double type = 1.0; type <= 4.0; ++type)
  {
    EXPECT_NEAR(lengths[0][type], lengths[1][type], 0.05 * all) << type;
  }
}

TEST(RidgeExtractionProperties, ModelSizeScalesSharpnessByItsSquare)
{
  const Outputs outputs = RunFilters(EllipsoidData(16));
  vtkNew<vtkRidgeExtraction> extraction;
  extraction->SetUmbilicCutOff(0.0); // which is a fraction of the model size
  const auto automatic = Extract(extraction, outputs.marked);
  extraction->SetModelSize(2.8);
  const auto twice = Extract(extraction, outputs.marked);
  ASSERT_EQ(automatic->GetNumberOfLines(), twice->GetNumberOfLines());
  for (vtkIdType line = 0; line < automatic->GetNumberOfLines(); ++line)
  {
    // The smallest sphere around points on the ellipsoid has a radius a little under 1.4: no point
    // is farther from an end of the long axis than half an edge of 0.08, which lowers it by 0.08^2.
    const double ratio = Value(twice->GetCellData(), names::Sharpness, line) /
      Value(automatic->GetCellData(), names::Sharpness, line);
    EXPECT_NEAR(ratio, 4.0, 4.0 * 0.01);
    EXPECT_EQ(Value(twice->GetCellData(), names::Strength, line),
      Value(automatic->GetCellData(), names::Strength, line));
  }
}

TEST(RidgeExtractionProperties, CutOffLowersTheSharpnessOfHyperbolicRidgesOnly)
{
  const Outputs outputs = RunFilters(EllipsoidData(32));
  vtkNew<vtkRidgeExtraction> extraction;
  double lastHyperbolic = std::numeric_limits<double>::max();
  for (const double cutOff : { 0.0, 0.01, 0.1, 1.0 })
  {
    extraction->SetUmbilicCutOff(cutOff);
    const auto ridges = Extract(extraction, outputs.marked);
    // Elliptic: the same sum, in the same order.
    EXPECT_EQ(SumOfSharpness(ridges, true), SumOfSharpness(outputs.ridges, true));
    EXPECT_LT(SumOfSharpness(ridges, false), lastHyperbolic) << cutOff;
    lastHyperbolic = SumOfSharpness(ridges, false);
  }
}

TEST(RidgeExtractionProperties, UmbilicsAreFoundWithoutTheirDetection)
{
  const Outputs outputs = RunFilters(EllipsoidData(32));
  vtkNew<vtkRidgeExtraction> extraction;
  const auto ridges = Extract(extraction, outputs.fitted);
  ExpectSameRidges(RidgesByPath(outputs.ridges), RidgesByPath(ridges), 1e-12);
  for (vtkIdType i = 0; i < ridges->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(Value(ridges->GetPointData(), names::Umbilic, i), -1.0);
  }
}

TEST(RidgeExtractionProperties, SettersClampAndAllIsPrinted)
{
  vtkNew<vtkRidgeExtraction> extraction;
  EXPECT_EQ(extraction->GetTypeRule(), vtkRidgeExtraction::FOURTH_ORDER);
  EXPECT_EQ(extraction->GetUmbilicCutOff(), 0.01);
  EXPECT_EQ(extraction->GetModelSize(), 0.0);
  extraction->SetTypeRule(5);
  EXPECT_EQ(extraction->GetTypeRule(), vtkRidgeExtraction::THIRD_ORDER);
  extraction->SetModelSize(-1.0);
  EXPECT_EQ(extraction->GetModelSize(), 0.0);
  extraction->SetUmbilicCutOff(3.0);
  EXPECT_EQ(extraction->GetUmbilicCutOff(), 1.0);
  extraction->SetUmbilicCutOff(-3.0);
  EXPECT_EQ(extraction->GetUmbilicCutOff(), 0.0);
  extraction->SetUmbilicCutOff(0.125);
  extraction->SetModelSize(2.5);
  extraction->ExtractMinimumOff();
  std::ostringstream text;
  extraction->Print(text);
  for (const char* line : { "ExtractMaximum: On", "ExtractMinimum: Off", "CrestOnly: Off",
         "TypeRule: ThirdOrder", "ModelSize: 2.5", "UmbilicCutOff: 0.125" })
  {
    EXPECT_NE(text.str().find(line), std::string::npos) << line;
  }
}
