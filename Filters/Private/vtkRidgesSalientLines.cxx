// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesSalientLines.h"

#include "Core/Ridges/RidgeMeasures.h"
#include "Core/Salience/LineSmoothing.h"
#include "vtkRidgesArrayNames.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <map>
#include <utility>

namespace names = vtkRidgesArrayNames;
using ridges::Id;

namespace
{

/// The points of lines, with their arrays.
class PointWriter
{
public:
  explicit PointWriter(const ridges::TriangleMesh& mesh)
    : Mesh(mesh)
  {
    this->Points->SetDataTypeToDouble();
    this->Curvature->SetName(names::Curvature);
    this->SecondDerivative->SetName(names::SecondDerivative);
    this->FoldAngle->SetName(names::FoldAngle);
    this->FoldWidth->SetName(names::FoldWidth);
    this->ArcLength->SetName(names::ArcLength);
    this->EdgePoint0->SetName(names::EdgePoint0);
    this->EdgePoint1->SetName(names::EdgePoint1);
    this->EdgeParameter->SetName(names::EdgeParameter);
  }

  vtkIdType Insert(const ridges::RidgeVertex& vertex, const ridges::Fold& fold, double arc)
  {
    const ridges::RidgePoint& point = vertex.point;
    const double magnitude = point.gap > 0.0 ? point.P / point.gap : 0.0;
    this->Curvature->InsertNextValue(point.curvature);
    this->SecondDerivative->InsertNextValue(
      point.color == ridges::Color::Blue ? magnitude : -magnitude);
    this->FoldAngle->InsertNextValue(vtkMath::DegreesFromRadians(fold.angle));
    this->FoldWidth->InsertNextValue(fold.width);
    this->ArcLength->InsertNextValue(arc);
    const bool onEdge = vertex.edge != ridges::RidgeVertex::None;
    this->EdgePoint0->InsertNextValue(onEdge ? this->Mesh.EdgeAt(vertex.edge).v0 : -1);
    this->EdgePoint1->InsertNextValue(onEdge ? this->Mesh.EdgeAt(vertex.edge).v1 : -1);
    this->EdgeParameter->InsertNextValue(point.parameter);
    return this->Points->InsertNextPoint(point.position.data());
  }

  void Store(vtkPolyData* output)
  {
    output->SetPoints(this->Points);
    vtkPointData* data = output->GetPointData();
    for (vtkDataArray* array : std::initializer_list<vtkDataArray*>{ this->Curvature,
           this->SecondDerivative, this->FoldAngle, this->FoldWidth, this->ArcLength,
           this->EdgePoint0, this->EdgePoint1, this->EdgeParameter })
    {
      data->AddArray(array);
    }
  }

private:
  const ridges::TriangleMesh& Mesh;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkDoubleArray> Curvature, SecondDerivative, FoldAngle, FoldWidth, ArcLength,
    EdgeParameter;
  vtkNew<vtkIdTypeArray> EdgePoint0, EdgePoint1;
};

/// The arrays on lines.
class CellWriter
{
public:
  CellWriter()
  {
    this->RidgeType->SetName(names::RidgeType);
    this->Crest->SetName(names::Crest);
    this->Sharpness->SetName(names::Sharpness);
    this->Strength->SetName(names::Strength);
    this->Length->SetName(names::Length);
    this->RidgeId->SetName(names::RidgeId);
    this->Closed->SetName(names::Closed);
    this->FoldAngle->SetName(names::FoldAngle);
    this->FoldMass->SetName(names::FoldMass);
    this->Confidence->SetName(names::Confidence);
  }

  void Insert(const ridges::SalientLine& line, const std::vector<ridges::RidgePoint>& points,
    vtkIdType ridge, double diameter)
  {
    const ridges::RidgeType type = ridges::TypeOf(points.front().color, true);
    const ridges::RidgeMeasures measures =
      ridges::MeasureRidge(points, type, ridges::UmbilicCutOff());
    double margin = 0.0;
    for (const ridges::RidgePoint& point : points)
    {
      margin += point.crestMargin;
    }
    this->RidgeType->InsertNextValue(static_cast<int>(type));
    this->Crest->InsertNextValue(margin >= 0.0 ? 1 : 0);
    this->Sharpness->InsertNextValue(0.25 * diameter * diameter * measures.rawSharpness);
    this->Strength->InsertNextValue(measures.strength);
    this->Length->InsertNextValue(measures.length);
    this->RidgeId->InsertNextValue(ridge);
    this->Closed->InsertNextValue(line.closed ? 1 : 0);
    this->FoldAngle->InsertNextValue(vtkMath::DegreesFromRadians(line.angle));
    this->FoldMass->InsertNextValue(vtkMath::DegreesFromRadians(line.mass) / diameter);
    this->Confidence->InsertNextValue(line.confidence);
  }

  void Store(vtkPolyData* output)
  {
    vtkCellData* data = output->GetCellData();
    for (vtkDataArray* array : std::initializer_list<vtkDataArray*>{ this->RidgeType, this->Crest,
           this->Sharpness, this->Strength, this->Length, this->RidgeId, this->Closed,
           this->FoldAngle, this->FoldMass, this->Confidence })
    {
      data->AddArray(array);
    }
    data->SetActiveScalars(names::RidgeType);
  }

private:
  vtkNew<vtkIntArray> RidgeType, Crest, Closed;
  vtkNew<vtkIdTypeArray> RidgeId;
  vtkNew<vtkDoubleArray> Sharpness, Strength, Length, FoldAngle, FoldMass, Confidence;
};

} // namespace

void vtkRidgesSalientLines::Add(const std::vector<ridges::RidgeTrace>& ridges,
  const std::vector<ridges::RidgeFolds>& folds, std::vector<ridges::SalientLine> lines)
{
  for (ridges::SalientLine& line : lines)
  {
    const auto ridge = static_cast<std::size_t>(line.ridge);
    this->Entries.push_back({ std::move(line), &ridges[ridge], &folds[ridge] });
  }
}

void vtkRidgesSalientLines::MeetAtCorners(
  const ridges::MongeField& field, const ridges::CornerRule& rule)
{
  std::vector<ridges::LineOfRidge> lines;
  for (Entry& entry : this->Entries)
  {
    lines.push_back({ &entry.line, entry.ridge, entry.folds });
  }
  ridges::MeetAtCorners(this->Mesh, field, rule, lines);
}

/// The vertices, corners included.
std::vector<ridges::RidgeVertex> vtkRidgesSalientLines::VerticesOf(const Entry& entry)
{
  std::vector<ridges::RidgeVertex> vertices;
  if (entry.line.startCorner)
  {
    vertices.push_back(*entry.line.startCorner);
  }
  for (const Id id : entry.line.vertices)
  {
    vertices.push_back(entry.ridge->vertices[id]);
  }
  if (entry.line.endCorner)
  {
    vertices.push_back(*entry.line.endCorner);
  }
  return vertices;
}

/// Corners have the fold of the line's end.
const ridges::Fold& vtkRidgesSalientLines::FoldAt(const Entry& entry, std::size_t vertex)
{
  const std::vector<Id>& ids = entry.line.vertices;
  const std::size_t corner = entry.line.startCorner ? 1 : 0;
  const std::size_t at = vertex < corner ? 0 : std::min(vertex - corner, ids.size() - 1);
  return (*entry.folds)[ids[at]];
}

void vtkRidgesSalientLines::Store(
  const ridges::MongeField& field, double smoothing, vtkPolyData* output) const
{
  std::vector<const Entry*> order;
  for (const Entry& entry : this->Entries)
  {
    order.push_back(&entry);
  }
  // Equal ones stay in the order in which they were found, which positions alone decide.
  std::stable_sort(order.begin(), order.end(),
    [](const Entry* a, const Entry* b) { return a->line.mass > b->line.mass; });

  vtkNew<vtkCellArray> lines;
  PointWriter pointWriter(this->Mesh);
  CellWriter cellWriter;
  std::map<const ridges::RidgeTrace*, vtkIdType> ridgeIds;
  std::vector<ridges::RidgePoint> points;
  ridges::LineSmoother smoother(this->Mesh, field, smoothing);
  for (const Entry* entry : order)
  {
    std::vector<ridges::RidgeVertex> vertices = VerticesOf(*entry);
    smoother.Smooth(entry->line.closed, vertices);
    const auto ridge =
      ridgeIds.insert({ entry->ridge, static_cast<vtkIdType>(ridgeIds.size()) }).first->second;
    points.clear();
    lines->InsertNextCell(static_cast<int>(vertices.size()));
    double arc = 0.0;
    vtkIdType first = -1;
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      const ridges::RidgeVertex& vertex = vertices[i];
      points.push_back(vertex.point);
      if (i > 0)
      {
        arc += (vertex.point.position - points[i - 1].position).norm();
      }
      const bool returns = entry->line.closed && i + 1 == vertices.size();
      const vtkIdType id = returns ? first : pointWriter.Insert(vertex, FoldAt(*entry, i), arc);
      first = i == 0 ? id : first;
      lines->InsertCellPoint(id);
    }
    cellWriter.Insert(entry->line, points, ridge, this->Diameter);
  }
  pointWriter.Store(output);
  output->SetLines(lines);
  cellWriter.Store(output);
}
