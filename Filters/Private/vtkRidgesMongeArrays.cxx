// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesMongeArrays.h"

#include "Core/Base/Finite.h"
#include "Core/Fit/JetFit.h"
#include "Core/Ridges/ExtremalityErrors.h"
#include "vtkRidgesArrayNames.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <limits>

namespace names = vtkRidgesArrayNames;

void vtkRidgesChooseMongeArrays(vtkAlgorithm* filter)
{
  int index = 0;
  for (const char* name : names::MongeInputs)
  {
    filter->SetInputArrayToProcess(index++, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name);
  }
}

std::string vtkRidgesMongeArrays::FetchSecondOrder(vtkAlgorithm* filter, vtkPolyData* mesh)
{
  this->Choose(filter, mesh);
  this->ReadSecondOrder();
  this->ReadStatus();
  return this->Reader.GetFaults();
}

std::string vtkRidgesMongeArrays::Fetch(
  vtkAlgorithm* filter, vtkPolyData* mesh, bool needsFourthOrder)
{
  this->Choose(filter, mesh);
  this->ReadSecondOrder();
  ridges::MongeField& field = this->Field;
  field.b = this->Read(names::ThirdOrder, 4);
  if (this->Has(names::FourthOrder))
  {
    field.c = this->Read(names::FourthOrder, 5);
  }
  else if (this->Has(names::P1) && this->Has(names::P2))
  {
    field.P1 = this->Read(names::P1, 1);
    field.P2 = this->Read(names::P2, 1);
  }
  else if (needsFourthOrder)
  {
    this->Reader.AddMissing(this->Source,
      this->Chosen[names::FourthOrder] + " (or " + this->Chosen[names::P1] + " and " +
        this->Chosen[names::P2] + ")");
  }
  this->ReadErrors();
  this->ReadStatus();
  return this->Reader.GetFaults();
}

/// By name, or as an attribute such as the scalars.
void vtkRidgesMongeArrays::Choose(vtkAlgorithm* filter, vtkPolyData* mesh)
{
  this->Source = { mesh->GetPointData(), mesh->GetNumberOfPoints(), "the point data of the mesh" };
  int index = 0;
  for (const char* name : names::MongeInputs)
  {
    vtkInformation* info = filter->GetInputArrayInformation(index++);
    std::string& chosen = this->Chosen[name];
    chosen = name; // of a filter that lets no others be chosen
    if (info->Get(vtkDataObject::FIELD_ASSOCIATION()) != vtkDataObject::FIELD_ASSOCIATION_POINTS)
    {
      this->Reader.AddFault(std::string(name) + " is to be read from other than point data");
    }
    if (const char* byName = info->Get(vtkDataObject::FIELD_NAME()))
    {
      chosen = byName;
    }
    else if (info->Has(vtkDataObject::FIELD_ATTRIBUTE_TYPE()))
    {
      const int type = info->Get(vtkDataObject::FIELD_ATTRIBUTE_TYPE());
      vtkAbstractArray* array = mesh->GetPointData()->GetAbstractAttribute(type);
      chosen = array && array->GetName() ? array->GetName() : "";
    }
  }
}

bool vtkRidgesMongeArrays::Has(const char* contractName) const
{
  return this->Source.data->HasArray(this->Chosen.at(contractName).c_str()) != 0;
}

std::string vtkRidgesMongeArrays::GetWarning() const
{
  return this->NumberOfNotFinitePoints == 0
    ? ""
    : std::to_string(this->NumberOfNotFinitePoints) + " points have values that are not finite (" +
      this->NotFinite + ") and are treated as points without a fit";
}

std::vector<std::uint8_t> vtkRidgesMongeArrays::FlaggedPoints() const
{
  std::vector<std::uint8_t> flagged(this->Status ? this->Source.tuples : 0);
  for (std::size_t p = 0; p < flagged.size(); ++p)
  {
    const vtkIdType status = this->Status[p];
    flagged[p] = status == 0 ? 0
      : (status & (ridges::FitBoundary | ridges::FitIllConditioned)) != 0
      ? ridges::ExtremalityErrors::FlaggedAsInexact
      : ridges::ExtremalityErrors::FlaggedAsWrong;
  }
  return flagged;
}

void vtkRidgesMongeArrays::ReadSecondOrder()
{
  this->Usable.assign(this->Source.tuples, 1);
  ridges::MongeField& field = this->Field;
  field.k1 = this->Read(names::MaximumCurvature, 1);
  field.k2 = this->Read(names::MinimumCurvature, 1);
  field.d1 = this->Read(names::MaximumDirection, 3);
  field.d2 = this->Read(names::MinimumDirection, 3);
}

void vtkRidgesMongeArrays::ReadErrors()
{
  const auto read = [this](const char* name, int components)
  { return this->Read(name, components, vtkRidgesArrayReader::Presence::Optional); };
  this->Errors.maximumCurvatureError = read(names::MaximumCurvatureError, 1);
  this->Errors.minimumCurvatureError = read(names::MinimumCurvatureError, 1);
  this->Errors.thirdOrderError = read(names::ThirdOrderError, 4);
  this->Errors.fitResidual = read(names::FitResidual, 1);
  this->Errors.fitScale = read(names::FitScale, 1);
  this->Errors.noiseGain = read(names::FitNoiseGain, 1);
}

/// Last, as only values that are not finite are to be counted.
void vtkRidgesMongeArrays::ReadStatus()
{
  this->NumberOfNotFinitePoints = std::count(this->Usable.begin(), this->Usable.end(), 0);
  this->Status = this->Reader.Ids(this->Source, this->Chosen[names::FitStatus].c_str(), 0,
    std::numeric_limits<int>::max(), vtkRidgesArrayReader::Presence::Optional);
  if (const vtkIdType* status = this->Status)
  {
    vtkSMPTools::For(0, this->Source.tuples,
      [this, status](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType p = begin; p < end; ++p)
        {
          if (status[p] & ridges::FitInvalid)
          {
            this->Usable[p] = 0;
          }
        }
      });
  }
}

const double* vtkRidgesMongeArrays::Read(
  const char* contractName, int components, vtkRidgesArrayReader::Presence presence)
{
  const std::string& name = this->Chosen[contractName];
  const double* values = this->Reader.Doubles(this->Source, name.c_str(), components, presence);
  if (values && this->FlagNotFinite(values, components))
  {
    this->NotFinite += (this->NotFinite.empty() ? "" : ", ") + name;
  }
  return values;
}

/// Whether there are any.
bool vtkRidgesMongeArrays::FlagNotFinite(const double* values, int components)
{
  std::atomic<bool> any(false);
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Usable.size()),
    [this, values, components, &any](vtkIdType begin, vtkIdType end)
    {
      // Point by point only where something is wrong.
      if (ridges::AllFinite(values + components * begin, values + components * end))
      {
        return;
      }
      any = true;
      for (vtkIdType p = begin; p < end; ++p)
      {
        const double* tuple = values + components * p;
        if (!ridges::AllFinite(tuple, tuple + components))
        {
          this->Usable[p] = 0;
        }
      }
    });
  return any;
}
