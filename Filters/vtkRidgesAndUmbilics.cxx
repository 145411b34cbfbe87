// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesAndUmbilics.h"

#include "Core/Base/RankGathering.h"
#include "vtkRidgesAndUmbilicsInternals.h"
#include "vtkRidgesCompatibility.h"
#include "vtkRidgesFitSettings.h"
#include "vtkRidgesGhosts.h"
#include "vtkRidgesRequest.h"
#include "vtkRidgesSharedInput.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <memory>
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
vtkRidgesStagePropertyMacro(jets, BlendNoisyFits, bool);
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
  if (this->IsStreamed())
  {
    std::unique_ptr<vtkRidgesStreamedFit>& stream = this->Internals->stream;
    const int pieces = this->GetNumberOfStreamedPieces();
    if (!stream || !stream->IsOf(this, pieces))
    {
      stream = std::make_unique<vtkRidgesStreamedFit>(this, pieces, 0);
    }
    stream->AskFor(inputVector[0], 0);
  }
  // Ranks that share the mesh get what they need from each other.
  else if (!ridges::AreSeveral(this->GetRanks()))
  {
    vtkRidgesRequestGhostLevels(inputVector[0],
      vtkRidgesGhostLevelsOf(this->Internals->jets) +
        vtkRidgesGhostLevelsOf(this->Internals->umbilics) +
        vtkRidgesGhostLevelsOf(this->Internals->ridges));
  }
  return this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
}

bool vtkRidgesAndUmbilics::IsStreamed()
{
  return this->GetNumberOfStreamedPieces() > 1 && !ridges::AreSeveral(this->GetRanks());
}

int vtkRidgesAndUmbilics::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (this->IsStreamed())
  {
    return this->RequestPieces(request, inputVector[0], outputVector);
  }
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
  internals.gathering = nullptr;
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

/// Each piece is forgotten before the next is asked for, but for positions and triangles.
int vtkRidgesAndUmbilics::RequestPieces(
  vtkInformation* request, vtkInformationVector* inputVector, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkPolyData* input = vtkRidgesGetPolyData(this, inputVector);
  if (!input)
  {
    return 0;
  }
  vtkInternals& internals = *this->Internals;
  internals.errorText = vtkRidgesFitSettingsFault(internals.jets);
  if (internals.errorText.empty())
  {
    const std::string fault = internals.stream->Take(input);
    if (fault.empty() && !internals.stream->IsComplete())
    {
      request->Set(Pipeline::CONTINUE_EXECUTING(), 1);
      return 1;
    }
    internals.errorText = fault.empty() ? fault : "The mesh cannot be used: " + fault + ".";
  }
  request->Remove(Pipeline::CONTINUE_EXECUTING());
  const int isDone = this->FindInPieces(outputVector);
  internals.ofPieces.Release();
  internals.stream = nullptr;
  return isDone;
}

int vtkRidgesAndUmbilics::FindInPieces(vtkInformationVector* outputVector)
{
  vtkInternals& internals = *this->Internals;
  ridges::OneRank alone;
  const bool isEmpty = internals.stream->GetMesh().NumberOfTriangles() == 0;
  if (internals.errorText.empty() && isEmpty && internals.stream->GetMesh().NumberOfOwned() > 0)
  {
    internals.errorText = "The input has points, but no triangles: give the mesh of a surface.";
  }
  if (internals.errorText.empty() && internals.FitPieces() && internals.FindOnFirst(alone))
  {
    internals.StoreLines(outputVector);
    internals.ofPieces.Store(
      internals.ridges->GetOutput(2), vtkPolyData::GetData(outputVector, MESH));
    return 1;
  }
  if (!internals.errorText.empty())
  {
    vtkErrorMacro(<< internals.errorText);
  }
  return internals.errorText.empty() ? 1 : 0;
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
    internals.StoreLines(outputVector);
  }
  internals.ofRanks.GiveBack(ranks, isFirst ? internals.ridges->GetOutput(2) : nullptr,
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
