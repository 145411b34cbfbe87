// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesUmbilicMarks.h"

#include "vtkRidgesArrayNames.h"
#include "vtkRidgesCollect.h"
#include "vtkRidgesMesh.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace names = vtkRidgesArrayNames;

vtkRidgesUmbilicMarks::vtkRidgesUmbilicMarks(const vtkRidgesMesh& mesh)
  : Mesh(mesh)
{
  vtkCellData* cellData = mesh.GetPolyData()->GetCellData();
  this->Patch = cellData->GetArray(names::UmbilicPatch);
  if (this->Patch)
  {
    this->FetchUmbilics();
    this->FetchRegions(this->Patch, 0);
  }
  if (vtkDataArray* cancelled = cellData->GetArray(names::CancelledUmbilics))
  {
    this->FetchRegions(cancelled, this->Patches.size());
  }
}

void vtkRidgesUmbilicMarks::FetchUmbilics()
{
  vtkFieldData* fieldData = this->Mesh.GetPolyData()->GetFieldData();
  vtkDataArray* position = fieldData->GetArray(names::UmbilicPosition);
  vtkDataArray* ridgeCount = fieldData->GetArray(names::UmbilicRidgeCount);
  vtkDataArray* triangle = fieldData->GetArray(names::UmbilicTriangle);
  if (!position || position->GetNumberOfComponents() != 3 || !ridgeCount || !triangle)
  {
    return;
  }
  const vtkIdType count = std::min(position->GetNumberOfTuples(),
    std::min(ridgeCount->GetNumberOfTuples(), triangle->GetNumberOfTuples()));
  for (vtkIdType i = 0; i < count; ++i)
  {
    Eigen::Vector3d x;
    position->GetTuple(i, x.data());
    this->Positions.push_back(x);
    ridges::RidgePatch patch;
    patch.position = x;
    patch.ridgeCount = ridgeCount->GetComponent(i, 0) == 3.0 ? 3 : 1;
    this->Patches.push_back(patch);
    // Of several in one triangle the first has the patch.
    this->UmbilicOfCell.insert({ static_cast<vtkIdType>(triangle->GetComponent(i, 0)), i });
  }
}

void vtkRidgesUmbilicMarks::FetchRegions(vtkDataArray* regions, std::size_t firstPatch)
{
  auto* exact = vtkIdTypeArray::SafeDownCast(regions);
  const vtkIdType* values = exact ? exact->GetPointer(0) : nullptr;
  const ridges::TriangleMesh& triangles = this->Mesh.GetTriangles();
  const auto regionOf = [&](ridges::Id t)
  {
    const vtkIdType cell = this->Mesh.GetCellId(t);
    return values ? values[cell] : static_cast<vtkIdType>(regions->GetComponent(cell, 0));
  };
  for (const ridges::Id t :
    vtkRidgesWhere(triangles.NumberOfTriangles(), [&](ridges::Id i) { return regionOf(i) >= 0; }))
  {
    const vtkIdType region = regionOf(t);
    // No more regions than triangles: other numbers are not of vtkUmbilicDetection.
    if (region >= triangles.NumberOfTriangles())
    {
      continue;
    }
    const std::size_t patch = firstPatch + static_cast<std::size_t>(region);
    if (patch >= this->Patches.size())
    {
      this->Patches.resize(patch + 1);
    }
    this->Patches[patch].triangles.push_back(t);
    const auto umbilic = this->UmbilicOfCell.find(this->Mesh.GetCellId(t));
    if (umbilic != this->UmbilicOfCell.end() && umbilic->second == static_cast<vtkIdType>(patch))
    {
      this->Patches[patch].umbilic = t;
    }
  }
}

vtkIdType vtkRidgesUmbilicMarks::UmbilicAt(ridges::Id triangle) const
{
  const auto found = this->UmbilicOfCell.find(this->Mesh.GetCellId(triangle));
  return found == this->UmbilicOfCell.end() ? -1 : found->second;
}

vtkIdType vtkRidgesUmbilicMarks::PatchOf(ridges::Id triangle) const
{
  return this->Patch
    ? static_cast<vtkIdType>(this->Patch->GetComponent(this->Mesh.GetCellId(triangle), 0))
    : -1;
}
