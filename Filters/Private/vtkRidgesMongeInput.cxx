// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesMongeInput.h"

#include "vtkAlgorithm.h"
#include "vtkPolyData.h"

bool vtkRidgesMongeInput::Fetch(
  vtkAlgorithm* filter, vtkPolyData* input, bool needsFourthOrder, Unusable unusable)
{
  const bool isEmpty = input->GetNumberOfPoints() == 0;
  return this->Build(
    filter, input, isEmpty ? "" : this->arrays.Fetch(input, needsFourthOrder), unusable);
}

bool vtkRidgesMongeInput::FetchSecondOrder(vtkAlgorithm* filter, vtkPolyData* input)
{
  const bool isEmpty = input->GetNumberOfPoints() == 0;
  return this->Build(
    filter, input, isEmpty ? "" : this->arrays.FetchSecondOrder(input), Unusable::LeftOut);
}

bool vtkRidgesMongeInput::Build(
  vtkAlgorithm* filter, vtkPolyData* input, const std::string& faults, Unusable unusable)
{
  if (!faults.empty())
  {
    vtkErrorWithObjectMacro(
      filter, "The input does not have the arrays of vtkJetFitting: " << faults << ".");
    return false;
  }
  const std::vector<std::uint8_t> all;
  if (!this->mesh.Build(input, unusable == Unusable::Kept ? all : this->arrays.GetUsable()))
  {
    vtkErrorWithObjectMacro(
      filter, "The mesh has more points or triangles than 32-bit numbering allows.");
    return false;
  }
  if (this->mesh.GetNumberOfTriangulatedCells() > 0)
  {
    vtkWarningWithObjectMacro(filter,
      << this->mesh.GetNumberOfTriangulatedCells() << " polygons or strips were triangulated.");
  }
  const std::string warning = this->arrays.GetWarning();
  if (!warning.empty())
  {
    vtkWarningWithObjectMacro(filter, << warning << ".");
  }
  return true;
}
