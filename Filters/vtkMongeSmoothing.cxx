// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMongeSmoothing.h"

#include "vtkRidgesFieldSmoothing.h"
#include "vtkRidgesRequest.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkMongeSmoothing);

const char* vtkMongeSmoothing::GetMethodAsString() const
{
  return this->Method == ALL_ORDERS ? "AllOrders" : "SecondOrder";
}

int vtkMongeSmoothing::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkRidgesGetPolyData(this, inputVector[0]);
  if (!input ||
    !vtkRidgesAreNumbers(
      this, { { "Sigma", this->Sigma }, { "RelativeSigma", this->RelativeSigma } }))
  {
    return 0;
  }
  vtkRidgesFieldSmoothing::Rule rule;
  rule.allOrders = this->Method == ALL_ORDERS;
  rule.sigma = this->Sigma;
  rule.relativeSigma = this->RelativeSigma;
  rule.steps = this->NumberOfSteps;
  vtkRidgesFieldSmoothing smoothing;
  return smoothing.Run(this, input, rule, vtkPolyData::GetData(outputVector)) ? 1 : 0;
}

void vtkMongeSmoothing::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->GetMethodAsString() << "\n";
  os << indent << "Sigma: " << this->Sigma << "\n";
  os << indent << "RelativeSigma: " << this->RelativeSigma << "\n";
  os << indent << "NumberOfSteps: " << this->NumberOfSteps << "\n";
}
