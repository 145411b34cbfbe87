// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPRidgesAndUmbilics.h"

#include "vtkRidgesControllerRanks.h"
#include "vtkRidgesLineShares.h"
#include "vtkRidgesRanksPipeline.h"

#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkPRidgesAndUmbilics);

int vtkPRidgesAndUmbilics::FillInputPortInformation(int port, vtkInformation* info)
{
  // So that the filter runs where it is missing, and says so.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return this->Superclass::FillInputPortInformation(port, info);
}

vtkExecutive* vtkPRidgesAndUmbilics::CreateDefaultExecutive()
{
  return vtkRidgesRanksPipeline::New();
}

vtkPRidgesAndUmbilics::vtkPRidgesAndUmbilics()
  : Ranks(new vtkRidgesControllerRanks(this))
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkPRidgesAndUmbilics::~vtkPRidgesAndUmbilics()
{
  vtkMultiProcessController* none = nullptr; // nullptr itself cannot be printed by the macro
  vtkSetObjectBodyMacro(Controller, vtkMultiProcessController, none);
  delete this->Ranks;
}

void vtkPRidgesAndUmbilics::SetController(vtkMultiProcessController* controller)
{
  vtkSetObjectBodyMacro(Controller, vtkMultiProcessController, controller);
  static_cast<vtkRidgesControllerRanks*>(this->Ranks)->SetController(controller);
}

ridges::Ranks* vtkPRidgesAndUmbilics::GetRanks()
{
  return this->Ranks;
}

int vtkPRidgesAndUmbilics::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int isDone = this->Superclass::RequestData(request, inputVector, outputVector);
  if (isDone != 0 && this->Ranks->Size() > 1)
  {
    // All or none: ranks wait for each other.
    int anywhere = 0;
    const int here = this->DistributeLines ? 1 : 0;
    this->Controller->AllReduce(&here, &anywhere, 1, vtkCommunicator::MAX_OP);
    if (anywhere != 0)
    {
      vtkRidgesShareLines(this->Controller, vtkPolyData::GetData(outputVector, RIDGES));
    }
  }
  return isDone;
}

void vtkPRidgesAndUmbilics::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller << "\n";
  os << indent << "DistributeLines: " << (this->DistributeLines ? "On" : "Off") << "\n";
  os << indent << "NumberOfPieces: " << this->NumberOfPieces << "\n";
}
