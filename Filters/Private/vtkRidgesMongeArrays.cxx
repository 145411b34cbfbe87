// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesMongeArrays.h"

#include "Core/Base/Finite.h"
#include "Core/Fit/JetFit.h"
#include "vtkRidgesArrayNames.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

namespace names = vtkRidgesArrayNames;

std::string vtkRidgesMongeArrays::FetchSecondOrder(vtkPolyData* mesh)
{
  this->Faults.clear();
  this->Usable.assign(mesh->GetNumberOfPoints(), 1);

  ridges::MongeField& field = this->Field;
  field.k1 = this->FetchArray(mesh, names::MaximumCurvature, 1);
  field.k2 = this->FetchArray(mesh, names::MinimumCurvature, 1);
  field.d1 = this->FetchArray(mesh, names::MaximumDirection, 3);
  field.d2 = this->FetchArray(mesh, names::MinimumDirection, 3);
  this->FetchStatus(mesh);
  return this->Faults;
}

std::string vtkRidgesMongeArrays::Fetch(vtkPolyData* mesh, bool needsFourthOrder)
{
  this->FetchSecondOrder(mesh);

  ridges::MongeField& field = this->Field;
  field.b = this->FetchArray(mesh, names::ThirdOrder, 4);
  vtkPointData* pointData = mesh->GetPointData();
  const bool hasP = pointData->HasArray(names::P1) && pointData->HasArray(names::P2);
  if (pointData->HasArray(names::FourthOrder))
  {
    field.c = this->FetchArray(mesh, names::FourthOrder, 5);
  }
  else if (hasP)
  {
    field.P1 = this->FetchArray(mesh, names::P1, 1);
    field.P2 = this->FetchArray(mesh, names::P2, 1);
  }
  else if (needsFourthOrder)
  {
    this->Fault("FourthOrder (or P1 and P2)");
  }
  return this->Faults;
}

void vtkRidgesMongeArrays::FetchStatus(vtkPolyData* mesh)
{
  if (vtkDataArray* status = mesh->GetPointData()->GetArray(names::FitStatus))
  {
    // An integer array is what vtkJetFitting makes, but not what all file formats keep.
    vtkIntArray* exact = vtkIntArray::SafeDownCast(status);
    const int* values =
      exact && exact->GetNumberOfComponents() == 1 ? exact->GetPointer(0) : nullptr;
    const auto fetch = [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType p = begin; p < end; ++p)
      {
        const int bits = values ? values[p] : static_cast<int>(status->GetComponent(p, 0));
        if (bits & ridges::FitInvalid)
        {
          this->Usable[p] = 0;
        }
      }
    };
    vtkSMPTools::For(0, mesh->GetNumberOfPoints(), fetch);
  }
}

void vtkRidgesMongeArrays::Fault(const std::string& text)
{
  this->Faults += (this->Faults.empty() ? "" : ", ") + text;
}

const double* vtkRidgesMongeArrays::FetchArray(vtkPolyData* mesh, const char* name, int components)
{
  vtkDataArray* array = mesh->GetPointData()->GetArray(name);
  if (!array)
  {
    this->Fault(name);
    return nullptr;
  }
  if (array->GetNumberOfComponents() != components)
  {
    this->Fault(std::string(name) + " (with " + std::to_string(components) + " components, not " +
      std::to_string(array->GetNumberOfComponents()) + ")");
    return nullptr;
  }

  const vtkIdType count = mesh->GetNumberOfPoints();
  const double* values = nullptr;
  if (vtkDoubleArray* exact = vtkDoubleArray::SafeDownCast(array))
  {
    values = exact->GetPointer(0);
  }
  else
  {
    this->Converted.emplace_back(components * count);
    std::vector<double>& converted = this->Converted.back();
    for (vtkIdType p = 0; p < count; ++p)
    {
      array->GetTuple(p, converted.data() + components * p);
    }
    values = converted.data();
  }
  const auto check = [&](vtkIdType begin, vtkIdType end)
  {
    // Point by point only where something is wrong.
    if (ridges::AllFinite(values + components * begin, values + components * end))
    {
      return;
    }
    for (vtkIdType p = begin; p < end; ++p)
    {
      const double* tuple = values + components * p;
      if (!ridges::AllFinite(tuple, tuple + components))
      {
        this->Usable[p] = 0;
      }
    }
  };
  vtkSMPTools::For(0, count, check);
  return values;
}
