// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCompliantRefinement.h"

#include "vtkJetFunction.h"
#include "vtkRidgesCertificateOutput.h"
#include "vtkRidgesCertifier.h"
#include "vtkRidgesRequest.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <string>

vtkStandardNewMacro(vtkCompliantRefinement);

vtkCompliantRefinement::vtkCompliantRefinement()
{
  this->SetNumberOfOutputPorts(2);
}

vtkCompliantRefinement::~vtkCompliantRefinement() = default;

void vtkCompliantRefinement::SetJetFunction(vtkJetFunction* function)
{
  if (this->JetFunction != function)
  {
    this->JetFunction = function;
    this->Modified();
  }
}

vtkJetFunction* vtkCompliantRefinement::GetJetFunction() const
{
  return this->JetFunction;
}

vtkMTimeType vtkCompliantRefinement::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->JetFunction ? std::max(own, this->JetFunction->GetMTime()) : own;
}

int vtkCompliantRefinement::FillOutputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
    return 1;
  }
  return this->Superclass::FillOutputPortInformation(port, info);
}

int vtkCompliantRefinement::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkRidgesGetPolyData(this, inputVector[0]);
  if (!input)
  {
    return 0;
  }
  vtkRidgesCertifier::Choice choice;
  choice.isGraph = this->SurfaceType == GRAPH;
  choice.formula = this->Formula;
  choice.function = this->JetFunction;
  choice.isProof = this->Level == PROVED;
  choice.mostPoints = this->MaximumNumberOfPoints;
  vtkRidgesCertifier certifier;
  if (!certifier.Run(this, input, choice))
  {
    return 0;
  }
  if (!certifier.IsDone())
  {
    return 1; // aborted
  }
  const vtkRidgesCertificateOutput output(certifier);
  const std::string faults = output.StoreMesh(vtkPolyData::GetData(outputVector, 0), nullptr);
  if (!faults.empty())
  {
    vtkErrorMacro(<< faults << ".");
    return 0;
  }
  output.StoreTable(vtkTable::GetData(outputVector, 1));
  return 1;
}

void vtkCompliantRefinement::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SurfaceType: " << (this->SurfaceType == GRAPH ? "Graph" : "Implicit") << "\n";
  os << indent << "Formula: " << this->Formula << "\n";
  os << indent << "Level: " << (this->Level == PROVED ? "Proved" : "Checked") << "\n";
  os << indent << "MaximumNumberOfPoints: " << this->MaximumNumberOfPoints << "\n";
  os << indent << "JetFunction: " << this->JetFunction.Get() << "\n";
}
