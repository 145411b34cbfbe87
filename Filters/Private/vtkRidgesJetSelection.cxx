// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesJetSelection.h"

#include "Core/Mesh/ShapeSample.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesBatches.h"
#include "vtkRidgesFieldData.h"
#include "vtkRidgesMesh.h"
#include "vtkRidgesPerThread.h"

#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkMongeSmoothing.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace names = vtkRidgesArrayNames;

namespace
{

struct TryPoints
{
  const ridges::TriangleMesh& mesh;
  const ridges::OrderedRings& rings;
  const std::vector<ridges::Id>& sample;
  int numberOfRings;
  int bands;
  std::vector<ridges::JetTrial>& trials;
  vtkRidgesPerThread<ridges::JetProbe> perThread;

  void operator()(vtkIdType begin, vtkIdType end)
  {
    ridges::JetProbe& probe = this->perThread.Get(
      [this] { return std::make_shared<ridges::JetProbe>(this->mesh, this->rings); });
    for (vtkIdType i = begin; i < end; ++i)
    {
      this->trials[i] = probe.Try(this->sample[i], this->numberOfRings, this->bands);
    }
  }
};

struct LookAtRemains
{
  const ridges::TriangleMesh& mesh;
  const ridges::OrderedRings& rings;
  const std::vector<ridges::Id>& sample;
  const ridges::JetChoice& choice;
  std::vector<ridges::JetRemains>& remains;
  vtkRidgesPerThread<ridges::JetProbe> perThread;

  void operator()(vtkIdType begin, vtkIdType end)
  {
    // A polynomial on fewer follows what neighbours have in common.
    constexpr int fewestRings = 5;
    ridges::JetProbe& probe = this->perThread.Get(
      [this] { return std::make_shared<ridges::JetProbe>(this->mesh, this->rings); });
    for (vtkIdType i = begin; i < end; ++i)
    {
      this->remains[i] = probe.RemainsOf(
        this->sample[i], std::max(this->choice.numberOfRings, fewestRings), this->choice.degree);
    }
  }
};

template <typename Array, typename Value>
void AddOne(vtkFieldData* field, const char* name, Value value)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->InsertNextValue(value);
  field->AddArray(array);
}

/// For a person, in one line.
std::string TextOf(const ridges::JetChoice& choice)
{
  constexpr double hardlyAny = 1e-5;
  std::ostringstream text;
  text.precision(2);
  text << "degree " << choice.degree << " on " << choice.numberOfRings << " rings";
  if (choice.numberOfAverages > 0)
  {
    text << ", averaged " << choice.numberOfAverages << " times";
  }
  if (choice.noise > hardlyAny * choice.edge)
  {
    text << ", for noise of about " << 100.0 * choice.noise / choice.edge << " % of an edge";
    // Of noise that is independent, estimates scatter by about 0.03.
    constexpr double hardlyCorrelated = 0.1;
    if (choice.correlation > hardlyCorrelated)
    {
      text << " that is not independent from point to point: not a reliable estimate";
    }
  }
  else
  {
    text << ", for hardly any noise";
  }
  return text.str();
}

} // namespace

bool vtkRidgesSelectJets(vtkAlgorithm* filter, const ridges::TriangleMesh& mesh,
  const ridges::OrderedRings& rings, ridges::JetSelection selection, double from, double to,
  ridges::JetChoice& choice)
{
  constexpr double wantedPoints = 300.0;
  const std::vector<ridges::Id> sample = ridges::ShapeSample(mesh, wantedPoints);
  std::vector<ridges::JetTrial> trials(sample.size());
  while (!sample.empty() && selection.NextRings() > 0)
  {
    // How many numbers of rings will be tried is not known.
    const double middle = 0.5 * (from + to);
    TryPoints tryPoints{ mesh, rings, sample, selection.NextRings(), selection.NextBands(), trials,
      {} };
    if (!vtkRidgesForBatches(
          filter, static_cast<vtkIdType>(sample.size()), from, middle, tryPoints))
    {
      return false;
    }
    from = middle;
    selection.Add(trials);
  }
  choice = selection.Choice();
  std::vector<ridges::JetRemains> remains(sample.size());
  LookAtRemains look{ mesh, rings, sample, choice, remains, {} };
  if (!vtkRidgesForBatches(filter, static_cast<vtkIdType>(sample.size()), from, to, look))
  {
    return false;
  }
  choice.correlation = ridges::NeighborCorrelation(remains);
  return true;
}

void vtkRidgesAverageJets(
  const vtkRidgesMesh& mesh, vtkPolyData* fitted, const ridges::JetChoice& choice)
{
  vtkNew<vtkPolyData> before;
  before->ShallowCopy(fitted);
  mesh.HandOnWith(before);
  vtkNew<vtkMongeSmoothing> smoothing;
  smoothing->SetMethodToAllOrders();
  smoothing->SetNumberOfSteps(choice.numberOfAverages);
  smoothing->SetInputData(before);
  smoothing->Update();
  fitted->ShallowCopy(smoothing->GetOutput());

  // The smoothing does not know that its input is a fit, of which these are true still, or too
  // large rather than too small.
  vtkPointData* arrays = fitted->GetPointData();
  vtkPointData* fit = before->GetPointData();
  for (const char* name : { names::FitScale, names::FitNoiseGain, names::MaximumCurvatureError,
         names::MinimumCurvatureError, names::ThirdOrderError, names::P1Error, names::P2Error })
  {
    arrays->AddArray(fit->GetAbstractArray(name));
  }
}

void vtkRidgesStoreJetChoice(vtkPolyData* mesh, const ridges::JetChoice* choice)
{
  vtkFieldData* field = vtkRidgesOwnFieldData(mesh);
  for (const char* name :
    { names::SelectedDegree, names::SelectedNumberOfRings, names::SelectedNumberOfAverages,
      names::EstimatedNoise, names::NoiseCorrelation, names::SelectedFit })
  {
    field->RemoveArray(name);
  }
  if (choice)
  {
    AddOne<vtkIntArray>(field, names::SelectedDegree, choice->degree);
    AddOne<vtkIntArray>(field, names::SelectedNumberOfRings, choice->numberOfRings);
    AddOne<vtkIntArray>(field, names::SelectedNumberOfAverages, choice->numberOfAverages);
    AddOne<vtkDoubleArray>(field, names::EstimatedNoise, choice->noise);
    AddOne<vtkDoubleArray>(field, names::NoiseCorrelation, choice->correlation);
    AddOne<vtkStringArray>(field, names::SelectedFit, TextOf(*choice));
  }
}
