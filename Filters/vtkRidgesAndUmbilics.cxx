// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesAndUmbilics.h"

#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>

vtkStandardNewMacro(vtkRidgesAndUmbilics);

namespace
{

/// A message without what VTK puts around it: file, line and object of the stage.
std::string BareText(const char* text)
{
  std::string bare = text;
  const std::size_t object = bare.find("): ");
  bare.erase(0, object == std::string::npos ? 0 : object + 3);
  bare.erase(bare.find_last_not_of(" \n") + 1);
  return bare;
}

} // namespace

vtkRidgesAndUmbilics::vtkRidgesAndUmbilics()
{
  this->SetNumberOfOutputPorts(3);

  this->Umbilics->SetInputConnection(this->Jets->GetOutputPort());
  this->Ridges->SetInputConnection(this->Umbilics->GetOutputPort());
  this->Selection->SetInputConnection(this->Ridges->GetOutputPort());

  // What part of the time each stage takes, roughly, on meshes of any size.
  this->Jets->SetProgressShiftScale(0.0, 0.5);
  this->Umbilics->SetProgressShiftScale(0.5, 0.2);
  this->Ridges->SetProgressShiftScale(0.7, 0.25);
  this->Selection->SetProgressShiftScale(0.95, 0.05);

  for (vtkPolyDataAlgorithm* stage : this->GetStages())
  {
    stage->AddObserver(vtkCommand::ProgressEvent, this, &vtkRidgesAndUmbilics::ForwardProgress);
    stage->AddObserver(vtkCommand::WarningEvent, this, &vtkRidgesAndUmbilics::ForwardMessage);
    stage->AddObserver(vtkCommand::ErrorEvent, this, &vtkRidgesAndUmbilics::ForwardMessage);
    stage->GetExecutive()->AddObserver(
      vtkCommand::ErrorEvent, this, &vtkRidgesAndUmbilics::ForwardMessage);
  }
}

std::array<vtkPolyDataAlgorithm*, 4> vtkRidgesAndUmbilics::GetStages()
{
  return { this->Jets, this->Umbilics, this->Ridges, this->Selection };
}

vtkMTimeType vtkRidgesAndUmbilics::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkPolyDataAlgorithm* stage : this->GetStages())
  {
    time = std::max(time, stage->GetMTime());
  }
  return time;
}

void vtkRidgesAndUmbilics::ForwardProgress(vtkObject* stage, unsigned long, void*)
{
  auto* algorithm = static_cast<vtkAlgorithm*>(stage);
  this->UpdateProgress(algorithm->GetProgress());
  if (this->GetAbortExecute())
  {
    algorithm->SetAbortExecute(1);
  }
}

void vtkRidgesAndUmbilics::ForwardMessage(vtkObject*, unsigned long event, void* text)
{
  const std::string bare = BareText(static_cast<const char*>(text));
  if (event == vtkCommand::WarningEvent)
  {
    vtkWarningMacro(<< bare);
  }
  else if (this->ErrorText.empty()) // then the executive only adds that its stage has failed
  {
    this->ErrorText = bare;
  }
}

/// Hands over a copy, as a pipeline of its own must not leave its marks on the input; and only
/// where the input is another or has changed, so that the fit is kept otherwise.
void vtkRidgesAndUmbilics::TakeIn(vtkPolyData* input)
{
  if (input != this->LastInput || input->GetMTime() != this->LastInputTime)
  {
    vtkNew<vtkPolyData> copy;
    copy->ShallowCopy(input);
    this->Jets->SetInputData(copy);
    this->LastInput = input;
    this->LastInputTime = input->GetMTime();
  }
}

int vtkRidgesAndUmbilics::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  if (input->GetNumberOfPoints() > 0 && input->GetNumberOfPolys() + input->GetNumberOfStrips() == 0)
  {
    vtkErrorMacro("The input has points, but no triangles: give the mesh of a surface.");
    return 0;
  }

  this->TakeIn(input);
  this->ErrorText.clear();
  for (vtkPolyDataAlgorithm* stage : this->GetStages())
  {
    stage->Update();
    if (!this->ErrorText.empty())
    {
      vtkErrorMacro(<< this->ErrorText);
      return 0;
    }
    if (this->GetAbortExecute())
    {
      // Taken back, as VTK after 9.1 does not do so itself; and what it has left is not its output.
      stage->SetAbortExecute(0);
      stage->Modified();
      return 1;
    }
  }

  vtkPolyData::GetData(outputVector, RIDGES)->ShallowCopy(this->Selection->GetOutput());
  vtkPolyData::GetData(outputVector, UMBILICS)->ShallowCopy(this->Umbilics->GetOutput(1));
  vtkPolyData::GetData(outputVector, MESH)->ShallowCopy(this->Umbilics->GetOutput(0));
  return 1;
}

void vtkRidgesAndUmbilics::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (vtkPolyDataAlgorithm* stage : this->GetStages())
  {
    os << indent << stage->GetClassName() << ":\n";
    stage->PrintSelf(os, indent.GetNextIndent());
  }
}
