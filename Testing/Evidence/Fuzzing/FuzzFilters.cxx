// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Meshes, and meshes with arrays, through the filters, with properties at random.

#include "FuzzData.h"
#include "FuzzTarget.h"

#include "vtkJetFitting.h"
#include "vtkMongeSmoothing.h"
#include "vtkNew.h"
#include "vtkPrincipalFoliation.h"
#include "vtkRidgeCoherence.h"
#include "vtkRidgeExtraction.h"
#include "vtkRidgeSharpnessFilter.h"
#include "vtkRidgesAndUmbilics.h"
#include "vtkSalientRidges.h"
#include "vtkUmbilicDetection.h"

#include <random>

namespace
{

//------------------------------------------------------------------------------
void SetUp(vtkJetFitting* jets, FuzzBytes& bytes)
{
  jets->SetNeighborhood(bytes.Below(4));
  jets->SetDegree(bytes.Below(9));
  jets->SetMongeOrder(1 + bytes.Below(4));
  jets->SetMinimumNumberOfPoints(3 + bytes.Byte());
  jets->SetNumberOfRings(1 + bytes.Below(5));
  jets->SetRadius(bytes.Number());
  jets->SetWeighting(bytes.Below(2));
  jets->SetStandardErrors(bytes.Flag());
  jets->SetBlendNoisyFits(bytes.Flag());
}

//------------------------------------------------------------------------------
void SetUp(vtkUmbilicDetection* umbilics, FuzzBytes& bytes)
{
  umbilics->SetMethod(bytes.Below(2));
  umbilics->SetSignificance(bytes.Number());
  umbilics->SetPatchSize(1.0 + bytes.Below(8));
}

//------------------------------------------------------------------------------
void SetUp(vtkRidgeExtraction* ridges, FuzzBytes& bytes)
{
  ridges->SetExtractMaximum(!bytes.Flag());
  ridges->SetExtractMinimum(!bytes.Flag());
  ridges->SetCrestOnly(bytes.Flag());
  ridges->SetFindPurplePoints(bytes.Flag());
  ridges->SetComputeFoldAngle(bytes.Flag());
  ridges->SetTypeRule(bytes.Below(2));
  ridges->SetExtremalityRule(bytes.Below(2));
  ridges->SetCrossingRule(bytes.Below(2));
  ridges->SetUmbilicJoining(bytes.Below(2));
  ridges->SetLoopSignificance(bytes.Number());
  ridges->SetZoneSignificance(bytes.Number());
  ridges->SetTypeSignificance(bytes.Number());
  ridges->SetTypeHysteresis(bytes.Number());
  ridges->SetModelSize(bytes.Number());
}

//------------------------------------------------------------------------------
// With Monge arrays: from the umbilics to the checks.
void RunStages(vtkPolyData* mesh, FuzzBytes& bytes)
{
  vtkNew<vtkUmbilicDetection> umbilics;
  vtkNew<vtkRidgeExtraction> ridges;
  vtkNew<vtkRidgeSharpnessFilter> sharpness;
  vtkNew<vtkRidgeCoherence> coherence;
  const bool hasProperties = bytes.Flag();
  if (hasProperties)
  {
    SetUp(umbilics.Get(), bytes);
    SetUp(ridges.Get(), bytes);
    sharpness->SetMinimumSharpness(bytes.Number());
    sharpness->SetMinimumLength(bytes.Number());
    sharpness->SetWholeRidges(bytes.Flag());
    sharpness->SetMaximumNumber(bytes.Byte());
  }
  umbilics->SetInputData(mesh);
  ridges->SetInputConnection(umbilics->GetOutputPort());
  sharpness->SetInputConnection(ridges->GetOutputPort());
  coherence->SetInputConnection(0, ridges->GetOutputPort(2));
  coherence->SetInputConnection(1, ridges->GetOutputPort());
  coherence->SetInputConnection(2, umbilics->GetOutputPort(1));
  fuzz::Run(umbilics, mesh);
  fuzz::Run(ridges, mesh);
  fuzz::Run(sharpness, mesh);
  fuzz::Run(coherence, mesh);
}

//------------------------------------------------------------------------------
void RunFoliation(vtkPolyData* mesh, FuzzBytes& bytes)
{
  vtkNew<vtkPrincipalFoliation> foliation;
  foliation->SetDirection(bytes.Below(3));
  // Not smaller, nor of a smaller model: there would be millions of lines, as asked for.
  foliation->SetSeparation(0.15 + bytes.Byte() / 256.0);
  foliation->SetModelSize(bytes.Flag() ? 1.0 + bytes.Byte() : 0.0);
  foliation->SetInputData(mesh);
  fuzz::Run(foliation, mesh);
}

//------------------------------------------------------------------------------
void RunSmoothing(vtkPolyData* mesh, FuzzBytes& bytes)
{
  vtkNew<vtkMongeSmoothing> smoothing;
  smoothing->SetMethod(bytes.Below(2));
  smoothing->SetSigma(bytes.Flag() ? bytes.Number() : 0.0);
  smoothing->SetNumberOfSteps(bytes.Below(8));
  smoothing->SetInputData(mesh);
  fuzz::Run(smoothing, mesh);
}

//------------------------------------------------------------------------------
void RunJets(vtkPolyData* mesh, FuzzBytes& bytes)
{
  vtkNew<vtkJetFitting> jets;
  SetUp(jets.Get(), bytes);
  jets->SetInputData(mesh);
  fuzz::Run(jets, mesh);
  RunStages(jets->GetOutput(), bytes);
}

} // namespace

//------------------------------------------------------------------------------
// Random bytes: all that matters is in their structure.
std::vector<std::string> FuzzSeeds()
{
  std::mt19937 random(7);
  std::vector<std::string> seeds;
  for (int kind = 0; kind < 6; ++kind)
  {
    for (const int size : { 60, 400, 1500 })
    {
      std::string seed(1, static_cast<char>(kind));
      while (static_cast<int>(seed.size()) < size)
      {
        seed += static_cast<char>(random() % 200);
      }
      seeds.push_back(seed);
    }
  }
  return seeds;
}

//------------------------------------------------------------------------------
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzBytes bytes(data, size);
  const int kind = bytes.Below(6);
  const auto mesh = fuzz::MakeMesh(bytes);
  if (kind > 2)
  {
    fuzz::AddMongeArrays(mesh, bytes);
  }
  switch (kind)
  {
    case 0:
      RunJets(mesh, bytes);
      break;
    case 1:
    {
      vtkNew<vtkRidgesAndUmbilics> all;
      all->SetInputData(mesh);
      fuzz::Run(all, mesh);
      break;
    }
    case 2:
    {
      vtkNew<vtkSalientRidges> salient;
      salient->SetFoldAngle(bytes.Byte());
      salient->SetRelativeScale(bytes.Byte() / 1000.0);
      salient->SetInputData(mesh);
      fuzz::Run(salient, mesh);
      break;
    }
    case 3:
      RunStages(mesh, bytes);
      break;
    case 4:
      RunFoliation(mesh, bytes);
      break;
    default:
      RunSmoothing(mesh, bytes);
      break;
  }
  return 0;
}
