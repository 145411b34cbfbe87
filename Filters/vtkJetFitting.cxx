// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkJetFitting.h"

#include "Core/Base/Ranks.h"
#include "Core/Fit/JetFit.h"
#include "Core/Mesh/OrderedRings.h"
#include "Core/Mesh/RingNeighborhood.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesBatches.h"
#include "vtkRidgesFitFaults.h"
#include "vtkRidgesFitSettings.h"
#include "vtkRidgesGhosts.h"
#include "vtkRidgesJetBlend.h"
#include "vtkRidgesJetSelection.h"
#include "vtkRidgesMesh.h"
#include "vtkRidgesMongeOutput.h"
#include "vtkRidgesRequest.h"
#include "vtkRidgesSharedFit.h"
#include "vtkRidgesStreamedFit.h"
#include "vtkRidgesUmbilicMarks.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <string>

namespace names = vtkRidgesArrayNames;

vtkStandardNewMacro(vtkJetFitting);

static_assert(static_cast<int>(vtkJetFitting::FIT_BOUNDARY) == ridges::FitBoundary &&
    static_cast<int>(vtkJetFitting::FIT_TOO_FEW_POINTS) == ridges::FitTooFewPoints &&
    static_cast<int>(vtkJetFitting::FIT_ILL_CONDITIONED) == ridges::FitIllConditioned &&
    static_cast<int>(vtkJetFitting::FIT_INVALID) == ridges::FitInvalid &&
    static_cast<int>(vtkJetFitting::FIT_FOLDED) == ridges::FitFolded,
  "FitStatusBits repeats ridges::FitStatus");

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

/// Whether one rank is asked for one of several pieces, and the filter is one for ranks.
bool IsStreamed(const ridges::Ranks* ranks, vtkInformationVector* outputVector)
{
  return ranks && ranks->Size() == 1 &&
    outputVector->GetInformationObject(0)->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) > 1;
}

struct BuildRings
{
  ridges::OrderedRings& rings;

  void operator()(vtkIdType begin, vtkIdType end)
  {
    this->rings.Build(static_cast<ridges::Id>(begin), static_cast<ridges::Id>(end));
  }
};

} // namespace

const char* vtkJetFitting::GetNeighborhoodAsString() const
{
  switch (this->Neighborhood)
  {
    case BY_RINGS:
      return "Rings";
    case BY_RADIUS:
      return "Radius";
    case AUTOMATIC:
      return "Automatic";
    default:
      return "PointCount";
  }
}

const char* vtkJetFitting::GetWeightingAsString() const
{
  return this->Weighting == GAUSSIAN ? "Gaussian" : "Uniform";
}

vtkJetFitting::~vtkJetFitting()
{
  delete this->Stream;
}

int vtkJetFitting::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (IsStreamed(this->GetRanks(), outputVector))
  {
    vtkInformation* output = outputVector->GetInformationObject(0);
    const int pieces = output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES());
    const int piece = output->Get(Pipeline::UPDATE_PIECE_NUMBER());
    if (!this->Stream || !this->Stream->IsOf(this, pieces))
    {
      delete this->Stream;
      // The one that is wanted comes last.
      this->Stream = new vtkRidgesStreamedFit(this, pieces, (piece + 1) % pieces);
    }
    this->Stream->AskFor(inputVector[0], piece);
  }
  // Ranks that share the mesh get what they need from each other.
  else if (!ridges::AreSeveral(this->GetRanks()))
  {
    vtkRidgesRequestGhostLevels(inputVector[0], vtkRidgesGhostLevelsOf(this));
  }
  return this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
}

/// Of the input all pieces are taken first.
int vtkJetFitting::RequestPiece(
  vtkInformation* request, vtkInformationVector* inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkRidgesGetPolyData(this, inputVector);
  if (!input)
  {
    return 0;
  }
  std::string fault = vtkRidgesFitSettingsFault(this);
  if (fault.empty() && !this->Stream->IsComplete())
  {
    fault = this->Stream->Take(input);
    fault = fault.empty() ? fault : "The mesh cannot be used: " + fault;
    if (fault.empty() && !this->Stream->IsComplete())
    {
      request->Set(Pipeline::CONTINUE_EXECUTING(), 1);
      return 1;
    }
  }
  request->Remove(Pipeline::CONTINUE_EXECUTING());
  if (!fault.empty())
  {
    delete this->Stream;
    this->Stream = nullptr;
    vtkErrorMacro(<< fault << ".");
    return 0;
  }
  const int piece = outputVector->GetInformationObject(0)->Get(Pipeline::UPDATE_PIECE_NUMBER());
  return this->Stream->FitPiece(this, piece, input, vtkPolyData::GetData(outputVector));
}

int vtkJetFitting::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (IsStreamed(this->GetRanks(), outputVector))
  {
    return this->RequestPiece(request, inputVector[0], outputVector);
  }
  ridges::Ranks* ranks = this->GetRanks();
  if (ridges::AreSeveral(ranks))
  {
    return vtkRidgesSharedFit(
      this, *ranks, inputVector[0], vtkPolyData::GetData(outputVector), this->GetSurface());
  }
  vtkPolyData* input = vtkRidgesGetPolyData(this, inputVector[0]);
  if (!input)
  {
    return 0;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector);

  const std::string fault = vtkRidgesFitSettingsFault(this);
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << ".");
    return 0;
  }
  vtkRidgesMesh mesh;
  const std::string faults = mesh.Build(input, {}, ridges::TriangleMesh::Edges::NotBuilt);
  if (!faults.empty())
  {
    vtkErrorMacro("The mesh cannot be used: " << faults << ".");
    return 0;
  }
  const ridges::TriangleMesh& triangles = mesh.GetTriangles();
  const vtkIdType count = mesh.GetPolyData()->GetNumberOfPoints();
  const bool isAutomatic = this->Neighborhood == AUTOMATIC;
  const int order = vtkRidgesFitOrder(this);
  vtkRidgesMongeOutput arrays(count, order, this->StandardErrors);
  ridges::OrderedRings rings(triangles);
  BuildRings buildRings{ rings };
  if (!vtkRidgesForBatches(this, count, 0.1, 0.2, buildRings))
  {
    return 1;
  }
  vtkRidgesJets jets{ triangles, rings, count, order, { vtkRidgesFitSettings(this) } };
  ridges::JetChoice choice;
  if (isAutomatic)
  {
    if (!vtkRidgesSelectJets(this, triangles, rings, 0.2, 0.3, choice))
    {
      return 1;
    }
    jets.fits = vtkRidgesFitSettings(this, choice);
    jets.noise = choice.noiseInBlend;
  }
  const double fitted = choice.numberOfAverages > 0 ? 0.95 : 1.0;
  if (!vtkRidgesFitJets(this, jets, isAutomatic ? 0.3 : 0.2, fitted, arrays))
  {
    return 1;
  }
  vtkRidgesWarnOfMissingGhosts(this, inputVector[0]);
  const std::string complaint = vtkRidgesCountFitFaults(mesh, rings, arrays.GetStatus()).GetText();
  if (!complaint.empty())
  {
    vtkWarningMacro(<< complaint << ".");
  }

  output->ShallowCopy(mesh.GetPolyData());
  arrays.AddTo(output->GetPointData());
  vtkRidgesUmbilicMarks::RemoveFrom(output);
  if (choice.numberOfAverages > 0 && !vtkRidgesAverageJets(this, mesh, output, choice, fitted, 1.0))
  {
    output->Initialize();
    return 1;
  }
  vtkRidgesStoreJetChoice(output, isAutomatic && count > 0 ? &choice : nullptr);
  mesh.HandOnWith(output);
  return 1;
}

void vtkJetFitting::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Degree: ";
  if (this->Degree > 0)
  {
    os << this->Degree << "\n";
  }
  else
  {
    os << "Automatic\n";
  }
  os << indent << "MongeOrder: " << this->MongeOrder << "\n";
  os << indent << "Neighborhood: " << this->GetNeighborhoodAsString() << "\n";
  os << indent << "MinimumNumberOfPoints: " << this->MinimumNumberOfPoints << "\n";
  os << indent << "NumberOfRings: " << this->NumberOfRings << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "Weighting: " << this->GetWeightingAsString() << "\n";
  os << indent << "BlendNoisyFits: " << (this->BlendNoisyFits ? "On" : "Off") << "\n";
  os << indent << "StandardErrors: " << (this->StandardErrors ? "On" : "Off") << "\n";
}
