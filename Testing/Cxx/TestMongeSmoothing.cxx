// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTestTools.h"
#include "MessageRecorder.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkJetFitting.h"
#include "vtkMongeSmoothing.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRidgeExtraction.h"
#include "vtkRidgesArrayNames.h"
#include "vtkSMPTools.h"
#include "vtkUmbilicDetection.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

vtkSmartPointer<vtkPolyData> Fit(vtkPolyData* mesh, int degree = 2)
{
  vtkNew<vtkJetFitting> jets;
  jets->SetNeighborhoodToPointCount();
  jets->SetDegree(degree);
  jets->SetMongeOrder(degree);
  jets->SetInputData(mesh);
  jets->Update();
  return jets->GetOutput();
}

vtkSmartPointer<vtkPolyData> Smooth(
  vtkPolyData* fitted, double sigma, int method = vtkMongeSmoothing::SECOND_ORDER)
{
  vtkNew<vtkMongeSmoothing> smoothing;
  smoothing->SetInputData(fitted);
  smoothing->SetSigma(sigma);
  smoothing->SetMethod(method);
  smoothing->Update();
  return smoothing->GetOutput();
}

double RmsError(vtkPolyData* data, const char* name, double expected)
{
  double squares = 0.0;
  for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
  {
    squares += std::pow(Value(data->GetPointData(), name, p) - expected, 2);
  }
  return std::sqrt(squares / static_cast<double>(data->GetNumberOfPoints()));
}

} // namespace

TEST(MongeSmoothing, MakesTheArraysOfTheFit)
{
  const auto smoothed = Smooth(Fit(EllipsoidData(16)), 0.2);
  const vtkIdType count = smoothed->GetNumberOfPoints();
  vtkPointData* data = smoothed->GetPointData();
  for (const char* name : { names::MaximumCurvature, names::MinimumCurvature, names::P1, names::P2,
         names::FitScale, names::FitResidual })
  {
    ExpectArray(data, name, VTK_DOUBLE, 1, count);
  }
  ExpectArray(data, names::Normals, VTK_DOUBLE, 3, count);
  ExpectArray(data, names::MaximumDirection, VTK_DOUBLE, 3, count);
  ExpectArray(data, names::MinimumDirection, VTK_DOUBLE, 3, count);
  ExpectArray(data, names::ThirdOrder, VTK_DOUBLE, 4, count);
  ExpectArray(data, names::FourthOrder, VTK_DOUBLE, 5, count);
  ExpectArray(data, names::FitStatus, VTK_INT, 1, count);
  ExpectAllFinite(smoothed);
  int reached = 0; // the scale, as the radius of a fit: 0.2 / 0.4
  for (vtkIdType p = 0; p < count; p += 10)
  {
    EXPECT_GE(Value(data, names::MaximumCurvature, p), Value(data, names::MinimumCurvature, p));
    const Eigen::Vector3d d1 = VectorAt(data, names::MaximumDirection, p);
    const Eigen::Vector3d d2 = VectorAt(data, names::MinimumDirection, p);
    EXPECT_NEAR((d1.cross(d2) - VectorAt(data, names::Normals, p)).norm(), 0.0, 1e-14);
    reached += std::abs(Value(data, names::FitScale, p) - 0.5) < 0.025 ? 1 : 0;
    const double k1 = Value(data, names::MaximumCurvature, p);
    const double b1 = Value(data, names::ThirdOrder, p, 1);
    const double gap = k1 - Value(data, names::MinimumCurvature, p);
    EXPECT_NEAR(Value(data, names::P1, p),
      3.0 * b1 * b1 + gap * (Value(data, names::FourthOrder, p) - 3.0 * k1 * k1 * k1), 1e-9);
  }
  // All but the twentieth part of points with the smallest triangles.
  EXPECT_GE(10 * reached, 0.95 * static_cast<double>(count));
}

// A sphere of radius 1 with noise: curvatures scatter around -1, and the less the more is averaged.
TEST(MongeSmoothing, AveragesNoiseAway)
{
  const auto noisy = ToPolyData(AddNormalNoise(Icosphere(20), 2e-4, 1));
  for (const int method : { vtkMongeSmoothing::SECOND_ORDER, vtkMongeSmoothing::ALL_ORDERS })
  {
    const auto fitted = Fit(noisy, 4);
    const auto smoothed = Smooth(fitted, 0.2, method);
    // The maximum of two curvatures that scatter is above both: it is not unbiased.
    EXPECT_LT(RmsError(smoothed, names::MaximumCurvature, -1.0),
      0.25 * RmsError(fitted, names::MaximumCurvature, -1.0));
    double before = 0.0;
    double after = 0.0;
    for (vtkIdType p = 0; p < fitted->GetNumberOfPoints(); ++p)
    {
      before += std::abs(Value(fitted->GetPointData(), names::ThirdOrder, p));
      after += std::abs(Value(smoothed->GetPointData(), names::ThirdOrder, p));
    }
    EXPECT_LT(after, 0.1 * before);
    EXPECT_TRUE(smoothed->GetPointData()->HasArray(names::FourthOrder));
  }
}

// The three principal ellipses of an ellipsoid, four umbilics, both ways.
TEST(MongeSmoothing, RidgesAndUmbilicsOfASmoothSurfaceStay)
{
  for (const int method : { vtkMongeSmoothing::SECOND_ORDER, vtkMongeSmoothing::ALL_ORDERS })
  {
    vtkNew<vtkMongeSmoothing> smoothing;
    smoothing->SetInputData(Fit(EllipsoidData(24), 4));
    smoothing->SetMethod(method);
    vtkNew<vtkUmbilicDetection> umbilics;
    umbilics->SetInputConnection(smoothing->GetOutputPort());
    vtkNew<vtkRidgeExtraction> ridges;
    ridges->SetInputConnection(umbilics->GetOutputPort());
    ridges->Update();
    EXPECT_EQ(umbilics->GetOutput(1)->GetNumberOfPoints(), 4);
    EXPECT_GE(ridges->GetOutput()->GetNumberOfLines(), 6);
    for (vtkIdType p = 0; p < ridges->GetOutput()->GetNumberOfPoints(); ++p)
    {
      // In a coordinate plane, within an edge.
      EXPECT_LT(PointAt(ridges->GetOutput(), p).cwiseAbs().minCoeff(), 0.06);
    }
  }
}

TEST(MongeSmoothing, TakesExactArraysWithoutAFit)
{
  const auto fitted = Fit(EllipsoidData(16), 4);
  for (const char* name : { names::FitScale, names::FitStatus, names::FitResidual })
  {
    fitted->GetPointData()->RemoveArray(name);
  }
  const auto smoothed = Smooth(fitted, 0.1);
  EXPECT_NEAR(Value(smoothed->GetPointData(), names::FitScale, 5), 0.25, 0.02);
  EXPECT_EQ(Value(smoothed->GetPointData(), names::FitStatus, 5), 0.0);
}

TEST(MongeSmoothing, LeavesOutInvalidPoints)
{
  const auto fitted = Fit(EllipsoidData(16));
  const double none = std::numeric_limits<double>::quiet_NaN();
  fitted->GetPointData()->GetArray(names::MaximumCurvature)->SetComponent(17, 0, none);
  fitted->GetPointData()->GetArray(names::FitStatus)->SetComponent(40, 0, 8.0);
  fitted->GetPointData()->GetArray(names::MaximumCurvature)->SetComponent(40, 0, 1e6);
  const auto smoothed = Smooth(fitted, 0.1);
  ExpectAllFinite(smoothed);
  const auto without = Smooth(Fit(EllipsoidData(16)), 0.1);
  for (vtkIdType p = 0; p < smoothed->GetNumberOfPoints(); ++p)
  {
    const auto status = static_cast<int>(Value(smoothed->GetPointData(), names::FitStatus, p));
    EXPECT_EQ((status & vtkJetFitting::FIT_INVALID) != 0, p == 17 || p == 40);
    if (p != 17 && p != 40)
    {
      EXPECT_NEAR(Value(smoothed->GetPointData(), names::MaximumCurvature, p),
        Value(without->GetPointData(), names::MaximumCurvature, p), 0.05);
    }
  }
}

TEST(MongeSmoothing, RemovesWhatDoesNotBelongToTheSmoothedField)
{
  vtkNew<vtkJetFitting> jets;
  jets->SetInputData(EllipsoidData(8));
  jets->StandardErrorsOn();
  vtkNew<vtkUmbilicDetection> umbilics;
  umbilics->SetInputConnection(jets->GetOutputPort());
  umbilics->Update();
  const auto smoothed = Smooth(umbilics->GetOutput(), 0.2);
  EXPECT_FALSE(smoothed->GetPointData()->HasArray(names::P1Error));
  EXPECT_FALSE(smoothed->GetPointData()->HasArray(names::ThirdOrderError));
  EXPECT_EQ(smoothed->GetFieldData()->GetArray(names::UmbilicPosition), nullptr);
  EXPECT_TRUE(umbilics->GetOutput()->GetPointData()->HasArray(names::P1Error));
}

TEST(MongeSmoothing, SameBytesForAnyThreadsAndNumbering)
{
  // Averages of the points themselves, and of cells that points are joined to.
  const Mesh mesh = AddNormalNoise(Icosphere(24), 1e-3, 2);
  for (const double sigma : { 0.2, 0.6 })
  {
    vtkSMPTools::Initialize(1);
    const auto one = Smooth(Fit(ToPolyData(mesh)), sigma);
    vtkSMPTools::Initialize(3);
    const auto three = Smooth(Fit(ToPolyData(mesh)), sigma);
    vtkSMPTools::Initialize();
    EXPECT_EQ(FirstDifference(one, three), "");

    std::vector<std::int32_t> newToOld;
    const auto permuted = Smooth(Fit(ToPolyData(Permute(mesh, 4, &newToOld))), sigma);
    for (const char* name : { names::MaximumCurvature, names::ThirdOrder, names::FourthOrder,
           names::P2, names::FitScale })
    {
      vtkDataArray* expected = one->GetPointData()->GetArray(name);
      for (std::size_t p = 0; p < newToOld.size(); ++p)
      {
        for (int i = 0; i < expected->GetNumberOfComponents(); ++i)
        {
          ASSERT_EQ(Value(permuted->GetPointData(), name, static_cast<vtkIdType>(p), i),
            expected->GetComponent(newToOld[p], i))
            << name;
        }
      }
    }
  }
}

// An ellipsoid so fine that points are joined: the field is that of a coarser mesh.
TEST(MongeSmoothing, FineMeshesGiveTheFieldOfCoarseOnes)
{
  const auto rmsOf = [](int frequency)
  {
    const auto smoothed = Smooth(Fit(EllipsoidData(frequency)), 0.15);
    double squares = 0.0;
    for (vtkIdType p = 0; p < smoothed->GetNumberOfPoints(); ++p)
    {
      squares += std::pow(Value(smoothed->GetPointData(), names::MaximumCurvature, p), 2);
    }
    return std::sqrt(squares / static_cast<double>(smoothed->GetNumberOfPoints()));
  };
  const double coarse = rmsOf(20);
  EXPECT_NEAR(rmsOf(80), coarse, 0.02 * coarse);
}

// Invalid values stay out of the cells that points are joined to.
TEST(MongeSmoothing, LeavesOutInvalidPointsOfFineMeshes)
{
  const auto fitted = Fit(ToPolyData(Icosphere(24)));
  vtkDataArray* curvature = fitted->GetPointData()->GetArray(names::MaximumCurvature);
  curvature->SetComponent(17, 0, std::numeric_limits<double>::quiet_NaN());
  const auto smoothed = Smooth(fitted, 0.6);
  ExpectAllFinite(smoothed);
  for (vtkIdType p = 0; p < smoothed->GetNumberOfPoints(); ++p)
  {
    const auto status = static_cast<int>(Value(smoothed->GetPointData(), names::FitStatus, p));
    EXPECT_EQ((status & vtkJetFitting::FIT_INVALID) != 0, p == 17);
  }
}

TEST(MongeSmoothing, NamesMissingArrays)
{
  vtkNew<vtkMongeSmoothing> smoothing;
  MessageRecorder messages(smoothing);
  smoothing->SetInputData(EllipsoidData(4));
  smoothing->Update();
  ASSERT_EQ(messages.NumberOfErrors(), 1u);
  EXPECT_NE(messages.ErrorText().find("MaximumCurvature"), std::string::npos);
  EXPECT_TRUE(IsEmpty(smoothing->GetOutput()));

  // Second order is not enough to average all orders.
  smoothing->SetInputData(Fit(EllipsoidData(4)));
  smoothing->SetMethodToAllOrders();
  smoothing->Update();
  ASSERT_EQ(messages.NumberOfErrors(), 2u);
  EXPECT_NE(messages.ErrorText().find("ThirdOrder"), std::string::npos);
}

// A regular point is one of seven, whose average has this variance along an axis.
TEST(MongeSmoothing, StepsAreCountedInEdges)
{
  const auto data = EllipsoidData(24);
  const auto fitted = Fit(data, 4);
  fitted->GetPointData()->RemoveArray(names::FitScale);
  vtkNew<vtkMongeSmoothing> smoothing;
  smoothing->SetInputData(fitted);
  smoothing->SetMethodToAllOrders();
  double before = 0.0;
  for (const int steps : { 4, 16 })
  {
    smoothing->SetNumberOfSteps(steps);
    smoothing->Update();
    vtkDataArray* scale = smoothing->GetOutput()->GetPointData()->GetArray(names::FitScale);
    const double now = scale->GetTuple1(data->GetNumberOfPoints() / 2);
    if (before > 0.0)
    {
      EXPECT_NEAR(now, 2.0 * before, 1e-12);
    }
    before = now;
  }
  // Edges are of different lengths here: 0.03 to 0.06.
  EXPECT_GT(before, 2.5 * 0.02 * std::sqrt(16 * 3.0 / 7.0));
  EXPECT_LT(before, 2.5 * 0.08 * std::sqrt(16 * 3.0 / 7.0));
  smoothing->SetNumberOfSteps(-1);
  EXPECT_EQ(smoothing->GetNumberOfSteps(), 0);
}

TEST(MongeSmoothing, NothingComesOfNothing)
{
  vtkNew<vtkPolyData> empty;
  vtkNew<vtkMongeSmoothing> smoothing;
  MessageRecorder messages(smoothing);
  smoothing->SetInputData(empty);
  smoothing->Update();
  EXPECT_EQ(messages.ErrorText(), "");
  EXPECT_TRUE(IsEmpty(smoothing->GetOutput()));
}

TEST(MongeSmoothing, StopsWhereTheScaleIsOutOfReach)
{
  const auto fitted = Fit(EllipsoidData(6));
  vtkNew<vtkMongeSmoothing> smoothing;
  const MessageRecorder messages(smoothing);
  smoothing->SetInputData(fitted);
  smoothing->SetSigma(1e30);
  smoothing->Update();
  EXPECT_EQ(messages.NumberOfWarnings(), 1u);
  EXPECT_NE(messages.WarningText().find("out of reach"), std::string::npos);
  vtkDataArray* scale = smoothing->GetOutput()->GetPointData()->GetArray(names::FitScale);
  for (vtkIdType p = 0; p < scale->GetNumberOfTuples(); ++p)
  {
    EXPECT_LT(scale->GetTuple1(p), 1e3);
    EXPECT_GT(scale->GetTuple1(p), 1.0);
  }
}
