// SPDX-License-Identifier: BSD-3-Clause
#include "vtkUmbilicDetection.h"

#include "Core/UmbilicDetection.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesBatches.h"
#include "vtkRidgesMongeInput.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace names = vtkRidgesArrayNames;

vtkStandardNewMacro(vtkUmbilicDetection);

namespace
{

struct FindCandidates
{
  FindCandidates(const ridges::TriangleMesh& mesh, const ridges::MongeField& field, double size)
    : Mesh(mesh)
    , Field(field)
    , PatchSize(size)
    , IsCandidate(mesh.NumberOfTriangles(), 0)
  {
  }

  void operator()(vtkIdType begin, vtkIdType end)
  {
    std::shared_ptr<ridges::UmbilicDetector>& detector = this->PerThread.Local();
    if (!detector)
    {
      detector =
        std::make_shared<ridges::UmbilicDetector>(this->Mesh, this->Field, this->PatchSize);
    }
    for (vtkIdType t = begin; t < end; ++t)
    {
      this->IsCandidate[t] = detector->Minimizes(static_cast<ridges::Id>(t)) ? 1 : 0;
    }
  }

  std::vector<ridges::Id> Collect() const
  {
    std::vector<ridges::Id> candidates;
    for (ridges::Id t = 0; t < this->Mesh.NumberOfTriangles(); ++t)
    {
      if (this->IsCandidate[t])
      {
        candidates.push_back(t);
      }
    }
    return candidates;
  }

private:
  const ridges::TriangleMesh& Mesh;
  const ridges::MongeField& Field;
  double PatchSize;
  std::vector<std::uint8_t> IsCandidate;
  // Shared, as vtkSMPThreadLocal copies the (empty) value it starts from.
  vtkSMPThreadLocal<std::shared_ptr<ridges::UmbilicDetector>> PerThread;
};

template <typename Array>
vtkNew<Array> MakeArray(const char* name, int components = 1)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  return array;
}

void MarkOnMesh(
  const vtkRidgesMesh& mesh, const std::vector<ridges::Umbilic>& umbilics, vtkPolyData* output)
{
  output->ShallowCopy(mesh.GetPolyData());
  mesh.HandOnWith(output);

  auto patch = MakeArray<vtkIdTypeArray>(names::UmbilicPatch);
  patch->SetNumberOfTuples(output->GetNumberOfCells());
  patch->Fill(-1);
  auto position = MakeArray<vtkDoubleArray>(names::UmbilicPosition, 3);
  auto index = MakeArray<vtkDoubleArray>(names::UmbilicIndex);
  auto ridgeCount = MakeArray<vtkIntArray>(names::UmbilicRidgeCount);
  double indexSum = 0.0;
  for (std::size_t i = 0; i < umbilics.size(); ++i)
  {
    const ridges::Umbilic& umbilic = umbilics[i];
    for (const ridges::Id t : umbilic.patch)
    {
      patch->SetValue(mesh.GetCellId(t), static_cast<vtkIdType>(i));
    }
    position->InsertNextTuple(umbilic.position.data());
    index->InsertNextValue(umbilic.index);
    ridgeCount->InsertNextValue(umbilic.ridgeCount);
    indexSum += umbilic.index;
  }
  auto sum = MakeArray<vtkDoubleArray>(names::UmbilicIndexSum);
  sum->InsertNextValue(indexSum);
  auto euler = MakeArray<vtkIntArray>(names::EulerCharacteristic);
  euler->InsertNextValue(mesh.GetTriangles().EulerCharacteristic());

  output->GetCellData()->AddArray(patch);
  // The field data is still the input's own, which is not ours to change.
  vtkNew<vtkFieldData> field;
  field->ShallowCopy(output->GetFieldData());
  for (vtkAbstractArray* array : { static_cast<vtkAbstractArray*>(position),
         static_cast<vtkAbstractArray*>(index), static_cast<vtkAbstractArray*>(ridgeCount),
         static_cast<vtkAbstractArray*>(sum), static_cast<vtkAbstractArray*>(euler) })
  {
    field->AddArray(array);
  }
  output->SetFieldData(field);
}

void StoreVertices(
  const vtkRidgesMesh& mesh, const std::vector<ridges::Umbilic>& umbilics, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  auto id = MakeArray<vtkIdTypeArray>(names::UmbilicId);
  auto index = MakeArray<vtkDoubleArray>(names::Index);
  auto ridgeCount = MakeArray<vtkIntArray>(names::RidgeCount);
  auto thirdOrderIndex = MakeArray<vtkIntArray>(names::ThirdOrderIndex);
  auto triangle = MakeArray<vtkIdTypeArray>(names::Triangle);
  for (const ridges::Umbilic& umbilic : umbilics)
  {
    const vtkIdType p = points->InsertNextPoint(umbilic.position.data());
    vertices->InsertNextCell(1, &p);
    id->InsertNextValue(p);
    index->InsertNextValue(umbilic.index);
    ridgeCount->InsertNextValue(umbilic.ridgeCount);
    thirdOrderIndex->InsertNextValue(umbilic.thirdOrderIndex);
    triangle->InsertNextValue(mesh.GetCellId(umbilic.triangle));
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  vtkPointData* pointData = output->GetPointData();
  pointData->AddArray(id);
  pointData->AddArray(index);
  pointData->AddArray(ridgeCount);
  pointData->AddArray(thirdOrderIndex);
  pointData->AddArray(triangle);
  pointData->SetActiveScalars(names::Index);
}

} // namespace

vtkUmbilicDetection::vtkUmbilicDetection()
{
  this->SetNumberOfOutputPorts(2);
}

int vtkUmbilicDetection::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* markedMesh = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* vertices = vtkPolyData::GetData(outputVector, 1);

  if (std::isnan(this->PatchSize))
  {
    vtkErrorMacro("PatchSize is not a number: set one from 1 to 100.");
    return 0;
  }
  vtkRidgesMongeInput monge;
  if (!monge.Fetch(this, input, false))
  {
    return 0;
  }
  const vtkRidgesMesh& mesh = monge.mesh;

  FindCandidates findCandidates(mesh.GetTriangles(), monge.arrays.GetField(), this->PatchSize);
  if (!vtkRidgesForBatches(this, mesh.GetTriangles().NumberOfTriangles(), 0.1, 0.9, findCandidates))
  {
    return 1;
  }
  ridges::UmbilicDetector detector(mesh.GetTriangles(), monge.arrays.GetField(), this->PatchSize);
  const std::vector<ridges::Umbilic> umbilics = detector.Select(findCandidates.Collect());

  MarkOnMesh(mesh, umbilics, markedMesh);
  StoreVertices(mesh, umbilics, vertices);
  return 1;
}

void vtkUmbilicDetection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PatchSize: " << this->PatchSize << "\n";
}
