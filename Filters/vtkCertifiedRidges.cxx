// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCertifiedRidges.h"

#include "vtkRidgeExtraction.h"
#include "vtkRidgesCertificateOutput.h"
#include "vtkRidgesCertifier.h"
#include "vtkRidgesRequest.h"

#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <string>

vtkStandardNewMacro(vtkCertifiedRidges);

vtkCertifiedRidges::vtkCertifiedRidges()
{
  this->SetNumberOfOutputPorts(5);
}

vtkCertifiedRidges::~vtkCertifiedRidges() = default;

int vtkCertifiedRidges::RequestData(
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
  vtkPolyData* mesh = vtkPolyData::GetData(outputVector, MESH);
  const std::string faults = output.StoreMesh(mesh, vtkPolyData::GetData(outputVector, UMBILICS));
  if (!faults.empty())
  {
    vtkErrorMacro(<< faults << ".");
    return 0;
  }
  output.StoreEdges(vtkPolyData::GetData(outputVector, EDGES));
  output.StoreTable(vtkTable::GetData(outputVector, TABLE));
  if (!certifier.GetCertificate().HoldsEverywhere())
  {
    vtkWarningMacro("The ridges are not certified: see the failed hypotheses in the table.");
  }
  this->StoreRidges(mesh, vtkPolyData::GetData(outputVector, RIDGES));
  output.PlaceOnRidges(vtkPolyData::GetData(outputVector, RIDGES));
  return 1;
}

// What may be noise in an estimate is none here: every loop and every turning point counts.
void vtkCertifiedRidges::StoreRidges(vtkPolyData* mesh, vtkPolyData* output)
{
  vtkNew<vtkPolyData> copy; // a pipeline of its own must not leave its marks on the output
  copy->ShallowCopy(mesh);
  vtkNew<vtkRidgeExtraction> extraction;
  extraction->SetLoopSignificance(0.0);
  extraction->SetZoneSignificance(0.0);
  extraction->SetTypeHysteresis(0.0);
  extraction->SetInputData(copy);
  extraction->Update();
  output->ShallowCopy(extraction->GetOutput());
}
