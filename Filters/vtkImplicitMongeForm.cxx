// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImplicitMongeForm.h"

#include "vtkJetFunction.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesExactForms.h"
#include "vtkRidgesFormulaSurface.h"
#include "vtkRidgesMesh.h"
#include "vtkRidgesRequest.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace names = vtkRidgesArrayNames;

vtkStandardNewMacro(vtkImplicitMongeForm);

vtkImplicitMongeForm::vtkImplicitMongeForm() = default;
vtkImplicitMongeForm::~vtkImplicitMongeForm() = default;

namespace
{

/// The formula that the source of the mesh has left there.
std::string FormulaOf(vtkPolyData* mesh)
{
  auto* array =
    vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray(names::Formula));
  return array && array->GetNumberOfValues() > 0 ? std::string(array->GetValue(0)) : std::string();
}

/// Parameters by the texture coordinates of a mesh; empty if it has none.
std::vector<std::array<double, 2>> ParametersOf(vtkPolyData* mesh, const double range[4])
{
  vtkDataArray* coordinates = mesh->GetPointData()->GetTCoords();
  if (!coordinates || coordinates->GetNumberOfComponents() < 2)
  {
    return {};
  }
  std::vector<std::array<double, 2>> parameters(
    static_cast<std::size_t>(coordinates->GetNumberOfTuples()));
  for (std::size_t p = 0; p < parameters.size(); ++p)
  {
    for (int i = 0; i < 2; ++i)
    {
      const double share = coordinates->GetComponent(static_cast<vtkIdType>(p), i);
      parameters[p][i] = (1.0 - share) * range[2 * i] + share * range[2 * i + 1];
    }
  }
  return parameters;
}

} // namespace

vtkCxxSetSmartPointerMacro(vtkImplicitMongeForm, JetFunction, vtkJetFunction);

vtkJetFunction* vtkImplicitMongeForm::GetJetFunction() const
{
  return this->JetFunction;
}

vtkMTimeType vtkImplicitMongeForm::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->JetFunction ? std::max(own, this->JetFunction->GetMTime()) : own;
}

const char* vtkImplicitMongeForm::GetSurfaceTypeAsString() const
{
  switch (this->SurfaceType)
  {
    case GRAPH:
      return "Graph";
    case PARAMETRIC:
      return "Parametric";
    default:
      return "Implicit";
  }
}

int vtkImplicitMongeForm::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkRidgesGetPolyData(this, inputVector[0]);
  if (!input)
  {
    return 0;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  vtkRidgesMesh mesh;
  std::string faults = mesh.Build(input);
  if (!faults.empty())
  {
    vtkErrorMacro("The mesh cannot be used: " << faults << ".");
    return 0;
  }
  vtkRidgesFormulaSurface surface;
  const bool isParametric = this->SurfaceType == PARAMETRIC;
  if (isParametric)
  {
    faults = surface.SetParametric({ this->XFormula, this->YFormula, this->ZFormula });
  }
  else if (this->JetFunction)
  {
    surface.SetFunction(this->JetFunction);
  }
  else
  {
    const std::string& formula = this->Formula.empty() ? FormulaOf(input) : this->Formula;
    faults = this->SurfaceType == GRAPH ? surface.SetGraph(formula) : surface.SetImplicit(formula);
  }
  if (!faults.empty())
  {
    vtkErrorMacro(<< faults << ".");
    return 0;
  }
  vtkRidgesExactForms forms(surface.Get());
  forms.placeOfFault = [&surface](const double* variables)
  { return surface.PlaceOfFault(variables); };
  if (isParametric)
  {
    vtkPolyData* triangulated = mesh.GetPolyData();
    forms.parameters = ParametersOf(triangulated, this->ParameterRange);
    if (static_cast<vtkIdType>(forms.parameters.size()) != triangulated->GetNumberOfPoints())
    {
      vtkErrorMacro(
        "A parametric surface needs a mesh with texture coordinates of two components.");
      return 0;
    }
  }
  return forms.Run(this, mesh, output);
}

void vtkImplicitMongeForm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SurfaceType: " << this->GetSurfaceTypeAsString() << "\n";
  os << indent << "Formula: " << this->Formula << "\n";
  os << indent << "XFormula: " << this->XFormula << "\n";
  os << indent << "YFormula: " << this->YFormula << "\n";
  os << indent << "ZFormula: " << this->ZFormula << "\n";
  os << indent << "ParameterRange: " << this->ParameterRange[0] << " " << this->ParameterRange[1]
     << " " << this->ParameterRange[2] << " " << this->ParameterRange[3] << "\n";
  os << indent << "JetFunction: " << this->JetFunction.Get() << "\n";
}
