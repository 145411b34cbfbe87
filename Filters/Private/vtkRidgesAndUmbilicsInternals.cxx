// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesAndUmbilicsInternals.h"

#include "Core/Base/RankGathering.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesFieldData.h"
#include "vtkRidgesRequest.h"

#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkRidgesAndUmbilics::vtkInternals::Jets);

vtkRidgesAndUmbilics::vtkInternals::vtkInternals(vtkRidgesAndUmbilics* filter)
  : Filter(filter)
{
  vtkNew<Jets> jetsOfFilter;
  jetsOfFilter->filter = filter;
  this->jets = jetsOfFilter;
  vtkNew<OnPart<vtkUmbilicDetection>> umbilicsOfPart;
  umbilicsOfPart->internals = this;
  this->umbilics = umbilicsOfPart;
  vtkNew<OnPart<vtkRidgeExtraction>> ridgesOfPart;
  ridgesOfPart->internals = this;
  this->ridges = ridgesOfPart;
  this->ridges->SetInputConnection(this->umbilics->GetOutputPort());
  this->selection->SetInputConnection(this->ridges->GetOutputPort());

  // What part of the time each stage takes, roughly, on meshes of any size.
  this->jets->SetProgressShiftScale(0.0, 0.5);
  this->umbilics->SetProgressShiftScale(0.5, 0.2);
  this->ridges->SetProgressShiftScale(0.7, 0.25);
  this->selection->SetProgressShiftScale(0.95, 0.05);

  for (vtkPolyDataAlgorithm* stage : this->GetStages())
  {
    stage->AddObserver(vtkCommand::ProgressEvent, this, &vtkInternals::ForwardProgress);
    stage->AddObserver(vtkCommand::WarningEvent, this, &vtkInternals::ForwardMessage);
    stage->AddObserver(vtkCommand::ErrorEvent, this, &vtkInternals::ForwardMessage);
    stage->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this, &vtkInternals::ForwardMessage);
  }
}

/// Passes a copy to the first stage, as a pipeline of its own must not leave its marks on the
/// input; and only where the input is another or has changed, so that the fit is kept otherwise.
void vtkRidgesAndUmbilics::vtkInternals::TakeIn(vtkPolyData* input)
{
  if (input != this->LastInput || input->GetMTime() != this->LastInputTime)
  {
    vtkNew<vtkPolyData> copy;
    copy->ShallowCopy(input);
    this->jets->SetInputData(copy);
    this->LastInput = input;
    this->LastInputTime = input->GetMTime();
  }
}

bool vtkRidgesAndUmbilics::vtkInternals::Run(vtkPolyDataAlgorithm* stage)
{
  stage->Update();
  if (this->errorText.empty() && vtkRidgesCompatibility::IsAborted(this->Filter))
  {
    // Taken back, as VTK after 9.1 does not do so itself; and what it has left is not its output.
    stage->SetAbortExecute(0);
    stage->Modified();
    return false;
  }
  return this->errorText.empty();
}

bool vtkRidgesAndUmbilics::vtkInternals::FitPieces()
{
  this->gathering = &this->ofPieces;
  this->HasGathered = false;
  ridges::OneRank alone;
  return this->ofPieces.Take(*this->stream, this->jets, this->umbilics, this->LeastExtent(alone)) &&
    this->errorText.empty();
}

bool vtkRidgesAndUmbilics::vtkInternals::FitOnRanks(ridges::Ranks& ranks)
{
  this->gathering = &this->ofRanks;
  if (!ridges::IsAnywhere(ranks, this->jets->GetMTime() > this->LastFitTime))
  {
    return true;
  }
  this->jets->Modified(); // so that all run
  if (ridges::IsAnywhere(ranks, !this->Run(this->jets)))
  {
    this->LastFitTime = 0;
    return false;
  }
  this->LastFitTime = this->jets->GetMTime();
  this->ofRanks.Take(ranks, this->jets->GetOutput(), this->surface);
  this->HasGathered = false;
  return true;
}

/// What the properties ask for, which are those of the first rank.
vtkRidgesGathering::Extent vtkRidgesAndUmbilics::vtkInternals::LeastExtent(ridges::Ranks& ranks)
{
  vtkRidgesGathering::Extent extent;
  extent.significance = this->umbilics->GetSignificance();
  extent.isAll = !this->gathering->MayBePart() ||
    this->umbilics->GetMethod() != vtkUmbilicDetection::INDICES ||
    this->ridges->GetTypeHysteresis() > 0.0 || this->ridges->GetComputeFoldAngle();
  return ridges::GatherAllOne(ranks, extent).front();
}

bool vtkRidgesAndUmbilics::vtkInternals::FindOnFirst(ridges::Ranks& ranks)
{
  using Wants = ridges::MeshPart::Wants;
  const vtkRidgesGathering::Extent least = this->LeastExtent(ranks);
  bool hasEnough = this->HasGathered && least == this->LeastGathered;
  if (!hasEnough)
  {
    this->LeastGathered = least;
    this->Gathered = least;
  }
  for (;;)
  {
    if (!hasEnough)
    {
      this->umbilics->SetInputData(this->gathering->Gather(ranks, this->umbilics, this->Gathered));
      this->HasGathered = true;
      if (ridges::IsAnywhere(ranks, vtkRidgesCompatibility::IsAborted(this->Filter)))
      {
        this->HasGathered = false;
        return false;
      }
    }
    if (!this->RunOnFirst(ranks))
    {
      return false;
    }
    const ridges::MeshPart* part = this->gathering->GetPart();
    const Wants wants = ridges::GatherAllOne(ranks, part ? part->Wanted() : Wants::Nothing).front();
    if (wants == Wants::Nothing)
    {
      return true;
    }
    this->Gathered.Enlarge();
    this->Gathered.isAll = this->Gathered.isAll || wants == Wants::All;
    hasEnough = false;
  }
}

/// All stages behind the fit. The same result on all.
bool vtkRidgesAndUmbilics::vtkInternals::RunOnFirst(ridges::Ranks& ranks)
{
  bool isDone = true;
  for (vtkPolyDataAlgorithm* stage : this->GetStages())
  {
    isDone = isDone && (ranks.Rank() > 0 || stage == this->jets || this->Run(stage));
  }
  return !ridges::IsAnywhere(ranks, !isDone);
}

void vtkRidgesAndUmbilics::vtkInternals::StoreLines(vtkInformationVector* outputs)
{
  vtkPolyData* lines = vtkPolyData::GetData(outputs, RIDGES);
  lines->ShallowCopy(this->selection->GetOutput());
  this->gathering->NumberPoints(lines->GetPointData(), vtkRidgesArrayNames::EdgePoint0);
  this->gathering->NumberPoints(lines->GetPointData(), vtkRidgesArrayNames::EdgePoint1);
  vtkPolyData* vertices = vtkPolyData::GetData(outputs, UMBILICS);
  vertices->ShallowCopy(this->umbilics->GetOutput(1));
  this->gathering->NumberTriangles(vertices->GetPointData(), vtkRidgesArrayNames::Triangle);
  for (vtkPolyData* output : { lines, vertices })
  {
    this->gathering->NumberTriangles(
      vtkRidgesOwnFieldData(output), vtkRidgesArrayNames::UmbilicTriangle);
  }
}

void vtkRidgesAndUmbilics::vtkInternals::ForwardProgress(vtkObject* stage, unsigned long, void*)
{
  auto* algorithm = static_cast<vtkAlgorithm*>(stage);
  this->Filter->UpdateProgress(algorithm->GetProgress());
  if (vtkRidgesCompatibility::IsAborted(this->Filter))
  {
    algorithm->SetAbortExecute(1);
  }
}

void vtkRidgesAndUmbilics::vtkInternals::ForwardMessage(vtkObject*, unsigned long event, void* text)
{
  const std::string bare = vtkRidgesBareText(static_cast<const char*>(text));
  if (event == vtkCommand::WarningEvent)
  {
    vtkWarningWithObjectMacro(this->Filter, << bare);
  }
  else if (this->errorText.empty()) // then the executive only adds that its stage has failed
  {
    this->errorText = bare;
  }
}
