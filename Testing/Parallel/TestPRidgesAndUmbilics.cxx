// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Ridges and umbilics on any number of ranks against those of one.

#include "FilterTestTools.h"
#include "ParallelTestTools.h"
#include "RankComparison.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkDoubleArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPRidgesAndUmbilics.h"
#include "vtkPointData.h"
#include "vtkRidgesArrayNames.h"

#include <gtest/gtest.h>

#include <string>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

void ExpectTheSame(const ExpectedRidges& expected, const NamedMesh& named, Partition partition,
  const RidgeSettings& set = SetNone)
{
  SCOPED_TRACE(
    std::string(named.name) + ", partition " + std::to_string(static_cast<int>(partition)));
  ExpectTheSameRidges(expected, PieceOfRank(named.mesh, partition), set);
}

} // namespace

TEST(PRidgesAndUmbilics, GivesTheBytesOfOneRank)
{
  for (const NamedMesh& named : SmallMeshes())
  {
    const ExpectedRidges expected = RidgesOnOneRank(named.mesh);
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
    RidgeSettings set;
  } cases[] = { { ellipsoid, SetNone }, { ellipsoid, largePatches },
    { { "large open patch", GraphPatch(height, 1.0, 90, 0.2) }, SetNone } };
  for (const auto& [mesh, set] : cases)
  {
    const ExpectedRidges expected = RidgesOnOneRank(mesh.mesh, set);
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
