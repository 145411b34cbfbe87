// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesPolylines.h"

#include "vtkRidgesArrayNames.h"
#include "vtkRidgesMesh.h"

#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace names = vtkRidgesArrayNames;
using ridges::Id;
using ridges::Ridge;
using ridges::RidgePoint;

vtkRidgesPolylines::vtkRidgesPolylines(const vtkRidgesMesh& mesh, const ridges::MongeField& field,
  const ridges::UmbilicCutOff& cutOff, double modelSize)
  : Mesh(mesh)
  , Field(field)
  , CutOff(cutOff)
  , ModelSize(modelSize)
  , UmbilicPatch(mesh.GetPolyData()->GetCellData()->GetArray(names::UmbilicPatch))
{
  this->Points->SetDataTypeToDouble();
  this->RidgeType->SetName(names::RidgeType);
  this->Crest->SetName(names::Crest);
  this->Sharpness->SetName(names::Sharpness);
  this->Strength->SetName(names::Strength);
  this->Length->SetName(names::Length);
  this->RidgeId->SetName(names::RidgeId);
  this->Closed->SetName(names::Closed);
  this->Curvature->SetName(names::Curvature);
  this->SecondDerivative->SetName(names::SecondDerivative);
  this->Umbilic->SetName(names::Umbilic);
  this->TurningPoint->SetName(names::TurningPoint);
  this->EdgePoint0->SetName(names::EdgePoint0);
  this->EdgePoint1->SetName(names::EdgePoint1);
  this->EdgeParameter->SetName(names::EdgeParameter);
}

// Near an umbilic the frames of neighbours differ by any angle, and P interpolated between them
// means little; section 6.5 says what it has to be.
void vtkRidgesPolylines::SetHyperbolicInPatches(
  const Ridge& ridge, std::vector<ridges::RidgeSegment>& segments, ridges::Color color) const
{
  const auto setFrom = [&](Id umbilicNode, auto first, auto last)
  {
    const vtkIdType umbilic =
      Ridge::IsUmbilic(umbilicNode) ? this->UmbilicIdOf(Ridge::TriangleOfUmbilic(umbilicNode)) : -1;
    for (auto s = first; umbilic >= 0 && s != last; ++s)
    {
      if (this->UmbilicIdOf(segments[*s].triangle) != umbilic)
      {
        break;
      }
      segments[*s].type = ridges::TypeOf(color, false);
      segments[*s].crest = false;
    }
  };
  setFrom(ridge.nodes.front(), ridge.segments.begin(), ridge.segments.end());
  setFrom(ridge.nodes.back(), ridge.segments.rbegin(), ridge.segments.rend());
}

void vtkRidgesPolylines::AddRidge(Ridge& ridge, std::vector<ridges::RidgeSegment>& segments,
  const ridges::RidgeCrossings& crossings)
{
  const ridges::Color color = crossings.RidgeColor();
  this->SetHyperbolicInPatches(ridge, segments, color);
  const std::vector<ridges::RidgeRun> runs = ridges::SplitByType(ridge, segments);
  const std::vector<RidgePoint> points = this->PointsOf(ridge, crossings);
  std::vector<vtkIdType> ids(points.size(), -1);
  const auto idOf = [&](Id i)
  {
    // A loop comes back to its first point.
    const Id slot = ridge.closed && i + 1 == static_cast<Id>(ids.size()) ? 0 : i;
    if (ids[slot] < 0)
    {
      ids[slot] = this->InsertPoint(ridge.nodes[slot], points[slot], color);
    }
    return ids[slot];
  };
  const auto typeOf = [&](Id i) { return segments[ridge.segments[i]].type; };

  const vtkIdType ridgeId = this->NextRidgeId++;
  vtkNew<vtkIdList> line;
  for (const ridges::RidgeRun& run : runs)
  {
    const ridges::RidgeSegment& segment = segments[ridge.segments[run.first]];
    if (this->CrestOnly && !segment.crest)
    {
      continue;
    }
    line->Reset();
    for (Id i = run.first; i <= run.last; ++i)
    {
      line->InsertNextId(idOf(i));
    }
    this->Lines->InsertNextCell(line);

    // The types at both sides of the run's ends, where there is another side.
    const Id last = static_cast<Id>(ridge.segments.size()) - 1;
    if (run.first > 0 || ridge.closed)
    {
      const bool turns = typeOf(run.first > 0 ? run.first - 1 : last) != segment.type;
      this->TurningPoint->SetValue(idOf(run.first), turns ? 1 : 0);
    }
    if (run.last <= last || ridge.closed)
    {
      const bool turns = typeOf(run.last <= last ? run.last : 0) != segment.type;
      this->TurningPoint->SetValue(idOf(run.last), turns ? 1 : 0);
    }

    const std::vector<RidgePoint> runPoints(
      points.begin() + run.first, points.begin() + run.last + 1);
    const auto measures = ridges::MeasureRidge(runPoints, segment.type, this->CutOff);
    this->RidgeType->InsertNextValue(static_cast<int>(segment.type));
    this->Crest->InsertNextValue(segment.crest ? 1 : 0);
    this->Sharpness->InsertNextValue(measures.rawSharpness * this->ModelSize * this->ModelSize);
    this->Strength->InsertNextValue(measures.strength);
    this->Length->InsertNextValue(measures.length);
    this->RidgeId->InsertNextValue(ridgeId);
    this->Closed->InsertNextValue(ridge.closed ? 1 : 0);
  }
}

std::vector<RidgePoint> vtkRidgesPolylines::PointsOf(
  const Ridge& ridge, const ridges::RidgeCrossings& crossings) const
{
  const ridges::TriangleMesh& mesh = this->Mesh.GetTriangles();
  std::vector<RidgePoint> points(ridge.nodes.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (!Ridge::IsUmbilic(ridge.nodes[i]))
    {
      points[i] = crossings.PointOn(ridge.nodes[i]);
    }
  }
  // A segment has at most one end at an umbilic, so the neighbours of such ends are on edges.
  const auto placeUmbilic = [&](std::size_t i, std::size_t next)
  {
    if (Ridge::IsUmbilic(ridge.nodes[i]))
    {
      points[i] = ridges::RidgePointAtUmbilic(
        mesh, this->Field, Ridge::TriangleOfUmbilic(ridge.nodes[i]), points[next]);
    }
  };
  placeUmbilic(0, 1);
  placeUmbilic(points.size() - 1, points.size() - 2);
  return points;
}

vtkIdType vtkRidgesPolylines::InsertPoint(Id node, const RidgePoint& point, ridges::Color color)
{
  vtkIdType umbilic = -1;
  vtkIdType edgePoints[2] = { -1, -1 };
  double secondDerivative = 0.0;
  if (Ridge::IsUmbilic(node))
  {
    // All ridges that meet at an umbilic, of both colours, share one point.
    const Id triangle = Ridge::TriangleOfUmbilic(node);
    const auto found = this->UmbilicPoints.find(triangle);
    if (found != this->UmbilicPoints.end())
    {
      return found->second;
    }
    this->UmbilicPoints[triangle] = this->Points->GetNumberOfPoints();
    umbilic = this->UmbilicIdOf(triangle);
  }
  else
  {
    const ridges::Edge& edge = this->Mesh.GetTriangles().EdgeAt(node);
    edgePoints[0] = edge.v0;
    edgePoints[1] = edge.v1;
    const double magnitude = point.gap > 0.0 ? point.P / point.gap : 0.0;
    secondDerivative = color == ridges::Color::Blue ? magnitude : -magnitude;
  }
  this->Curvature->InsertNextValue(point.curvature);
  this->SecondDerivative->InsertNextValue(secondDerivative);
  this->Umbilic->InsertNextValue(umbilic);
  this->TurningPoint->InsertNextValue(0);
  this->EdgePoint0->InsertNextValue(edgePoints[0]);
  this->EdgePoint1->InsertNextValue(edgePoints[1]);
  this->EdgeParameter->InsertNextValue(point.parameter);
  return this->Points->InsertNextPoint(point.position.data());
}

vtkIdType vtkRidgesPolylines::UmbilicIdOf(Id triangle) const
{
  return this->UmbilicPatch
    ? static_cast<vtkIdType>(this->UmbilicPatch->GetComponent(this->Mesh.GetCellId(triangle), 0))
    : -1;
}

void vtkRidgesPolylines::Store(vtkPolyData* output)
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
  cellData->SetActiveScalars(names::RidgeType);

  vtkPointData* pointData = output->GetPointData();
  pointData->AddArray(this->Curvature);
  pointData->AddArray(this->Umbilic);
  pointData->AddArray(this->TurningPoint);
  pointData->AddArray(this->EdgePoint0);
  pointData->AddArray(this->EdgePoint1);
  pointData->AddArray(this->EdgeParameter);
  if (this->Field.HasFourthOrder())
  {
    cellData->AddArray(this->Sharpness);
    pointData->AddArray(this->SecondDerivative);
  }
}
