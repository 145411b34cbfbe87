// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesPictureInput.h"

#include "vtkRidgesArrayNames.h"
#include "vtkRidgesArraySource.h"
#include "vtkRidgesUmbilicInput.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
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

/// What does not fit in 32 bits is no id of ours.
Id IdOf(vtkIdType value)
{
  return value >= 0 && value < std::numeric_limits<Id>::max() ? static_cast<Id>(value) : -1;
}

Id IdAt(vtkDataArray* array, vtkIdType tuple)
{
  return IdOf(vtkRidgesIdAt(array, tuple));
}

ridges::RidgeType TypeAt(vtkDataArray* array, vtkIdType tuple)
{
  const Id value = IdAt(array, tuple);
  return value >= 0 && value <= 4 ? static_cast<ridges::RidgeType>(value)
                                  : ridges::RidgeType::Undecided;
}

} // namespace

std::string vtkRidgesPictureInput::Fetch(
  vtkAlgorithm* filter, vtkPolyData* mesh, vtkPolyData* ridges, vtkPolyData* umbilics)
{
  this->Faults.clear();
  this->FetchMesh(filter, mesh);
  this->FetchUmbilics(umbilics);
  this->FetchRidges(ridges);
  return this->Faults;
}

void vtkRidgesPictureInput::AddFaults(const std::string& faults)
{
  this->Faults += (this->Faults.empty() || faults.empty() ? "" : ", ") + faults;
}

void vtkRidgesPictureInput::FetchMesh(vtkAlgorithm* filter, vtkPolyData* mesh)
{
  if (mesh->GetNumberOfPoints() > 0)
  {
    this->AddFaults(this->Arrays.Fetch(filter, mesh, false));
  }
  const std::string faults = this->Mesh.Build(mesh);
  if (!faults.empty())
  {
    this->AddFaults(faults);
    return;
  }
  const ridges::TriangleMesh& triangles = this->Mesh.GetTriangles();
  vtkPolyData* data = this->Mesh.GetPolyData();
  const vtkRidgesRegions patches(data, names::UmbilicPatch);
  const vtkRidgesRegions cancelled(data, names::CancelledUmbilics);
  if (mesh->GetNumberOfPoints() > 0 && !patches.AreThere())
  {
    this->AddFaults(std::string(names::UmbilicPatch) + " of the mesh's cells");
  }

  const auto zones = data->GetCellData()->GetArray(names::RidgeZone);
  const bool hasZones = zones && zones->GetNumberOfComponents() == 2 &&
    zones->GetNumberOfTuples() == data->GetNumberOfCells();
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
    if (hasZones)
    {
      this->Picture.isInMaximumZone.push_back(zones->GetComponent(cell, 0) >= 0.0 ? 1 : 0);
      this->Picture.isInMinimumZone.push_back(zones->GetComponent(cell, 1) >= 0.0 ? 1 : 0);
    }
    this->Picture.patchOf.push_back(IdOf(patches.At(cell)));
    this->Picture.cancelledIn.push_back(IdOf(cancelled.At(cell)));
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
  vtkRidgesUmbilicInput input;
  if (umbilics)
  {
    input.FetchFromVertices(umbilics);
  }
  else if (this->Mesh.GetPolyData()->GetNumberOfPoints() > 0)
  {
    input.FetchFromMesh(this->Mesh.GetPolyData());
  }
  this->AddFaults(input.GetFaults());
  for (const vtkRidgesUmbilicInput::Umbilic& found : input.GetUmbilics())
  {
    ridges::PictureUmbilic umbilic;
    umbilic.id = IdOf(found.id);
    umbilic.triangle = this->TriangleOf(found.cell);
    umbilic.position = found.position;
    umbilic.ridgeCount = found.ridgeCount;
    umbilic.index = found.index;
    this->Picture.umbilics.push_back(umbilic);
  }
}

void vtkRidgesPictureInput::FetchRidges(vtkPolyData* ridges)
{
  if (ridges->GetNumberOfLines() == 0)
  {
    return;
  }
  const vtkRidgesArraySource cells{ "the ridges", ridges->GetCellData(),
    ridges->GetNumberOfCells() };
  const vtkRidgesArraySource points{ "the ridges", ridges->GetPointData(),
    ridges->GetNumberOfPoints() };
  vtkDataArray* type = cells.Fetch(names::RidgeType, this->Faults);
  vtkDataArray* ridgeId = cells.Fetch(names::RidgeId, this->Faults);
  vtkDataArray* closed = cells.Fetch(names::Closed, this->Faults);
  vtkDataArray* umbilic = points.Fetch(names::Umbilic, this->Faults);
  vtkDataArray* turningPoint = points.Fetch(names::TurningPoint, this->Faults);
  vtkDataArray* edgePoint0 = points.Fetch(names::EdgePoint0, this->Faults);
  vtkDataArray* edgePoint1 = points.Fetch(names::EdgePoint1, this->Faults);
  vtkDataArray* parameter = points.Fetch(names::EdgeParameter, this->Faults);
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
