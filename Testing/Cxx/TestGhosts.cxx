// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// vtkGhostType: hidden cells are no part of the surface; duplicates of cells in other pieces serve
// their neighbours, and what lies in them is reported by the piece that owns them.

#include "FilterTestTools.h"
#include "MessageRecorder.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPrincipalFoliation.h"
#include "vtkRidgeCoherence.h"
#include "vtkRidgeExtraction.h"
#include "vtkRidgesAndUmbilics.h"
#include "vtkRidgesArrayNames.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"
#include "vtkUmbilicDetection.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <string>
#include <vector>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

/// Flags the cells, or points, where `is` says so.
void AddGhosts(
  vtkDataSetAttributes* data, vtkIdType count, int flag, const std::function<bool(vtkIdType)>& is)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType i = 0; i < count; ++i)
  {
    ghosts->InsertNextValue(static_cast<unsigned char>(is(i) ? flag : 0));
  }
  data->AddArray(ghosts);
}

vtkSmartPointer<vtkPolyData> Copy(vtkPolyData* data)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(data);
  return copy;
}

double CentroidX(vtkPolyData* data, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  data->GetPolys()->GetCellAtId(cell, ids);
  return (data->GetPoint(ids->GetId(0))[0] + data->GetPoint(ids->GetId(1))[0] +
           data->GetPoint(ids->GetId(2))[0]) /
    3.0;
}

/// The whole mesh, with all cells on one side flagged as duplicates.
vtkSmartPointer<vtkPolyData> Half(vtkPolyData* mesh, double sign)
{
  auto half = Copy(mesh);
  AddGhosts(half->GetCellData(), half->GetNumberOfCells(), vtkDataSetAttributes::DUPLICATECELL,
    [&half, sign](vtkIdType cell) { return sign * CentroidX(half, cell) < 0.0; });
  return half;
}

double TotalLength(vtkPolyData* ridges)
{
  double length = 0.0;
  for (vtkIdType i = 0; i < ridges->GetNumberOfLines(); ++i)
  {
    length += Value(ridges->GetCellData(), names::Length, i);
  }
  return length;
}

/// A source that says that it has pieces, and notes how many ghost levels were asked of it.
class PieceSource : public vtkPolyDataAlgorithm
{
public:
  static PieceSource* New();
  vtkTypeMacro(PieceSource, vtkPolyDataAlgorithm);

  vtkSmartPointer<vtkPolyData> data;
  int askedLevels = -1;

protected:
  PieceSource() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override
  {
    outputVector->GetInformationObject(0)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
    return 1;
  }

  int RequestData(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override
  {
    this->askedLevels = outputVector->GetInformationObject(0)->Get(
      vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS());
    vtkPolyData::GetData(outputVector)->ShallowCopy(this->data);
    return 1;
  }
};
vtkStandardNewMacro(PieceSource);

} // namespace

// The same as of a mesh that does not have the cells at all.
TEST(Ghosts, HiddenCellsAreNoPartOfTheSurface)
{
  const auto mesh = EllipsoidData(12);
  const auto isHidden = [](vtkIdType cell) { return cell % 7 == 0 || cell < 300; };
  for (const int flag : { vtkDataSetAttributes::HIDDENCELL, vtkDataSetAttributes::REFINEDCELL })
  {
    const auto flagged = Copy(mesh);
    AddGhosts(flagged->GetCellData(), flagged->GetNumberOfCells(), flag, isHidden);
    const auto without = Copy(mesh);
    vtkNew<vtkCellArray> kept;
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      mesh->GetPolys()->GetCellAtId(cell, ids);
      if (!isHidden(cell))
      {
        kept->InsertNextCell(ids);
      }
    }
    without->SetPolys(kept);
    const Outputs expected = RunFilters(without);
    const Outputs actual = RunFilters(flagged);
    for (vtkPolyData* ridges : { actual.ridges.Get(), expected.ridges.Get() })
    {
      ridges->GetFieldData()->Initialize(); // of the mesh, with its cell ids
    }
    EXPECT_EQ(FirstDifference(actual.ridges, expected.ridges), "");
    for (const char* name : { names::ThirdOrder, names::FitStatus, names::FitScale })
    {
      for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
      {
        ASSERT_EQ(Value(actual.fitted->GetPointData(), name, p),
          Value(expected.fitted->GetPointData(), name, p));
      }
    }
    EXPECT_EQ(actual.umbilics->GetNumberOfPoints(), expected.umbilics->GetNumberOfPoints());
    // Points without triangles are nothing to warn of where these are hidden.
    EXPECT_NE(expected.warnings.find("points have no fit"), std::string::npos);
    EXPECT_EQ(actual.warnings.find("points have no fit"), std::string::npos) << actual.warnings;
  }
}

TEST(Ghosts, TrianglesOfHiddenPointsAreNoPartOfTheSurface)
{
  const auto mesh = EllipsoidData(12);
  AddGhosts(mesh->GetPointData(), mesh->GetNumberOfPoints(), vtkDataSetAttributes::HIDDENPOINT,
    [](vtkIdType p) { return p == 100; });
  const Outputs outputs = RunFilters(mesh);
  EXPECT_EQ(outputs.warnings + outputs.errors, "");
  EXPECT_EQ(Value(outputs.fitted->GetPointData(), names::FitStatus, 100),
    vtkJetFitting::FIT_INVALID + vtkJetFitting::FIT_TOO_FEW_POINTS);
  EXPECT_EQ(Value(outputs.fitted->GetPointData(), names::FitStatus, 500), 0.0);
  for (vtkIdType i = 0; i < outputs.ridges->GetNumberOfPoints(); ++i)
  {
    EXPECT_NE(Value(outputs.ridges->GetPointData(), names::EdgePoint0, i), 100.0);
    EXPECT_NE(Value(outputs.ridges->GetPointData(), names::EdgePoint1, i), 100.0);
  }
}

TEST(Ghosts, HiddenPolygonsAreNotCutIntoVisibleTriangles)
{
  const auto mesh =
    MakePolyData({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 2, 0, 0 }, { 2, 1, 0 } },
      { { 0, 1, 2, 3 }, { 1, 4, 5, 2 } });
  AddGhosts(mesh->GetCellData(), 2, vtkDataSetAttributes::HIDDENCELL,
    [](vtkIdType cell) { return cell == 1; });
  vtkNew<vtkJetFitting> jets;
  const MessageRecorder recorder(jets);
  jets->SetInputData(mesh);
  jets->Update();
  vtkPolyData* output = jets->GetOutput();
  ASSERT_EQ(output->GetNumberOfPolys(), 4);
  EXPECT_EQ(Value(output->GetCellData(), vtkDataSetAttributes::GhostArrayName(), 3), 32.0);
  // Points 4 and 5 are in hidden triangles only: two points are not counted as without a fit.
  EXPECT_NE(recorder.WarningText().find("; 4 points have no fit"), std::string::npos)
    << recorder.WarningText();
}

TEST(Ghosts, DuplicatesServeTheirNeighboursAndAreReportedByTheirOwner)
{
  const auto mesh = BlendData(24);
  const Outputs whole = RunFilters(mesh);
  const Outputs halves[] = { RunFilters(Half(mesh, 1.0)), RunFilters(Half(mesh, -1.0)) };
  EXPECT_EQ(halves[0].warnings + halves[0].errors, "");

  // Points get the values of the whole mesh.
  EXPECT_EQ(BytesOf(halves[0].fitted).size(), BytesOf(halves[1].fitted).size());
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    ASSERT_EQ(Value(halves[0].fitted->GetPointData(), names::ThirdOrder, p),
      Value(whole.fitted->GetPointData(), names::ThirdOrder, p));
  }
  // Each umbilic is reported once, under its id, and the indices sum up.
  std::multiset<double> ids;
  double sum = 0.0;
  double length = 0.0;
  for (const Outputs& half : halves)
  {
    for (vtkIdType i = 0; i < half.umbilics->GetNumberOfPoints(); ++i)
    {
      ids.insert(Value(half.umbilics->GetPointData(), names::UmbilicId, i));
    }
    EXPECT_LT(half.umbilics->GetNumberOfPoints(), 8);
    EXPECT_EQ(half.marked->GetFieldData()->GetArray(names::UmbilicIndex)->GetNumberOfTuples(), 8);
    sum += Value(half.marked->GetFieldData(), names::UmbilicIndexSum, 0);
    length += TotalLength(half.ridges);
  }
  EXPECT_EQ(ids, (std::multiset<double>{ 0, 1, 2, 3, 4, 5, 6, 7 }));
  EXPECT_EQ(sum, 2.0);
  // As is each piece of the ridges. Their order of summation differs.
  EXPECT_NEAR(length, TotalLength(whole.ridges), 1e-12 * length);
  for (const Outputs& half : halves)
  {
    EXPECT_GT(half.ridges->GetNumberOfLines(), 0);
    EXPECT_LT(TotalLength(half.ridges), 0.9 * length);
  }
}

TEST(Ghosts, FoliationLeavesDuplicatesOut)
{
  const auto mesh = EllipsoidData(12);
  const auto half = RunFilters(Half(mesh, 1.0)).marked;
  vtkNew<vtkPrincipalFoliation> foliation;
  foliation->SetInputData(half);
  foliation->Update();
  EXPECT_GT(foliation->GetOutput()->GetNumberOfLines(), 0);
  for (vtkIdType p = 0; p < foliation->GetOutput()->GetNumberOfPoints(); ++p)
  {
    EXPECT_GT(foliation->GetOutput()->GetPoint(p)[0], -0.2); // an edge is 0.1
  }
}

TEST(Ghosts, CoherenceRefusesDuplicates)
{
  const Outputs half = RunFilters(Half(EllipsoidData(8), 1.0));
  vtkNew<vtkRidgeCoherence> coherence;
  const MessageRecorder recorder(coherence);
  coherence->SetInputData(0, half.marked);
  coherence->SetInputData(1, half.ridges);
  coherence->Update();
  EXPECT_EQ(recorder.NumberOfErrors(), 1u);
  EXPECT_NE(recorder.ErrorText().find("duplicates of cells"), std::string::npos)
    << recorder.ErrorText();
  EXPECT_EQ(coherence->GetOutput()->GetNumberOfRows(), 0);
}

TEST(Ghosts, WrongArrayIsAnError)
{
  const auto mesh = EllipsoidData(6);
  AddGhosts(mesh->GetCellData(), 5, 1, [](vtkIdType) { return true; });
  vtkNew<vtkJetFitting> jets;
  const MessageRecorder recorder(jets);
  jets->SetInputData(mesh);
  jets->Update();
  EXPECT_EQ(recorder.NumberOfErrors(), 1u);
  EXPECT_NE(recorder.ErrorText().find("vtkGhostType has 5 tuples, not 720"), std::string::npos)
    << recorder.ErrorText();
  EXPECT_TRUE(IsEmpty(jets->GetOutput()));
}

TEST(Ghosts, LevelsAreRequestedWhereTheMeshComesInPieces)
{
  vtkNew<PieceSource> source;
  source->data = EllipsoidData(6);
  vtkNew<vtkJetFitting> jets;
  jets->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkUmbilicDetection> umbilics;
  umbilics->SetInputConnection(jets->GetOutputPort());
  vtkNew<vtkRidgeExtraction> ridges;
  ridges->SetInputConnection(umbilics->GetOutputPort());
  {
    const MessageRecorder recorder(jets);
    ridges->Update();
    EXPECT_EQ(source->askedLevels, 0);
    EXPECT_EQ(recorder.WarningText(), "");
  }
  const MessageRecorder recorder(jets);
  jets->SetNeighborhoodToRings();
  jets->SetNumberOfRings(3);
  ridges->UpdatePiece(0, 4, 0);
  EXPECT_EQ(source->askedLevels, 3 + 5 + 1); // of the fit, the patches and the ridges
  EXPECT_NE(recorder.WarningText().find("has no ghost cells"), std::string::npos)
    << recorder.WarningText();

  vtkNew<vtkRidgesAndUmbilics> all;
  const MessageRecorder recorderOfAll(all);
  all->SetInputConnection(source->GetOutputPort());
  all->SetNeighborhoodToRings();
  all->SetNumberOfRings(3);
  all->UpdatePiece(1, 4, 0);
  EXPECT_EQ(source->askedLevels, 3 + 5 + 1);
  EXPECT_EQ(recorderOfAll.NumberOfWarnings(), 1u);
}
