// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesUmbilicInput.h"

#include "vtkRidgesArrayNames.h"
#include "vtkRidgesArraySource.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace names = vtkRidgesArrayNames;

void vtkRidgesUmbilicInput::FetchFromMesh(vtkPolyData* mesh)
{
  this->Faults.clear();
  vtkRidgesArraySource source{ "the mesh's field data", mesh->GetFieldData(), 0 };
  Arrays arrays;
  arrays.position = source.Fetch(names::UmbilicPosition, this->Faults, 3);
  source.tuples = arrays.position ? arrays.position->GetNumberOfTuples() : 0;
  arrays.index = source.Fetch(names::UmbilicIndex, this->Faults);
  arrays.ridgeCount = source.Fetch(names::UmbilicRidgeCount, this->Faults);
  arrays.cell = source.Fetch(names::UmbilicTriangle, this->Faults);
  const bool good = arrays.position && arrays.ridgeCount && arrays.cell;
  this->Read(arrays, good ? source.tuples : 0);
}

void vtkRidgesUmbilicInput::FetchFromVertices(vtkPolyData* vertices)
{
  this->Faults.clear();
  const vtkIdType count = vertices->GetNumberOfPoints();
  Arrays arrays;
  if (count > 0)
  {
    const vtkRidgesArraySource source{ "the umbilics", vertices->GetPointData(), count };
    arrays.id = source.Fetch(names::UmbilicId, this->Faults);
    arrays.index = source.Fetch(names::Index, this->Faults);
    arrays.ridgeCount = source.Fetch(names::RidgeCount, this->Faults);
    arrays.cell = source.Fetch(names::Triangle, this->Faults);
  }
  this->Read(arrays, arrays.id && arrays.ridgeCount && arrays.cell ? count : 0);
  for (vtkIdType i = 0; i < static_cast<vtkIdType>(this->Umbilics.size()); ++i)
  {
    vertices->GetPoint(i, this->Umbilics[i].position.data());
  }
}

void vtkRidgesUmbilicInput::Read(const Arrays& arrays, vtkIdType count)
{
  this->Umbilics.assign(count, {});
  for (vtkIdType i = 0; i < count; ++i)
  {
    Umbilic& umbilic = this->Umbilics[i];
    umbilic.id = arrays.id ? vtkRidgesIdAt(arrays.id, i) : i;
    umbilic.cell = vtkRidgesIdAt(arrays.cell, i);
    umbilic.ridgeCount = static_cast<int>(vtkRidgesIdAt(arrays.ridgeCount, i));
    umbilic.index = arrays.index ? arrays.index->GetComponent(i, 0) : 0.0;
    if (arrays.position)
    {
      arrays.position->GetTuple(i, umbilic.position.data());
    }
  }
}

vtkRidgesRegions::vtkRidgesRegions(vtkPolyData* mesh, const char* array)
{
  vtkDataArray* found = mesh->GetCellData()->GetArray(array);
  if (found && found->GetNumberOfComponents() == 1 &&
    found->GetNumberOfTuples() >= mesh->GetNumberOfCells())
  {
    this->Array = found;
    auto* exact = vtkIdTypeArray::SafeDownCast(found);
    this->Values = exact ? exact->GetPointer(0) : nullptr;
  }
}

vtkIdType vtkRidgesRegions::At(vtkIdType cell) const
{
  if (this->Values)
  {
    return this->Values[cell];
  }
  return this->Array ? vtkRidgesIdAt(this->Array, cell) : -1;
}
