// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesRanksPipeline.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkRidgesRanksPipeline);

namespace
{

/// All that is before a pipeline.
void FindBefore(vtkExecutive* pipeline, std::set<vtkExecutive*>& found)
{
  for (int port = 0; port < pipeline->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < pipeline->GetNumberOfInputConnections(port); ++i)
    {
      vtkExecutive* before = pipeline->GetInputExecutive(port, i);
      if (before && found.insert(before).second)
      {
        FindBefore(before, found);
      }
    }
  }
}

/// The first sentence, without what VTK puts before it.
std::string SentenceOf(const std::string& message)
{
  const std::size_t object = message.find("): ");
  std::string text = object == std::string::npos ? message : message.substr(object + 3);
  text.erase(std::min(text.find('\n'), text.size()));
  text.erase(text.find_last_not_of(" .") + 1);
  return text;
}

} // namespace

std::string vtkRidgesRanksPipeline::GetFault() const
{
  return this->HasFailed
    ? "what makes the piece has failed" + (this->Heard.empty() ? "" : " (" + this->Heard + ")")
    : std::string();
}

void vtkRidgesRanksPipeline::Hear(vtkObject*, unsigned long, void* text)
{
  if (this->Heard.empty() && text)
  {
    this->Heard = SentenceOf(static_cast<const char*>(text));
  }
}

/// Errors go to VTK's window, unless somebody observes who reports them.
int vtkRidgesRanksPipeline::ForwardAndListen(vtkInformation* request)
{
  std::set<vtkExecutive*> before;
  FindBefore(this, before);
  std::vector<std::pair<vtkSmartPointer<vtkObject>, unsigned long>> observed;
  const auto observe = [this, &observed](vtkObject* reporter)
  {
    observed.emplace_back(
      reporter, reporter->AddObserver(vtkCommand::ErrorEvent, this, &vtkRidgesRanksPipeline::Hear));
  };
  for (vtkExecutive* pipeline : before)
  {
    for (vtkObject* reporter :
      { static_cast<vtkObject*>(pipeline), static_cast<vtkObject*>(pipeline->GetAlgorithm()) })
    {
      if (reporter && reporter->HasObserver(vtkCommand::ErrorEvent))
      {
        observe(reporter);
      }
    }
  }
  observe(vtkOutputWindow::GetInstance());
  const int isDone = this->Superclass::ForwardUpstream(request);
  for (const auto& [reporter, observer] : observed)
  {
    reporter->RemoveObserver(observer);
  }
  return isDone;
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
  if (!this->IsShared)
  {
    const int isDone = this->Superclass::ForwardUpstream(request);
    // A filter that wanted another piece does not run, and cannot take that back itself.
    this->ContinueExecuting = isDone == 0 ? 0 : this->ContinueExecuting;
    return isDone;
  }
  // After a failure VTK may not ask again what is upstream, but take what is there.
  const std::string heardBefore = std::exchange(this->Heard, std::string());
  const int isDone = this->ForwardAndListen(request);
  if (isDone == 0 || !this->Heard.empty())
  {
    this->HasFailed = true;
    this->FailedTime = this->TimeOfSource();
  }
  else if (this->TimeOfSource() != this->FailedTime)
  {
    this->HasFailed = false;
  }
  if (this->HasFailed && this->Heard.empty())
  {
    this->Heard = heardBefore;
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
