// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesRanksPipeline.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkRidgesRanksPipeline);

std::string vtkRidgesRanksPipeline::GetFault() const
{
  return this->HasFailed ? "what makes the piece has failed" : "";
}

/// When what makes the piece was last changed.
vtkMTimeType vtkRidgesRanksPipeline::TimeOfSource()
{
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    return 0;
  }
  auto* source = vtkDemandDrivenPipeline::SafeDownCast(this->GetInputExecutive(0, 0));
  return source ? source->GetPipelineMTime() : 0;
}

int vtkRidgesRanksPipeline::ForwardUpstream(vtkInformation* request)
{
  const int isDone = this->Superclass::ForwardUpstream(request);
  if (!this->IsShared)
  {
    // A filter that wanted another piece does not run, and cannot take that back itself.
    this->ContinueExecuting = isDone == 0 ? 0 : this->ContinueExecuting;
    return isDone;
  }
  // After a failure VTK may not ask again what is upstream, but take what is there.
  if (isDone == 0)
  {
    this->HasFailed = true;
    this->FailedTime = this->TimeOfSource();
  }
  else if (this->TimeOfSource() != this->FailedTime)
  {
    this->HasFailed = false;
  }
  return 1;
}

int vtkRidgesRanksPipeline::InputTypeIsValid(int port, int index, vtkInformationVector** inputs)
{
  return this->IsShared ? 1 : this->Superclass::InputTypeIsValid(port, index, inputs);
}

/// Not block after block: other ranks may have more of them.
void vtkRidgesRanksPipeline::ExecuteSimpleAlgorithm(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs, int port)
{
  if (this->IsShared)
  {
    this->CallAlgorithm(request, vtkExecutive::RequestDownstream, inputs, outputs);
  }
  else
  {
    this->Superclass::ExecuteSimpleAlgorithm(request, inputs, outputs, port);
  }
}
