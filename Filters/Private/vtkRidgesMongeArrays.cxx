// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesMongeArrays.h"

#include "Core/Base/Finite.h"
#include "Core/Fit/JetFit.h"
#include "vtkRidgesArrayNames.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <limits>

namespace names = vtkRidgesArrayNames;

namespace
{

vtkRidgesArrayReader::Source PointDataOf(vtkPolyData* mesh)
{
  return { mesh->GetPointData(), mesh->GetNumberOfPoints(), "the point data of the mesh" };
}

} // namespace

std::string vtkRidgesMongeArrays::FetchSecondOrder(vtkPolyData* mesh)
{
  const vtkRidgesArrayReader::Source source = PointDataOf(mesh);
  this->ReadSecondOrder(source);
  this->ReadStatus(source);
  return this->Reader.GetFaults();
}

std::string vtkRidgesMongeArrays::Fetch(vtkPolyData* mesh, bool needsFourthOrder)
{
  const vtkRidgesArrayReader::Source source = PointDataOf(mesh);
  this->ReadSecondOrder(source);
  ridges::MongeField& field = this->Field;
  field.b = this->Read(source, names::ThirdOrder, 4);
  vtkPointData* pointData = mesh->GetPointData();
  if (pointData->HasArray(names::FourthOrder))
  {
    field.c = this->Read(source, names::FourthOrder, 5);
  }
  else if (pointData->HasArray(names::P1) && pointData->HasArray(names::P2))
  {
    field.P1 = this->Read(source, names::P1, 1);
    field.P2 = this->Read(source, names::P2, 1);
  }
  else if (needsFourthOrder)
  {
    this->Reader.AddMissing(source, "FourthOrder (or P1 and P2)");
  }
  this->ReadErrors(source);
  this->ReadStatus(source);
  return this->Reader.GetFaults();
}

std::string vtkRidgesMongeArrays::GetWarning() const
{
  return this->NumberOfNotFinitePoints == 0
    ? ""
    : std::to_string(this->NumberOfNotFinitePoints) + " points have values that are not finite (" +
      this->NotFinite + ") and are treated as points without a fit";
}

void vtkRidgesMongeArrays::ReadSecondOrder(const vtkRidgesArrayReader::Source& source)
{
  this->Usable.assign(source.tuples, 1);
  ridges::MongeField& field = this->Field;
  field.k1 = this->Read(source, names::MaximumCurvature, 1);
  field.k2 = this->Read(source, names::MinimumCurvature, 1);
  field.d1 = this->Read(source, names::MaximumDirection, 3);
  field.d2 = this->Read(source, names::MinimumDirection, 3);
}

void vtkRidgesMongeArrays::ReadErrors(const vtkRidgesArrayReader::Source& source)
{
  const auto read = [this, &source](const char* name, int components)
  { return this->Read(source, name, components, vtkRidgesArrayReader::Presence::Optional); };
  this->Errors.maximumCurvatureError = read(names::MaximumCurvatureError, 1);
  this->Errors.minimumCurvatureError = read(names::MinimumCurvatureError, 1);
  this->Errors.thirdOrderError = read(names::ThirdOrderError, 4);
  this->Errors.fitResidual = read(names::FitResidual, 1);
  this->Errors.fitScale = read(names::FitScale, 1);
}

/// Last, as only values that are not finite are to be counted.
void vtkRidgesMongeArrays::ReadStatus(const vtkRidgesArrayReader::Source& source)
{
  this->NumberOfNotFinitePoints = std::count(this->Usable.begin(), this->Usable.end(), 0);
  const vtkIdType* status = this->Reader.Ids(source, names::FitStatus, 0,
    std::numeric_limits<int>::max(), vtkRidgesArrayReader::Presence::Optional);
  if (status)
  {
    vtkSMPTools::For(0, source.tuples,
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

const double* vtkRidgesMongeArrays::Read(const vtkRidgesArrayReader::Source& source,
  const char* name, int components, vtkRidgesArrayReader::Presence presence)
{
  const double* values = this->Reader.Doubles(source, name, components, presence);
  if (values && this->FlagNotFinite(values, components))
  {
    this->NotFinite += (this->NotFinite.empty() ? "" : ", ") + std::string(name);
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
