// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Automatic scale, weights and standard errors of vtkJetFitting.

#include "AnalyticSurface.h"
#include "FilterTestTools.h"
#include "MessageRecorder.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkJetFitting.h"
#include "vtkMongeSmoothing.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRidgesArrayNames.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <sstream>
#include <string>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

const char* const ErrorNames[] = { names::MaximumCurvatureError, names::MinimumCurvatureError,
  names::ThirdOrderError, names::P1Error, names::P2Error };

vtkSmartPointer<vtkPolyData> Fit(vtkJetFitting* jets, vtkPolyData* mesh)
{
  jets->SetInputData(mesh);
  jets->Update();
  auto fitted = vtkSmartPointer<vtkPolyData>::New();
  fitted->ShallowCopy(jets->GetOutput());
  return fitted;
}

/// The number of rings that was chosen, 0 for none.
int SelectedRings(vtkPolyData* fitted)
{
  const char* name = names::SelectedNumberOfRings;
  return fitted->GetFieldData()->HasArray(name)
    ? static_cast<int>(Value(fitted->GetFieldData(), name, 0))
    : 0;
}

/// 4,002 points: as some 300 of them are tried, the sample is a part of them.
Mesh NoisyEllipsoid(double noiseInEdges)
{
  const Mesh mesh = EllipsoidMesh(20, 1.4, 1.0, 0.6);
  return AddNormalNoise(mesh, noiseInEdges * MeanEdgeLength(mesh), 11);
}

} // namespace

TEST(JetFittingScale, ChoosesMoreRingsTheMoreNoiseThereIs)
{
  vtkNew<vtkJetFitting> jets;
  jets->SetNeighborhoodToAutomatic();
  int rings = 2;
  for (const double noise : { 0.0, 1e-3, 0.05 })
  {
    const Mesh mesh = NoisyEllipsoid(noise);
    const auto fitted = Fit(jets, ToPolyData(mesh));
    // A lower degree may stand for a ring.
    EXPECT_GE(SelectedRings(fitted), rings - 1);
    rings = SelectedRings(fitted);
    const auto selected = [&fitted](const char* name)
    { return Value(fitted->GetFieldData(), name, 0); };
    if (noise == 0.0)
    {
      EXPECT_EQ(selected(names::SelectedNumberOfAverages), 0.0);
    }
    EXPECT_GE(selected(names::SelectedDegree), noise > 0.0 ? 4.0 : 6.0);
    EXPECT_NEAR(selected(names::EstimatedNoise), noise * MeanEdgeLength(mesh),
      noise > 0.0 ? 0.2 * noise * MeanEdgeLength(mesh) : 1e-6 * MeanEdgeLength(mesh));
    ExpectAllFinite(fitted);
  }
  EXPECT_GE(rings, 7);
  // Nothing is left over where none is chosen.
  const auto automatic = Fit(jets, EllipsoidData(4));
  jets->SetNeighborhoodToPointCount();
  EXPECT_EQ(SelectedRings(Fit(jets, automatic)), 0);
}

// Without noise a mean of the three fits that it names.
TEST(JetFittingScale, AutomaticBlendsTheFitsItSays)
{
  const auto mesh = ToPolyData(NoisyEllipsoid(0.0));
  vtkNew<vtkJetFitting> jets;
  jets->SetNeighborhoodToAutomatic();
  const auto automatic = Fit(jets, mesh);
  vtkFieldData* field = automatic->GetFieldData();
  EXPECT_EQ(Value(field, names::SelectedDegree, 0), 8.0);
  EXPECT_EQ(SelectedRings(automatic), 4);
  const std::string text =
    vtkStringArray::SafeDownCast(field->GetAbstractArray(names::SelectedFit))->GetValue(0);
  EXPECT_EQ(
    text, "degree 8 on 4 rings, for hardly any noise; blended with degree 6 on 3 and 4 on 2");
  jets->SetNeighborhoodToRings();
  std::vector<vtkSmartPointer<vtkPolyData>> fits;
  for (const int rings : { 2, 3, 4 })
  {
    jets->SetNumberOfRings(rings);
    jets->SetDegree(2 * rings);
    fits.push_back(Fit(jets, mesh));
  }
  const auto mean = [](vtkPolyData* fit, vtkIdType p)
  {
    vtkPointData* data = fit->GetPointData();
    return Value(data, names::MaximumCurvature, p) + Value(data, names::MinimumCurvature, p);
  };
  // Around the twelve points with five neighbours a ring more is needed for as many points.
  vtkIdType others = 0;
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    const auto [least, most] =
      std::minmax({ mean(fits[0], p), mean(fits[1], p), mean(fits[2], p) });
    // Normals of the fits differ by 1e-6 at most: of that the square.
    const double value = mean(automatic, p);
    others += value < least - 1e-10 || value > most + 1e-10 ? 1 : 0;
    EXPECT_EQ(Value(automatic->GetPointData(), names::FitStatus, p), 0.0);
  }
  EXPECT_LT(others, 100);
}

// The averages that may follow are those of vtkMongeSmoothing.
TEST(JetFittingScale, AutomaticFitsWhatItSays)
{
  for (const double noise : { 1e-4, 0.002 })
  {
    const auto mesh = ToPolyData(NoisyEllipsoid(noise));
    vtkNew<vtkJetFitting> jets;
    jets->SetNeighborhoodToAutomatic();
    const auto automatic = Fit(jets, mesh);
    jets->SetNeighborhoodToRings();
    jets->SetNumberOfRings(SelectedRings(automatic));
    jets->SetDegree(static_cast<int>(Value(automatic->GetFieldData(), names::SelectedDegree, 0)));
    vtkSmartPointer<vtkPolyData> expected = Fit(jets, mesh);
    const int averages =
      static_cast<int>(Value(automatic->GetFieldData(), names::SelectedNumberOfAverages, 0));
    if (averages > 0)
    {
      EXPECT_EQ(Value(automatic->GetPointData(), names::FitNoiseGain, 7),
        Value(expected->GetPointData(), names::FitNoiseGain, 7));
      vtkNew<vtkMongeSmoothing> smoothing;
      smoothing->SetMethodToAllOrders();
      smoothing->SetNumberOfSteps(averages);
      smoothing->SetInputData(expected);
      smoothing->Update();
      EXPECT_FALSE(smoothing->GetOutput()->GetPointData()->HasArray(names::FitNoiseGain));
      EXPECT_EQ(Value(automatic->GetPointData(), names::FitScale, 7),
        Value(expected->GetPointData(), names::FitScale, 7));
      expected = smoothing->GetOutput();
    }
    for (const char* name : { names::SelectedDegree, names::SelectedNumberOfRings,
           names::SelectedNumberOfAverages, names::EstimatedNoise, names::SelectedFit })
    {
      automatic->GetFieldData()->RemoveArray(name);
    }
    // Around the twelve points with five neighbours a ring more is needed for as many points.
    vtkIdType others = 0;
    for (vtkIdType p = 0; p < expected->GetNumberOfPoints(); ++p)
    {
      for (const char* name : { names::ThirdOrder, names::FourthOrder, names::P1 })
      {
        if (Value(automatic->GetPointData(), name, p) != Value(expected->GetPointData(), name, p))
        {
          ++others;
          break;
        }
      }
    }
    EXPECT_LT(others, 400);
  }
}

// The mean error of b0 and b3 without their signs, against those of all degrees and rings.
TEST(JetFittingScale, AutomaticIsNearlyAsGoodAsTheBestChoice)
{
  const AnalyticSurface surface = MakeEllipsoid(1.4, 1.0, 0.6);
  const Mesh clean = NoisyEllipsoid(0.0);
  const vtkIdType count = clean.PointCount();
  std::vector<ExactMonge> exact;
  for (vtkIdType p = 0; p < count; ++p)
  {
    exact.push_back(surface.Monge(clean.Point(p)));
  }
  const auto errorOf = [&exact, count](vtkPolyData* fitted)
  {
    double sum = 0.0;
    vtkPointData* data = fitted->GetPointData();
    for (vtkIdType p = 0; p < count; ++p)
    {
      for (const int i : { 0, 3 })
      {
        sum += std::abs(std::abs(Value(data, names::ThirdOrder, p, i)) - std::abs(exact[p].b[i]));
      }
    }
    return sum;
  };
  for (const double noise : { 0.0, 1e-4, 1e-3, 0.01 })
  {
    const auto mesh = ToPolyData(NoisyEllipsoid(noise));
    vtkNew<vtkJetFitting> jets;
    const MessageRecorder recorder(jets);
    jets->SetNeighborhoodToAutomatic();
    const double automatic = errorOf(Fit(jets, mesh));
    jets->SetNeighborhoodToRings();
    double least = std::numeric_limits<double>::infinity();
    for (const int degree : { 4, 6, 8 })
    {
      jets->SetDegree(degree);
      for (const int rings : { 2, 3, 4, 5, 6, 8, 10, 12 })
      {
        if (rings < degree / 2)
        {
          continue; // A lower degree would be fitted to so few points.
        }
        jets->SetNumberOfRings(rings);
        least = std::min(least, errorOf(Fit(jets, mesh)));
      }
    }
    std::printf("noise %g: %.2f of the least error\n", noise, automatic / least);
    // Without noise a blend, whose error is less than that of each of its fits.
    EXPECT_LE(automatic, (noise > 0.0 ? 1.5 : 0.9) * least) << noise;
  }
}

TEST(JetFittingScale, AutomaticAlwaysHasEnoughPoints)
{
  // Where an octahedron is refined, six points have four neighbours, and two rings 13 points.
  Mesh mesh;
  for (const double sign : { 1.0, -1.0 })
  {
    for (int i = 0; i < 3; ++i)
    {
      mesh.AddPoint(sign * Eigen::Vector3d::Unit(i));
    }
  }
  for (const auto& t : { std::array<int, 3>{ 0, 1, 2 }, { 1, 3, 2 }, { 3, 4, 2 }, { 4, 0, 2 },
         { 1, 0, 5 }, { 3, 1, 5 }, { 4, 3, 5 }, { 0, 4, 5 } })
  {
    mesh.AddTriangle(t[0], t[1], t[2]);
  }
  vtkNew<vtkJetFitting> jets;
  MessageRecorder recorder(jets);
  jets->SetNeighborhoodToAutomatic();
  const auto small = Fit(jets, ToPolyData(mesh));
  EXPECT_EQ(SelectedRings(small), 2);
  EXPECT_EQ(recorder.NumberOfErrors(), 0U);
  ExpectAllFinite(small);

  const auto fitted = Fit(jets, EllipsoidData(8));
  for (vtkIdType p = 0; p < fitted->GetNumberOfPoints(); ++p)
  {
    EXPECT_EQ(Value(fitted->GetPointData(), names::FitStatus, p), 0.0);
  }
}

TEST(JetFittingScale, AutomaticDoesNotDependOnTheNumbering)
{
  const Mesh mesh = NoisyEllipsoid(0.001);
  std::vector<std::int32_t> newToOld;
  const Mesh permuted = Permute(mesh, 3, &newToOld);
  vtkNew<vtkJetFitting> jets;
  jets->SetNeighborhoodToAutomatic();
  jets->StandardErrorsOn();
  jets->SetWeightingToGaussian();
  const auto expected = Fit(jets, ToPolyData(mesh));
  const auto actual = Fit(jets, ToPolyData(permuted));
  EXPECT_EQ(SelectedRings(actual), SelectedRings(expected));
  for (std::size_t p = 0; p < newToOld.size(); ++p)
  {
    const auto id = static_cast<vtkIdType>(p);
    for (const char* name : { names::P1, names::P1Error, names::FitScale })
    {
      ASSERT_EQ(Value(actual->GetPointData(), name, id),
        Value(expected->GetPointData(), name, newToOld[p]));
    }
  }
}

TEST(JetFittingScale, AutomaticDoesNotDependOnTheUnitOfLength)
{
  // Coarse, so that the surface folds over within some neighbourhoods.
  const vtkSmartPointer<vtkPolyData> mesh = BlendData(6);
  const auto choiceAt = [&mesh](double unit)
  {
    vtkNew<vtkPolyData> scaled;
    scaled->DeepCopy(mesh);
    for (vtkIdType p = 0; p < scaled->GetNumberOfPoints(); ++p)
    {
      const Eigen::Vector3d x = unit * PointAt(mesh, p);
      scaled->GetPoints()->SetPoint(p, x.data());
    }
    vtkNew<vtkJetFitting> jets;
    jets->SetInputData(scaled);
    jets->Update();
    vtkFieldData* field = jets->GetOutput()->GetFieldData();
    return vtkStringArray::SafeDownCast(field->GetAbstractArray(names::SelectedFit))->GetValue(0);
  };
  // Powers of two: not a digit changes.
  for (const double unit : { 1.0 / 64.0, 64.0, 4096.0 })
  {
    EXPECT_EQ(choiceAt(unit), choiceAt(1.0)) << unit;
  }
}

TEST(JetFittingScale, AutomaticAcceptsEmptyAndTinyInput)
{
  vtkNew<vtkJetFitting> jets;
  MessageRecorder recorder(jets);
  jets->SetNeighborhoodToAutomatic();
  jets->StandardErrorsOn();
  const auto empty = Fit(jets, vtkSmartPointer<vtkPolyData>::New());
  EXPECT_TRUE(IsEmpty(empty));
  EXPECT_EQ(SelectedRings(empty), 0);
  const auto triangle =
    Fit(jets, MakePolyData({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } }));
  EXPECT_EQ(recorder.NumberOfErrors(), 0U);
  ExpectAllFinite(triangle);
  EXPECT_EQ(Value(triangle->GetPointData(), names::FitScale, 0), 0.0);
  for (const char* name : ErrorNames)
  {
    EXPECT_EQ(Value(triangle->GetPointData(), name, 0), -1.0) << name;
  }
}

TEST(JetFittingScale, AutomaticCanBeAborted)
{
  vtkNew<vtkJetFitting> jets;
  jets->SetNeighborhoodToAutomatic();
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void*)
    {
      auto* algorithm = vtkAlgorithm::SafeDownCast(caller);
      if (algorithm->GetProgress() >= 0.3) // The trials are done.
      {
        algorithm->AbortExecuteOn();
      }
    });
  jets->AddObserver(vtkCommand::ProgressEvent, abort);
  EXPECT_TRUE(IsEmpty(Fit(jets, EllipsoidData(16))));
}

TEST(JetFittingScale, FitScaleIsTheRadiusOfTheNeighborhood)
{
  const auto mesh = EllipsoidData(16);
  vtkNew<vtkJetFitting> jets;
  jets->SetNeighborhoodToRadius();
  jets->SetRadius(0.3);
  const auto fitted = Fit(jets, mesh);
  ExpectArray(fitted->GetPointData(), names::FitScale, VTK_DOUBLE, 1, mesh->GetNumberOfPoints());
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    const Eigen::Vector3d center = PointAt(mesh, p);
    double farthest = 0.0;
    for (vtkIdType q = 0; q < mesh->GetNumberOfPoints(); ++q)
    {
      const double distance = (PointAt(mesh, q) - center).norm();
      farthest = distance <= 0.3 ? std::max(farthest, distance) : farthest;
    }
    EXPECT_NEAR(Value(fitted->GetPointData(), names::FitScale, p), farthest, 1e-14);
  }
}

TEST(JetFittingScale, ErrorsLeaveTheOtherArraysAsTheyAre)
{
  const auto mesh = ToPolyData(NoisyEllipsoid(0.01));
  vtkNew<vtkJetFitting> jets;
  const auto without = Fit(jets, mesh);
  jets->StandardErrorsOn();
  const auto with = Fit(jets, mesh);
  const vtkIdType count = mesh->GetNumberOfPoints();
  for (const char* name : ErrorNames)
  {
    EXPECT_FALSE(without->GetPointData()->HasArray(name)) << name;
    ExpectArray(
      with->GetPointData(), name, VTK_DOUBLE, name == names::ThirdOrderError ? 4 : 1, count);
    for (vtkIdType p = 0; p < count; ++p)
    {
      ASSERT_GT(Value(with->GetPointData(), name, p), 0.0) << name;
    }
    with->GetPointData()->RemoveArray(name);
  }
  EXPECT_EQ(FirstDifference(with, without), "");
}

// Half of a normal distribution is within 0.674 of its standard deviation.
TEST(JetFittingScale, StandardErrorsMatchTheErrorsOfCurvatures)
{
  const Mesh clean = EllipsoidMesh(20, 1.4, 1.0, 0.6);
  vtkNew<vtkJetFitting> jets;
  jets->SetNeighborhoodToRings();
  jets->SetNumberOfRings(3);
  const auto expected = Fit(jets, ToPolyData(clean));
  jets->StandardErrorsOn();
  for (const bool weighted : { false, true })
  {
    jets->SetWeighting(weighted ? vtkJetFitting::GAUSSIAN : vtkJetFitting::UNIFORM);
    const auto fitted = Fit(jets, ToPolyData(NoisyEllipsoid(0.01)));
    vtkIdType within = 0;
    for (vtkIdType p = 0; p < fitted->GetNumberOfPoints(); ++p)
    {
      const double off = std::abs(Value(fitted->GetPointData(), names::MaximumCurvature, p) -
        Value(expected->GetPointData(), names::MaximumCurvature, p));
      const double error = Value(fitted->GetPointData(), names::MaximumCurvatureError, p);
      within += off < 0.674 * error ? 1 : 0;
    }
    const double part = static_cast<double>(within) / fitted->GetNumberOfPoints();
    EXPECT_GT(part, 0.44);
    EXPECT_LT(part, 0.54);
  }
}

TEST(JetFittingScale, MongeOrderDecidesWhichErrorsThereAre)
{
  vtkNew<vtkJetFitting> jets;
  jets->StandardErrorsOn();
  for (int order = 4; order >= 1; --order)
  {
    // Fed with what the fit of higher order gave: nothing of that may stay.
    jets->SetMongeOrder(order);
    const auto fitted = Fit(jets, order == 4 ? EllipsoidData(6) : Fit(jets, EllipsoidData(6)));
    vtkPointData* data = fitted->GetPointData();
    EXPECT_EQ(data->HasArray(names::MaximumCurvatureError) != 0, order >= 2);
    EXPECT_EQ(data->HasArray(names::MinimumCurvatureError) != 0, order >= 2);
    EXPECT_EQ(data->HasArray(names::ThirdOrderError) != 0, order >= 3);
    EXPECT_EQ(data->HasArray(names::P1Error) != 0, order >= 4);
    EXPECT_EQ(data->HasArray(names::P2Error) != 0, order >= 4);
  }
  jets->SetMongeOrder(4);
  const auto first = Fit(jets, EllipsoidData(6));
  jets->StandardErrorsOff();
  const auto second = Fit(jets, first);
  for (const char* name : ErrorNames)
  {
    EXPECT_FALSE(second->GetPointData()->HasArray(name)) << name << " is stale";
  }
}

TEST(JetFittingScale, WeightsBringFitsNearerToThePoint)
{
  const AnalyticSurface surface = MakeEllipsoid(1.4, 1.0, 0.6);
  const auto mesh = EllipsoidData(16);
  const auto meanError = [&](int weighting)
  {
    vtkNew<vtkJetFitting> jets;
    jets->SetNeighborhoodToRings();
    jets->SetNumberOfRings(4);
    jets->SetWeighting(weighting);
    const auto fitted = Fit(jets, mesh);
    double sum = 0.0;
    for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
    {
      sum += std::abs(Value(fitted->GetPointData(), names::MaximumCurvature, p) -
        surface.Monge(PointAt(mesh, p)).k1);
    }
    return sum;
  };
  EXPECT_LT(meanError(vtkJetFitting::GAUSSIAN), 0.8 * meanError(vtkJetFitting::UNIFORM));
}

TEST(JetFittingScale, PropertiesHaveTheirDefaultsAndAreClampedAndPrinted)
{
  vtkNew<vtkJetFitting> jets;
  EXPECT_FALSE(jets->GetStandardErrors());
  EXPECT_EQ(jets->GetWeighting(), vtkJetFitting::UNIFORM);
  EXPECT_STREQ(jets->GetWeightingAsString(), "Uniform");
  jets->SetWeighting(9);
  EXPECT_EQ(jets->GetWeighting(), vtkJetFitting::GAUSSIAN);
  jets->SetNeighborhood(9);
  EXPECT_EQ(jets->GetNeighborhood(), vtkJetFitting::AUTOMATIC);
  jets->StandardErrorsOn();
  std::ostringstream text;
  jets->Print(text);
  for (const char* line :
    { "Neighborhood: Automatic", "Weighting: Gaussian", "StandardErrors: On" })
  {
    EXPECT_NE(text.str().find(line), std::string::npos) << line;
  }
  jets->SetWeightingToUniform();
  EXPECT_EQ(jets->GetWeighting(), vtkJetFitting::UNIFORM);
}
