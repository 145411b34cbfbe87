// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// What is wrong on one rank is an error on all, and no rank waits for another.

#include "FilterTestTools.h"
#include "MessageRecorder.h"
#include "ParallelTestTools.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPJetFitting.h"
#include "vtkPRidgesAndUmbilics.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLPolyDataReader.h"

#include <gtest/gtest.h>

#include <csignal>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

using namespace ridges::testing;

namespace
{

int Rank()
{
  return Controller()->GetLocalProcessId();
}

bool IsAlone()
{
  return Controller()->GetNumberOfProcesses() == 1;
}

/// Of both filters: one error, with these words on every rank, no output, and the same filter works
/// afterwards. `spoil` gives the last rank another input than its piece.
void ExpectErrorOnAllRanks(
  const std::function<void(vtkPolyDataAlgorithm*, vtkPolyData*)>& spoil, const std::string& words)
{
  const bool isLast = Rank() + 1 == Controller()->GetNumberOfProcesses();
  const auto expect = [&](vtkPolyDataAlgorithm* filter, int port)
  {
    const RankPiece own = PieceOfRank(EllipsoidMesh(8, 1.0, 0.8, 0.6), Partition::Blocks);
    {
      const MessageRecorder recorder(filter);
      filter->SetInputData(own.data);
      if (isLast)
      {
        spoil(filter, own.data);
      }
      filter->Update();
      EXPECT_EQ(recorder.NumberOfErrors(), 1U);
      EXPECT_NE(recorder.ErrorText().find(words), std::string::npos) << recorder.ErrorText();
      vtkDataObject* output = filter->GetOutputDataObject(port);
      EXPECT_TRUE(!output || output->GetNumberOfElements(vtkDataObject::POINT) == 0);
      filter->Modified();
      filter->Update();
      EXPECT_EQ(recorder.NumberOfErrors(), 2U) << "not silent later on";
    }
    const MessageRecorder recorder(filter);
    filter->SetInputData(PieceOfRank(EllipsoidMesh(8, 1.0, 0.8, 0.6), Partition::Blocks).data);
    filter->Update();
    EXPECT_EQ(recorder.ErrorText(), "");
    EXPECT_EQ(filter->GetOutput(port)->GetNumberOfPoints(), own.piece.mesh.PointCount());
  };
  vtkNew<vtkPJetFitting> jets;
  expect(jets, 0);
  vtkNew<vtkPRidgesAndUmbilics> ridges;
  expect(ridges, vtkRidgesAndUmbilics::MESH);
}

/// Says that something is wrong, but not to the pipeline.
class ReportingSource : public vtkPolyDataAlgorithm
{
public:
  static ReportingSource* New() { VTK_STANDARD_NEW_BODY(ReportingSource); }

protected:
  ReportingSource() { this->SetNumberOfInputPorts(0); }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override
  {
    vtkErrorMacro("half of it is missing.");
    return 1;
  }
};

std::string OnLastRank(const std::string& text)
{
  return "on rank " + std::to_string(Controller()->GetNumberOfProcesses() - 1) + ": " + text;
}

} // namespace

TEST(RankErrors, MissingPiece)
{
  if (!IsAlone())
  {
    ExpectErrorOnAllRanks([](vtkPolyDataAlgorithm* filter, vtkPolyData*)
      { filter->SetInputConnection(nullptr); },
      OnLastRank("there is no piece"));
  }
}

TEST(RankErrors, PieceThatCannotBeRead)
{
  if (!IsAlone())
  {
    std::vector<std::unique_ptr<MessageRecorder>> recorders;
    ExpectErrorOnAllRanks(
      [&recorders](vtkPolyDataAlgorithm* filter, vtkPolyData*)
      {
        vtkNew<vtkXMLPolyDataReader> reader;
        reader->SetFileName("/nowhere/piece.vtp");
        recorders.push_back(std::make_unique<MessageRecorder>(reader));
        filter->SetInputConnection(reader->GetOutputPort());
      },
      OnLastRank("what makes the piece has failed"));
  }
}

// Readers report what they cannot read, and go on.
TEST(RankErrors, PieceWhoseMakerReportsAnError)
{
  for (const bool isObserved : { true, false })
  {
    if (IsAlone())
    {
      break;
    }
    std::vector<std::unique_ptr<MessageRecorder>> recorders;
    ExpectErrorOnAllRanks(
      [&recorders, isObserved](vtkPolyDataAlgorithm* filter, vtkPolyData*)
      {
        vtkNew<ReportingSource> source;
        if (isObserved)
        {
          recorders.push_back(std::make_unique<MessageRecorder>(source));
        }
        filter->SetInputConnection(source->GetOutputPort());
      },
      OnLastRank("what makes the piece has failed (half of it is missing)"));
  }
}

TEST(RankErrors, PieceOfOtherCells)
{
  if (!IsAlone())
  {
    ExpectErrorOnAllRanks(
      [](vtkPolyDataAlgorithm* filter, vtkPolyData*)
      {
        vtkNew<vtkUnstructuredGrid> grid;
        filter->SetInputData(grid);
      },
      OnLastRank("the piece is a vtkUnstructuredGrid"));
  }
}

TEST(RankErrors, PieceOfBlocks)
{
  if (!IsAlone())
  {
    ExpectErrorOnAllRanks(
      [](vtkPolyDataAlgorithm* filter, vtkPolyData* piece)
      {
        vtkNew<vtkMultiBlockDataSet> blocks;
        blocks->SetBlock(0, piece);
        blocks->SetBlock(1, piece);
        filter->SetInputDataObject(blocks);
      },
      OnLastRank("the piece is a vtkMultiBlockDataSet"));
  }
}

TEST(RankErrors, OtherArrays)
{
  if (!IsAlone())
  {
    ExpectErrorOnAllRanks([](vtkPolyDataAlgorithm*, vtkPolyData* piece)
      { AddPointArray(piece, "Extra", 2, [](vtkIdType, double* values) { values[0] = 1.0; }); },
      "the arrays differ between ranks: rank 0 has none; rank " +
        std::to_string(Controller()->GetNumberOfProcesses() - 1) +
        " has Extra (points, 2 x double)");
  }
}

TEST(RankErrors, OtherProperties)
{
  if (!IsAlone())
  {
    vtkNew<vtkPJetFitting> jets;
    const MessageRecorder recorder(jets);
    jets->SetNumberOfRings(Rank() == 0 ? 3 : 4);
    jets->SetInputData(PieceOfRank(EllipsoidMesh(8, 1.0, 0.8, 0.6), Partition::Blocks).data);
    jets->Update();
    EXPECT_NE(
      recorder.ErrorText().find("properties of the filter differ between ranks"), std::string::npos)
      << recorder.ErrorText();
  }
}

// Points that two pieces have are one point; but which, if one of them has two at the place?
TEST(RankErrors, AmbiguousPoints)
{
  if (!IsAlone())
  {
    ExpectErrorOnAllRanks(
      [](vtkPolyDataAlgorithm*, vtkPolyData* piece)
      {
        // All triangles again, at points of their own.
        const vtkIdType count = piece->GetNumberOfPoints();
        for (vtkIdType p = 0; p < count; ++p)
        {
          double x[3];
          piece->GetPoint(p, x);
          piece->GetPoints()->InsertNextPoint(x);
        }
        for (vtkIdType t = piece->GetNumberOfPolys() - 1; t >= 0; --t)
        {
          vtkNew<vtkIdList> ids;
          piece->GetPolys()->GetCellAtId(t, ids);
          const vtkIdType other[] = { ids->GetId(0) + count, ids->GetId(1) + count,
            ids->GetId(2) + count };
          piece->GetPolys()->InsertNextCell(3, other);
        }
      },
      "which are the same cannot be known");
  }
}

TEST(RankErrors, NoTriangles)
{
  vtkNew<vtkPRidgesAndUmbilics> ridges;
  const MessageRecorder recorder(ridges);
  RankPiece own = PieceOfRank(EllipsoidMesh(8, 1.0, 0.8, 0.6), Partition::Blocks);
  vtkNew<vtkCellArray> none;
  own.data->SetPolys(none);
  ridges->SetInputData(own.data);
  ridges->Update();
  EXPECT_NE(recorder.ErrorText().find("no triangles"), std::string::npos);
}

TEST(RankErrors, NothingAnywhere)
{
  vtkNew<vtkPRidgesAndUmbilics> ridges;
  const MessageRecorder recorder(ridges);
  vtkNew<vtkPolyData> empty;
  ridges->SetInputData(empty);
  ridges->Update();
  EXPECT_EQ(recorder.ErrorText(), "");
  EXPECT_TRUE(IsEmpty(ridges->GetOutput()));
}

// Points that are not finite are left out, as on one rank.
TEST(RankErrors, PointThatIsNotFinite)
{
  Mesh mesh = EllipsoidMesh(8, 1.0, 0.8, 0.6);
  mesh.points[300] = std::numeric_limits<double>::quiet_NaN();
  const auto expected = FromFirstRank(
    [&mesh]
    {
      vtkNew<vtkJetFitting> serial;
      const MessageRecorder recorder(serial);
      serial->SetInputData(ToPolyData(mesh));
      serial->Update();
      vtkSmartPointer<vtkPolyData> result = serial->GetOutput();
      return result;
    });
  const RankPiece own = PieceOfRank(mesh, Partition::Random);
  vtkNew<vtkPJetFitting> jets;
  const MessageRecorder recorder(jets);
  jets->SetInputData(own.data);
  jets->Update();
  EXPECT_EQ(
    recorder.WarningText().find("triangles were left out") != std::string::npos, Rank() == 0);
  EXPECT_EQ(
    FirstOtherRow(expected->GetPointData(), jets->GetOutput()->GetPointData(), own.piece.points),
    "");
}

// Run by a test of its own, which expects that MPI ends all ranks.
TEST(Killed, DISABLED_OneRank)
{
  if (Rank() == 1)
  {
    std::raise(SIGKILL);
  }
  vtkNew<vtkPRidgesAndUmbilics> ridges;
  ridges->SetInputData(PieceOfRank(EllipsoidMesh(8, 1.0, 0.8, 0.6), Partition::Blocks).data);
  ridges->Update();
}
