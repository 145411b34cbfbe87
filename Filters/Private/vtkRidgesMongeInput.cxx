// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesMongeInput.h"

#include "vtkAlgorithm.h"
#include "vtkPolyData.h"

bool vtkRidgesMongeInput::Fetch(
  vtkAlgorithm* filter, vtkPolyData* input, bool needsFourthOrder, Unusable unusable)
{
  const bool isEmpty = input->GetNumberOfPoints() == 0;
  const std::string faults = isEmpty ? "" : this->arrays.Fetch(filter, input, needsFourthOrder);
  return this->Build(filter, input, faults, unusable, vtkRidgesMesh::Duplicates::Kept);
}

bool vtkRidgesMongeInput::FetchSecondOrder(vtkAlgorithm* filter, vtkPolyData* input)
{
  const bool isEmpty = input->GetNumberOfPoints() == 0;
  const std::string faults = isEmpty ? "" : this->arrays.FetchSecondOrder(filter, input);
  return this->Build(filter, input, faults, Unusable::LeftOut, vtkRidgesMesh::Duplicates::LeftOut);
}

bool vtkRidgesMongeInput::Build(vtkAlgorithm* filter, vtkPolyData* input,
  const std::string& faultsOfArrays, Unusable unusable, vtkRidgesMesh::Duplicates duplicates)
{
  if (!faultsOfArrays.empty())
  {
    vtkErrorWithObjectMacro(
      filter, "The input does not have the arrays of vtkJetFitting: " << faultsOfArrays << ".");
    return false;
  }
  const std::vector<std::uint8_t> all;
  const std::string faults =
    this->mesh.Build(input, unusable == Unusable::Kept ? all : this->arrays.GetUsable(),
      ridges::TriangleMesh::Edges::Built, duplicates);
  if (!faults.empty())
  {
    vtkErrorWithObjectMacro(filter, "The mesh cannot be used: " << faults << ".");
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
