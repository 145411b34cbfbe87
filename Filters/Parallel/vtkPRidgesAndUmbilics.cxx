// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPRidgesAndUmbilics.h"

#include "vtkRidgesControllerRanks.h"

#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPRidgesAndUmbilics);

vtkCxxSetObjectMacro(vtkPRidgesAndUmbilics, Controller, vtkMultiProcessController);

vtkPRidgesAndUmbilics::vtkPRidgesAndUmbilics()
  : Ranks(new vtkRidgesControllerRanks)
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkPRidgesAndUmbilics::~vtkPRidgesAndUmbilics()
{
  this->SetController(nullptr);
  delete this->Ranks;
}

ridges::Ranks* vtkPRidgesAndUmbilics::GetRanks()
{
  static_cast<vtkRidgesControllerRanks*>(this->Ranks)->SetController(this->Controller);
  return this->Ranks;
}

void vtkPRidgesAndUmbilics::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller << "\n";
}
