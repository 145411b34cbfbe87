// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ParallelTestTools.h"

#include "FilterTestTools.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRidgesArrayNames.h"

#include <gtest/gtest.h>

#include <cstring>
#include <numeric>
#include <regex>

namespace names = vtkRidgesArrayNames;

namespace ridges
{
namespace testing
{
namespace
{

std::string BytesOfPointsAndLines(vtkPolyData* data)
{
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(data->GetPoints());
  bare->SetVerts(data->GetVerts());
  bare->SetLines(data->GetLines());
  return BytesOf(bare);
}

void ExpectTheSameData(vtkPolyData* expected, vtkPolyData* actual)
{
  ASSERT_EQ(actual->GetNumberOfPoints(), expected->GetNumberOfPoints());
  ASSERT_EQ(actual->GetNumberOfCells(), expected->GetNumberOfCells());
  EXPECT_TRUE(BytesOfPointsAndLines(actual) == BytesOfPointsAndLines(expected));
  EXPECT_EQ(FirstOtherRow(expected->GetPointData(), actual->GetPointData(),
              AllOf(expected->GetNumberOfPoints())),
    "");
  EXPECT_EQ(FirstOtherRow(
              expected->GetCellData(), actual->GetCellData(), AllOf(expected->GetNumberOfCells())),
    "");
}

/// Each crossing on the same edge, at the same place on it: from one of its ends or, where the ends
/// come in the other order, from the other one.
void ExpectTheSameEdges(
  vtkPolyData* expected, vtkPolyData* actual, const std::vector<vtkIdType>& pointNames)
{
  const auto idAt = [](vtkPolyData* ridges, const char* name, vtkIdType i)
  { return static_cast<vtkIdType>(Value(ridges->GetPointData(), name, i)); };
  const auto nameAt = [&pointNames, &idAt, actual](const char* name, vtkIdType i)
  {
    const vtkIdType id = idAt(actual, name, i);
    return id < 0 ? id : pointNames.at(static_cast<std::size_t>(id));
  };
  for (vtkIdType i = 0; i < expected->GetNumberOfPoints(); ++i)
  {
    const vtkIdType p = idAt(expected, names::EdgePoint0, i);
    const vtkIdType q = idAt(expected, names::EdgePoint1, i);
    const double x = Value(expected->GetPointData(), names::EdgeParameter, i);
    const double y = Value(actual->GetPointData(), names::EdgeParameter, i);
    const bool isTurned = p != q && nameAt(names::EdgePoint0, i) == q;
    ASSERT_EQ(nameAt(names::EdgePoint0, i), isTurned ? q : p) << i;
    ASSERT_EQ(nameAt(names::EdgePoint1, i), isTurned ? p : q) << i;
    ASSERT_TRUE(isTurned ? x == 1.0 - y || y == 1.0 - x : x == y) << i << ": " << x << ", " << y;
  }
}

} // namespace

vtkMultiProcessController* Controller()
{
  return vtkMultiProcessController::GetGlobalController();
}

vtkSmartPointer<vtkPolyData> FromFirstRank(
  const std::function<vtkSmartPointer<vtkPolyData>()>& make)
{
  auto data = Controller()->GetLocalProcessId() == 0 ? make() : vtkSmartPointer<vtkPolyData>::New();
  Controller()->Broadcast(data, 0);
  return data;
}

RankPiece PieceOfRank(const Mesh& mesh, Partition partition)
{
  RankPiece own;
  own.piece = PieceOf(mesh, PartsOf(mesh, partition, Controller()->GetNumberOfProcesses()),
    Controller()->GetLocalProcessId());
  own.data = ToPolyData(own.piece.mesh);
  return own;
}

std::string FirstOtherRow(
  vtkFieldData* expected, vtkFieldData* actual, const std::vector<std::int32_t>& ids)
{
  for (int i = 0; i < expected->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = expected->GetArray(i);
    if (!array)
    {
      continue;
    }
    vtkDataArray* other = actual->GetArray(array->GetName());
    const std::string name = array->GetName();
    if (!other || other->GetDataType() != array->GetDataType() ||
      other->GetNumberOfComponents() != array->GetNumberOfComponents() ||
      other->GetNumberOfTuples() != static_cast<vtkIdType>(ids.size()))
    {
      return name + " is missing or of another type or size";
    }
    const auto size =
      static_cast<std::size_t>(array->GetNumberOfComponents()) * array->GetDataTypeSize();
    const auto* rows = static_cast<const char*>(array->GetVoidPointer(0));
    const auto* otherRows = static_cast<const char*>(other->GetVoidPointer(0));
    for (std::size_t k = 0; k < ids.size(); ++k)
    {
      if (std::memcmp(rows + size * ids[k], otherRows + size * k, size) != 0)
      {
        return name + " at " + std::to_string(ids[k]);
      }
    }
  }
  return {};
}

std::vector<std::int32_t> AllOf(vtkIdType count)
{
  std::vector<std::int32_t> ids(static_cast<std::size_t>(count));
  std::iota(ids.begin(), ids.end(), 0);
  return ids;
}

vtkSmartPointer<vtkPolyData> Without(vtkPolyData* data, const std::vector<const char*>& arrayNames)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(data);
  for (const char* name : arrayNames)
  {
    copy->GetPointData()->RemoveArray(name);
    copy->GetFieldData()->RemoveArray(name);
  }
  return copy;
}

void ExpectTheSameLines(
  vtkPolyData* expected, vtkPolyData* actual, const std::vector<vtkIdType>& pointNames)
{
  const std::vector<const char*> edges = { names::EdgePoint0, names::EdgePoint1,
    names::EdgeParameter };
  ExpectTheSameData(Without(expected, edges), Without(actual, edges));
  ExpectTheSameEdges(expected, actual, pointNames);
}

void ExpectTheSameTriangles(
  vtkFieldData* expected, vtkFieldData* actual, const std::vector<vtkIdType>& cellNames)
{
  vtkDataArray* ids = expected->GetArray(names::UmbilicTriangle);
  for (vtkIdType i = 0; ids && i < ids->GetNumberOfTuples(); ++i)
  {
    const auto id = static_cast<std::size_t>(Value(actual, names::UmbilicTriangle, i));
    EXPECT_EQ(cellNames.at(id), ids->GetTuple1(i));
  }
}

void ExpectTheSameUmbilics(
  vtkPolyData* expected, vtkPolyData* actual, const std::vector<vtkIdType>& cellNames)
{
  ExpectTheSameData(Without(expected, { names::Triangle }), Without(actual, { names::Triangle }));
  for (vtkIdType i = 0; i < actual->GetNumberOfPoints(); ++i)
  {
    const auto triangle =
      static_cast<std::size_t>(Value(actual->GetPointData(), names::Triangle, i));
    EXPECT_EQ(cellNames.at(triangle), Value(expected->GetPointData(), names::Triangle, i));
  }
}

std::string Bare(const std::string& messages)
{
  return std::regex_replace(messages, std::regex("Warning: In [^\n]*\n[^\n]*\\): "), "");
}

std::vector<NamedMesh> SmallMeshes()
{
  Mesh two = EllipsoidMesh(10, 1.0, 0.8, 0.6);
  Append(
    two, Transform(TorusMesh(0.8, 0.3, 40, 20), GenericRotation(), Eigen::Vector3d(3.0, 0.2, 0.1)));
  const auto height = [](double x, double y)
  { return 0.4 * x * x - 0.3 * y * y + 0.3 * x * x * x + 0.2 * x * y * y; };
  return { { "ellipsoid", EllipsoidMesh(16, 1.0, 0.8, 0.6) },
    { "noisy ellipsoid", AddNormalNoise(EllipsoidMesh(20, 1.0, 0.8, 0.6), 0.002, 5) },
    { "blend", ToMesh(BlendData(14)) }, { "torus", TorusMesh(1.0, 0.4, 60, 30) },
    { "open patch", AddNormalNoise(GraphPatch(height, 1.0, 30, 0.2), 0.0005, 3) },
    { "two components", two } };
}

} // namespace testing
} // namespace ridges
