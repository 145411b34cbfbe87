// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesUmbilicMarks.h"

#include "vtkRidgesArrayNames.h"
#include "vtkRidgesCollect.h"
#include "vtkRidgesMesh.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace names = vtkRidgesArrayNames;

vtkRidgesUmbilicMarks::vtkRidgesUmbilicMarks(const vtkRidgesMesh& mesh)
  : Mesh(mesh)
  , PatchOfCell(mesh.GetPolyData(), names::UmbilicPatch)
{
  if (this->PatchOfCell.AreThere())
  {
    this->FetchUmbilics();
    this->FetchRegions(this->PatchOfCell, 0);
  }
  const vtkRidgesRegions cancelled(mesh.GetPolyData(), names::CancelledUmbilics);
  if (cancelled.AreThere())
  {
    this->FetchRegions(cancelled, this->Patches.size());
  }
}

void vtkRidgesUmbilicMarks::RemoveFrom(vtkPolyData* output)
{
  for (const char* name :
    { names::UmbilicPatch, names::CancelledUmbilics, names::UmbilicZone, names::RidgeZone })
  {
    output->GetCellData()->RemoveArray(name);
  }
  // The field data is still the input's own, which is not ours to change.
  vtkNew<vtkFieldData> field;
  field->ShallowCopy(output->GetFieldData());
  for (const char* name : { names::UmbilicPosition, names::UmbilicIndex, names::UmbilicRidgeCount,
         names::UmbilicTriangle, names::UmbilicIndexSum, names::EulerCharacteristic,
         names::NumberOfCancelledRegions, names::NumberOfUmbilicZones, names::NumberOfRidgeZones })
  {
    field->RemoveArray(name);
  }
  output->SetFieldData(field);
}

void vtkRidgesUmbilicMarks::FetchUmbilics()
{
  vtkRidgesUmbilicInput input;
  input.FetchFromMesh(this->Mesh.GetPolyData());
  for (const vtkRidgesUmbilicInput::Umbilic& umbilic : input.GetUmbilics())
  {
    // Of several in one triangle the first has the patch.
    this->UmbilicOfCell.insert({ umbilic.cell, static_cast<vtkIdType>(this->Positions.size()) });
    this->Positions.push_back(umbilic.position);
    ridges::RidgePatch patch;
    patch.position = umbilic.position;
    patch.ridgeCount = umbilic.ridgeCount == 3 ? 3 : 1;
    this->Patches.push_back(patch);
  }
}

void vtkRidgesUmbilicMarks::FetchRegions(const vtkRidgesRegions& regions, std::size_t firstPatch)
{
  const ridges::TriangleMesh& triangles = this->Mesh.GetTriangles();
  const auto regionOf = [this, &regions](ridges::Id t)
  { return regions.At(this->Mesh.GetCellId(t)); };
  for (const ridges::Id t : vtkRidgesWhere(
         triangles.NumberOfTriangles(), [&regionOf](ridges::Id i) { return regionOf(i) >= 0; }))
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
  return this->PatchOfCell.At(this->Mesh.GetCellId(triangle));
}
