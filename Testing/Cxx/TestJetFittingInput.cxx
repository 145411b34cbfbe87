// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// What vtkJetFitting makes of the different kinds of input.

#include "FilterTestTools.h"
#include "MessageRecorder.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRidgesArrayNames.h"
#include "vtkStripper.h"
#include "vtkTriangleFilter.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

struct Fitting
{
  explicit Fitting(vtkPolyData* mesh)
    : recorder(this->jets)
  {
    this->jets->SetInputData(mesh);
    this->jets->Update();
  }
  vtkPolyData* Output() { return this->jets->GetOutput(); }
  vtkPointData* Data() { return this->jets->GetOutput()->GetPointData(); }

  vtkNew<vtkJetFitting> jets;
  MessageRecorder recorder;
};

/// A smooth graph whose Monge form is known.
double Height(double x, double y)
{
  return 0.4 * x * x - 0.3 * y * y + 0.1 * x * x * x - 0.2 * x * y * y;
}

AnalyticSurface HeightSurface()
{
  return AnalyticSurface([](auto x, auto y, auto z)
    { return z - (0.4 * x * x - 0.3 * y * y + 0.1 * x * x * x - 0.2 * x * y * y); });
}

/// The graph as quadrilaterals of n by n cells.
vtkSmartPointer<vtkPolyData> QuadPatch(int n)
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::vector<vtkIdType>> quads;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      const double x = -0.5 + static_cast<double>(i) / n;
      const double y = -0.5 + static_cast<double>(j) / n;
      points.push_back({ x, y, Height(x, y) });
      if (i < n && j < n)
      {
        const vtkIdType p = j * (n + 1) + i;
        quads.push_back({ p, p + 1, p + n + 2, p + n + 1 });
      }
    }
  }
  return MakePolyData(points, quads);
}

double LargestCurvatureError(vtkPolyData* fitted)
{
  const AnalyticSurface surface = HeightSurface();
  double largest = 0.0;
  for (vtkIdType p = 0; p < fitted->GetNumberOfPoints(); ++p)
  {
    const ExactMonge exact = surface.Monge(PointAt(fitted, p));
    largest = std::max(
      { largest, std::abs(Value(fitted->GetPointData(), names::MaximumCurvature, p) - exact.k1),
        std::abs(Value(fitted->GetPointData(), names::MinimumCurvature, p) - exact.k2) });
  }
  return largest;
}

} // namespace

TEST(JetFittingInput, IsNotModified)
{
  const auto mesh = EllipsoidData(6);
  vtkNew<vtkIdTypeArray> cellIds;
  cellIds->SetName("Own");
  cellIds->SetNumberOfTuples(mesh->GetNumberOfCells());
  cellIds->Fill(7);
  mesh->GetCellData()->AddArray(cellIds);
  const std::string before = BytesOf(mesh);
  const Outputs outputs = RunFilters(mesh);
  EXPECT_TRUE(BytesOf(mesh) == before);
  EXPECT_EQ(mesh->GetPointData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(mesh->GetPointData()->GetNormals(), nullptr);
  EXPECT_EQ(mesh->GetFieldData()->GetNumberOfArrays(), 0);
  EXPECT_FALSE(outputs.fitted->GetCellData()->HasArray(names::UmbilicPatch));
  EXPECT_EQ(Value(outputs.marked->GetCellData(), "Own", 0), 7.0);
}

TEST(JetFittingInput, RemovesMarksOfAnEarlierUmbilicDetection)
{
  const Outputs first = RunFilters(EllipsoidData(6));
  ASSERT_GT(first.marked->GetFieldData()->GetNumberOfArrays(), 0);
  ASSERT_GT(first.marked->GetCellData()->GetNumberOfArrays(), 0);
  const Outputs again = RunFilters(first.marked, vtkJetFitting::BY_POINT_COUNT);
  EXPECT_EQ(again.fitted->GetFieldData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(again.fitted->GetCellData()->GetNumberOfArrays(), 0);
}

// Float coordinates move the points by 6e-8 of their size: b, a third difference over the edge
// length h = 0.11, changes by 6e-8 / h^3 times a factor of some tens.
TEST(JetFittingInput, FloatPointsGiveNearlyTheSameAsDoublePoints)
{
  const Mesh mesh = EllipsoidMesh(12, 1.4, 1.0, 0.6);
  Fitting exact(ToPolyData(mesh, VTK_DOUBLE));
  Fitting rounded(ToPolyData(mesh, VTK_FLOAT));
  double change = 0.0;
  double changeOfThird = 0.0;
  for (vtkIdType p = 0; p < exact.Output()->GetNumberOfPoints(); ++p)
  {
    change = std::max(change,
      std::abs(Value(exact.Data(), names::MaximumCurvature, p) -
        Value(rounded.Data(), names::MaximumCurvature, p)));
    changeOfThird = std::max(changeOfThird,
      std::abs(std::abs(Value(exact.Data(), names::ThirdOrder, p)) -
        std::abs(Value(rounded.Data(), names::ThirdOrder, p))));
  }
  EXPECT_GT(change, 0.0);
  EXPECT_LT(change, 1e-4);
  EXPECT_LT(changeOfThird, 1e-2);
  EXPECT_EQ(rounded.Output()->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(rounded.recorder.NumberOfWarnings(), 0u);
}

TEST(JetFittingInput, NormalsAreOnTheSideOfTheOrientation)
{
  const auto mesh = BlendData(10);
  Fitting fitting(mesh);
  const std::vector<Eigen::Vector3d> normals = PointNormals(ToMesh(mesh));
  for (std::size_t p = 0; p < normals.size(); ++p)
  {
    const auto id = static_cast<vtkIdType>(p);
    EXPECT_GT(VectorAt(fitting.Data(), names::Normals, id).dot(normals[p]), 0.8);
  }
}

TEST(JetFittingInput, FlippedOrientationSwapsAndNegatesTheCurvatures)
{
  const Mesh mesh = ToMesh(BlendData(10));
  Fitting outward(ToPolyData(mesh));
  Fitting inward(ToPolyData(Flip(mesh)));
  for (vtkIdType p = 0; p < outward.Output()->GetNumberOfPoints(); ++p)
  {
    const auto k1 = Value(outward.Data(), names::MaximumCurvature, p);
    const auto k2 = Value(outward.Data(), names::MinimumCurvature, p);
    // The same system solved in a turned frame: round-off times its condition number.
    const double tolerance = 1e-10 * (std::abs(k1) + std::abs(k2));
    EXPECT_NEAR(Value(inward.Data(), names::MaximumCurvature, p), -k2, tolerance);
    EXPECT_NEAR(Value(inward.Data(), names::MinimumCurvature, p), -k1, tolerance);
    const Eigen::Vector3d n = VectorAt(outward.Data(), names::Normals, p);
    EXPECT_NEAR(VectorAt(inward.Data(), names::Normals, p).dot(n), -1.0, 1e-12);
    const double P1 = Value(outward.Data(), names::P1, p);
    EXPECT_NEAR(Value(inward.Data(), names::P2, p), P1, 1e-6 * (std::abs(P1) + 1e3));
  }
}

TEST(JetFittingInput, KeepsAndIgnoresVertsAndLines)
{
  const auto plain = EllipsoidData(6);
  const auto mixed = vtkSmartPointer<vtkPolyData>::New();
  mixed->DeepCopy(plain);
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 3 });
  verts->InsertNextCell({ 4, 5 });
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 10, 20 });
  mixed->SetVerts(verts);
  mixed->SetLines(lines);
  Fitting expected(plain);
  Fitting fitting(mixed);
  EXPECT_EQ(fitting.recorder.NumberOfWarnings(), 0u);
  EXPECT_EQ(fitting.Output()->GetNumberOfVerts(), 2);
  EXPECT_EQ(fitting.Output()->GetNumberOfLines(), 1);
  EXPECT_EQ(fitting.Output()->GetNumberOfPolys(), plain->GetNumberOfPolys());
  fitting.Output()->SetVerts(nullptr);
  fitting.Output()->SetLines(nullptr);
  EXPECT_EQ(FirstDifference(fitting.Output(), expected.Output()), "");
}

TEST(JetFittingInput, QuadsAreTriangulatedWithOneWarning)
{
  Fitting fitting(QuadPatch(12));
  EXPECT_EQ(fitting.Output()->GetNumberOfPolys(), 2 * 12 * 12);
  EXPECT_EQ(fitting.recorder.NumberOfWarnings(), 1u);
  EXPECT_NE(fitting.recorder.WarningText().find("144 polygons or strips were triangulated"),
    std::string::npos);
  ExpectArray(fitting.Data(), names::ThirdOrder, VTK_DOUBLE, 4, 13 * 13);
}

// vtkTriangleFilter would cut the polyline into pieces.
TEST(JetFittingInput, PolylinesBesideQuadsAreKept)
{
  const auto mesh = QuadPatch(4);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 6, 12, 18 });
  lines->InsertNextCell({ 3, 2 });
  mesh->SetLines(lines);
  vtkNew<vtkIdTypeArray> own;
  own->SetName("Own");
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    own->InsertNextValue(100 + cell);
  }
  mesh->GetCellData()->AddArray(own);
  Fitting fitting(mesh);
  vtkNew<vtkIdList> ids;
  ASSERT_EQ(fitting.Output()->GetNumberOfLines(), 2);
  fitting.Output()->GetLines()->GetCellAtId(0, ids);
  EXPECT_EQ(ids->GetNumberOfIds(), 4);
  EXPECT_EQ(ids->GetId(3), 18);
  ASSERT_EQ(fitting.Output()->GetNumberOfCells(), 2 + 2 * 16);
  for (vtkIdType cell = 0; cell < fitting.Output()->GetNumberOfCells(); ++cell)
  {
    const vtkIdType from = cell < 2 ? cell : 2 + (cell - 2) / 2;
    EXPECT_EQ(Value(fitting.Output()->GetCellData(), "Own", cell), 100.0 + from);
  }
}

TEST(JetFittingInput, PolygonsAreCutAsByVtkTriangleFilter)
{
  const auto mesh = QuadPatch(6);
  mesh->GetPolys()->InsertNextCell({ 0, 1, 9, 15, 14 }); // not convex, nor planar
  vtkNew<vtkTriangleFilter> filter;
  filter->SetInputData(mesh);
  filter->Update();
  Fitting fitting(mesh);
  EXPECT_EQ(ToMesh(fitting.Output()).triangles, ToMesh(filter->GetOutput()).triangles);
}

TEST(JetFittingInput, PolygonsWithABadCornerLoseTheTrianglesThere)
{
  const auto mesh = QuadPatch(6);
  mesh->GetPolys()->InsertNextCell({ 0, 1, 8, 1000 });
  mesh->GetPolys()->InsertNextCell({ 0, 1, 8, -5 });
  mesh->GetPolys()->InsertNextCell({ 0, 1 });
  mesh->GetPoints()->SetPoint(48, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  Fitting fitting(mesh);
  EXPECT_EQ(fitting.recorder.NumberOfErrors(), 0u);
  EXPECT_NE(fitting.recorder.WarningText().find("5 triangles were left out"), std::string::npos)
    << fitting.recorder.WarningText();
  ExpectArray(fitting.Data(), names::ThirdOrder, VTK_DOUBLE, 4, 49);
}

TEST(JetFittingInput, StripsAreTriangulatedWithOneWarning)
{
  const auto mesh = EllipsoidData(8);
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(mesh);
  stripper->Update();
  const vtkIdType cells = stripper->GetOutput()->GetNumberOfStrips();
  ASSERT_GT(cells, 0);
  Fitting expected(mesh);
  Fitting fitting(stripper->GetOutput());
  EXPECT_EQ(fitting.recorder.NumberOfWarnings(), 1u);
  EXPECT_NE(fitting.recorder.WarningText().find(std::to_string(cells) + " polygons or strips"),
    std::string::npos);
  EXPECT_EQ(fitting.Output()->GetNumberOfPolys(), mesh->GetNumberOfPolys());
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    // The neighbourhoods, and the order they are summed in, do not depend on the cells' numbers.
    EXPECT_EQ(Value(fitting.Data(), names::MaximumCurvature, p),
      Value(expected.Data(), names::MaximumCurvature, p));
  }
}

TEST(JetFittingInput, BorderIsFlaggedAndRightOnASmoothPatch)
{
  const int n = 24;
  const auto mesh = ToPolyData(GraphPatch(Height, 0.5, n, 0.2, 5));
  Fitting fitting(mesh);
  EXPECT_EQ(fitting.recorder.NumberOfWarnings(), 0u) << fitting.recorder.WarningText();
  int flagged = 0;
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    const Eigen::Vector3d point = PointAt(mesh, p);
    const bool border = std::max(std::abs(point[0]), std::abs(point[1])) > 0.5 - 1e-9;
    EXPECT_EQ(Value(fitting.Data(), names::FitStatus, p), border ? vtkJetFitting::FIT_BOUNDARY : 0);
    flagged += border ? 1 : 0;
  }
  EXPECT_EQ(flagged, 4 * n);
  // Four times as fine, the error of k falls by 4^3 in the limit; a quarter of that has to be
  // there, as the points are jittered and which of them get another ring changes from mesh to mesh.
  Fitting finer(ToPolyData(GraphPatch(Height, 0.5, 4 * n, 0.2, 5)));
  const double error = LargestCurvatureError(fitting.Output());
  EXPECT_LT(error, 0.0015);
  EXPECT_LT(LargestCurvatureError(finer.Output()), error / 16.0);
}

// A border point of a regular grid sees one-sided neighbourhoods whose points lie in few straight
// rows: with too few rows the polynomial is not determined across them.
TEST(JetFittingInput, BorderOfARegularGridIsRight)
{
  for (const int n : { 12, 24, 48 })
  {
    Fitting fitting(ToPolyData(GraphPatch(Height, 0.5, n, 0.0)));
    EXPECT_LT(LargestCurvatureError(fitting.Output()), 0.05) << n; // of curvatures up to 1.2
  }
}

// Four rows of points at the border do not determine the polynomial across it. The fit has to
// notice whatever its axes are, and they depend on the orientation of the mesh. Noise of 1e-6, over
// neighbourhoods of a radius of 0.2, changes curvatures by some 1e-6 / 0.2^2 times 100.
TEST(JetFittingInput, BorderOfANoisyGridIsRightInAnyOrientation)
{
  const Mesh cylinder = AddNormalNoise(CylinderPatch(1.0, 3.0, 1.0, 30, 10), 1e-6, 3);
  for (int turn = 0; turn < 12; ++turn)
  {
    const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(0.5 * turn, Eigen::Vector3d(1.0, 0.3 * turn - 2.0, 0.5).normalized())
        .toRotationMatrix();
    Fitting fitting(ToPolyData(Transform(cylinder, rotation, Eigen::Vector3d::Zero())));
    EXPECT_EQ(fitting.recorder.WarningText(), "");
    for (vtkIdType p = 0; p < fitting.Output()->GetNumberOfPoints(); ++p)
    {
      ASSERT_NEAR(Value(fitting.Data(), names::MaximumCurvature, p), 0.0, 0.01) << turn << " " << p;
      ASSERT_NEAR(Value(fitting.Data(), names::MinimumCurvature, p), -1.0, 0.01)
        << turn << " " << p;
    }
  }
}
