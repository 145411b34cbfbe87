// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCompliantRefinement.h"

#include "vtkRidgesCertificateOutput.h"
#include "vtkRidgesCertifier.h"
#include "vtkRidgesRequest.h"

#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <string>

vtkStandardNewMacro(vtkCompliantRefinement);

vtkCompliantRefinement::vtkCompliantRefinement()
{
  this->SetNumberOfOutputPorts(2);
}

vtkCompliantRefinement::~vtkCompliantRefinement() = default;

int vtkCompliantRefinement::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkRidgesGetPolyData(this, inputVector[0]);
  if (!input)
  {
    return 0;
  }
  vtkRidgesCertifier certifier;
  if (!certifier.Run(this, input))
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
