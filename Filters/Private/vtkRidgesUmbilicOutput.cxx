// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesUmbilicOutput.h"

#include "vtkRidgesAllocate.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesFieldData.h"
#include "vtkRidgesMakeArray.h"
#include "vtkRidgesMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

namespace names = vtkRidgesArrayNames;

namespace
{

/// The number of the region that a cell is in, -1 outside.
template <typename Regions>
void FillWithRegions(vtkIdTypeArray* array, const vtkRidgesMesh& mesh, const Regions& regions)
{
  vtkIdType* values = array->GetPointer(0);
  vtkSMPTools::Fill(values, values + array->GetNumberOfTuples(), vtkIdType(-1));
  for (std::size_t i = 0; i < regions.size(); ++i)
  {
    for (const ridges::Id t : regions[i])
    {
      values[mesh.GetCellId(t)] = static_cast<vtkIdType>(i);
    }
  }
}

} // namespace

void vtkRidgesUmbilicOutput::MarkOnMesh(const vtkRidgesMesh& mesh, vtkPolyData* output) const
{
  output->ShallowCopy(mesh.GetPolyData());
  mesh.HandOnWith(output);

  ridges::TriangleGroups patches;
  auto position = vtkRidgesMakeArray<vtkDoubleArray>(names::UmbilicPosition, 3);
  auto index = vtkRidgesMakeArray<vtkDoubleArray>(names::UmbilicIndex);
  auto ridgeCount = vtkRidgesMakeArray<vtkIntArray>(names::UmbilicRidgeCount);
  double indexSum = 0.0;
  auto triangle = vtkRidgesMakeArray<vtkIdTypeArray>(names::UmbilicTriangle);
  for (const ridges::Umbilic& umbilic : this->umbilics)
  {
    patches.Add(umbilic.patch);
    triangle->InsertNextValue(mesh.GetCellId(umbilic.triangle));
    position->InsertNextTuple(umbilic.position.data());
    index->InsertNextValue(umbilic.index);
    ridgeCount->InsertNextValue(umbilic.ridgeCount);
    indexSum += mesh.IsOwned(umbilic.triangle) ? umbilic.index : 0.0;
  }
  auto sum = vtkRidgesMakeArray<vtkDoubleArray>(names::UmbilicIndexSum);
  sum->InsertNextValue(indexSum);
  auto euler = vtkRidgesMakeArray<vtkIntArray>(names::EulerCharacteristic);
  euler->InsertNextValue(this->eulerCharacteristic);

  auto numberOfCancelled = vtkRidgesMakeArray<vtkIntArray>(names::NumberOfCancelledRegions);
  numberOfCancelled->InsertNextValue(static_cast<int>(this->cancelled.size()));
  auto numberOfZones = vtkRidgesMakeArray<vtkIntArray>(names::NumberOfUmbilicZones);
  numberOfZones->InsertNextValue(static_cast<int>(this->zones.size()));

  auto patch = vtkRidgesMakeArray<vtkIdTypeArray>(names::UmbilicPatch);
  auto region = vtkRidgesMakeArray<vtkIdTypeArray>(names::CancelledUmbilics);
  auto zone = vtkRidgesMakeArray<vtkIdTypeArray>(names::UmbilicZone);
  vtkRidgesAllocate({ patch, region, zone }, output->GetNumberOfCells());
  FillWithRegions(patch, mesh, patches);
  FillWithRegions(region, mesh, this->cancelled);
  FillWithRegions(zone, mesh, this->zones);
  vtkCellData* cellData = output->GetCellData();
  cellData->AddArray(patch);
  cellData->AddArray(region);
  cellData->AddArray(zone);
  vtkFieldData* field = vtkRidgesOwnFieldData(output);
  for (vtkAbstractArray* array : { static_cast<vtkAbstractArray*>(position),
         static_cast<vtkAbstractArray*>(index), static_cast<vtkAbstractArray*>(ridgeCount),
         static_cast<vtkAbstractArray*>(triangle), static_cast<vtkAbstractArray*>(sum),
         static_cast<vtkAbstractArray*>(euler), static_cast<vtkAbstractArray*>(numberOfCancelled),
         static_cast<vtkAbstractArray*>(numberOfZones) })
  {
    field->AddArray(array);
  }
}

void vtkRidgesUmbilicOutput::StoreVertices(const vtkRidgesMesh& mesh, vtkPolyData* output) const
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  auto id = vtkRidgesMakeArray<vtkIdTypeArray>(names::UmbilicId);
  auto index = vtkRidgesMakeArray<vtkDoubleArray>(names::Index);
  auto ridgeCount = vtkRidgesMakeArray<vtkIntArray>(names::RidgeCount);
  auto thirdOrderIndex = vtkRidgesMakeArray<vtkIntArray>(names::ThirdOrderIndex);
  auto triangle = vtkRidgesMakeArray<vtkIdTypeArray>(names::Triangle);
  auto pattern = vtkRidgesMakeArray<vtkIntArray>(names::Pattern);
  auto touchesBorder = vtkRidgesMakeArray<vtkIntArray>(names::TouchesBorder);
  auto nearBorder = vtkRidgesMakeArray<vtkIntArray>(names::NearBorder);
  for (std::size_t i = 0; i < this->umbilics.size(); ++i)
  {
    const ridges::Umbilic& umbilic = this->umbilics[i];
    if (!mesh.IsOwned(umbilic.triangle))
    {
      continue;
    }
    const vtkIdType p = points->InsertNextPoint(umbilic.position.data());
    vertices->InsertNextCell(1, &p);
    id->InsertNextValue(static_cast<vtkIdType>(i));
    index->InsertNextValue(umbilic.index);
    ridgeCount->InsertNextValue(umbilic.ridgeCount);
    thirdOrderIndex->InsertNextValue(umbilic.thirdOrderIndex);
    triangle->InsertNextValue(mesh.GetCellId(umbilic.triangle));
    pattern->InsertNextValue(static_cast<int>(umbilic.pattern));
    touchesBorder->InsertNextValue(umbilic.touchesBorder ? 1 : 0);
    nearBorder->InsertNextValue(umbilic.isNearBorder ? 1 : 0);
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  vtkPointData* pointData = output->GetPointData();
  pointData->AddArray(id);
  pointData->AddArray(index);
  pointData->AddArray(ridgeCount);
  pointData->AddArray(thirdOrderIndex);
  pointData->AddArray(triangle);
  pointData->AddArray(pattern);
  pointData->AddArray(touchesBorder);
  pointData->AddArray(nearBorder);
  pointData->SetActiveScalars(names::Index);
}
