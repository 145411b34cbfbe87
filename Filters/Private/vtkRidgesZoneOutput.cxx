// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesZoneOutput.h"

#include "vtkRidgesAllocate.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesFieldData.h"
#include "vtkRidgesMesh.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

namespace names = vtkRidgesArrayNames;

void vtkRidgesZoneOutput::MarkOnMesh(const vtkRidgesMesh& mesh, vtkPolyData* output) const
{
  output->ShallowCopy(mesh.GetPolyData());
  mesh.HandOnWith(output);
  vtkNew<vtkIdTypeArray> zone;
  zone->SetName(names::RidgeZone);
  zone->SetNumberOfComponents(2);
  zone->SetComponentName(0, "Maximum");
  zone->SetComponentName(1, "Minimum");
  vtkRidgesAllocate({ zone }, output->GetNumberOfCells());
  vtkIdType* values = zone->GetPointer(0);
  vtkSMPTools::Fill(values, values + zone->GetNumberOfValues(), vtkIdType(-1));
  vtkIdType number = 0;
  for (const vtkRidgesZones* zones : { &this->maximum, &this->minimum })
  {
    const int component = zones == &this->maximum ? 0 : 1;
    for (const std::vector<ridges::Id>& triangles : zones->triangles)
    {
      for (const ridges::Id t : triangles)
      {
        values[2 * mesh.GetCellId(t) + component] = number;
      }
      ++number;
    }
  }
  output->GetCellData()->AddArray(zone);
  this->StoreNumber(output);
}

void vtkRidgesZoneOutput::StoreNumber(vtkPolyData* output) const
{
  vtkRidgesAddFieldValue<vtkIntArray>(vtkRidgesOwnFieldData(output), names::NumberOfRidgeZones,
    static_cast<int>(this->NumberOfZones()));
}

std::size_t vtkRidgesZoneOutput::NumberOfZones() const
{
  return this->maximum.triangles.size() + this->minimum.triangles.size();
}

std::string vtkRidgesZoneOutput::Warning() const
{
  const std::size_t zones = this->NumberOfZones();
  const vtkIdType ridges = this->maximum.numberOfRidges + this->minimum.numberOfRidges;
  return zones == 0 ? ""
                    : std::to_string(ridges) + " ridges were left out in " + std::to_string(zones) +
      " regions (RidgeZone) where the derivative of their curvature is nowhere significant, as on "
      "planes, spheres and cylinders; with ZoneSignificance 0 they are kept.";
}
