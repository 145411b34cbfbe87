// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImplicitSurfaceMesh.h"

#include "vtkRidgesArrayNames.h"
#include "vtkRidgesEvenMesh.h"
#include "vtkRidgesFormulaSurface.h"
#include "vtkRidgesMakeArray.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <cmath>

namespace names = vtkRidgesArrayNames;

vtkStandardNewMacro(vtkImplicitSurfaceMesh);

vtkImplicitSurfaceMesh::vtkImplicitSurfaceMesh()
  : Formula("1 - exp(-0.7*((x/0.15)^2 + (y/0.25)^2 + (z/0.35)^2 - 1))"
            " - exp(-0.7*(((x-0.25)/0.1)^2 + ((y-0.1)/0.2)^2 + ((z-0.1)/0.3)^2 - 1))")
{
  this->SetNumberOfInputPorts(0);
}

vtkImplicitSurfaceMesh::~vtkImplicitSurfaceMesh() = default;

int vtkImplicitSurfaceMesh::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  double squares = 0.0;
  bool isBox = true;
  for (int i = 0; i < 3; ++i)
  {
    const double extent = this->Bounds[2 * i + 1] - this->Bounds[2 * i];
    isBox = isBox && extent > 0.0;
    squares += extent * extent;
  }
  constexpr double share = 0.01;
  const double edgeLength = this->EdgeLength == 0.0 ? share * std::sqrt(squares) : this->EdgeLength;
  if (!isBox || !std::isfinite(squares) || !std::isfinite(edgeLength))
  {
    vtkErrorMacro("Bounds are " << this->Bounds[0] << ", " << this->Bounds[1] << ", "
                                << this->Bounds[2] << ", " << this->Bounds[3] << ", "
                                << this->Bounds[4] << ", " << this->Bounds[5]
                                << " and EdgeLength is " << this->EdgeLength
                                << ": a box that is not empty and a number are needed.");
    return 0;
  }
  vtkRidgesFormulaSurface surface;
  const std::string fault = surface.SetImplicit(this->Formula);
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << ".");
    return 0;
  }

  vtkRidgesEvenMesh mesh;
  if (!mesh.Make(
        this, surface.GetFunction(), surface.Get(), surface.Get(), this->Bounds, edgeLength))
  {
    if (mesh.contour.hasNaN)
    {
      const std::array<double, 3>& at = mesh.contour.firstNaN;
      vtkErrorMacro("Formula: f is not a number at " << at[0] << ", " << at[1] << ", " << at[2]
                                                     << ", because of what is at "
                                                     << surface.PlaceOfFault(at.data()) << ".");
      return 0;
    }
    if (!mesh.contour.error.empty())
    {
      vtkErrorMacro(<< mesh.contour.error << ".");
      return 0;
    }
    return 1; // aborted
  }
  mesh.Warn(this, "The Bounds cut");
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  mesh.Store(output);
  auto text = vtkRidgesMakeArray<vtkStringArray>(names::Formula);
  text->InsertNextValue(this->Formula);
  output->GetFieldData()->AddArray(text);
  return 1;
}

void vtkImplicitSurfaceMesh::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Formula: " << this->Formula << "\n";
  os << indent << "Bounds:";
  for (const double bound : this->Bounds)
  {
    os << " " << bound;
  }
  os << "\n" << indent << "EdgeLength: " << this->EdgeLength << "\n";
}
