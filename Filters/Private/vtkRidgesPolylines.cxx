// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesPolylines.h"

#include "Core/Mesh/BorderStrip.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesMesh.h"
#include "vtkRidgesUmbilicMarks.h"

#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace names = vtkRidgesArrayNames;
using ridges::Id;

namespace
{

/// The triangles that a vertex of a ridge lies in; none for a turning point.
std::vector<Id> TrianglesAt(const ridges::RidgeVertex& vertex, const ridges::TriangleMesh& mesh)
{
  if (vertex.umbilic != ridges::RidgeVertex::None)
  {
    return { vertex.umbilic };
  }
  if (vertex.edge == ridges::RidgeVertex::None)
  {
    return {};
  }
  const ridges::Edge& edge = mesh.EdgeAt(vertex.edge);
  return edge.t1 < 0 ? std::vector<Id>{ edge.t0 } : std::vector<Id>{ edge.t0, edge.t1 };
}

/// The triangle of the piece between the vertices i and i + 1; where it crosses several on its way
/// to an umbilic, that of the umbilic.
Id TriangleOfPiece(const ridges::RidgeTrace& ridge, Id i, const ridges::TriangleMesh& mesh)
{
  const Id last = static_cast<Id>(ridge.vertices.size()) - 1;
  Id from = i;
  Id to = i + 1;
  std::vector<Id> atStart = TrianglesAt(ridge.vertices[from], mesh);
  std::vector<Id> atEnd = TrianglesAt(ridge.vertices[to], mesh);
  while (atStart.empty() && from > 0)
  {
    atStart = TrianglesAt(ridge.vertices[--from], mesh);
  }
  while (atEnd.empty() && to < last)
  {
    atEnd = TrianglesAt(ridge.vertices[++to], mesh);
  }
  const auto common =
    std::find_first_of(atStart.begin(), atStart.end(), atEnd.begin(), atEnd.end());
  return common != atStart.end() ? *common : (atEnd.size() == 1 ? atEnd : atStart).front();
}

/// In degrees; 0 on a run that is not elliptic, which may begin or end where an elliptic one does.
double LargestAngle(const ridges::RidgeFolds& folds, const ridges::RidgeRun& run, bool isElliptic)
{
  double largest = 0.0;
  for (Id i = run.first; isElliptic && i <= run.last; ++i)
  {
    largest = std::max(largest, folds[i].angle);
  }
  return vtkMath::DegreesFromRadians(largest);
}

/// The share of its sure lengths in the length of a run; 0 without any.
double ShareOfSure(const ridges::RidgeTrace& ridge, const ridges::RidgeRun& run, double lengthOfRun)
{
  double sure = 0.0;
  for (Id i = run.first; i < run.last && !ridge.sureLengths.empty(); ++i)
  {
    sure += ridge.sureLengths[i];
  }
  return lengthOfRun > 0.0 ? std::min(sure / lengthOfRun, 1.0) : 0.0;
}

} // namespace

vtkRidgesPolylines::vtkRidgesPolylines(const vtkRidgesMesh& mesh,
  const vtkRidgesUmbilicMarks& umbilics, const ridges::UmbilicCutOff& cutOff, double modelSize)
  : Mesh(mesh)
  , Umbilics(umbilics)
  , CutOff(cutOff)
  , ModelSize(modelSize)
{
  this->Points->SetDataTypeToDouble();
  this->RidgeType->SetName(names::RidgeType);
  this->Crest->SetName(names::Crest);
  this->Confidence->SetName(names::Confidence);
  this->Sharpness->SetName(names::Sharpness);
  this->Strength->SetName(names::Strength);
  this->Length->SetName(names::Length);
  this->RidgeId->SetName(names::RidgeId);
  this->Closed->SetName(names::Closed);
  this->NearBorder->SetName(names::NearBorder);
  this->Curvature->SetName(names::Curvature);
  this->SecondDerivative->SetName(names::SecondDerivative);
  this->Umbilic->SetName(names::Umbilic);
  this->TurningPoint->SetName(names::TurningPoint);
  this->EdgePoint0->SetName(names::EdgePoint0);
  this->EdgePoint1->SetName(names::EdgePoint1);
  this->EdgeParameter->SetName(names::EdgeParameter);
  this->FoldAngle->SetName(names::FoldAngle);
  this->FoldWidth->SetName(names::FoldWidth);
  this->LargestFoldAngle->SetName(names::FoldAngle);
}

bool vtkRidgesPolylines::AddRidges(const std::vector<ridges::RidgeTrace>& ridges,
  const std::vector<ridges::RidgeFolds>* folds, const ridges::Monitor& monitor)
{
  for (std::size_t i = 0; i < ridges.size(); ++i)
  {
    constexpr std::size_t between = 1024;
    if (i % between == 0 && !monitor(static_cast<double>(i) / ridges.size()))
    {
      return false;
    }
    this->AddRidge(ridges[i], folds ? &(*folds)[i] : nullptr);
  }
  return true;
}

void vtkRidgesPolylines::AddRidge(const ridges::RidgeTrace& ridge, const ridges::RidgeFolds* folds)
{
  std::vector<vtkIdType> ids(ridge.vertices.size(), -1);
  const auto idOf = [this, &ids, &ridge, folds](Id i)
  {
    // A loop comes back to its first point.
    const Id slot = ridge.closed && i + 1 == static_cast<Id>(ids.size()) ? 0 : i;
    if (ids[slot] < 0)
    {
      ids[slot] = this->InsertVertex(ridge.vertices[slot], folds ? &(*folds)[slot] : nullptr);
    }
    return ids[slot];
  };

  const vtkIdType ridgeId = this->NextRidgeId++;
  const Id last = static_cast<Id>(ridge.types.size()) - 1;
  vtkNew<vtkIdList> line;
  std::vector<ridges::RidgePoint> points;
  for (const ridges::RidgeRun& run : this->OwnedRunsOf(ridge))
  {
    const ridges::RidgeType type = ridge.types[run.first];
    const bool crest = ridge.IsCrest(run.first);
    if (this->CrestOnly && !crest)
    {
      continue;
    }
    line->Reset();
    points.clear();
    for (Id i = run.first; i <= run.last; ++i)
    {
      line->InsertNextId(idOf(i));
      points.push_back(ridge.vertices[i].point);
    }
    this->Lines->InsertNextCell(line);

    // The types at both sides of the run's ends, where there is another side.
    if (run.first > 0 || ridge.closed)
    {
      const bool turns = ridge.types[run.first > 0 ? run.first - 1 : last] != type;
      this->TurningPoint->SetValue(idOf(run.first), turns ? 1 : 0);
    }
    if (run.last <= last || ridge.closed)
    {
      const bool turns = ridge.types[run.last <= last ? run.last : 0] != type;
      this->TurningPoint->SetValue(idOf(run.last), turns ? 1 : 0);
    }

    const auto measures = ridges::MeasureRidge(points, type, this->CutOff);
    this->RidgeType->InsertNextValue(static_cast<int>(type));
    this->Crest->InsertNextValue(crest ? 1 : 0);
    this->Sharpness->InsertNextValue(measures.rawSharpness * this->ModelSize * this->ModelSize);
    this->Strength->InsertNextValue(measures.strength);
    this->Confidence->InsertNextValue(ShareOfSure(ridge, run, measures.length));
    this->Length->InsertNextValue(measures.length);
    this->RidgeId->InsertNextValue(ridgeId);
    this->Closed->InsertNextValue(ridge.closed ? 1 : 0);
    this->NearBorder->InsertNextValue(this->IsNearBorder(ridge, run) ? 1 : 0);
    if (folds)
    {
      this->LargestFoldAngle->InsertNextValue(LargestAngle(*folds, run, ridges::IsElliptic(type)));
    }
  }
}

/// Whether all of a run is; a turning point is where its neighbours are.
bool vtkRidgesPolylines::IsNearBorder(
  const ridges::RidgeTrace& ridge, const ridges::RidgeRun& run) const
{
  const ridges::TriangleMesh& mesh = this->Mesh.GetTriangles();
  const auto isNear = [this, &mesh](const ridges::RidgeVertex& vertex)
  {
    if (vertex.umbilic != ridges::RidgeVertex::None)
    {
      return ridges::IsInStrip(mesh, this->BorderStrip, vertex.umbilic);
    }
    if (vertex.edge == ridges::RidgeVertex::None)
    {
      return true;
    }
    const ridges::Edge& edge = mesh.EdgeAt(vertex.edge);
    return this->BorderStrip[edge.v0] != 0 || this->BorderStrip[edge.v1] != 0;
  };
  return !this->BorderStrip.empty() &&
    std::all_of(ridge.vertices.begin() + run.first, ridge.vertices.begin() + run.last + 1, isNear);
}

/// The runs of one type, without their parts in triangles that belong to another piece.
std::vector<ridges::RidgeRun> vtkRidgesPolylines::OwnedRunsOf(const ridges::RidgeTrace& ridge) const
{
  std::vector<ridges::RidgeRun> runs = RunsOf(ridge);
  if (!this->Mesh.HasDuplicates())
  {
    return runs;
  }
  const auto isOwned = [this, &ridge](Id piece)
  { return this->Mesh.IsOwned(TriangleOfPiece(ridge, piece, this->Mesh.GetTriangles())); };
  std::vector<ridges::RidgeRun> owned;
  for (const ridges::RidgeRun& run : runs)
  {
    for (Id i = run.first; i < run.last; ++i)
    {
      if (isOwned(i))
      {
        if (owned.empty() || i == run.first || owned.back().last != i)
        {
          owned.push_back({ i, i });
        }
        owned.back().last = i + 1;
      }
    }
  }
  return owned;
}

vtkIdType vtkRidgesPolylines::InsertVertex(
  const ridges::RidgeVertex& vertex, const ridges::Fold* fold)
{
  const ridges::RidgePoint& point = vertex.point;
  vtkIdType umbilic = -1;
  vtkIdType edgePoints[2] = { -1, -1 };
  double secondDerivative = 0.0;
  if (vertex.umbilic != ridges::RidgeVertex::None)
  {
    // All ridges that meet at an umbilic, of both colours, share one point.
    const auto inserted =
      this->UmbilicPoints.insert({ vertex.umbilic, this->Points->GetNumberOfPoints() });
    if (!inserted.second)
    {
      return inserted.first->second;
    }
    umbilic = this->Umbilics.UmbilicAt(vertex.umbilic);
  }
  else
  {
    const double magnitude = point.gap > 0.0 ? point.P / point.gap : 0.0;
    secondDerivative = point.color == ridges::Color::Blue ? magnitude : -magnitude;
  }
  if (vertex.edge != ridges::RidgeVertex::None)
  {
    const ridges::Edge& edge = this->Mesh.GetTriangles().EdgeAt(vertex.edge);
    edgePoints[0] = edge.v0;
    edgePoints[1] = edge.v1;
  }
  this->Curvature->InsertNextValue(point.curvature);
  this->SecondDerivative->InsertNextValue(secondDerivative);
  this->Umbilic->InsertNextValue(umbilic);
  this->TurningPoint->InsertNextValue(0);
  this->EdgePoint0->InsertNextValue(edgePoints[0]);
  this->EdgePoint1->InsertNextValue(edgePoints[1]);
  this->EdgeParameter->InsertNextValue(point.parameter);
  if (fold)
  {
    this->FoldAngle->InsertNextValue(vtkMath::DegreesFromRadians(fold->angle));
    this->FoldWidth->InsertNextValue(fold->width);
  }
  return this->Points->InsertNextPoint(point.position.data());
}

void vtkRidgesPolylines::Store(vtkPolyData* output, bool hasFourthOrder, bool hasFolds)
{
  output->SetPoints(this->Points);
  output->SetLines(this->Lines);

  vtkCellData* cellData = output->GetCellData();
  cellData->AddArray(this->RidgeType);
  cellData->AddArray(this->Crest);
  cellData->AddArray(this->Strength);
  cellData->AddArray(this->Length);
  cellData->AddArray(this->RidgeId);
  cellData->AddArray(this->Closed);
  cellData->AddArray(this->NearBorder);
  cellData->SetActiveScalars(names::RidgeType);

  vtkPointData* pointData = output->GetPointData();
  pointData->AddArray(this->Curvature);
  pointData->AddArray(this->Umbilic);
  pointData->AddArray(this->TurningPoint);
  pointData->AddArray(this->EdgePoint0);
  pointData->AddArray(this->EdgePoint1);
  pointData->AddArray(this->EdgeParameter);
  if (hasFourthOrder)
  {
    cellData->AddArray(this->Sharpness);
    cellData->AddArray(this->Confidence);
    pointData->AddArray(this->SecondDerivative);
  }
  if (hasFolds)
  {
    cellData->AddArray(this->LargestFoldAngle);
    pointData->AddArray(this->FoldAngle);
    pointData->AddArray(this->FoldWidth);
  }
}
