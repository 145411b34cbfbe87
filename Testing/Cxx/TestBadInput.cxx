// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Missing inputs, missing arrays and bad properties, filter by filter. Meshes that are faulty
// themselves are in TestBadMeshes.cxx.

#include "FilterTestTools.h"
#include "MessageRecorder.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkJetFitting.h"
#include "vtkMongeSmoothing.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPrincipalFoliation.h"
#include "vtkRidgeExtraction.h"
#include "vtkRidgeSharpnessFilter.h"
#include "vtkRidgesAndUmbilics.h"
#include "vtkRidgesArrayNames.h"
#include "vtkSalientRidges.h"
#include "vtkUmbilicDetection.h"

#include <gtest/gtest.h>

#include <limits>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

template <typename Filter>
class BadInput : public ::testing::Test
{
};

using AllFilters = ::testing::Types<vtkJetFitting, vtkUmbilicDetection, vtkRidgeExtraction,
  vtkRidgeSharpnessFilter, vtkPrincipalFoliation, vtkRidgesAndUmbilics>;
TYPED_TEST_SUITE(BadInput, AllFilters);

template <typename Filter>
void ExpectEmptyOutputs(Filter* filter)
{
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    EXPECT_TRUE(IsEmpty(filter->GetOutput(port))) << port;
  }
}

const double NaN = std::numeric_limits<double>::quiet_NaN();

} // namespace

TYPED_TEST(BadInput, ReportsMissingInput)
{
  vtkNew<TypeParam> filter;
  const MessageRecorder recorder(filter);
  filter->Update();
  EXPECT_NE(
    recorder.ExecutiveErrorText().find("0 connections but is not optional"), std::string::npos)
    << recorder.ExecutiveErrorText();
  ExpectEmptyOutputs(filter.GetPointer());
}

TYPED_TEST(BadInput, EmptyInputGivesEmptyOutputSilently)
{
  vtkNew<TypeParam> filter;
  const MessageRecorder recorder(filter);
  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  filter->Update();
  EXPECT_EQ(recorder.ErrorText() + recorder.WarningText() + recorder.ExecutiveErrorText(), "");
  ExpectEmptyOutputs(filter.GetPointer());
}

TYPED_TEST(BadInput, EmptyInputWithAllocatedPointsAndCellsGivesEmptyOutput)
{
  vtkNew<TypeParam> filter;
  const MessageRecorder recorder(filter);
  filter->SetInputData(MakePolyData({}, {}));
  filter->Update();
  EXPECT_EQ(recorder.ErrorText() + recorder.WarningText() + recorder.ExecutiveErrorText(), "");
  ExpectEmptyOutputs(filter.GetPointer());
}

TEST(BadMongeArrays, NamesAllMissingArraysInOneError)
{
  const auto good = RunFilters(EllipsoidData(8)).fitted;
  const auto bare = EllipsoidData(8);
  const auto expectComplaint = [&](vtkPolyDataAlgorithm* filter)
  {
    const MessageRecorder recorder(filter);
    filter->SetInputDataObject(good);
    filter->Update();
    ASSERT_FALSE(IsEmpty(filter->GetOutput()));
    ASSERT_EQ(recorder.NumberOfErrors(), 0u);
    filter->SetInputDataObject(bare);
    filter->Update();
    EXPECT_EQ(recorder.NumberOfErrors(), 1u);
    EXPECT_NE(recorder.ErrorText().find("MaximumCurvature, MinimumCurvature, MaximumDirection, "
                                        "MinimumDirection, ThirdOrder"),
      std::string::npos)
      << recorder.ErrorText();
    ExpectEmptyOutputs(filter); // nothing stale
  };
  vtkNew<vtkUmbilicDetection> umbilics;
  expectComplaint(umbilics);
  vtkNew<vtkRidgeExtraction> ridges;
  expectComplaint(ridges);
}

TEST(BadMongeArrays, NamesEachMissingArrayAndNoOther)
{
  const auto good = RunFilters(EllipsoidData(8)).fitted;
  const std::vector<const char*> needed = { names::MaximumCurvature, names::MinimumCurvature,
    names::MaximumDirection, names::MinimumDirection, names::ThirdOrder };
  for (const char* missing : needed)
  {
    vtkNew<vtkPolyData> mesh;
    mesh->ShallowCopy(good);
    mesh->GetPointData()->RemoveArray(missing);
    vtkNew<vtkRidgeExtraction> ridges;
    const MessageRecorder recorder(ridges);
    ridges->SetInputData(mesh);
    ridges->Update();
    EXPECT_EQ(recorder.NumberOfErrors(), 1u);
    for (const char* name : needed)
    {
      EXPECT_EQ(recorder.ErrorText().find(name) != std::string::npos, name == missing)
        << recorder.ErrorText();
    }
    EXPECT_TRUE(IsEmpty(ridges->GetOutput()));
  }
}

TEST(BadMongeArrays, ReportsWrongNumberOfComponents)
{
  const auto mesh = RunFilters(EllipsoidData(8)).fitted;
  AddPointArray(mesh, names::ThirdOrder, 3, [](vtkIdType, double* b) { std::fill(b, b + 3, 1.0); });
  AddPointArray(mesh, names::MaximumCurvature, 2, [](vtkIdType, double* k) { k[0] = k[1] = 1.0; });
  vtkNew<vtkUmbilicDetection> umbilics;
  const MessageRecorder recorder(umbilics);
  umbilics->SetInputData(mesh);
  umbilics->Update();
  EXPECT_EQ(recorder.NumberOfErrors(), 1u);
  EXPECT_NE(recorder.ErrorText().find("ThirdOrder has 3 components, not 4"), std::string::npos)
    << recorder.ErrorText();
  EXPECT_NE(
    recorder.ErrorText().find("MaximumCurvature has 2 components, not 1"), std::string::npos);
  EXPECT_EQ(recorder.ErrorText().find("MinimumCurvature"), std::string::npos);
  ExpectEmptyOutputs(umbilics.GetPointer());
}

TEST(BadMongeArrays, NaNAtAPointLeavesOutOnlyItsTriangles)
{
  const Outputs expected = RunFilters(BlendData(24));
  for (const char* name : { names::MaximumCurvature, names::ThirdOrder, names::FourthOrder })
  {
    vtkNew<vtkPolyData> mesh;
    mesh->DeepCopy(expected.fitted);
    mesh->GetPointData()->GetArray(name)->SetComponent(100, 0, NaN);
    vtkNew<vtkUmbilicDetection> umbilics;
    umbilics->SetInputData(mesh);
    vtkNew<vtkRidgeExtraction> ridges;
    ridges->SetInputConnection(umbilics->GetOutputPort());
    ridges->Update();
    ExpectAllFinite(ridges->GetOutput());
    ExpectAllFinite(umbilics->GetOutput(1));
    EXPECT_GT(ridges->GetOutput()->GetNumberOfPoints(),
      expected.ridges->GetNumberOfPoints() - 20); // six triangles have a few crossings
    for (vtkIdType i = 0; i < ridges->GetOutput()->GetNumberOfPoints(); ++i)
    {
      vtkPointData* data = ridges->GetOutput()->GetPointData();
      EXPECT_NE(Value(data, names::EdgePoint0, i), 100.0);
      EXPECT_NE(Value(data, names::EdgePoint1, i), 100.0);
    }
  }
}

TEST(BadProperties, RejectsRadiusThatIsNotPositive)
{
  vtkNew<vtkJetFitting> jets;
  jets->SetInputData(EllipsoidData(6));
  jets->Update();
  ASSERT_FALSE(IsEmpty(jets->GetOutput()));
  jets->SetNeighborhoodToRadius();
  for (const double radius : { 0.0, -1.0, NaN, std::numeric_limits<double>::infinity() })
  {
    const MessageRecorder recorder(jets);
    jets->SetRadius(radius);
    jets->Update();
    EXPECT_EQ(recorder.NumberOfErrors(), 1u) << radius;
    EXPECT_NE(recorder.ErrorText().find("Radius is"), std::string::npos);
    EXPECT_TRUE(IsEmpty(jets->GetOutput())) << "stale output";
  }
  const MessageRecorder recorder(jets);
  jets->SetNeighborhoodToRings(); // where it is not
  jets->Update();
  EXPECT_EQ(recorder.ErrorText(), "");
  EXPECT_FALSE(IsEmpty(jets->GetOutput()));
}

TEST(BadProperties, ReportsRadiusThatIsTooSmall)
{
  vtkNew<vtkJetFitting> jets;
  const MessageRecorder recorder(jets);
  const auto mesh = EllipsoidData(6);
  jets->SetInputData(mesh);
  jets->SetNeighborhoodToRadius();
  jets->SetRadius(1e-6);
  jets->Update();
  EXPECT_EQ(recorder.NumberOfWarnings(), 1u);
  EXPECT_NE(
    recorder.WarningText().find(std::to_string(mesh->GetNumberOfPoints()) + " points have no fit"),
    std::string::npos)
    << recorder.WarningText();
  ExpectAllFinite(jets->GetOutput());
  EXPECT_EQ(Value(jets->GetOutput()->GetPointData(), names::MaximumCurvature, 0), 0.0);
}

TEST(BadProperties, AcceptsMoreRingsOrPointsThanTheMeshHas)
{
  vtkNew<vtkJetFitting> jets;
  jets->SetInputData(EllipsoidData(4));
  jets->SetMinimumNumberOfPoints(VTK_INT_MAX);
  jets->Update();
  EXPECT_FALSE(IsEmpty(jets->GetOutput()));
  ExpectAllFinite(jets->GetOutput());
  jets->SetNeighborhoodToRings();
  jets->SetNumberOfRings(1000);
  jets->Update();
  ExpectAllFinite(jets->GetOutput());
}

// A setter that clamps lets NaN through.
TEST(BadProperties, EveryFilterRejectsNaN)
{
  const Outputs outputs = RunFilters(EllipsoidData(8));
  const auto expectError = [](vtkPolyDataAlgorithm* filter, vtkPolyData* input, const char* name)
  {
    const MessageRecorder recorder(filter);
    filter->SetInputDataObject(input);
    filter->Update();
    EXPECT_EQ(recorder.NumberOfErrors(), 1u) << name;
    EXPECT_NE(recorder.ErrorText().find(std::string("These properties are not numbers: ") + name),
      std::string::npos)
      << recorder.ErrorText();
    ExpectEmptyOutputs(filter);
  };
#define EXPECT_NAN_IS_AN_ERROR(Class, Property, input)                                             \
  {                                                                                                \
    vtkNew<Class> filter;                                                                          \
    filter->Set##Property(NaN);                                                                    \
    expectError(filter, outputs.input, #Property);                                                 \
  }
  EXPECT_NAN_IS_AN_ERROR(vtkUmbilicDetection, Significance, fitted);
  EXPECT_NAN_IS_AN_ERROR(vtkUmbilicDetection, PatchSize, fitted);
  EXPECT_NAN_IS_AN_ERROR(vtkRidgeExtraction, LoopSignificance, marked);
  EXPECT_NAN_IS_AN_ERROR(vtkRidgeExtraction, ZoneSignificance, marked);
  EXPECT_NAN_IS_AN_ERROR(vtkRidgeExtraction, TypeHysteresis, marked);
  EXPECT_NAN_IS_AN_ERROR(vtkRidgeExtraction, ModelSize, marked);
  EXPECT_NAN_IS_AN_ERROR(vtkRidgeExtraction, UmbilicCutOff, marked);
  EXPECT_NAN_IS_AN_ERROR(vtkRidgeSharpnessFilter, MinimumSharpness, ridges);
  EXPECT_NAN_IS_AN_ERROR(vtkRidgeSharpnessFilter, MinimumStrength, ridges);
  EXPECT_NAN_IS_AN_ERROR(vtkRidgeSharpnessFilter, MinimumLength, ridges);
  EXPECT_NAN_IS_AN_ERROR(vtkPrincipalFoliation, Separation, marked);
  EXPECT_NAN_IS_AN_ERROR(vtkPrincipalFoliation, MinimumLength, marked);
  EXPECT_NAN_IS_AN_ERROR(vtkMongeSmoothing, Sigma, fitted);
  EXPECT_NAN_IS_AN_ERROR(vtkMongeSmoothing, RelativeSigma, fitted);
  EXPECT_NAN_IS_AN_ERROR(vtkSalientRidges, FoldAngle, fitted);
  EXPECT_NAN_IS_AN_ERROR(vtkSalientRidges, RelativeScale, fitted);
  EXPECT_NAN_IS_AN_ERROR(vtkSalientRidges, Hysteresis, fitted);
  EXPECT_NAN_IS_AN_ERROR(vtkSalientRidges, LongestGap, fitted);
  EXPECT_NAN_IS_AN_ERROR(vtkSalientRidges, LeastMass, fitted);
  EXPECT_NAN_IS_AN_ERROR(vtkSalientRidges, LineSmoothing, fitted);
  EXPECT_NAN_IS_AN_ERROR(vtkSalientRidges, NoiseFactor, fitted);
  EXPECT_NAN_IS_AN_ERROR(vtkRidgesAndUmbilics, MinimumSharpness, fitted);
  EXPECT_NAN_IS_AN_ERROR(vtkRidgesAndUmbilics, UmbilicCutOff, fitted);
#undef EXPECT_NAN_IS_AN_ERROR
}
