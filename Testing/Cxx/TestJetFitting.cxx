// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Values and arrays of vtkJetFitting, against surfaces known in closed form.

#include "FilterTestTools.h"

#include "vtkDataArray.h"
#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRidgesArrayNames.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <sstream>
#include <vector>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

AnalyticSurface Ellipsoid()
{
  return MakeEllipsoid(1.4, 1.0, 0.6);
}

/// Largest errors over a mesh, where the frame is well determined; d and b up to half a turn.
struct MongeErrors
{
  double normal = 0.0;
  double curvature = 0.0;
  double direction = 0.0;
  double third = 0.0;
  double fourth = 0.0;
  double P = 0.0;
  int compared = 0;
};

MongeErrors CompareWithExact(vtkPolyData* fitted, const AnalyticSurface& surface)
{
  MongeErrors errors;
  const auto raise = [](double& largest, double error) { largest = std::max(largest, error); };
  vtkPointData* data = fitted->GetPointData();
  for (vtkIdType p = 0; p < fitted->GetNumberOfPoints(); ++p)
  {
    const ExactMonge exact = surface.Monge(PointAt(fitted, p));
    raise(errors.normal, (VectorAt(data, names::Normals, p) - exact.n).norm());
    raise(errors.curvature, std::abs(Value(data, names::MaximumCurvature, p) - exact.k1));
    raise(errors.curvature, std::abs(Value(data, names::MinimumCurvature, p) - exact.k2));
    if (exact.k1 - exact.k2 < 0.3) // near an umbilic the frame turns by any angle
    {
      continue;
    }
    ++errors.compared;
    const Eigen::Vector3d d1 = VectorAt(data, names::MaximumDirection, p);
    const Eigen::Vector3d d2 = VectorAt(data, names::MinimumDirection, p);
    const double sign = d1.dot(exact.d1) > 0.0 ? 1.0 : -1.0;
    raise(errors.direction, (d1 - sign * exact.d1).norm());
    raise(errors.direction, (d2 - sign * exact.d2).norm());
    for (int i = 0; i < 4; ++i)
    {
      raise(errors.third, std::abs(Value(data, names::ThirdOrder, p, i) - sign * exact.b[i]));
    }
    for (int i = 0; i < 5; ++i)
    {
      raise(errors.fourth, std::abs(Value(data, names::FourthOrder, p, i) - exact.c[i]));
    }
    raise(errors.P, std::abs(Value(data, names::P1, p) - exact.P1));
    raise(errors.P, std::abs(Value(data, names::P2, p) - exact.P2));
  }
  return errors;
}

vtkSmartPointer<vtkPolyData> Fit(vtkJetFitting* jets, vtkPolyData* mesh)
{
  jets->SetInputData(mesh);
  jets->Update();
  return jets->GetOutput();
}

vtkSmartPointer<vtkPolyData> Fit(vtkPolyData* mesh)
{
  vtkNew<vtkJetFitting> jets;
  jets->SetNeighborhoodToPointCount();
  return Fit(jets, mesh);
}

} // namespace

TEST(JetFitting, OutputsTheDocumentedArrays)
{
  const auto mesh = EllipsoidData(4);
  const vtkIdType n = mesh->GetNumberOfPoints();
  const auto fitted = Fit(mesh);
  vtkPointData* data = fitted->GetPointData();
  EXPECT_EQ(data->GetNumberOfArrays(), 14);
  for (const char* name : { names::MaximumCurvature, names::MinimumCurvature, names::P1, names::P2,
         names::FitConditionNumber, names::FitResidual, names::FitScale, names::FitNoiseGain })
  {
    ExpectArray(data, name, VTK_DOUBLE, 1, n);
  }
  for (const char* name : { names::MaximumDirection, names::MinimumDirection, names::Normals })
  {
    ExpectArray(data, name, VTK_DOUBLE, 3, n);
  }
  ExpectArray(data, names::ThirdOrder, VTK_DOUBLE, 4, n);
  ExpectArray(data, names::FourthOrder, VTK_DOUBLE, 5, n);
  ExpectArray(data, names::FitStatus, VTK_INT, 1, n);
  EXPECT_STREQ(data->GetNormals()->GetName(), names::Normals);
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_EQ(
      data->GetArray(names::ThirdOrder)->GetComponentName(i), std::string("b") + std::to_string(i));
  }
  for (int i = 0; i < 5; ++i)
  {
    EXPECT_EQ(data->GetArray(names::FourthOrder)->GetComponentName(i),
      std::string("c") + std::to_string(i));
  }
}

TEST(JetFitting, ArraysOutliveEachOtherAndTheFilter)
{
  // Large enough that small arrays share their memory, and that the largest do not.
  vtkSmartPointer<vtkDataArray> k1;
  vtkSmartPointer<vtkDataArray> fourth;
  std::vector<double> expected;
  {
    vtkNew<vtkJetFitting> jets;
    jets->SetNeighborhoodToPointCount();
    jets->SetInputData(EllipsoidData(110));
    jets->Update();
    vtkPointData* data = jets->GetOutput()->GetPointData();
    k1 = data->GetArray(names::MaximumCurvature);
    fourth = data->GetArray(names::FourthOrder);
    for (vtkIdType p = 0; p < k1->GetNumberOfTuples(); ++p)
    {
      expected.push_back(k1->GetTuple1(p));
    }
  }
  const auto count = static_cast<vtkIdType>(expected.size());
  k1->InsertNextTuple1(7.0);
  fourth->Resize(1);
  ASSERT_EQ(k1->GetNumberOfTuples(), count + 1);
  for (vtkIdType p = 0; p < count; ++p)
  {
    ASSERT_EQ(k1->GetTuple1(p), expected[p]);
  }
  EXPECT_EQ(k1->GetTuple1(count), 7.0);
  EXPECT_EQ(fourth->GetNumberOfTuples(), 1);
}

TEST(JetFitting, FramesAreDirectAndOrthonormalAndOrdered)
{
  const auto fitted = Fit(BlendData(12));
  vtkPointData* data = fitted->GetPointData();
  for (vtkIdType p = 0; p < fitted->GetNumberOfPoints(); ++p)
  {
    Eigen::Matrix3d frame;
    frame << VectorAt(data, names::MaximumDirection, p), VectorAt(data, names::MinimumDirection, p),
      VectorAt(data, names::Normals, p);
    // Round-off of a few operations on unit vectors.
    EXPECT_LT((frame.transpose() * frame - Eigen::Matrix3d::Identity()).norm(), 1e-13);
    EXPECT_GT(frame.determinant(), 0.0);
    EXPECT_GE(Value(data, names::MaximumCurvature, p), Value(data, names::MinimumCurvature, p));
  }
}

TEST(JetFitting, SphereHasMinusOneOverItsRadius)
{
  const double radius = 2.5;
  const auto fitted = Fit(ToPolyData(EllipsoidMesh(20, radius, radius, radius)));
  for (vtkIdType p = 0; p < fitted->GetNumberOfPoints(); ++p)
  {
    // Degree 4 leaves out x^6 / (16 r^5) in the height: with neighbours at 0.2 r the relative
    // error of k is of the order of 0.2^4 / 8 = 2e-4.
    for (const char* name : { names::MaximumCurvature, names::MinimumCurvature })
    {
      EXPECT_NEAR(Value(fitted->GetPointData(), name, p), -1.0 / radius, 2e-4 / radius);
    }
    EXPECT_EQ(Value(fitted->GetPointData(), names::FitStatus, p), 0.0);
  }
}

// With the edge length h the error of k falls as h^3 at least, that of b as h^2 and that of c as h;
// halving h has to bring out that factor up to a tenth of the order. The bounds at the fine end are
// twice what was found.
TEST(JetFitting, ConvergesToTheExactMongeFormOfTheEllipsoid)
{
  const AnalyticSurface surface = Ellipsoid();
  const MongeErrors coarse = CompareWithExact(Fit(EllipsoidData(32)), surface);
  const MongeErrors fine = CompareWithExact(Fit(EllipsoidData(64)), surface);
  EXPECT_GT(fine.compared, 35000);
  const auto order = [](double atCoarse, double atFine) { return std::log2(atCoarse / atFine); };
  EXPECT_GT(order(coarse.normal, fine.normal), 3.9);
  EXPECT_GT(order(coarse.curvature, fine.curvature), 2.9);
  EXPECT_GT(order(coarse.direction, fine.direction), 2.9);
  EXPECT_GT(order(coarse.third, fine.third), 1.9);
  EXPECT_GT(order(coarse.fourth, fine.fourth), 0.9);
  EXPECT_GT(order(coarse.P, fine.P), 0.9);
  EXPECT_LT(fine.normal, 2.2e-6);
  EXPECT_LT(fine.curvature, 6e-5);
  EXPECT_LT(fine.direction, 6e-5);
  EXPECT_LT(fine.third, 0.08);
  EXPECT_LT(fine.fourth, 1.5);
  EXPECT_LT(fine.P, 3.0);
}

TEST(JetFitting, DegreeAndMongeOrderDecideWhichArraysThereAre)
{
  const auto mesh = EllipsoidData(4);
  for (const int degree : { 1, 2, 3, 4, 5, 8 })
  {
    for (int mongeOrder = 1; mongeOrder <= 4; ++mongeOrder)
    {
      vtkNew<vtkJetFitting> jets;
      jets->SetNeighborhoodToPointCount();
      jets->SetDegree(degree);
      jets->SetMongeOrder(mongeOrder);
      const auto fitted = Fit(jets, mesh);
      vtkPointData* data = fitted->GetPointData();
      const int order = std::min(degree, mongeOrder);
      EXPECT_TRUE(data->HasArray(names::Normals));
      EXPECT_TRUE(data->HasArray(names::FitStatus));
      for (const char* name : { names::MaximumCurvature, names::MinimumCurvature,
             names::MaximumDirection, names::MinimumDirection })
      {
        EXPECT_EQ(data->HasArray(name) != 0, order >= 2) << name << " at " << order;
      }
      EXPECT_EQ(data->HasArray(names::ThirdOrder) != 0, order >= 3) << order;
      for (const char* name : { names::FourthOrder, names::P1, names::P2 })
      {
        EXPECT_EQ(data->HasArray(name) != 0, order >= 4) << name << " at " << order;
      }
    }
  }
}

TEST(JetFitting, ArraysOfALaterStageDoNotSurviveASecondFitOfLowerOrder)
{
  const auto first = Fit(EllipsoidData(4));
  vtkNew<vtkJetFitting> jets;
  jets->SetMongeOrder(2);
  const auto second = Fit(jets, first);
  for (const char* name : { names::ThirdOrder, names::FourthOrder, names::P1, names::P2 })
  {
    EXPECT_FALSE(second->GetPointData()->HasArray(name)) << name << " is stale";
  }
}

TEST(JetFitting, SettersClamp)
{
  vtkNew<vtkJetFitting> jets;
  EXPECT_EQ(jets->GetDegree(), 0);
  EXPECT_EQ(jets->GetMongeOrder(), 4);
  EXPECT_EQ(jets->GetNeighborhood(), vtkJetFitting::AUTOMATIC);
  EXPECT_EQ(jets->GetMinimumNumberOfPoints(), 18);
  jets->SetDegree(9);
  EXPECT_EQ(jets->GetDegree(), 8);
  jets->SetDegree(-1);
  EXPECT_EQ(jets->GetDegree(), 0);
  jets->SetMongeOrder(5);
  EXPECT_EQ(jets->GetMongeOrder(), 4);
  jets->SetMongeOrder(-1);
  EXPECT_EQ(jets->GetMongeOrder(), 1);
  jets->SetNeighborhood(7);
  EXPECT_EQ(jets->GetNeighborhood(), vtkJetFitting::AUTOMATIC);
  jets->SetNeighborhood(-7);
  EXPECT_EQ(jets->GetNeighborhood(), vtkJetFitting::BY_POINT_COUNT);
  jets->SetMinimumNumberOfPoints(0);
  EXPECT_EQ(jets->GetMinimumNumberOfPoints(), 3);
  jets->SetNumberOfRings(0);
  EXPECT_EQ(jets->GetNumberOfRings(), 1);
  jets->SetNeighborhoodToRings();
  EXPECT_STREQ(jets->GetNeighborhoodAsString(), "Rings");
  jets->SetNeighborhoodToRadius();
  EXPECT_STREQ(jets->GetNeighborhoodAsString(), "Radius");
  jets->SetNeighborhoodToPointCount();
  EXPECT_STREQ(jets->GetNeighborhoodAsString(), "PointCount");
}

TEST(JetFitting, PrintsEveryProperty)
{
  vtkNew<vtkJetFitting> jets;
  jets->SetRadius(0.625);
  jets->SetNumberOfRings(17);
  jets->SetMinimumNumberOfPoints(41);
  jets->SetNeighborhoodToRings();
  std::ostringstream text;
  jets->Print(text);
  for (const char* line : { "Degree: Automatic", "MongeOrder: 4", "Neighborhood: Rings",
         "MinimumNumberOfPoints: 41", "NumberOfRings: 17", "Radius: 0.625" })
  {
    EXPECT_NE(text.str().find(line), std::string::npos) << line;
  }
}

// Of three rings of edges 0.035 long the error of k is below 0.002; the ball of 0.15, twice as wide
// where triangles are small, has sixteen times as much (the error grows as its radius^4).
TEST(JetFitting, EveryKindOfNeighborhoodFits)
{
  const AnalyticSurface surface = Ellipsoid();
  const auto mesh = EllipsoidData(32);
  vtkNew<vtkJetFitting> jets;
  jets->SetNeighborhoodToRings();
  jets->SetNumberOfRings(3);
  const MongeErrors rings = CompareWithExact(Fit(jets, mesh), surface);
  jets->SetNeighborhoodToRadius();
  jets->SetRadius(0.15);
  const MongeErrors ball = CompareWithExact(Fit(jets, mesh), surface);
  jets->SetNeighborhoodToPointCount();
  jets->SetMinimumNumberOfPoints(37);
  const MongeErrors points = CompareWithExact(Fit(jets, mesh), surface);
  EXPECT_LT(rings.curvature, 0.002);
  EXPECT_LT(ball.curvature, 0.032);
  EXPECT_LT(points.curvature, 0.002);
}

TEST(JetFitting, UsesMorePointsThanCoefficients)
{
  vtkNew<vtkJetFitting> jets;
  jets->SetNeighborhoodToPointCount();
  jets->SetMinimumNumberOfPoints(3); // raised to the 15 coefficients of degree 4
  const auto fitted = Fit(jets, EllipsoidData(8));
  for (vtkIdType p = 0; p < fitted->GetNumberOfPoints(); ++p)
  {
    EXPECT_FALSE(static_cast<int>(Value(fitted->GetPointData(), names::FitStatus, p)) &
      vtkJetFitting::FIT_TOO_FEW_POINTS);
  }
}
