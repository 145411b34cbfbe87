// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "EllipsoidRidges.h"
#include "FilterTestTools.h"
#include "MessageRecorder.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRidgesArrayNames.h"
#include "vtkUmbilicDetection.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <vector>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

std::map<double, int> CountByIndex(vtkPolyData* umbilics)
{
  std::map<double, int> counts;
  for (vtkIdType i = 0; i < umbilics->GetNumberOfPoints(); ++i)
  {
    ++counts[Value(umbilics->GetPointData(), names::Index, i)];
  }
  return counts;
}

void ExpectUmbilicsOfEllipsoid(int frequency)
{
  const auto mesh = EllipsoidData(frequency);
  const Outputs outputs = RunFilters(mesh);
  vtkPointData* data = outputs.umbilics->GetPointData();
  ASSERT_EQ(outputs.umbilics->GetNumberOfPoints(), 4);
  const double edge = MeanEdgeLength(ToMesh(mesh));
  std::set<int> found;
  for (vtkIdType i = 0; i < 4; ++i)
  {
    EXPECT_EQ(Value(data, names::Index, i), 0.5);
    EXPECT_EQ(Value(data, names::RidgeCount, i), 1.0);
    EXPECT_EQ(Value(data, names::ThirdOrderIndex, i), 1.0);
    const auto exact = EllipsoidUmbilics(1.4, 1.0, 0.6);
    for (int j = 0; j < 4; ++j)
    {
      if ((PointAt(outputs.umbilics, i) - exact[j]).norm() < edge)
      {
        found.insert(j);
      }
    }
  }
  EXPECT_EQ(found.size(), 4u);
  EXPECT_EQ(Value(outputs.marked->GetFieldData(), names::UmbilicIndexSum, 0), 2.0);
  EXPECT_EQ(Value(outputs.marked->GetFieldData(), names::EulerCharacteristic, 0), 2.0);
}

} // namespace

TEST(UmbilicDetectionFilter, FindsTheFourOfTheEllipsoid)
{
  ExpectUmbilicsOfEllipsoid(32);
}

TEST(UmbilicDetectionFilter, FindsTheFourOfTheEllipsoidOnAFinerMesh)
{
  ExpectUmbilicsOfEllipsoid(63);
}

TEST(UmbilicDetectionFilter, FindsSixAndTwoOnTheBlendForAllUsualPatchSizes)
{
  vtkNew<vtkJetFitting> jets;
  jets->SetInputData(BlendData(63));
  vtkNew<vtkUmbilicDetection> detection;
  detection->SetInputConnection(jets->GetOutputPort());
  for (const double size : { 2.0, 3.0, 4.0 })
  {
    detection->SetPatchSize(size);
    detection->Update();
    const std::map<double, int> expected = { { -0.5, 2 }, { 0.5, 6 } };
    EXPECT_EQ(CountByIndex(detection->GetOutput(1)), expected) << size;
    EXPECT_EQ(Value(detection->GetOutput(0)->GetFieldData(), names::UmbilicIndexSum, 0), 2.0);
  }
}

TEST(UmbilicDetectionFilter, OutputsTheDocumentedArrays)
{
  const auto mesh = BlendData(32);
  const Outputs outputs = RunFilters(mesh);
  const vtkIdType n = outputs.umbilics->GetNumberOfPoints();
  ASSERT_GT(n, 0);
  EXPECT_EQ(outputs.umbilics->GetNumberOfVerts(), n);
  EXPECT_EQ(outputs.umbilics->GetNumberOfCells(), n);
  EXPECT_EQ(outputs.umbilics->GetPoints()->GetDataType(), VTK_DOUBLE);
  vtkPointData* data = outputs.umbilics->GetPointData();
  EXPECT_EQ(data->GetNumberOfArrays(), 8);
  ExpectArray(data, names::UmbilicId, VTK_ID_TYPE, 1, n);
  ExpectArray(data, names::Index, VTK_DOUBLE, 1, n);
  ExpectArray(data, names::RidgeCount, VTK_INT, 1, n);
  ExpectArray(data, names::ThirdOrderIndex, VTK_INT, 1, n);
  ExpectArray(data, names::Triangle, VTK_ID_TYPE, 1, n);
  ExpectArray(data, names::Pattern, VTK_INT, 1, n);
  ExpectArray(data, names::TouchesBorder, VTK_INT, 1, n);
  ExpectArray(data, names::NearBorder, VTK_INT, 1, n);

  vtkCellData* cells = outputs.marked->GetCellData();
  ExpectArray(cells, names::UmbilicPatch, VTK_ID_TYPE, 1, mesh->GetNumberOfCells());
  ExpectArray(cells, names::CancelledUmbilics, VTK_ID_TYPE, 1, mesh->GetNumberOfCells());
  ExpectArray(cells, names::UmbilicZone, VTK_ID_TYPE, 1, mesh->GetNumberOfCells());
  vtkFieldData* field = outputs.marked->GetFieldData();
  ExpectArray(field, names::UmbilicTriangle, VTK_ID_TYPE, 1, n);
  ExpectArray(field, names::NumberOfCancelledRegions, VTK_INT, 1, 1);
  ExpectArray(field, names::NumberOfUmbilicZones, VTK_INT, 1, 1);
  ExpectArray(field, names::UmbilicPosition, VTK_DOUBLE, 3, n);
  ExpectArray(field, names::UmbilicIndex, VTK_DOUBLE, 1, n);
  ExpectArray(field, names::UmbilicRidgeCount, VTK_INT, 1, n);
  ExpectArray(field, names::UmbilicIndexSum, VTK_DOUBLE, 1, 1);
  ExpectArray(field, names::EulerCharacteristic, VTK_INT, 1, 1);
  double sum = 0.0;
  for (vtkIdType i = 0; i < n; ++i)
  {
    EXPECT_EQ(Value(data, names::UmbilicId, i), static_cast<double>(i));
    EXPECT_EQ(VectorAt(field, names::UmbilicPosition, i), PointAt(outputs.umbilics, i));
    EXPECT_EQ(Value(field, names::UmbilicIndex, i), Value(data, names::Index, i));
    EXPECT_EQ(Value(field, names::UmbilicRidgeCount, i), Value(data, names::RidgeCount, i));
    EXPECT_EQ(Value(field, names::UmbilicTriangle, i), Value(data, names::Triangle, i));
    const double index = Value(data, names::Index, i);
    EXPECT_TRUE(index == 0.5 || index == -0.5);
    const double count = Value(data, names::RidgeCount, i);
    EXPECT_TRUE(count == 1.0 || (count == 3.0 && index == -0.5)) << "3 ridges make a star";
    const double pattern = Value(data, names::Pattern, i);
    EXPECT_TRUE(index < 0.0 ? pattern == 3.0 : pattern == 1.0 || pattern == 2.0);
    EXPECT_EQ(Value(data, names::TouchesBorder, i), 0.0);
    EXPECT_EQ(Value(data, names::NearBorder, i), 0.0);
    sum += index;
  }
  EXPECT_EQ(Value(field, names::UmbilicIndexSum, 0), sum);
}

TEST(UmbilicDetectionFilter, AddsToTheMeshAndChangesNothingOnIt)
{
  const Outputs outputs = RunFilters(EllipsoidData(16), vtkJetFitting::BY_POINT_COUNT);
  const auto stripped = vtkSmartPointer<vtkPolyData>::New();
  stripped->DeepCopy(outputs.marked);
  for (const char* name : { names::UmbilicPatch, names::CancelledUmbilics, names::UmbilicZone })
  {
    stripped->GetCellData()->RemoveArray(name);
  }
  stripped->GetFieldData()->Initialize();
  EXPECT_EQ(FirstDifference(stripped, outputs.fitted), "");
}

TEST(UmbilicDetectionFilter, TriangleContainsThePosition)
{
  const Outputs outputs = RunFilters(BlendData(32));
  for (vtkIdType i = 0; i < outputs.umbilics->GetNumberOfPoints(); ++i)
  {
    const auto cell =
      static_cast<vtkIdType>(Value(outputs.umbilics->GetPointData(), names::Triangle, i));
    vtkNew<vtkIdList> corners;
    outputs.marked->GetCellPoints(cell, corners);
    ASSERT_EQ(corners->GetNumberOfIds(), 3);
    Eigen::Matrix3d points;
    for (int j = 0; j < 3; ++j)
    {
      points.col(j) = PointAt(outputs.marked, corners->GetId(j));
    }
    // Barycentric, as the planes of the triangles do not go through the origin, which is inside.
    const Eigen::Vector3d weights = points.inverse() * PointAt(outputs.umbilics, i);
    EXPECT_NEAR(weights.sum(), 1.0, 1e-10);
    EXPECT_GE(weights.minCoeff(), -1e-10);
    EXPECT_EQ(
      Value(outputs.marked->GetCellData(), names::UmbilicPatch, cell), static_cast<double>(i));
  }
}

TEST(UmbilicDetectionFilter, PatchesAreMarkedOnTheTrianglesBehindVertsAndLines)
{
  const auto plain = EllipsoidData(32);
  const auto mixed = vtkSmartPointer<vtkPolyData>::New();
  mixed->DeepCopy(plain);
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 3 });
  verts->InsertNextCell({ 4 });
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 10 });
  mixed->SetVerts(verts);
  mixed->SetLines(lines);
  const Outputs expected = RunFilters(plain);
  const Outputs outputs = RunFilters(mixed);
  ExpectArray(outputs.marked->GetCellData(), names::UmbilicPatch, VTK_ID_TYPE, 1,
    plain->GetNumberOfCells() + 3);
  for (vtkIdType cell = 0; cell < 3; ++cell)
  {
    EXPECT_EQ(Value(outputs.marked->GetCellData(), names::UmbilicPatch, cell), -1.0);
  }
  std::map<double, int> sizes;
  for (vtkIdType cell = 0; cell < plain->GetNumberOfCells(); ++cell)
  {
    const double id = Value(expected.marked->GetCellData(), names::UmbilicPatch, cell);
    EXPECT_EQ(Value(outputs.marked->GetCellData(), names::UmbilicPatch, cell + 3), id);
    ++sizes[id];
  }
  EXPECT_EQ(sizes.size(), 5u); // four patches and the rest
  for (vtkIdType i = 0; i < 4; ++i)
  {
    EXPECT_EQ(Value(outputs.umbilics->GetPointData(), names::Triangle, i),
      Value(expected.umbilics->GetPointData(), names::Triangle, i) + 3);
  }
  // But for the ids of cells, which are handed on.
  outputs.ridges->GetFieldData()->RemoveArray(names::UmbilicTriangle);
  expected.ridges->GetFieldData()->RemoveArray(names::UmbilicTriangle);
  EXPECT_EQ(FirstDifference(outputs.ridges, expected.ridges), "");
}

TEST(UmbilicDetectionFilter, IdsGoByXThenYThenZOfTheirTriangles)
{
  const Outputs outputs = RunFilters(BlendData(63));
  ASSERT_EQ(outputs.umbilics->GetNumberOfPoints(), 8);
  std::vector<std::vector<double>> centroids;
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < 8; ++i)
  {
    const double cell = Value(outputs.umbilics->GetPointData(), names::Triangle, i);
    outputs.marked->GetCellPoints(static_cast<vtkIdType>(cell), corners);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const vtkIdType p : *corners)
    {
      sum += PointAt(outputs.marked, p);
    }
    centroids.push_back({ sum[0], sum[1], sum[2] });
  }
  EXPECT_TRUE(std::is_sorted(centroids.begin(), centroids.end()));
}

TEST(UmbilicDetectionFilter, IdsOfMinimaGoByGrowingGapOfTheirPatches)
{
  vtkNew<vtkJetFitting> jets;
  jets->SetInputData(BlendData(63));
  vtkNew<vtkUmbilicDetection> detection;
  detection->SetInputConnection(jets->GetOutputPort());
  detection->SetMethodToMinima();
  detection->Update();
  vtkPolyData* marked = detection->GetOutput(0);
  ASSERT_EQ(detection->GetOutput(1)->GetNumberOfPoints(), 8);
  std::map<double, double> least;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < marked->GetNumberOfCells(); ++cell)
  {
    const double id = Value(marked->GetCellData(), names::UmbilicPatch, cell);
    marked->GetCellPoints(cell, corners);
    double gap = 0.0;
    for (const vtkIdType p : *corners)
    {
      gap += (Value(marked->GetPointData(), names::MaximumCurvature, p) -
               Value(marked->GetPointData(), names::MinimumCurvature, p)) /
        3.0;
    }
    least[id] = least.count(id) ? std::min(least[id], gap) : gap;
  }
  for (double id = 1.0; id < 8.0; ++id)
  {
    EXPECT_LE(least[id - 1.0], least[id]) << id;
  }
}

TEST(UmbilicDetectionFilter, SettersClampAndAllIsPrinted)
{
  vtkNew<vtkUmbilicDetection> detection;
  EXPECT_EQ(detection->GetPatchSize(), 2.0);
  detection->SetPatchSize(0.0);
  EXPECT_EQ(detection->GetPatchSize(), 1.0);
  detection->SetPatchSize(1e9);
  EXPECT_EQ(detection->GetPatchSize(), 100.0);
  detection->SetPatchSize(2.25);
  EXPECT_EQ(detection->GetMethod(), vtkUmbilicDetection::INDICES);
  detection->SetMethod(7);
  EXPECT_EQ(detection->GetMethod(), vtkUmbilicDetection::MINIMA);
  EXPECT_EQ(detection->GetSignificance(), 3.0);
  detection->SetSignificance(-1.0);
  EXPECT_EQ(detection->GetSignificance(), 0.0);
  detection->SetSignificance(1e9);
  EXPECT_EQ(detection->GetSignificance(), 100.0);
  std::ostringstream text;
  detection->Print(text);
  for (const char* line : { "PatchSize: 2.25", "Method: Minima", "Significance: 100" })
  {
    EXPECT_NE(text.str().find(line), std::string::npos) << line;
  }
}

TEST(UmbilicDetectionFilter, AcceptsAPatchOfTheWholeMesh)
{
  vtkNew<vtkJetFitting> jets;
  jets->SetInputData(EllipsoidData(6));
  vtkNew<vtkUmbilicDetection> detection;
  detection->SetInputConnection(jets->GetOutputPort());
  detection->SetPatchSize(100.0);
  detection->Update();
  EXPECT_EQ(detection->GetOutput(1)->GetNumberOfPoints(), 4);
  detection->SetMethodToMinima();
  detection->Update();
  EXPECT_LE(detection->GetOutput(1)->GetNumberOfPoints(), 1);
}
