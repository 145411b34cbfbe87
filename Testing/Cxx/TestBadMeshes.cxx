// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Faulty meshes through the whole pipeline: flagged, counted and told in one warning; the rest is
// computed, and nothing is ever NaN.

#include "FilterTestTools.h"
#include "RidgeGraph.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRidgesArrayNames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

/// All arrays of all outputs; the positions of the mesh itself are the user's.
void ExpectFiniteArrays(const Outputs& outputs)
{
  for (vtkPolyData* mesh : { outputs.fitted.GetPointer(), outputs.marked.GetPointer() })
  {
    const auto arrays = vtkSmartPointer<vtkPolyData>::New();
    arrays->ShallowCopy(mesh);
    arrays->SetPoints(nullptr);
    ExpectAllFinite(arrays);
  }
  ExpectAllFinite(outputs.umbilics);
  ExpectAllFinite(outputs.ridges);
  EXPECT_EQ(outputs.errors, "");
}

int StatusAt(const Outputs& outputs, vtkIdType point)
{
  return static_cast<int>(Value(outputs.fitted->GetPointData(), names::FitStatus, point));
}

vtkIdType CountStatus(const Outputs& outputs, int bit)
{
  vtkIdType count = 0;
  for (vtkIdType p = 0; p < outputs.fitted->GetNumberOfPoints(); ++p)
  {
    count += StatusAt(outputs, p) & bit ? 1 : 0;
  }
  return count;
}

bool Says(const Outputs& outputs, const std::string& text)
{
  return outputs.warnings.find(text) != std::string::npos;
}

/// Warnings of all three filters together.
int NumberOfWarnings(const Outputs& outputs)
{
  int count = 0;
  for (std::size_t at = outputs.warnings.find("Warning:"); at != std::string::npos;
       at = outputs.warnings.find("Warning:", at + 1))
  {
    ++count;
  }
  return count;
}

constexpr int Invalid = vtkJetFitting::FIT_INVALID;
constexpr int TooFew = vtkJetFitting::FIT_TOO_FEW_POINTS;
constexpr int Boundary = vtkJetFitting::FIT_BOUNDARY;

} // namespace

TEST(BadMeshes, IsolatedPointIsFlaggedAndChangesNothingElse)
{
  Mesh mesh = ToMesh(EllipsoidData(12));
  const Outputs expected = RunFilters(ToPolyData(mesh));
  const auto isolated = static_cast<vtkIdType>(mesh.PointCount());
  mesh.AddPoint({ 50.0, 0.0, 0.0 });
  const Outputs outputs = RunFilters(ToPolyData(mesh));
  EXPECT_TRUE(StatusAt(outputs, isolated) & Invalid);
  EXPECT_EQ(CountStatus(outputs, Invalid), 1);
  EXPECT_TRUE(Says(outputs, "1 points have no fit")) << outputs.warnings;
  EXPECT_EQ(NumberOfWarnings(outputs), 1);
  EXPECT_EQ(Value(outputs.fitted->GetPointData(), names::P1, isolated), 0.0);
  EXPECT_EQ(FirstDifference(outputs.ridges, expected.ridges), "");
  EXPECT_EQ(FirstDifference(outputs.umbilics, expected.umbilics), "");
}

TEST(BadMeshes, LeavesOutNonFiniteCoordinates)
{
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() })
  {
    const auto mesh = EllipsoidData(12);
    mesh->GetPoints()->SetPoint(77, 0.1, bad, 0.2);
    const Outputs outputs = RunFilters(mesh);
    EXPECT_TRUE(StatusAt(outputs, 77) & Invalid);
    EXPECT_EQ(CountStatus(outputs, Invalid), 1);
    EXPECT_TRUE(Says(outputs, "6 triangles were left out")) << outputs.warnings;
    EXPECT_EQ(NumberOfWarnings(outputs), 1) << outputs.warnings;
    ExpectFiniteArrays(outputs);
    ExpectCompleteRidgeGraph(outputs.marked, outputs.ridges);
  }
}

TEST(BadMeshes, HugeCoordinatesGiveNoNaN)
{
  for (const double scale : { 1e150, 1e300, 1e-150, 1e-300 })
  {
    const Mesh mesh = Transform(
      ToMesh(EllipsoidData(8)), Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero(), scale);
    ExpectFiniteArrays(RunFilters(ToPolyData(mesh)));
  }
}

TEST(BadMeshes, TrianglesWithARepeatedCornerAreLeftOut)
{
  Mesh mesh = ToMesh(EllipsoidData(12));
  const Outputs expected = RunFilters(ToPolyData(mesh));
  mesh.AddTriangle(3, 3, 9);
  mesh.AddTriangle(5, 5, 5);
  const Outputs outputs = RunFilters(ToPolyData(mesh));
  EXPECT_TRUE(Says(outputs, "2 triangles were left out (a repeated corner")) << outputs.warnings;
  EXPECT_EQ(NumberOfWarnings(outputs), 1);
  EXPECT_EQ(FirstDifference(outputs.ridges, expected.ridges), "");
  EXPECT_EQ(outputs.fitted->GetNumberOfPolys(), 20 * 12 * 12 + 2);
  EXPECT_EQ(Value(outputs.marked->GetCellData(), names::UmbilicPatch, 20 * 12 * 12), -1.0);
}

// Slivers of no area: three different points on a line.
TEST(BadMeshes, AcceptsTrianglesWithoutArea)
{
  Mesh mesh;
  for (int j = 0; j <= 20; ++j)
  {
    const int even = j - j % 2;
    for (int i = 0; i <= 20; ++i)
    {
      mesh.AddPoint({ 0.1 * i, 0.1 * even, 0.1 * std::sin(0.3 * i) });
    }
  }
  for (int j = 0; j < 20; ++j)
  {
    for (int i = 0; i < 20; ++i)
    {
      const int p = 21 * j + i;
      mesh.AddTriangle(p, p + 1, p + 22);
      mesh.AddTriangle(p, p + 22, p + 21);
    }
  }
  const Outputs outputs = RunFilters(ToPolyData(mesh));
  ExpectFiniteArrays(outputs);
  ExpectJoinedPolylines(outputs.ridges);
}

TEST(BadMeshes, ReportsTriangleSoupWithItsRemedy)
{
  const Mesh mesh = ToMesh(EllipsoidData(6));
  Mesh soup;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
  {
    const auto first = static_cast<std::int32_t>(soup.PointCount());
    for (std::size_t j = 0; j < 3; ++j)
    {
      soup.AddPoint(mesh.Point(mesh.triangles[i + j]));
    }
    soup.AddTriangle(first, first + 1, first + 2);
  }
  const Outputs outputs = RunFilters(ToPolyData(soup));
  const auto points = static_cast<vtkIdType>(soup.PointCount());
  EXPECT_EQ(CountStatus(outputs, Invalid), points);
  EXPECT_EQ(CountStatus(outputs, TooFew), points);
  const auto extra = soup.PointCount() - mesh.PointCount();
  EXPECT_TRUE(Says(outputs, std::to_string(extra) + " points coincide with another"))
    << outputs.warnings;
  EXPECT_TRUE(Says(outputs, "vtkStaticCleanPolyData"));
  EXPECT_EQ(NumberOfWarnings(outputs), 1);
  EXPECT_TRUE(IsEmpty(outputs.ridges));
  ExpectFiniteArrays(outputs);
}

TEST(BadMeshes, DuplicatePointOfAFanGivesNoNaN)
{
  Mesh mesh = ToMesh(EllipsoidData(12));
  mesh.SetPoint(50, mesh.Point(static_cast<std::size_t>(mesh.triangles[0])));
  ExpectFiniteArrays(RunFilters(ToPolyData(mesh)));
}

TEST(BadMeshes, TreatsNonManifoldEdgesAsBordersAndReportsThemOnce)
{
  Mesh mesh = ToMesh(EllipsoidData(12));
  const std::int32_t p = mesh.triangles[0];
  const std::int32_t q = mesh.triangles[1];
  mesh.AddPoint({ 3.0, 3.0, 3.0 });
  mesh.AddTriangle(p, q, static_cast<std::int32_t>(mesh.PointCount()) - 1);
  const Outputs outputs = RunFilters(ToPolyData(mesh));
  EXPECT_TRUE(Says(outputs, "1 edges with more than two triangles")) << outputs.warnings;
  EXPECT_EQ(NumberOfWarnings(outputs), 1);
  EXPECT_TRUE(StatusAt(outputs, p) & Boundary);
  EXPECT_TRUE(StatusAt(outputs, q) & Boundary);
  EXPECT_EQ(CountStatus(outputs, Boundary), 3);
  ExpectFiniteArrays(outputs);
  ExpectCompleteRidgeGraph(outputs.marked, outputs.ridges);
}

TEST(BadMeshes, ASingleTriangleHasNoFit)
{
  const auto mesh = MakePolyData({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } });
  const Outputs outputs = RunFilters(mesh);
  for (vtkIdType p = 0; p < 3; ++p)
  {
    EXPECT_EQ(StatusAt(outputs, p), Boundary | TooFew | Invalid);
  }
  ExpectFiniteArrays(outputs);
  EXPECT_TRUE(IsEmpty(outputs.ridges));
  EXPECT_TRUE(IsEmpty(outputs.umbilics));
}

TEST(BadMeshes, ATetrahedronHasTooFewPoints)
{
  const auto mesh = MakePolyData({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } });
  const Outputs outputs = RunFilters(mesh);
  EXPECT_EQ(CountStatus(outputs, TooFew), 4);
  EXPECT_EQ(CountStatus(outputs, Boundary), 0);
  ExpectFiniteArrays(outputs);
  EXPECT_TRUE(IsEmpty(outputs.ridges));
}

TEST(BadMeshes, PointsAllInOnePlaceOrOnALineHaveNoFit)
{
  Mesh mesh = Icosphere(4);
  for (const bool coincident : { true, false })
  {
    for (std::size_t p = 0; p < mesh.PointCount(); ++p)
    {
      const double x = coincident ? 0.3 : std::sin(static_cast<double>(p));
      mesh.SetPoint(p, { x, 2.0 * x, -x });
    }
    const Outputs outputs = RunFilters(ToPolyData(mesh));
    EXPECT_EQ(CountStatus(outputs, Invalid), outputs.fitted->GetNumberOfPoints()) << coincident;
    EXPECT_EQ(NumberOfWarnings(outputs), 1);
    ExpectFiniteArrays(outputs);
    EXPECT_TRUE(IsEmpty(outputs.ridges));
  }
}

TEST(BadMeshes, OppositeOrientationsAreCountedInOneWarning)
{
  Mesh mesh = ToMesh(EllipsoidData(12));
  std::swap(mesh.triangles[3 * 100], mesh.triangles[3 * 100 + 1]);
  std::swap(mesh.triangles[3 * 900], mesh.triangles[3 * 900 + 1]);
  const Outputs outputs = RunFilters(ToPolyData(mesh));
  EXPECT_TRUE(Says(outputs, "6 edges lie between triangles of opposite orientation"))
    << outputs.warnings;
  EXPECT_EQ(NumberOfWarnings(outputs), 1);
  ExpectFiniteArrays(outputs);
  ExpectCompleteRidgeGraph(outputs.marked, outputs.ridges);
}

TEST(BadMeshes, RandomOrientationsGiveNoNaN)
{
  Mesh mesh = ToMesh(BlendData(12));
  for (std::size_t t = 0; t < mesh.TriangleCount(); t += 2)
  {
    std::swap(mesh.triangles[3 * t], mesh.triangles[3 * t + 1]);
  }
  const Outputs outputs = RunFilters(ToPolyData(mesh));
  ExpectFiniteArrays(outputs);
  ExpectCompleteRidgeGraph(outputs.marked, outputs.ridges);
}

TEST(BadMeshes, PlaneAndSphereHaveNoNaN)
{
  const auto flat = [](double, double) { return 0.0; };
  ExpectFiniteArrays(RunFilters(ToPolyData(GraphPatch(flat, 1.0, 12))));
  ExpectFiniteArrays(RunFilters(ToPolyData(GraphPatch(flat, 1.0, 12, 0.2, 3))));
  ExpectFiniteArrays(RunFilters(ToPolyData(Icosphere(12))));
}

TEST(BadMeshes, PassesPointsWithoutTriangles)
{
  const auto mesh = MakePolyData({ { 0, 0, 0 }, { 1, 0, 0 } }, {});
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 0, 1 });
  mesh->SetVerts(verts);
  const Outputs outputs = RunFilters(mesh);
  EXPECT_EQ(outputs.fitted->GetNumberOfVerts(), 1);
  EXPECT_EQ(CountStatus(outputs, Invalid), 2);
  ExpectFiniteArrays(outputs);
  EXPECT_TRUE(IsEmpty(outputs.ridges));
}
