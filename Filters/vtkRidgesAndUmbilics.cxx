// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesAndUmbilics.h"

#include "Core/Base/RankGathering.h"
#include "vtkRidgeSharpnessFilter.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesCompatibility.h"
#include "vtkRidgesGathering.h"
#include "vtkRidgesGhosts.h"
#include "vtkRidgesRequest.h"
#include "vtkRidgesSharedInput.h"

#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <type_traits>

vtkStandardNewMacro(vtkRidgesAndUmbilics);

namespace
{

/// Sets a property of a stage. If that modifies the stage, the filter is modified, too.
template <typename Stage, typename Value>
void SetOnStage(vtkAlgorithm* filter, Stage* stage, void (Stage::*setter)(Value), Value value)
{
  const vtkMTimeType before = stage->GetMTime();
  (stage->*setter)(value);
  if (stage->GetMTime() != before)
  {
    filter->Modified();
  }
}

} // namespace

//------------------------------------------------------------------------------
/// The four filters in a row.
class vtkRidgesAndUmbilics::vtkInternals
{
  /// On the ranks of the filter.
  class Jets : public vtkJetFitting
  {
  public:
    static Jets* New();
    vtkRidgesAndUmbilics* filter = nullptr;

  protected:
    ridges::Ranks* GetRanks() override { return this->filter->GetRanks(); }
    ridges::SharedSurface* GetSurface() override { return &this->filter->Internals->surface; }
  };

  /// On the part of the mesh that was gathered, if ranks share it.
  template <typename Stage>
  class OnPart : public Stage
  {
  public:
    static OnPart* New() { VTK_STANDARD_NEW_BODY(OnPart); }
    const vtkRidgesGathering* gathering = nullptr;

  protected:
    const ridges::MeshPart* GetPart() override { return this->gathering->GetPart(); }
  };

public:
  explicit vtkInternals(vtkRidgesAndUmbilics* filter);

  std::array<vtkPolyDataAlgorithm*, 4> GetStages()
  {
    return { this->jets, this->umbilics, this->ridges, this->selection };
  }

  void TakeIn(vtkPolyData* input);

  /// Runs a stage. False where the filter has to stop: because of an error, or of the user.
  bool Run(vtkPolyDataAlgorithm* stage);

  /// Fits on all ranks if any of them has to. The same result on all.
  bool FitOnRanks(ridges::Ranks& ranks);

  /// Finds umbilics and ridges on the first rank, from as much of the mesh as that takes. The same
  /// result on all.
  bool FindOnFirst(ridges::Ranks& ranks);

  vtkSmartPointer<vtkJetFitting> jets;
  vtkSmartPointer<vtkUmbilicDetection> umbilics;
  vtkSmartPointer<vtkRidgeExtraction> ridges;
  vtkNew<vtkRidgeSharpnessFilter> selection;
  std::string errorText; ///< Of the stages, in this update.
  vtkRidgesGathering gathering;
  ridges::SharedSurface surface; ///< From the fit to the gathering.

private:
  bool RunOnFirst(ridges::Ranks& ranks);
  vtkRidgesGathering::Extent LeastExtent(ridges::Ranks& ranks);

  void ForwardProgress(vtkObject* stage, unsigned long, void*);
  void ForwardMessage(vtkObject* caller, unsigned long event, void* text);

  vtkRidgesAndUmbilics* Filter;
  const vtkPolyData* LastInput = nullptr; ///< To compare with only.
  vtkMTimeType LastInputTime = 0;
  vtkMTimeType LastFitTime = 0;             ///< On ranks.
  vtkRidgesGathering::Extent LeastGathered; ///< What was asked for,
  vtkRidgesGathering::Extent Gathered;      ///< and what it took.
  bool HasGathered = false;
};

vtkStandardNewMacro(vtkRidgesAndUmbilics::vtkInternals::Jets);

vtkRidgesAndUmbilics::vtkInternals::vtkInternals(vtkRidgesAndUmbilics* filter)
  : Filter(filter)
{
  vtkNew<Jets> jetsOfFilter;
  jetsOfFilter->filter = filter;
  this->jets = jetsOfFilter;
  vtkNew<OnPart<vtkUmbilicDetection>> umbilicsOfPart;
  umbilicsOfPart->gathering = &this->gathering;
  this->umbilics = umbilicsOfPart;
  vtkNew<OnPart<vtkRidgeExtraction>> ridgesOfPart;
  ridgesOfPart->gathering = &this->gathering;
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

bool vtkRidgesAndUmbilics::vtkInternals::FitOnRanks(ridges::Ranks& ranks)
{
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
  this->gathering.Take(ranks, this->jets->GetOutput(), this->surface);
  this->HasGathered = false;
  return true;
}

/// What the properties ask for, which are those of the first rank.
vtkRidgesGathering::Extent vtkRidgesAndUmbilics::vtkInternals::LeastExtent(ridges::Ranks& ranks)
{
  vtkRidgesGathering::Extent extent;
  extent.significance = this->umbilics->GetSignificance();
  extent.isAll = !this->gathering.MayBePart() ||
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
      this->umbilics->SetInputData(this->gathering.Gather(ranks, this->umbilics, this->Gathered));
      this->HasGathered = true;
    }
    if (!this->RunOnFirst(ranks))
    {
      return false;
    }
    const ridges::MeshPart* part = this->gathering.GetPart();
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

//------------------------------------------------------------------------------
#define vtkRidgesStagePropertyMacro(stage, name, type)                                             \
  void vtkRidgesAndUmbilics::Set##name(type value)                                                 \
  {                                                                                                \
    using Stage = std::decay_t<decltype(*this->Internals->stage)>;                                 \
    SetOnStage(this, this->Internals->stage.GetPointer(), &Stage::Set##name, value);               \
  }                                                                                                \
  type vtkRidgesAndUmbilics::Get##name()                                                           \
  {                                                                                                \
    return this->Internals->stage->Get##name();                                                    \
  }

vtkRidgesStagePropertyMacro(jets, Degree, int);
vtkRidgesStagePropertyMacro(jets, Neighborhood, int);
vtkRidgesStagePropertyMacro(jets, MinimumNumberOfPoints, int);
vtkRidgesStagePropertyMacro(jets, NumberOfRings, int);
vtkRidgesStagePropertyMacro(jets, Radius, double);
vtkRidgesStagePropertyMacro(jets, Weighting, int);
vtkRidgesStagePropertyMacro(jets, StandardErrors, bool);
vtkRidgesStagePropertyMacro(umbilics, Method, int);
vtkRidgesStagePropertyMacro(umbilics, Significance, double);
vtkRidgesStagePropertyMacro(umbilics, PatchSize, double);
vtkRidgesStagePropertyMacro(ridges, TypeRule, int);
vtkRidgesStagePropertyMacro(ridges, CrossingRule, int);
vtkRidgesStagePropertyMacro(ridges, UmbilicJoining, int);
vtkRidgesStagePropertyMacro(ridges, LoopSignificance, double);
vtkRidgesStagePropertyMacro(ridges, ZoneSignificance, double);
vtkRidgesStagePropertyMacro(ridges, TypeSignificance, double);
vtkRidgesStagePropertyMacro(ridges, TypeHysteresis, double);
vtkRidgesStagePropertyMacro(ridges, ComputeFoldAngle, bool);
vtkRidgesStagePropertyMacro(ridges, ModelSize, double);
vtkRidgesStagePropertyMacro(ridges, UmbilicCutOff, double);
vtkRidgesStagePropertyMacro(selection, MinimumSharpness, double);
vtkRidgesStagePropertyMacro(selection, MinimumStrength, double);
vtkRidgesStagePropertyMacro(selection, MinimumLength, double);
vtkRidgesStagePropertyMacro(selection, KeepMaximumElliptic, bool);
vtkRidgesStagePropertyMacro(selection, KeepMaximumHyperbolic, bool);
vtkRidgesStagePropertyMacro(selection, KeepMinimumElliptic, bool);
vtkRidgesStagePropertyMacro(selection, KeepMinimumHyperbolic, bool);
vtkRidgesStagePropertyMacro(selection, KeepUndecided, bool);
vtkRidgesStagePropertyMacro(selection, CrestOnly, bool);
vtkRidgesStagePropertyMacro(selection, WholeRidges, bool);
vtkRidgesStagePropertyMacro(selection, MaximumNumber, int);
vtkRidgesStagePropertyMacro(selection, RankBy, int);

#undef vtkRidgesStagePropertyMacro

//------------------------------------------------------------------------------
vtkRidgesAndUmbilics::vtkRidgesAndUmbilics()
  : Internals(new vtkInternals(this))
{
  this->SetNumberOfOutputPorts(3);
}

vtkRidgesAndUmbilics::~vtkRidgesAndUmbilics()
{
  delete this->Internals;
}

int vtkRidgesAndUmbilics::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // Ranks that share the mesh get what they need from each other.
  if (!ridges::AreSeveral(this->GetRanks()))
  {
    vtkRidgesRequestGhostLevels(inputVector[0],
      vtkRidgesGhostLevelsOf(this->Internals->jets) +
        vtkRidgesGhostLevelsOf(this->Internals->umbilics) +
        vtkRidgesGhostLevelsOf(this->Internals->ridges));
  }
  return this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
}

int vtkRidgesAndUmbilics::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  ridges::Ranks* ranks = this->GetRanks();
  if (ridges::AreSeveral(ranks))
  {
    return this->RequestSharedData(*ranks, inputVector, outputVector);
  }
  vtkPolyData* input = vtkRidgesGetPolyData(this, inputVector[0]);
  if (!input)
  {
    return 0;
  }
  if (input->GetNumberOfPoints() > 0 && input->GetNumberOfPolys() + input->GetNumberOfStrips() == 0)
  {
    vtkErrorMacro("The input has points, but no triangles: give the mesh of a surface.");
    return 0;
  }

  vtkRidgesWarnOfMissingGhosts(this, inputVector[0]);

  vtkInternals& internals = *this->Internals;
  internals.TakeIn(input);
  internals.errorText.clear();
  internals.umbilics->SetInputConnection(internals.jets->GetOutputPort());
  for (vtkPolyDataAlgorithm* stage : internals.GetStages())
  {
    if (!internals.Run(stage))
    {
      if (!internals.errorText.empty())
      {
        vtkErrorMacro(<< internals.errorText);
      }
      return internals.errorText.empty() ? 1 : 0;
    }
  }

  vtkPolyData::GetData(outputVector, RIDGES)->ShallowCopy(internals.selection->GetOutput());
  vtkPolyData::GetData(outputVector, UMBILICS)->ShallowCopy(internals.umbilics->GetOutput(1));
  vtkPolyData::GetData(outputVector, MESH)->ShallowCopy(internals.ridges->GetOutput(2));
  return 1;
}

/// Jets are fitted on all ranks, all else is found on the first.
int vtkRidgesAndUmbilics::RequestSharedData(
  ridges::Ranks& ranks, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  std::string faults;
  vtkPolyData* input = vtkRidgesGetPiece(ranks, inputVector[0], faults);
  if (!vtkRidgesAgree(this, ranks, faults))
  {
    return 0;
  }
  const vtkIdType polygons = input->GetNumberOfPolys() + input->GetNumberOfStrips();
  if (!ridges::IsAnywhere(ranks, polygons > 0) &&
    ridges::IsAnywhere(ranks, input->GetNumberOfPoints() > 0))
  {
    vtkErrorMacro("The input has points, but no triangles: give the mesh of a surface.");
    return 0;
  }
  vtkInternals& internals = *this->Internals;
  internals.TakeIn(input);
  internals.errorText.clear();
  const bool isDone = internals.FitOnRanks(ranks) && internals.FindOnFirst(ranks);
  const bool isFirst = ranks.Rank() == 0;
  if (!isDone)
  {
    // That of the first rank is the error of all. There is none if the user aborted.
    const std::string text = ridges::GatherAllTexts(ranks, internals.errorText).front();
    if (!text.empty())
    {
      vtkErrorMacro(<< text);
    }
    return text.empty() ? 1 : 0;
  }
  if (isFirst)
  {
    vtkPolyData* lines = vtkPolyData::GetData(outputVector, RIDGES);
    lines->ShallowCopy(internals.selection->GetOutput());
    internals.gathering.NumberPoints(lines->GetPointData(), vtkRidgesArrayNames::EdgePoint0);
    internals.gathering.NumberPoints(lines->GetPointData(), vtkRidgesArrayNames::EdgePoint1);
    vtkPolyData* vertices = vtkPolyData::GetData(outputVector, UMBILICS);
    vertices->ShallowCopy(internals.umbilics->GetOutput(1));
    internals.gathering.NumberTriangles(vertices->GetPointData(), vtkRidgesArrayNames::Triangle);
  }
  internals.gathering.GiveBack(ranks, isFirst ? internals.ridges->GetOutput(2) : nullptr,
    vtkPolyData::GetData(outputVector, MESH));
  return 1;
}

void vtkRidgesAndUmbilics::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (vtkPolyDataAlgorithm* stage : this->Internals->GetStages())
  {
    os << indent << stage->GetClassName() << ":\n";
    stage->PrintSelf(os, indent.GetNextIndent());
  }
}
