// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesStreamedFit.h"

#include "vtkJetFitting.h"
#include "vtkRidgesMesh.h"
#include "vtkRidgesPiece.h"
#include "vtkRidgesRangeLoop.h"
#include "vtkRidgesSharedInput.h"
#include "vtkRidgesSharedRows.h"

#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

using ridges::Id;

namespace
{

/// What the mesh of a piece becomes, without what it takes to make that.
vtkSmartPointer<vtkPolyData> TrianglesOf(vtkPolyData* piece)
{
  vtkRidgesMesh mesh;
  mesh.Build(piece, {}, ridges::TriangleMesh::Edges::NotBuilt, vtkRidgesMesh::Duplicates::LeftOut);
  return mesh.GetPolyData();
}

} // namespace

vtkMTimeType vtkRidgesTimeOfSource(vtkAlgorithm* filter)
{
  if (filter->GetNumberOfInputConnections(0) == 0)
  {
    return 0;
  }
  auto* source = vtkDemandDrivenPipeline::SafeDownCast(filter->GetInputExecutive(0, 0));
  return source ? source->GetPipelineMTime() : 0;
}

vtkRidgesStreamedFit::vtkRidgesStreamedFit(vtkAlgorithm* filter, int pieces, int first)
  : NumberOfPieces(pieces)
  , First(first)
  , SourceTime(vtkRidgesTimeOfSource(filter))
  , Pieces(pieces)
  , CoordinateType(VTK_DOUBLE)
{
}

bool vtkRidgesStreamedFit::IsOf(vtkAlgorithm* filter, int pieces) const
{
  return pieces == this->NumberOfPieces && vtkRidgesTimeOfSource(filter) == this->SourceTime;
}

int vtkRidgesStreamedFit::NextPiece() const
{
  const int taken = this->Pieces.NumberOfPieces();
  return taken < this->NumberOfPieces ? (this->First + taken) % this->NumberOfPieces : -1;
}

/// How many were taken before it.
int vtkRidgesStreamedFit::IndexOf(int piece) const
{
  return (piece - this->First + this->NumberOfPieces) % this->NumberOfPieces;
}

void vtkRidgesStreamedFit::AskFor(vtkInformationVector* input, int piece) const
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (int i = 0; i < input->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* info = input->GetInformationObject(i);
    info->Set(Pipeline::UPDATE_PIECE_NUMBER(), this->IsComplete() ? piece : this->NextPiece());
    info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), this->NumberOfPieces);
  }
}

std::string vtkRidgesStreamedFit::Take(vtkPolyData* piece)
{
  vtkRidgesMesh mesh;
  std::string faults = mesh.Build(
    piece, {}, ridges::TriangleMesh::Edges::NotBuilt, vtkRidgesMesh::Duplicates::LeftOut);
  if (faults.empty() && piece->GetNumberOfPoints() > 0)
  {
    const std::string arrays = vtkRidgesDescribeArrays(piece);
    const bool isFirst = this->Arrays.empty();
    const std::string described = "arrays: " + arrays;
    if (!isFirst && described != this->Arrays)
    {
      faults = "the arrays differ between pieces: " + this->Arrays + "; " + described;
    }
    this->Arrays = described;
    this->CoordinateType = piece->GetPoints()->GetDataType();
  }
  if (!faults.empty())
  {
    return "in piece " + std::to_string(this->NextPiece()) + ": " + faults;
  }
  this->Faults.triangulatedCells += mesh.GetNumberOfTriangulatedCells();
  this->Faults.unusableTriangles += mesh.GetNumberOfUnusableTriangles();
  this->Pieces.Add(vtkRidgesPiece(mesh).GetView());
  return this->IsComplete() ? this->FinishTaking() : std::string();
}

std::string vtkRidgesStreamedFit::FinishTaking()
{
  std::string faults = this->Pieces.Finish();
  if (faults.empty())
  {
    this->Shared.TakeWhole(this->Pieces, vtkRidgesRangeLoop);
  }
  return faults;
}

bool vtkRidgesStreamedFit::Choose(vtkJetFitting* filter)
{
  if (this->Fits && filter->GetMTime() == this->ChoiceTime)
  {
    return true;
  }
  this->ChoiceTime = 0;
  this->IsFitted.assign(this->NumberOfPieces, 0);
  this->Fits = std::make_unique<vtkRidgesOwnedFits>(filter, this->Alone, this->Shared);
  if (!this->Fits->Choose())
  {
    this->Fits = nullptr;
    return false;
  }
  this->ChoiceTime = filter->GetMTime();
  return true;
}

int vtkRidgesStreamedFit::FitPiece(
  vtkJetFitting* filter, int piece, vtkPolyData* input, vtkPolyData* output)
{
  if (!this->Choose(filter))
  {
    return 1;
  }
  const vtkSmartPointer<vtkPolyData> triangles = TrianglesOf(input);
  const std::vector<Id> points = this->Pieces.PointsOf(this->IndexOf(piece));
  if (triangles->GetNumberOfPoints() != static_cast<vtkIdType>(points.size()))
  {
    vtkErrorWithObjectMacro(
      filter, "Piece " << piece << " is not the one that it was when it was asked for first.");
    return 0;
  }
  vtkNew<vtkPointData> values;
  if (!this->FitPoints(points, values))
  {
    return 1;
  }
  this->Fits->Store(triangles, values, output);
  this->IsFitted[piece] = 1;
  if (std::count(this->IsFitted.begin(), this->IsFitted.end(), 0) == 0)
  {
    this->Warn(filter);
    this->IsFitted.assign(this->NumberOfPieces, 0);
  }
  return 1;
}

/// False if the user aborted.
bool vtkRidgesStreamedFit::FitPoints(const std::vector<Id>& points, vtkPointData* values)
{
  // Several points of a piece may be one, if no triangle of the piece has them.
  std::vector<Id> different = points;
  std::sort(different.begin(), different.end());
  different.erase(std::unique(different.begin(), different.end()), different.end());
  if (different.size() == points.size())
  {
    return this->Fits->FitAndAverage(points, values);
  }
  vtkNew<vtkPointData> ofDifferent;
  if (!this->Fits->FitAndAverage(different, ofDifferent))
  {
    return false;
  }
  std::vector<Id> rows(points.size());
  std::transform(points.begin(), points.end(), rows.begin(),
    [&different](Id p)
    {
      return static_cast<Id>(
        std::lower_bound(different.begin(), different.end(), p) - different.begin());
    });
  vtkRidgesPickRows(ofDifferent, rows, values);
  return true;
}

void vtkRidgesStreamedFit::Warn(vtkJetFitting* filter) const
{
  vtkRidgesFitFaults all = this->Faults;
  all += this->Fits->CountFaults();
  all.triangles = this->Shared.NumberOfTriangles();
  const std::string text = all.GetText();
  if (!text.empty())
  {
    vtkWarningWithObjectMacro(filter, << text << ".");
  }
}
