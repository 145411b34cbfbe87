// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesJetSelection.h"

#include "Core/Base/RankGathering.h"
#include "Core/Mesh/ShapeSample.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesBatches.h"
#include "vtkRidgesFieldData.h"
#include "vtkRidgesFitSettings.h"
#include "vtkRidgesMesh.h"
#include "vtkRidgesPerThread.h"

#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkMongeSmoothing.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <memory>
#include <numeric>
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
  int numberOfRings;
  int degree;
  std::vector<ridges::JetRemains>& remains;
  vtkRidgesPerThread<ridges::JetProbe> perThread;

  void operator()(vtkIdType begin, vtkIdType end)
  {
    ridges::JetProbe& probe = this->perThread.Get(
      [this] { return std::make_shared<ridges::JetProbe>(this->mesh, this->rings); });
    for (vtkIdType i = begin; i < end; ++i)
    {
      this->remains[i] = probe.RemainsOf(this->sample[i], this->numberOfRings, this->degree);
    }
  }
};

/// What a low degree leaves over on many rings is of the surface, and looks like correlated noise.
/// As high a degree as its coefficients are few beside the points.
int DegreeToLookWith(int numberOfRings, int leastDegree)
{
  constexpr int highestDegree = 6;
  constexpr int fewPerCent = 15;
  const int points = 1 + 3 * numberOfRings * (numberOfRings + 1);
  int degree = leastDegree;
  while (degree < highestDegree && 100 * ridges::HeightJet::Size(degree + 1) <= fewPerCent * points)
  {
    ++degree;
  }
  return degree;
}

/// Of noise that is independent, estimates scatter by about 0.03.
constexpr double HardlyCorrelated = 0.1;

/// Where a degree above 4 is best, noise needs as many rings everywhere.
void BlendNoisyFits(ridges::JetChoice& choice)
{
  constexpr int degree = 4;
  constexpr int fewestRings = 3;
  if (choice.blend.empty() && choice.degree == degree && choice.numberOfRings >= fewestRings &&
    choice.correlation <= HardlyCorrelated)
  {
    choice.blend = ridges::JetsWithNoise(choice.numberOfRings);
    choice.degree = choice.blend.back().degree;
    choice.numberOfRings = choice.blend.back().numberOfRings;
    choice.noiseInBlend = choice.noise;
  }
}

/// For a person, in one line.
std::string TextOf(const ridges::JetChoice& choice)
{
  std::ostringstream text;
  text.precision(2);
  text << "degree " << choice.degree << " on " << choice.numberOfRings << " rings";
  if (choice.numberOfAverages > 0)
  {
    text << ", averaged " << choice.numberOfAverages << " times";
  }
  if (choice.noise > ridges::JetChoice::HardlyAnyNoise * choice.edge)
  {
    text << ", for noise of about " << 100.0 * choice.noise / choice.edge << " % of an edge";
    if (choice.correlation > HardlyCorrelated)
    {
      text << " that is not independent from point to point: not a reliable estimate";
    }
  }
  else
  {
    text << ", for hardly any noise";
  }
  for (std::size_t i = choice.blend.size(); i-- > 1;)
  {
    const ridges::BlendedJet& other = choice.blend[i - 1];
    text << (i + 1 == choice.blend.size() ? "; blended with degree " : " and ") << other.degree
         << " on " << other.numberOfRings;
  }
  return text.str();
}

constexpr double WantedPoints = 300.0;

/// Where trials are made: on a mesh that is all here.
struct WholeMesh
{
  const ridges::TriangleMesh& mesh;
  const ridges::OrderedRings& rings;
  std::vector<ridges::Id> sample;

  bool IsEmpty() const { return this->sample.empty(); }

  /// body(mesh, rings, sample, values) sets the values of the points of a sample, as far as they
  /// are here; false if it was stopped. Then all values that there are, in order.
  template <typename Value, typename Body>
  bool ForSample(int, std::vector<Value>& values, const Body& body) const
  {
    values.resize(this->sample.size());
    return body(this->mesh, this->rings, this->sample, values);
  }
};

/// On the shares that ranks have of a mesh.
struct MeshOfRanks
{
  ridges::Ranks& ranks;
  ridges::SharedMesh& shared;
  std::vector<ridges::DrawnPoint> sample;

  bool IsEmpty() const { return this->sample.empty(); }

  template <typename Value, typename Body>
  bool ForSample(int numberOfRings, std::vector<Value>& values, const Body& body) const
  {
    const ridges::MeshShare share(
      this->ranks, this->shared, ridges::DrawnOn(this->ranks.Rank(), this->sample), numberOfRings);
    ridges::OrderedRings rings(share.Mesh());
    rings.Build(0, share.Mesh().NumberOfPoints());
    std::vector<ridges::Id> inner(share.NumberOfInner());
    std::iota(inner.begin(), inner.end(), 0);
    std::vector<Value> own(inner.size());
    const bool isDone = body(share.Mesh(), rings, inner, own);
    if (ridges::IsAnywhere(this->ranks, !isDone))
    {
      return false;
    }
    const std::vector<std::vector<Value>> all = ridges::GatherAllValues(this->ranks, own);
    std::vector<std::size_t> taken(all.size(), 0);
    values.clear();
    for (const ridges::DrawnPoint& point : this->sample)
    {
      values.push_back(all[point.rank][taken[point.rank]++]);
    }
    return true;
  }
};

template <typename Mesh>
bool Select(
  vtkJetFitting* filter, const Mesh& where, double from, double to, ridges::JetChoice& choice)
{
  const int order = vtkRidgesFitOrder(filter);
  ridges::JetSelection selection(std::clamp(order, 2, 3), filter->GetDegree());
  using Sample = std::vector<ridges::Id>;
  std::vector<ridges::JetTrial> trials;
  while (!where.IsEmpty() && selection.NextRings() > 0)
  {
    // How many numbers of rings will be tried is not known.
    const double middle = 0.5 * (from + to);
    const auto tryPoints = [&](const ridges::TriangleMesh& mesh, const ridges::OrderedRings& rings,
                             const Sample& sample, std::vector<ridges::JetTrial>& values)
    {
      TryPoints body{ mesh, rings, sample, selection.NextRings(), selection.NextBands(), values,
        {} };
      return vtkRidgesForBatches(filter, static_cast<vtkIdType>(sample.size()), from, middle, body);
    };
    if (!where.ForSample(selection.NextRings(), trials, tryPoints))
    {
      return false;
    }
    from = middle;
    selection.Add(trials);
  }
  choice = selection.Choice();
  // Without P1 and P2 there are no types to flicker.
  choice.numberOfAverages = order < 4 ? 0 : choice.numberOfAverages;
  // A polynomial on fewer follows what neighbours have in common.
  constexpr int fewestRings = 5;
  const int rings = std::max(choice.numberOfRings, fewestRings);
  const int degree = DegreeToLookWith(rings, choice.degree);
  std::vector<ridges::JetRemains> remains;
  const auto look = [&](const ridges::TriangleMesh& mesh, const ridges::OrderedRings& ordered,
                      const Sample& sample, std::vector<ridges::JetRemains>& values)
  {
    LookAtRemains body{ mesh, ordered, sample, rings, degree, values, {} };
    return vtkRidgesForBatches(filter, static_cast<vtkIdType>(sample.size()), from, to, body);
  };
  if (!where.ForSample(rings, remains, look))
  {
    return false;
  }
  choice.correlation = ridges::NeighborCorrelation(remains);
  if (filter->GetBlendNoisyFits() && filter->GetDegree() == 0 && order > 2)
  {
    BlendNoisyFits(choice);
  }
  return true;
}

} // namespace

bool vtkRidgesSelectJets(vtkJetFitting* filter, const ridges::TriangleMesh& mesh,
  const ridges::OrderedRings& rings, double from, double to, ridges::JetChoice& choice)
{
  WholeMesh whole{ mesh, rings, ridges::ShapeSample(mesh, WantedPoints) };
  return Select(filter, whole, from, to, choice);
}

bool vtkRidgesSelectJets(vtkJetFitting* filter, ridges::Ranks& ranks, ridges::SharedMesh& shared,
  double from, double to, ridges::JetChoice& choice)
{
  MeshOfRanks mesh{ ranks, shared,
    ridges::ShapeSample(shared.Around(), shared.NumberOfOwned(), WantedPoints, ranks) };
  return Select(filter, mesh, from, to, choice);
}

namespace
{

/// Tells a filter how far another one is that works for it, and that one to abort.
struct Forwarding
{
  vtkJetFitting* filter; ///< Or null.
  double from;
  double to;

  void Hear(vtkObject* caller, unsigned long, void*)
  {
    auto* stage = vtkAlgorithm::SafeDownCast(caller);
    if (this->filter)
    {
      this->filter->UpdateProgress(this->from + (this->to - this->from) * stage->GetProgress());
      if (vtkRidgesCompatibility::IsAborted(this->filter))
      {
        stage->SetAbortExecute(1);
      }
    }
  }
};

} // namespace

bool vtkRidgesAverageJets(vtkJetFitting* filter, const vtkRidgesMesh& mesh, vtkPolyData* fitted,
  const ridges::JetChoice& choice, double from, double to)
{
  vtkNew<vtkPolyData> before;
  before->ShallowCopy(fitted);
  mesh.HandOnWith(before);
  vtkNew<vtkMongeSmoothing> smoothing;
  smoothing->SetMethodToAllOrders();
  smoothing->SetNumberOfSteps(choice.numberOfAverages);
  smoothing->SetInputData(before);
  Forwarding forwarding{ filter, from, to };
  smoothing->AddObserver(vtkCommand::ProgressEvent, &forwarding, &Forwarding::Hear);
  smoothing->Update();
  if (filter && vtkRidgesCompatibility::IsAborted(filter))
  {
    return false;
  }
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
  return true;
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
    vtkRidgesAddFieldValue<vtkIntArray>(field, names::SelectedDegree, choice->degree);
    vtkRidgesAddFieldValue<vtkIntArray>(field, names::SelectedNumberOfRings, choice->numberOfRings);
    vtkRidgesAddFieldValue<vtkIntArray>(
      field, names::SelectedNumberOfAverages, choice->numberOfAverages);
    vtkRidgesAddFieldValue<vtkDoubleArray>(field, names::EstimatedNoise, choice->noise);
    vtkRidgesAddFieldValue<vtkDoubleArray>(field, names::NoiseCorrelation, choice->correlation);
    vtkRidgesAddFieldValue<vtkStringArray>(field, names::SelectedFit, TextOf(*choice));
  }
}
