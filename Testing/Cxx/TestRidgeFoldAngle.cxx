// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// FoldAngle of vtkRidgeExtraction against integrals on the surfaces themselves.

#include "EllipsoidRidges.h"
#include "ExactFolds.h"
#include "ExactRidges.h"
#include "FilterTestTools.h"
#include "ParallelFor.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRidgeExtraction.h"
#include "vtkRidgesArrayNames.h"
#include "vtkSMPTools.h"
#include "vtkUmbilicDetection.h"

#include "Mesh/EnclosingSphere.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <utility>
#include <vector>

namespace
{

using namespace ridges::testing;
using Eigen::Vector3d;
namespace names = vtkRidgesArrayNames;

constexpr double Degree = 0.017453292519943295;

/// The mesh with the exact Monge arrays of the surface.
vtkSmartPointer<vtkPolyData> WithExactArrays(
  vtkSmartPointer<vtkPolyData> mesh, const AnalyticSurface& surface)
{
  std::vector<ExactMonge> forms(mesh->GetNumberOfPoints());
  ParallelFor(forms.size(),
    [&forms, &mesh, &surface](std::size_t p)
    {
      Vector3d x;
      mesh->GetPoint(static_cast<vtkIdType>(p), x.data());
      forms[p] = surface.Monge(x);
    });
  const auto add = [&mesh, &forms](const char* name, int components, const auto& valuesOf)
  {
    AddPointArray(mesh, name, components,
      [&forms, &valuesOf, components](vtkIdType p, double* values)
      { std::copy_n(valuesOf(forms[p]), components, values); });
  };
  add(names::MaximumCurvature, 1, [](const ExactMonge& form) { return &form.k1; });
  add(names::MinimumCurvature, 1, [](const ExactMonge& form) { return &form.k2; });
  add(names::MaximumDirection, 3, [](const ExactMonge& form) { return form.d1.data(); });
  add(names::MinimumDirection, 3, [](const ExactMonge& form) { return form.d2.data(); });
  add(names::ThirdOrder, 4, [](const ExactMonge& form) { return form.b.data(); });
  add(names::FourthOrder, 5, [](const ExactMonge& form) { return form.c.data(); });
  return mesh;
}

vtkSmartPointer<vtkPolyData> Extract(vtkPolyData* mesh)
{
  vtkNew<vtkUmbilicDetection> umbilics;
  umbilics->SetInputData(mesh);
  vtkNew<vtkRidgeExtraction> ridges;
  ridges->SetInputConnection(umbilics->GetOutputPort());
  ridges->ComputeFoldAngleOn();
  ridges->Update();
  return ridges->GetOutput();
}

/// Points on edges inside the elliptic lines, each with whether it is on a maximum.
std::vector<std::pair<vtkIdType, bool>> EllipticPoints(vtkPolyData* lines)
{
  std::vector<std::pair<vtkIdType, bool>> points;
  for (vtkIdType i = 0; i < lines->GetNumberOfLines(); ++i)
  {
    const int type = static_cast<int>(Value(lines->GetCellData(), names::RidgeType, i));
    if (type == MaximumElliptic || type == MinimumElliptic)
    {
      vtkIdList* ids = lines->GetCell(i)->GetPointIds();
      for (vtkIdType j = 1; j + 1 < ids->GetNumberOfIds(); ++j)
      {
        points.emplace_back(ids->GetId(j), type == MaximumElliptic);
      }
    }
  }
  return points;
}

/// Errors of fold angles, relative to the truth, or to 5 degrees where that is less.
class Errors
{
public:
  void Add(double found, double truth)
  {
    this->All_.push_back(std::abs(found - truth) / std::max(truth, 5.0 * Degree));
  }
  std::size_t Count() const { return this->All_.size(); }
  double Mean() const
  {
    return std::accumulate(this->All_.begin(), this->All_.end(), 0.0) /
      static_cast<double>(this->All_.size());
  }
  double Largest() const { return *std::max_element(this->All_.begin(), this->All_.end()); }

  /// To see how they fall: a line of the test's output.
  void Print(const char* surface, vtkIdType points) const
  {
    std::printf("%s, %lld points: mean error %.5f, largest %.5f\n", surface,
      static_cast<long long>(points), this->Mean(), this->Largest());
  }

private:
  std::vector<double> All_;
};

constexpr double A = 1.4; // the ellipsoid of vtkRidgeExampleSource
constexpr double B = 1.0;
constexpr double C = 0.6;

/// Of the filter, in diameters.
constexpr double Reach = 0.25;

double FoundAt(vtkPolyData* lines, vtkIdType point)
{
  return Degree * Value(lines->GetPointData(), names::FoldAngle, point);
}

/// Of the red ridges. The blue ones fold inward nowhere, as k1 is negative: theirs must be 0.
Errors EllipsoidErrors(vtkPolyData* lines)
{
  Errors errors;
  const auto points = EllipticPoints(lines);
  const std::size_t stride = std::max<std::size_t>(1, points.size() / 200);
  for (std::size_t i = 0; i < points.size(); i += stride)
  {
    const auto [id, isMaximum] = points[i];
    if (isMaximum)
    {
      EXPECT_EQ(FoundAt(lines, id), 0.0);
    }
    else
    {
      errors.Add(
        FoundAt(lines, id), EllipsoidRimFold(A, B, C, PointAt(lines, id), Reach * 2.0 * A));
    }
  }
  return errors;
}

double DiameterOf(vtkPolyData* mesh)
{
  Eigen::Matrix3Xd points(3, mesh->GetNumberOfPoints());
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    mesh->GetPoint(p, points.col(p).data());
  }
  return 2.0 * ridges::SmallestEnclosingSphere(points).radius;
}

/// At points of the surface's own ridges nearest to some of the points found.
Errors BlendErrors(vtkPolyData* lines, double diameter)
{
  const AnalyticSurface surface = MakeBlend();
  const auto points = EllipticPoints(lines);
  const double reach = Reach * diameter;
  constexpr std::size_t count = 40;
  std::vector<double> truths(count, -1.0);
  const auto place = [&points](std::size_t i) { return points[i * points.size() / count]; };
  ParallelFor(count,
    [&surface, &lines, &place, &truths, reach](std::size_t i)
    {
      const auto [id, isMaximum] = place(i);
      constexpr double farthest = 0.02;
      const ExactRidgePoint exact =
        NearestRidgePoint(surface, isMaximum, surface.Project(PointAt(lines, id)), farthest);
      if (exact.found)
      {
        truths[i] = SurfaceFold(surface, isMaximum, exact.monge.origin, reach, reach / 100.0);
      }
    });
  Errors errors;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (truths[i] >= 0.0)
    {
      errors.Add(FoundAt(lines, place(i).first), truths[i]);
    }
  }
  return errors;
}

} // namespace

//------------------------------------------------------------------------------
TEST(ExactFolds, BothWaysOfIntegrationAgree)
{
  for (const double t : { 0.1, 0.8, 1.5 })
  {
    const Vector3d point(A * std::cos(t), B * std::sin(t), 0.0);
    const double expected = EllipsoidRimFold(A, B, C, point, 0.6);
    // Trapezoids of 0.006 under a curvature that changes within about 0.3.
    EXPECT_NEAR(
      SurfaceFold(MakeEllipsoid(A, B, C), false, point, 0.6, 0.006), expected, 1e-3 * expected);
  }
}

// The values are exact at the points of the mesh and linear between them: the error is of second
// order in the length of edges, but of first order at the end of the reach, where the foot is.
TEST(RidgeFoldAngle, ConvergesOnTheEllipsoid)
{
  double coarser = 0.0;
  for (const int frequency : { 16, 32, 63 })
  {
    const auto mesh = WithExactArrays(EllipsoidData(frequency), MakeEllipsoid(A, B, C));
    const auto lines = Extract(mesh);
    const Errors errors = EllipsoidErrors(lines);
    errors.Print("ellipsoid", mesh->GetNumberOfPoints());
    EXPECT_GT(errors.Count(), 50u);
    EXPECT_TRUE(coarser == 0.0 || errors.Mean() < 0.6 * coarser) << frequency;
    coarser = errors.Mean();
    if (frequency == 63)
    {
      EXPECT_LT(errors.Largest(), 0.03);
    }
    EXPECT_EQ(Value(lines->GetFieldData(), names::NoiseFloor, 0), 0.0); // nothing was fitted
  }
}

TEST(RidgeFoldAngle, ConvergesOnTheBlend)
{
  double coarser = 0.0;
  for (const int frequency : { 32, 63 })
  {
    const auto mesh = WithExactArrays(BlendData(frequency), MakeBlend());
    const Errors errors = BlendErrors(Extract(mesh), DiameterOf(mesh));
    errors.Print("blend", mesh->GetNumberOfPoints());
    EXPECT_GT(errors.Count(), 30u);
    EXPECT_TRUE(coarser == 0.0 || errors.Mean() < 0.6 * coarser) << frequency;
    coarser = errors.Mean();
    if (frequency == 63)
    {
      EXPECT_LT(errors.Largest(), 0.03);
    }
  }
}

// Fits to 10,242 points, whose b has errors of some percent: the ridges lie beside the true ones.
TEST(RidgeFoldAngle, IsRightForFits)
{
  vtkNew<vtkJetFitting> jets;
  jets->SetInputData(EllipsoidData(32));
  jets->Update();
  const auto lines = Extract(jets->GetOutput());
  const Errors errors = EllipsoidErrors(lines);
  EXPECT_LT(errors.Mean(), 0.01);
  EXPECT_LT(errors.Largest(), 0.05);
  // What is left over there is no noise, but the part of the surface beyond degree four.
  const double floor = Value(lines->GetFieldData(), names::NoiseFloor, 0);
  EXPECT_GT(floor, 0.0);
  EXPECT_LT(floor, 0.1);
}

TEST(RidgeFoldAngle, IsStoredOnRequest)
{
  const auto mesh = RunFilters(EllipsoidData(16)).marked;
  vtkNew<vtkRidgeExtraction> ridges;
  EXPECT_FALSE(ridges->GetComputeFoldAngle());
  ridges->SetInputData(mesh);
  ridges->Update();
  vtkNew<vtkPolyData> without;
  without->DeepCopy(ridges->GetOutput());
  EXPECT_FALSE(without->GetPointData()->HasArray(names::FoldAngle));
  EXPECT_FALSE(without->GetFieldData()->HasArray(names::NoiseFloor));
  ridges->ComputeFoldAngleOn();
  ridges->Update();
  vtkPolyData* lines = ridges->GetOutput();
  const vtkIdType points = lines->GetNumberOfPoints();
  ExpectArray(lines->GetPointData(), names::FoldAngle, VTK_DOUBLE, 1, points);
  ExpectArray(lines->GetPointData(), names::FoldWidth, VTK_DOUBLE, 1, points);
  ExpectArray(lines->GetCellData(), names::FoldAngle, VTK_DOUBLE, 1, lines->GetNumberOfCells());
  ExpectArray(lines->GetFieldData(), names::NoiseFloor, VTK_DOUBLE, 1, 1);
  ExpectAllFinite(lines);
  // Hyperbolic lines have none, elliptic ones the largest of their points.
  for (vtkIdType i = 0; i < lines->GetNumberOfLines(); ++i)
  {
    const int type = static_cast<int>(Value(lines->GetCellData(), names::RidgeType, i));
    const bool isElliptic = type == MaximumElliptic || type == MinimumElliptic;
    double largest = 0.0;
    vtkIdList* ids = lines->GetCell(i)->GetPointIds();
    for (vtkIdType j = 0; isElliptic && j < ids->GetNumberOfIds(); ++j)
    {
      largest = std::max(largest, Value(lines->GetPointData(), names::FoldAngle, ids->GetId(j)));
    }
    EXPECT_EQ(Value(lines->GetCellData(), names::FoldAngle, i), largest);
  }
  // Nothing else changes.
  vtkNew<vtkPolyData> rest;
  rest->DeepCopy(lines);
  rest->GetPointData()->RemoveArray(names::FoldAngle);
  rest->GetPointData()->RemoveArray(names::FoldWidth);
  rest->GetCellData()->RemoveArray(names::FoldAngle);
  rest->GetFieldData()->RemoveArray(names::NoiseFloor);
  EXPECT_EQ(FirstDifference(without, rest), "");
}

// Everything that a walk can run into: borders, triangles without area, points without a fit, and
// directions that turn from point to point.
TEST(RidgeFoldAngle, IsFiniteOnBadMeshes)
{
  ridges::testing::Mesh bad =
    GraphPatch([](double x, double y) { return x * x * y; }, 1.0, 20, 0.2);
  bad.SetPoint(30, bad.Point(31)); // triangles without area
  const auto mesh = ToPolyData(bad);
  AddRandomMongeArrays(mesh, 7);
  const auto lines = Extract(mesh);
  EXPECT_GT(lines->GetNumberOfLines(), 0);
  ExpectAllFinite(lines);
}

TEST(RidgeFoldAngle, SameBytesForAnyNumberOfThreads)
{
  const auto mesh = RunFilters(EllipsoidData(24)).marked;
  vtkSMPTools::Initialize(1);
  const auto one = Extract(mesh);
  vtkSMPTools::Initialize(3);
  const auto three = Extract(mesh);
  vtkSMPTools::Initialize();
  EXPECT_EQ(FirstDifference(one, three), "");
}

TEST(RidgeFoldAngle, KeepsTheNoiseFloorOfTheMesh)
{
  const auto mesh = RunFilters(EllipsoidData(8)).marked;
  vtkNew<vtkDoubleArray> floor;
  floor->SetName(names::NoiseFloor);
  floor->InsertNextValue(0.25);
  mesh->GetFieldData()->AddArray(floor);
  EXPECT_EQ(Value(Extract(mesh)->GetFieldData(), names::NoiseFloor, 0), 0.25);
}
