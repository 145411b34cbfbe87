// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesFormArrays.h"

#include "vtkRidgesAllocate.h"
#include "vtkRidgesArrayNames.h"

#include "vtkPointData.h"

#include <algorithm>
#include <string>

namespace names = vtkRidgesArrayNames;

void vtkRidgesFormArrays::StoreAll(
  const vtkRidgesFormArrays& others, const std::vector<ridges::Id>& ids)
{
  for (std::size_t k = 0; k < this->Arrays.size(); ++k)
  {
    const vtkIdType components = this->Arrays[k]->GetNumberOfComponents();
    const double* from = others.Arrays[k]->GetPointer(0);
    double* values = this->Arrays[k]->GetPointer(0);
    for (const ridges::Id id : ids)
    {
      std::copy_n(from, components, values + components * id);
      from += components;
    }
  }
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    this->Status[ids[i]] = others.Status[i];
  }
}

void vtkRidgesFormArrays::AddTo(vtkPointData* pointData)
{
  for (const char* name : { names::Normals, names::MaximumCurvature, names::MinimumCurvature,
         names::MaximumDirection, names::MinimumDirection, names::ThirdOrder, names::FourthOrder,
         names::P1, names::P2, names::MaximumCurvatureError, names::MinimumCurvatureError,
         names::ThirdOrderError, names::P1Error, names::P2Error, names::FitNoiseGain })
  {
    pointData->RemoveArray(name);
  }
  for (const auto& array : this->Arrays)
  {
    pointData->AddArray(array);
  }
  pointData->AddArray(this->StatusArray);
  pointData->SetActiveNormals(names::Normals);
}

void vtkRidgesFormArrays::Add(
  double*& values, const char* name, int components, bool wanted, const char* componentPrefix)
{
  values = nullptr;
  if (!wanted)
  {
    return;
  }
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  for (int i = 0; componentPrefix && i < components; ++i)
  {
    array->SetComponentName(i, (componentPrefix + std::to_string(i)).c_str());
  }
  this->Arrays.emplace_back(array);
  this->Values.push_back(&values);
}

void vtkRidgesFormArrays::Allocate(vtkIdType count)
{
  this->StatusArray->SetName(names::FitStatus);
  std::vector<vtkDataArray*> arrays(this->Arrays.begin(), this->Arrays.end());
  arrays.push_back(this->StatusArray);
  vtkRidgesAllocate(arrays, count);
  for (std::size_t i = 0; i < this->Arrays.size(); ++i)
  {
    *this->Values[i] = this->Arrays[i]->GetPointer(0);
  }
  this->Status = this->StatusArray->GetPointer(0);
}
