// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Ridges and umbilics on any number of ranks against those of one: byte for byte, but for ids of
// points and triangles, which are compared by the names that these have in the whole mesh.

#include "FilterTestTools.h"
#include "MessageRecorder.h"
#include "ParallelTestTools.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPRidgesAndUmbilics.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRidgesArrayNames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

struct Expected
{
  vtkSmartPointer<vtkPolyData> ridges;
  vtkSmartPointer<vtkPolyData> umbilics;
  vtkSmartPointer<vtkPolyData> mesh;
  std::string warnings; ///< On rank 0.
};

using Settings = std::function<void(vtkRidgesAndUmbilics*)>;

void SetNone(vtkRidgesAndUmbilics*) {}

Expected OnOneRank(const Mesh& mesh, const Settings& set = SetNone)
{
  vtkNew<vtkRidgesAndUmbilics> serial;
  set(serial);
  const MessageRecorder recorder(serial);
  const auto output = [&serial, &mesh](int port)
  {
    return FromFirstRank(
      [&serial, &mesh, port]
      {
        if (!serial->GetInput())
        {
          serial->SetInputData(ToPolyData(mesh));
        }
        serial->Update();
        vtkSmartPointer<vtkPolyData> result = serial->GetOutput(port);
        return result;
      });
  };
  Expected expected{ output(vtkRidgesAndUmbilics::RIDGES), output(vtkRidgesAndUmbilics::UMBILICS),
    output(vtkRidgesAndUmbilics::MESH), "" };
  expected.warnings = Bare(recorder.WarningText());
  return expected;
}

/// On rank 0 the names in the whole mesh, by the numbers that pieces have; -1 is of nothing.
std::vector<vtkIdType> Names(vtkDataArray* numbers, const std::vector<std::int32_t>& names)
{
  vtkNew<vtkIdTypeArray> own;
  own->SetNumberOfComponents(2);
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    own->InsertNextTuple2(numbers->GetTuple1(static_cast<vtkIdType>(i)), names[i]);
  }
  vtkNew<vtkIdTypeArray> all;
  Controller()->GatherV(own, all, 0);
  std::vector<vtkIdType> found;
  for (vtkIdType i = 0; i < all->GetNumberOfTuples(); ++i)
  {
    const auto number = static_cast<std::size_t>(all->GetComponent(i, 0));
    found.resize(std::max(found.size(), number + 1), -1);
    found[number] = static_cast<vtkIdType>(all->GetComponent(i, 1));
  }
  return found;
}

void ExpectTheSame(const Expected& expected, const NamedMesh& named, Partition partition,
  const Settings& set = SetNone)
{
  SCOPED_TRACE(
    std::string(named.name) + ", partition " + std::to_string(static_cast<int>(partition)));
  const RankPiece own = PieceOfRank(named.mesh, partition);
  vtkNew<vtkPRidgesAndUmbilics> parallel;
  set(parallel);
  const MessageRecorder recorder(parallel);
  parallel->SetInputData(own.data);
  parallel->Update();
  ASSERT_EQ(recorder.ErrorText(), "");
  EXPECT_EQ(Bare(recorder.WarningText()), expected.warnings);
  vtkPolyData* mesh = parallel->GetOutput(vtkRidgesAndUmbilics::MESH);
  EXPECT_EQ(
    FirstOtherRow(expected.mesh->GetPointData(), mesh->GetPointData(), own.piece.points), "");
  EXPECT_EQ(
    FirstOtherRow(expected.mesh->GetCellData(), mesh->GetCellData(), own.piece.triangles), "");
  const auto bare = Without(expected.mesh, { names::UmbilicTriangle });
  for (int i = 0; i < bare->GetFieldData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = bare->GetFieldData()->GetArray(i);
    if (array)
    {
      vtkNew<vtkFieldData> one;
      one->AddArray(array);
      EXPECT_EQ(FirstOtherRow(one, mesh->GetFieldData(), AllOf(array->GetNumberOfTuples())), "");
    }
  }

  const bool isSerial = Controller()->GetNumberOfProcesses() == 1;
  const auto numbers = [mesh, isSerial](vtkFieldData* data, const char* name)
  {
    vtkSmartPointer<vtkDataArray> array = data->GetArray(name);
    if (isSerial)
    {
      vtkNew<vtkIdTypeArray> all;
      for (vtkIdType i = 0; i < mesh->GetNumberOfPoints() + mesh->GetNumberOfCells(); ++i)
      {
        all->InsertNextValue(i);
      }
      array = all;
    }
    return array;
  };
  const auto pointNames =
    Names(numbers(mesh->GetPointData(), names::GatheredPointId), own.piece.points);
  const auto cellNames =
    Names(numbers(mesh->GetCellData(), names::GatheredCellId), own.piece.triangles);
  vtkPolyData* ridges = parallel->GetOutput(vtkRidgesAndUmbilics::RIDGES);
  vtkPolyData* umbilics = parallel->GetOutput(vtkRidgesAndUmbilics::UMBILICS);
  if (Controller()->GetLocalProcessId() > 0)
  {
    EXPECT_TRUE(IsEmpty(ridges));
    EXPECT_TRUE(IsEmpty(umbilics));
    return;
  }
  ExpectTheSameLines(expected.ridges, ridges, pointNames);
  ExpectTheSameUmbilics(expected.umbilics, umbilics, cellNames);
  ExpectTheSameTriangles(expected.ridges->GetFieldData(), ridges->GetFieldData(), cellNames);
  ExpectTheSameTriangles(expected.umbilics->GetFieldData(), umbilics->GetFieldData(), cellNames);
}

} // namespace

TEST(PRidgesAndUmbilics, GivesTheBytesOfOneRank)
{
  for (const NamedMesh& named : SmallMeshes())
  {
    const Expected expected = OnOneRank(named.mesh);
    for (const Partition partition : AllPartitions)
    {
      ExpectTheSame(expected, named, partition);
    }
  }
}

// Of these, rank 0 gets a part, and larger ones where patches reach farther, or loops.
TEST(PRidgesAndUmbilics, GivesTheBytesOfOneRankFromAPartOfTheMesh)
{
  const auto height = [](double x, double y)
  { return 0.4 * x * x - 0.3 * y * y + 0.3 * x * x * x + 0.2 * x * y * y; };
  const auto largePatches = [](vtkRidgesAndUmbilics* filter) { filter->SetPatchSize(10.0); };
  const NamedMesh ellipsoid = { "large ellipsoid", EllipsoidMesh(48, 1.0, 0.8, 0.6) };
  const struct
  {
    NamedMesh mesh;
    Settings set;
  } cases[] = { { ellipsoid, SetNone }, { ellipsoid, largePatches },
    { { "large open patch", GraphPatch(height, 1.0, 90, 0.2) }, SetNone } };
  for (const auto& [mesh, set] : cases)
  {
    const Expected expected = OnOneRank(mesh.mesh, set);
    ExpectTheSame(
      expected, mesh, &mesh == &cases[0].mesh ? Partition::Random : Partition::Blocks, set);
  }
}

// Only what has changed is done again, on all ranks together.
TEST(PRidgesAndUmbilics, RunsAgainWhereOneRankHasToFitAnew)
{
  const NamedMesh named = SmallMeshes().front();
  const RankPiece own = PieceOfRank(named.mesh, Partition::Blocks);
  vtkNew<vtkPRidgesAndUmbilics> parallel;
  parallel->SetInputData(own.data);
  parallel->Update();
  const auto countOf = [&parallel]
  {
    vtkIdType count = parallel->GetOutput()->GetNumberOfLines();
    Controller()->Broadcast(&count, 1, 0);
    return count;
  };
  const vtkIdType all = countOf();
  EXPECT_GT(all, 0);
  parallel->SetMaximumNumber(1);
  parallel->SetWholeRidges(false);
  parallel->Update();
  EXPECT_EQ(countOf(), 1);
  parallel->SetMaximumNumber(0);
  own.data->Modified();
  if (Controller()->GetLocalProcessId() == 0)
  {
    vtkNew<vtkPolyData> copy;
    copy->ShallowCopy(own.data);
    parallel->SetInputData(copy);
  }
  parallel->Update();
  EXPECT_EQ(countOf(), all);
}

TEST(PRidgesAndUmbilics, DistributesWholeRidges)
{
  const NamedMesh named = SmallMeshes()[2]; // the blend, with 36 lines
  const RankPiece own = PieceOfRank(named.mesh, Partition::Blocks);
  vtkNew<vtkPRidgesAndUmbilics> parallel;
  parallel->SetInputData(own.data);
  parallel->Update();
  vtkNew<vtkPolyData> all;
  all->DeepCopy(parallel->GetOutput());
  parallel->DistributeLinesOn();
  parallel->Update();

  // One rank after the other: the same lines, of the same points and values.
  const auto linesOf = [](vtkPolyData* data)
  {
    vtkNew<vtkDoubleArray> lines;
    lines->SetNumberOfComponents(4);
    const auto cell = vtk::TakeSmartPointer(data->GetLines()->NewIterator());
    for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      cell->GetCurrentCell(size, ids);
      const vtkIdType i = cell->GetCurrentCellId();
      double sum = 0.0;
      for (vtkIdType k = 0; k < size; ++k)
      {
        sum += data->GetPoint(ids[k])[0] + Value(data->GetPointData(), names::Curvature, ids[k]);
      }
      const double values[] = { Value(data->GetCellData(), names::RidgeId, i),
        Value(data->GetCellData(), names::Length, i), sum, static_cast<double>(size) };
      lines->InsertNextTuple(values);
    }
    return lines;
  };
  const auto shares = linesOf(parallel->GetOutput());
  vtkNew<vtkDoubleArray> gathered;
  Controller()->GatherV(shares, gathered, 0);
  const int here = static_cast<int>(shares->GetNumberOfTuples());
  int least = 0;
  Controller()->AllReduce(&here, &least, 1, vtkCommunicator::MIN_OP);
  EXPECT_GT(least, 0);
  if (Controller()->GetLocalProcessId() == 0)
  {
    const auto expected = linesOf(all);
    ASSERT_EQ(gathered->GetNumberOfTuples(), expected->GetNumberOfTuples());
    for (vtkIdType i = 0; i < expected->GetNumberOfValues(); ++i)
    {
      ASSERT_EQ(gathered->GetValue(i), expected->GetValue(i)) << i;
    }
  }
}
