// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Each check of coherence finds what was tampered with, and tells where.

#include "CoherenceRows.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

/// An ellipsoid to tamper with: a copy for each test.
class Tampered : public ::testing::Test
{
protected:
  void SetUp() override
  {
    static const Outputs good = RunFilters(EllipsoidData(20));
    this->Marked = CopyOf(good.marked);
    this->Umbilics = CopyOf(good.umbilics);
    this->Ridges = CopyOf(good.ridges);
  }

  vtkSmartPointer<vtkTable> Table() { return Check(this->Marked, this->Ridges, this->Umbilics); }

  vtkIdType ValueOfLine(const char* name, vtkIdType line)
  {
    return static_cast<vtkIdType>(Value(this->Ridges->GetCellData(), name, line));
  }

  /// The first polyline of which this is true.
  vtkIdType FindLine(const std::function<bool(vtkIdType)>& isMeant)
  {
    for (vtkIdType line = 0; line < this->Ridges->GetNumberOfLines(); ++line)
    {
      if (isMeant(line))
      {
        return line;
      }
    }
    ADD_FAILURE() << "there is no such line";
    return 0;
  }

  vtkIdType LineOfLoop()
  {
    return this->FindLine(
      [this](vtkIdType line) { return this->ValueOfLine(names::Closed, line) == 1; });
  }

  std::vector<vtkIdType> PointsOf(vtkIdType line)
  {
    vtkNew<vtkIdList> ids;
    this->Ridges->GetLines()->GetCellAtId(line, ids);
    return { ids->begin(), ids->end() };
  }

  vtkIdType LineAtUmbilic()
  {
    return this->FindLine(
      [this](vtkIdType line)
      {
        return Value(this->Ridges->GetPointData(), names::Umbilic, this->PointsOf(line).front()) >=
          0.0;
      });
  }

  void RemoveLine(vtkIdType line)
  {
    this->Ridges->BuildCells();
    this->Ridges->DeleteCell(line);
    this->Ridges->RemoveDeletedCells();
  }

  vtkSmartPointer<vtkPolyData> Marked;
  vtkSmartPointer<vtkPolyData> Umbilics;
  vtkSmartPointer<vtkPolyData> Ridges;
};

} // namespace

TEST_F(Tampered, UntamperedResultPasses)
{
  EXPECT_EQ(Failed(this->Table()), "");
}

TEST_F(Tampered, WrongIndexReportsACellOfItsPart)
{
  this->Umbilics->GetPointData()->GetArray(names::Index)->SetComponent(0, 0, -0.5);
  const Row row = RowOf(this->Table(), "index sum");
  EXPECT_EQ(Failed(this->Table()), "index sum; ");
  EXPECT_EQ(row.found, "1");
  EXPECT_EQ(row.kind, "cell");
  EXPECT_EQ(row.offenders, "0");
  this->Umbilics->GetPointData()->GetArray(names::Index)->SetComponent(0, 0, 0.0);
  EXPECT_EQ(RowOf(this->Table(), "index sum").found, "3/2");
}

TEST_F(Tampered, ReportsAWrongRidgeCount)
{
  this->Umbilics->GetPointData()->GetArray(names::RidgeCount)->SetComponent(2, 0, 3);
  const auto table = this->Table();
  EXPECT_EQ(Failed(table), "ridges at umbilics; patch contours; ");
  for (const char* check : { "ridges at umbilics", "patch contours" })
  {
    const Row row = RowOf(table, check);
    EXPECT_EQ(row.kind, "umbilic");
    EXPECT_EQ(row.offenders, "2");
    EXPECT_EQ(row.position, PointAt(this->Umbilics, 2));
    EXPECT_NE(row.found.find("1 blue and 1 red instead of 3"), std::string::npos) << row.found;
  }
}

TEST_F(Tampered, MissingRidgeReportsItsUmbilicsAndEdges)
{
  const vtkIdType line = this->LineAtUmbilic();
  const std::string umbilic = std::to_string(static_cast<int>(
    Value(this->Ridges->GetPointData(), names::Umbilic, this->PointsOf(line).front())));
  const vtkIdType edges = static_cast<vtkIdType>(this->PointsOf(line).size()) - 2;
  this->RemoveLine(line);
  const auto table = this->Table();
  EXPECT_EQ(Failed(table), "ridges at umbilics; patch contours; crossings; ");
  EXPECT_NE(RowOf(table, "ridges at umbilics").offenders.find(umbilic), std::string::npos);
  EXPECT_EQ(RowOf(table, "ridges at umbilics").count, 2);
  EXPECT_EQ(RowOf(table, "crossings").kind, "edge");
  EXPECT_GT(RowOf(table, "crossings").count, edges / 2); // those in patches are not looked at
}

TEST_F(Tampered, MissingLoopReportsItsEdges)
{
  const vtkIdType line = this->LineOfLoop();
  const vtkIdType edges = static_cast<vtkIdType>(this->PointsOf(line).size()) - 1;
  this->RemoveLine(line);
  const auto table = this->Table();
  EXPECT_EQ(Failed(table), "crossings; ");
  EXPECT_EQ(RowOf(table, "crossings").count, edges);
}

TEST_F(Tampered, ShortenedRidgeEndsNowhere)
{
  const vtkIdType line = this->LineOfLoop();
  const std::vector<vtkIdType> points = this->PointsOf(line);
  vtkNew<vtkCellArray> lines;
  for (vtkIdType i = 0; i < this->Ridges->GetNumberOfLines(); ++i)
  {
    const std::vector<vtkIdType> ids = this->PointsOf(i);
    lines->InsertNextCell(static_cast<vtkIdType>(ids.size()) - (i == line ? 10 : 0), ids.data());
  }
  this->Ridges->SetLines(lines);
  const auto table = this->Table();
  const Row row = RowOf(table, "ridge ends");
  EXPECT_EQ(Failed(table), "ridge ends; crossings; ");
  EXPECT_EQ(row.kind, "ridge");
  EXPECT_EQ(row.offenders, std::to_string(this->ValueOfLine(names::RidgeId, line)));
  EXPECT_EQ(row.position, PointAt(this->Ridges, points.front()));
  EXPECT_EQ(RowOf(table, "crossings").count, 9);
}

TEST_F(Tampered, ReportsWrongClosedFlagAndRidgeId)
{
  const vtkIdType line = this->LineOfLoop();
  vtkDataArray* closed = this->Ridges->GetCellData()->GetArray(names::Closed);
  closed->SetComponent(line, 0, 0);
  EXPECT_EQ(Failed(this->Table()), "ridge ends; ");
  closed->SetComponent(line, 0, 1);
  // Two ridges with one id are not one chain.
  const vtkIdType other = this->LineAtUmbilic();
  this->Ridges->GetCellData()
    ->GetArray(names::RidgeId)
    ->SetComponent(other, 0, static_cast<double>(this->ValueOfLine(names::RidgeId, line)));
  EXPECT_EQ(Failed(this->Table()).find("ridge ends; "), 0u);
}

TEST_F(Tampered, ReportsAnEllipticRidgeAtAnUmbilic)
{
  const vtkIdType line = this->LineAtUmbilic();
  vtkDataArray* type = this->Ridges->GetCellData()->GetArray(names::RidgeType);
  type->SetComponent(line, 0, type->GetComponent(line, 0) - 1.0);
  const auto table = this->Table();
  EXPECT_EQ(Failed(table), "types at umbilics; ");
  EXPECT_EQ(RowOf(table, "types at umbilics").offenders,
    std::to_string(this->ValueOfLine(names::RidgeId, line)));
}

TEST_F(Tampered, ReportsAnOddNumberOfTurningPoints)
{
  const vtkIdType line = this->LineOfLoop();
  this->Ridges->GetPointData()
    ->GetArray(names::TurningPoint)
    ->SetComponent(this->PointsOf(line)[3], 0, 1);
  const auto table = this->Table();
  const Row row = RowOf(table, "turning points");
  EXPECT_EQ(Failed(table), "turning points; ");
  EXPECT_EQ(row.offenders, std::to_string(this->ValueOfLine(names::RidgeId, line)));
  EXPECT_EQ(row.position, PointAt(this->Ridges, this->PointsOf(line)[3]));
}

TEST_F(Tampered, ReportsAMovedPoint)
{
  const vtkIdType point = this->PointsOf(this->LineOfLoop())[5];
  const Eigen::Vector3d moved = PointAt(this->Ridges, point) * 1.001;
  this->Ridges->GetPoints()->SetPoint(point, moved.data());
  const auto table = this->Table();
  const Row row = RowOf(table, "points on edges");
  EXPECT_EQ(Failed(table), "points on edges; ");
  EXPECT_EQ(row.kind, "ridge point");
  EXPECT_EQ(row.offenders, std::to_string(point));
  EXPECT_EQ(row.position, moved);
}

TEST_F(Tampered, ReportsAMovedEnd)
{
  const vtkIdType end = this->PointsOf(this->LineAtUmbilic()).front();
  const Eigen::Vector3d moved = PointAt(this->Ridges, end) * 1.001; // off its triangle
  this->Ridges->GetPoints()->SetPoint(end, moved.data());
  const auto table = this->Table();
  EXPECT_EQ(Failed(table), "points on edges; ");
  EXPECT_EQ(RowOf(table, "points on edges").offenders, std::to_string(end));
}

TEST(RidgeCoherence, ReportsAMovedTurningPoint)
{
  Outputs outputs = RunFilters(BlendData(45));
  const auto isInside = [&](vtkIdType point)
  {
    vtkPointData* data = outputs.ridges->GetPointData();
    return Value(data, names::TurningPoint, point) != 0.0 &&
      Value(data, names::EdgePoint0, point) < 0.0;
  };
  vtkIdType point = 0;
  while (point < outputs.ridges->GetNumberOfPoints() && !isInside(point))
  {
    ++point;
  }
  ASSERT_LT(point, outputs.ridges->GetNumberOfPoints());
  const Eigen::Vector3d moved = PointAt(outputs.ridges, point) * 1.001;
  outputs.ridges->GetPoints()->SetPoint(point, moved.data());
  const auto table = Check(outputs);
  EXPECT_EQ(Failed(table), "points on edges; ");
  EXPECT_EQ(RowOf(table, "points on edges").offenders, std::to_string(point));
}

TEST_F(Tampered, ReportsAnEdgeThatDoesNotExist)
{
  const vtkIdType line = this->LineOfLoop();
  const vtkIdType point = this->PointsOf(line)[5];
  vtkDataArray* edgePoint = this->Ridges->GetPointData()->GetArray(names::EdgePoint1);
  for (const double id : { 1e9, 1.0, -1.0 })
  {
    edgePoint->SetComponent(point, 0, id);
    const auto table = this->Table();
    EXPECT_FALSE(RowOf(table, "points on edges").passed);
    EXPECT_FALSE(RowOf(table, "ridge ends").passed);
    EXPECT_EQ(RowOf(table, "points on edges").offenders, std::to_string(point));
  }
}

TEST_F(Tampered, ReportsTwoUmbilicsInATriangle)
{
  vtkDataArray* triangle = this->Umbilics->GetPointData()->GetArray(names::Triangle);
  triangle->SetComponent(1, 0, triangle->GetComponent(0, 0));
  const auto table = this->Table();
  const Row row = RowOf(table, "umbilics per triangle");
  EXPECT_FALSE(row.passed);
  EXPECT_EQ(row.kind, "cell");
  EXPECT_EQ(row.offenders, std::to_string(static_cast<int>(triangle->GetComponent(0, 0))));
  EXPECT_EQ(RowOf(table, "patches").offenders, "1"); // it has left its patch
}

TEST_F(Tampered, ReportsAPatchThatIsNoDisk)
{
  vtkDataArray* patch = this->Marked->GetCellData()->GetArray(names::UmbilicPatch);
  vtkIdType far = 0;
  while (patch->GetComponent(far, 0) >= 0.0)
  {
    ++far;
  }
  patch->SetComponent(far, 0, 3.0); // of two pieces now
  EXPECT_EQ(RowOf(this->Table(), "patches").offenders, "3");
  patch->SetComponent(far, 0, -1.0);
  // A hole where the umbilic is.
  const auto triangle =
    static_cast<vtkIdType>(Value(this->Umbilics->GetPointData(), names::Triangle, 2));
  patch->SetComponent(triangle, 0, -1.0);
  EXPECT_EQ(RowOf(this->Table(), "patches").offenders, "2");
  // A patch of nobody.
  patch->SetComponent(triangle, 0, 2.0);
  patch->SetComponent(far, 0, 77.0);
  EXPECT_EQ(RowOf(this->Table(), "patches").offenders, "77");
}

TEST_F(Tampered, ReportsARidgeInsideAPatch)
{
  // All the mesh one patch.
  vtkDataArray* patch = this->Marked->GetCellData()->GetArray(names::UmbilicPatch);
  patch->Fill(0.0);
  const Row row = RowOf(this->Table(), "ridges inside patches");
  EXPECT_FALSE(row.passed);
  EXPECT_EQ(row.kind, "ridge");
  EXPECT_EQ(row.count, 6); // all there are
}

TEST_F(Tampered, ReportsARightAngle)
{
  // Far from umbilics, where the longest axis ends.
  vtkDataArray* direction = this->Marked->GetPointData()->GetArray(names::MaximumDirection);
  const vtkIdType point = this->Marked->FindPoint(0.0, 1.0, 0.0);
  const Eigen::Vector3d turned =
    VectorAt(this->Marked->GetPointData(), names::MinimumDirection, point);
  vtkIdType other = -1;
  vtkNew<vtkIdList> cells;
  this->Marked->BuildLinks();
  this->Marked->GetPointCells(point, cells);
  vtkNew<vtkIdList> corners;
  this->Marked->GetCellPoints(cells->GetId(0), corners);
  for (const vtkIdType corner : *corners)
  {
    other = corner != point ? corner : other;
  }
  // Exactly at right angle with one neighbour.
  const Eigen::Vector3d d = VectorAt(this->Marked->GetPointData(), names::MaximumDirection, other);
  const Eigen::Vector3d exact = (turned - turned.dot(d) * d).normalized();
  direction->SetTuple(point, exact.data());
  const Row row = RowOf(this->Table(), "right angles");
  EXPECT_FALSE(row.passed);
  EXPECT_EQ(row.kind, "edge");
  const std::string pair =
    std::to_string(std::min(point, other)) + "-" + std::to_string(std::max(point, other));
  EXPECT_NE(row.offenders.find(pair), std::string::npos) << row.offenders;
}

TEST_F(Tampered, CopiedRidgeCrossesEdgesTwice)
{
  // With an id of its own, and a little aside.
  const vtkIdType line = this->LineOfLoop();
  const std::vector<vtkIdType> points = this->PointsOf(line);
  auto* pointData = this->Ridges->GetPointData();
  vtkDataArray* parameter = pointData->GetArray(names::EdgeParameter);
  std::vector<vtkIdType> copy;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    const vtkIdType id =
      this->Ridges->GetPoints()->InsertNextPoint(PointAt(this->Ridges, points[i]).data());
    for (int a = 0; a < pointData->GetNumberOfArrays(); ++a)
    {
      pointData->GetArray(a)->InsertNextTuple(points[i], pointData->GetArray(a));
    }
    // To one side at some points, to the other at others.
    const double t = parameter->GetComponent(id, 0);
    parameter->SetComponent(id, 0, (i / 8) % 2 == 0 ? 0.9 * t : 1.0 - 0.9 * (1.0 - t));
    copy.push_back(id);
  }
  copy.push_back(copy.front());
  this->Ridges->GetLines()->InsertNextCell(static_cast<vtkIdType>(copy.size()), copy.data());
  auto* cellData = this->Ridges->GetCellData();
  for (int a = 0; a < cellData->GetNumberOfArrays(); ++a)
  {
    cellData->GetArray(a)->InsertNextTuple(line, cellData->GetArray(a));
  }
  cellData->GetArray(names::RidgeId)->SetComponent(this->Ridges->GetNumberOfLines() - 1, 0, 99);
  const auto table = this->Table();
  EXPECT_EQ(RowOf(table, "double crossings").kind, "edge");
  EXPECT_EQ(RowOf(table, "double crossings").count, static_cast<vtkIdType>(points.size()) - 1);
  EXPECT_EQ(RowOf(table, "intersections").kind, "cell");
  EXPECT_GT(RowOf(table, "intersections").count, 5);
  EXPECT_FALSE(RowOf(table, "points on edges").passed);
}

TEST_F(Tampered, ReportsAtMostTwentyOffenders)
{
  this->Ridges->GetPointData()->GetArray(names::EdgeParameter)->Fill(2.0);
  const Row row = RowOf(this->Table(), "points on edges");
  EXPECT_GT(row.count, 100);
  EXPECT_EQ(std::count(row.offenders.begin(), row.offenders.end(), ','), 20);
  EXPECT_EQ(row.offenders.substr(row.offenders.size() - 5), ", ...");
}

TEST_F(Tampered, SurvivesEverythingAtOnce)
{
  const double values[] = { -1.0, 0.0, 1e300, std::numeric_limits<double>::quiet_NaN() };
  for (const double value : values)
  {
    for (vtkFieldData* data : { static_cast<vtkFieldData*>(this->Ridges->GetPointData()),
           static_cast<vtkFieldData*>(this->Ridges->GetCellData()),
           static_cast<vtkFieldData*>(this->Umbilics->GetPointData()),
           static_cast<vtkFieldData*>(this->Marked->GetCellData()) })
    {
      for (int a = 0; a < data->GetNumberOfArrays(); ++a)
      {
        vtkDataArray* array = data->GetArray(a);
        const bool isReal = array->GetDataType() == VTK_DOUBLE;
        array->Fill(
          isReal ? value : std::max(-1.0, std::min(1e9, std::isnan(value) ? 7.0 : value)));
      }
    }
    EXPECT_NE(Failed(this->Table()), "");
  }
}
