// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPJetFitting.h"

#include "vtkRidgesControllerRanks.h"

#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPJetFitting);

vtkCxxSetObjectMacro(vtkPJetFitting, Controller, vtkMultiProcessController);

vtkPJetFitting::vtkPJetFitting()
  : Ranks(new vtkRidgesControllerRanks)
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkPJetFitting::~vtkPJetFitting()
{
  this->SetController(nullptr);
  delete this->Ranks;
}

ridges::Ranks* vtkPJetFitting::GetRanks()
{
  static_cast<vtkRidgesControllerRanks*>(this->Ranks)->SetController(this->Controller);
  return this->Ranks;
}

void vtkPJetFitting::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller << "\n";
}
