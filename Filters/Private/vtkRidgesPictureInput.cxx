// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesPictureInput.h"

#include "vtkRidgesArrayNames.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <limits>

namespace names = vtkRidgesArrayNames;
using ridges::Id;

namespace
{

/// A value of an array that holds ids or small numbers; -1 for what cannot be one.
Id IdAt(vtkDataArray* array, vtkIdType tuple)
{
  const double value = array->GetComponent(tuple, 0);
  return value >= 0.0 && value < std::numeric_limits<Id>::max() ? static_cast<Id>(value) : -1;
}

ridges::RidgeType TypeAt(vtkDataArray* array, vtkIdType tuple)
{
  const Id value = IdAt(array, tuple);
  return value >= 0 && value <= 4 ? static_cast<ridges::RidgeType>(value)
                                  : ridges::RidgeType::Undecided;
}

} // namespace

std::string vtkRidgesPictureInput::Fetch(
  vtkPolyData* mesh, vtkPolyData* ridges, vtkPolyData* umbilics)
{
  this->Faults.clear();
  this->FetchMesh(mesh);
  this->FetchUmbilics(umbilics);
  this->FetchRidges(ridges);
  return this->Faults;
}

vtkDataArray* vtkRidgesPictureInput::FetchArray(
  const Source& source, const char* name, int components)
{
  vtkDataArray* array = source.arrays->GetArray(name);
  const bool good = array && array->GetNumberOfComponents() == components &&
    (source.tuples < 0 || array->GetNumberOfTuples() >= source.tuples);
  if (!good)
  {
    this->Faults += (this->Faults.empty() ? "" : ", ") + std::string(name) + " of " + source.name;
  }
  return good ? array : nullptr;
}

void vtkRidgesPictureInput::FetchMesh(vtkPolyData* mesh)
{
  if (mesh->GetNumberOfPoints() > 0)
  {
    const std::string faults = this->Arrays.Fetch(mesh, false);
    this->Faults += faults.empty() ? "" : faults + " of the mesh";
  }
  if (!this->Mesh.Build(mesh))
  {
    this->Faults += ", a numbering of the mesh in 32 bits";
    return;
  }
  const ridges::TriangleMesh& triangles = this->Mesh.GetTriangles();
  vtkPolyData* data = this->Mesh.GetPolyData();
  vtkDataArray* patch = nullptr;
  if (mesh->GetNumberOfPoints() > 0)
  {
    patch = this->FetchArray(
      { "the mesh's cells", data->GetCellData(), data->GetNumberOfCells() }, names::UmbilicPatch);
  }
  vtkDataArray* cancelled = data->GetCellData()->GetArray(names::CancelledUmbilics);

  this->Picture.mesh = &triangles;
  this->Picture.field = this->Arrays.GetField();
  this->TriangleOfCell.assign(data->GetNumberOfCells(), -1);
  const std::vector<std::uint8_t>& usable = this->Arrays.GetUsable();
  for (Id t = 0; t < triangles.NumberOfTriangles(); ++t)
  {
    const vtkIdType cell = this->Mesh.GetCellId(t);
    this->TriangleOfCell[cell] = t;
    const bool good = ridges::AreUsable(triangles.Corners(t), usable.data());
    this->Picture.isUsable.push_back(good ? 1 : 0);
    this->Picture.patchOf.push_back(patch ? IdAt(patch, cell) : -1);
    this->Picture.cancelledIn.push_back(cancelled ? IdAt(cancelled, cell) : -1);
  }
}

Id vtkRidgesPictureInput::TriangleOf(vtkIdType cell) const
{
  return cell >= 0 && cell < static_cast<vtkIdType>(this->TriangleOfCell.size())
    ? this->TriangleOfCell[cell]
    : -1;
}

void vtkRidgesPictureInput::FetchUmbilics(vtkPolyData* umbilics)
{
  vtkDataArray* id = nullptr;
  vtkDataArray* index = nullptr;
  vtkDataArray* ridgeCount = nullptr;
  vtkDataArray* triangle = nullptr;
  vtkDataArray* position = nullptr;
  vtkIdType count = 0;
  if (umbilics)
  {
    count = umbilics->GetNumberOfPoints();
    const Source source{ "the umbilics", umbilics->GetPointData(), count };
    if (count > 0)
    {
      id = this->FetchArray(source, names::UmbilicId);
      index = this->FetchArray(source, names::Index);
      ridgeCount = this->FetchArray(source, names::RidgeCount);
      triangle = this->FetchArray(source, names::Triangle);
    }
  }
  else if (this->Mesh.GetPolyData()->GetNumberOfPoints() > 0)
  {
    Source source{ "the mesh's field data", this->Mesh.GetPolyData()->GetFieldData(), -1 };
    position = this->FetchArray(source, names::UmbilicPosition, 3);
    count = source.tuples = position ? position->GetNumberOfTuples() : 0;
    index = this->FetchArray(source, names::UmbilicIndex);
    ridgeCount = this->FetchArray(source, names::UmbilicRidgeCount);
    triangle = this->FetchArray(source, names::UmbilicTriangle);
  }
  if (!this->Faults.empty())
  {
    return;
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    ridges::PictureUmbilic umbilic;
    umbilic.id = id ? IdAt(id, i) : static_cast<Id>(i);
    umbilic.triangle = this->TriangleOf(IdAt(triangle, i));
    umbilic.ridgeCount = IdAt(ridgeCount, i);
    umbilic.index = index->GetComponent(i, 0);
    if (position)
    {
      position->GetTuple(i, umbilic.position.data());
    }
    else
    {
      umbilics->GetPoint(i, umbilic.position.data());
    }
    this->Picture.umbilics.push_back(umbilic);
  }
}

void vtkRidgesPictureInput::FetchRidges(vtkPolyData* ridges)
{
  if (ridges->GetNumberOfLines() == 0)
  {
    return;
  }
  const Source cells{ "the ridges", ridges->GetCellData(), ridges->GetNumberOfCells() };
  const Source points{ "the ridges", ridges->GetPointData(), ridges->GetNumberOfPoints() };
  vtkDataArray* type = this->FetchArray(cells, names::RidgeType);
  vtkDataArray* ridgeId = this->FetchArray(cells, names::RidgeId);
  vtkDataArray* closed = this->FetchArray(cells, names::Closed);
  vtkDataArray* umbilic = this->FetchArray(points, names::Umbilic);
  vtkDataArray* turningPoint = this->FetchArray(points, names::TurningPoint);
  vtkDataArray* edgePoint0 = this->FetchArray(points, names::EdgePoint0);
  vtkDataArray* edgePoint1 = this->FetchArray(points, names::EdgePoint1);
  vtkDataArray* parameter = this->FetchArray(points, names::EdgeParameter);
  if (!this->Faults.empty())
  {
    return;
  }

  for (vtkIdType i = 0; i < ridges->GetNumberOfPoints(); ++i)
  {
    ridges::PicturePoint point;
    const Id p = IdAt(edgePoint0, i);
    const Id q = IdAt(edgePoint1, i);
    point.edge =
      p < 0 && q < 0 ? ridges::PicturePoint::None : ridges::FindEdge(*this->Picture.mesh, p, q);
    // The parameter is told from the first point, which should be the smaller id.
    point.parameter = parameter->GetComponent(i, 0);
    point.parameter = p <= q ? point.parameter : 1.0 - point.parameter;
    point.umbilic = IdAt(umbilic, i);
    point.turning = turningPoint->GetComponent(i, 0) != 0.0;
    ridges->GetPoint(i, point.position.data());
    this->Picture.points.push_back(point);
  }
  vtkIdType cell = ridges->GetNumberOfVerts();
  vtkNew<vtkIdList> ids;
  for (ridges->GetLines()->InitTraversal(); ridges->GetLines()->GetNextCell(ids); ++cell)
  {
    ridges::PictureLine line;
    line.type = TypeAt(type, cell);
    line.ridge = IdAt(ridgeId, cell);
    line.closed = closed->GetComponent(cell, 0) != 0.0;
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      line.points.push_back(static_cast<Id>(ids->GetId(i)));
    }
    this->Picture.lines.push_back(line);
  }
}
