// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPJetFitting.h"

#include "vtkRidgesControllerRanks.h"
#include "vtkRidgesRanksPipeline.h"

#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPJetFitting);

int vtkPJetFitting::FillInputPortInformation(int port, vtkInformation* info)
{
  // So that the filter runs where it is missing, and says so.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return this->Superclass::FillInputPortInformation(port, info);
}

vtkExecutive* vtkPJetFitting::CreateDefaultExecutive()
{
  return vtkRidgesRanksPipeline::New();
}

vtkPJetFitting::vtkPJetFitting()
  : Ranks(new vtkRidgesControllerRanks(this))
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkPJetFitting::~vtkPJetFitting()
{
  vtkMultiProcessController* none = nullptr; // nullptr itself cannot be printed by the macro
  vtkSetObjectBodyMacro(Controller, vtkMultiProcessController, none);
  delete this->Ranks;
}

void vtkPJetFitting::SetController(vtkMultiProcessController* controller)
{
  vtkSetObjectBodyMacro(Controller, vtkMultiProcessController, controller);
  static_cast<vtkRidgesControllerRanks*>(this->Ranks)->SetController(controller);
}

ridges::Ranks* vtkPJetFitting::GetRanks()
{
  return this->Ranks;
}

void vtkPJetFitting::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller << "\n";
}
