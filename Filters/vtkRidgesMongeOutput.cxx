// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesMongeOutput.h"

#include "Core/LargeMemory.h"
#include "vtkRidgesArrayNames.h"

#include "vtkPointData.h"

#include <algorithm>
#include <string>

namespace names = vtkRidgesArrayNames;

namespace
{

template <typename Tuple>
void Put(double* values, vtkIdType p, const Tuple& tuple)
{
  if (values)
  {
    const auto size = static_cast<vtkIdType>(tuple.size());
    std::copy_n(tuple.data(), size, values + p * size);
  }
}

void Put(double* values, vtkIdType p, double value)
{
  if (values)
  {
    values[p] = value;
  }
}

/// Values of a lane, `lanes` apart.
template <int Components>
void Put(double* values, vtkIdType p, const double* batch, int lanes, int lane)
{
  if (values)
  {
    for (int i = 0; i < Components; ++i)
    {
      values[Components * p + i] = batch[i * lanes + lane];
    }
  }
}

} // namespace

vtkRidgesMongeOutput::vtkRidgesMongeOutput(vtkIdType count, int order, bool standardErrors)
{
  this->Add(this->Normals, names::Normals, 3, count, order >= 1);
  this->Add(this->MaximumCurvature, names::MaximumCurvature, 1, count, order >= 2);
  this->Add(this->MinimumCurvature, names::MinimumCurvature, 1, count, order >= 2);
  this->Add(this->MaximumDirection, names::MaximumDirection, 3, count, order >= 2);
  this->Add(this->MinimumDirection, names::MinimumDirection, 3, count, order >= 2);
  this->Add(this->ThirdOrder, names::ThirdOrder, 4, count, order >= 3, "b");
  this->Add(this->FourthOrder, names::FourthOrder, 5, count, order >= 4, "c");
  this->Add(this->P1, names::P1, 1, count, order >= 4);
  this->Add(this->P2, names::P2, 1, count, order >= 4);

  const bool errors = standardErrors;
  this->Add(
    this->MaximumCurvatureError, names::MaximumCurvatureError, 1, count, errors && order >= 2);
  this->Add(
    this->MinimumCurvatureError, names::MinimumCurvatureError, 1, count, errors && order >= 2);
  this->Add(this->ThirdOrderError, names::ThirdOrderError, 4, count, errors && order >= 3, "b");
  this->Add(this->P1Error, names::P1Error, 1, count, errors && order >= 4);
  this->Add(this->P2Error, names::P2Error, 1, count, errors && order >= 4);

  this->Add(this->ConditionNumber, names::FitConditionNumber, 1, count, true);
  this->Add(this->Residual, names::FitResidual, 1, count, true);
  this->Add(this->Scale, names::FitScale, 1, count, true);
  this->StatusArray->SetName(names::FitStatus);
  this->StatusArray->SetNumberOfTuples(count);
  this->Status = this->StatusArray->GetPointer(0);
}

void vtkRidgesMongeOutput::Store(vtkIdType p, const ridges::MongeForm& form, const Quality& quality)
{
  Put(this->Normals, p, form.n);
  Put(this->MaximumDirection, p, form.d1);
  Put(this->MinimumDirection, p, form.d2);
  Put(this->ThirdOrder, p, form.b);
  Put(this->FourthOrder, p, form.c);
  Put(this->MaximumCurvature, p, form.k1);
  Put(this->MinimumCurvature, p, form.k2);
  Put(this->P1, p, form.P1());
  Put(this->P2, p, form.P2());
  Put(this->ConditionNumber, p, quality.conditionNumber);
  Put(this->Residual, p, quality.residual);
  Put(this->Scale, p, quality.radius);
  this->Status[p] = quality.status;
}

void vtkRidgesMongeOutput::Store(
  vtkIdType p, const ridges::JetBatch& batch, int lanes, int lane, int status)
{
  Put<3>(this->Normals, p, batch.n, lanes, lane);
  Put<3>(this->MaximumDirection, p, batch.d1, lanes, lane);
  Put<3>(this->MinimumDirection, p, batch.d2, lanes, lane);
  Put<4>(this->ThirdOrder, p, batch.b, lanes, lane);
  Put<5>(this->FourthOrder, p, batch.c, lanes, lane);
  Put<1>(this->MaximumCurvature, p, batch.k1, lanes, lane);
  Put<1>(this->MinimumCurvature, p, batch.k2, lanes, lane);
  Put<1>(this->P1, p, batch.P1, lanes, lane);
  Put<1>(this->P2, p, batch.P2, lanes, lane);
  Put<1>(this->ConditionNumber, p, batch.conditionNumber, lanes, lane);
  Put<1>(this->Residual, p, batch.residual, lanes, lane);
  Put<1>(this->Scale, p, batch.radius, lanes, lane);
  this->Status[p] = status;
}

void vtkRidgesMongeOutput::StoreErrors(vtkIdType p, const ridges::JetErrors& errors)
{
  Put(this->MaximumCurvatureError, p, errors.k1);
  Put(this->MinimumCurvatureError, p, errors.k2);
  Put(this->ThirdOrderError, p, errors.b);
  Put(this->P1Error, p, errors.P1);
  Put(this->P2Error, p, errors.P2);
}

void vtkRidgesMongeOutput::AddTo(vtkPointData* pointData)
{
  // What an earlier fit of higher order may have left would not belong to this one.
  for (const char* name : { names::Normals, names::MaximumCurvature, names::MinimumCurvature,
         names::MaximumDirection, names::MinimumDirection, names::ThirdOrder, names::FourthOrder,
         names::P1, names::P2, names::MaximumCurvatureError, names::MinimumCurvatureError,
         names::ThirdOrderError, names::P1Error, names::P2Error })
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

void vtkRidgesMongeOutput::Add(double*& values, const char* name, int components, vtkIdType count,
  bool wanted, const char* componentPrefix)
{
  values = nullptr;
  if (wanted)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(components);
    for (int i = 0; componentPrefix && i < components; ++i)
    {
      array->SetComponentName(i, (componentPrefix + std::to_string(i)).c_str());
    }
    const vtkIdType size = components * count;
    values = static_cast<double*>(ridges::AllocateLarge(size * sizeof(double)));
    array->SetArray(values, size, 0, vtkAbstractArray::VTK_DATA_ARRAY_FREE);
    this->Arrays.emplace_back(array);
  }
}
