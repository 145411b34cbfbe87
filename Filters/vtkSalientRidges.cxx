// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSalientRidges.h"

#include "Core/Mesh/EnclosedVolume.h"
#include "Core/Mesh/EnclosingSphere.h"
#include "Core/Mesh/PositionSample.h"
#include "Core/Salience/FoldEvening.h"
#include "Core/Salience/NoiseFloor.h"
#include "vtkJetFitting.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesBatches.h"
#include "vtkRidgesCompatibility.h"
#include "vtkRidgesFieldData.h"
#include "vtkRidgesFieldSmoothing.h"
#include "vtkRidgesFolds.h"
#include "vtkRidgesMongeInput.h"
#include "vtkRidgesRequest.h"
#include "vtkRidgesSalientLines.h"
#include "vtkRidgesSearch.h"
#include "vtkRidgesUmbilicMarks.h"
#include "vtkUmbilicDetection.h"

#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace names = vtkRidgesArrayNames;
using ridges::Id;

vtkStandardNewMacro(vtkSalientRidges);

namespace
{

/// How far walks across ridges go at most, in units of the scale. Farther than eight there is
/// hardly a feature of that scale left, and slow bends of the whole body would count as folds.
constexpr double Reach = 8.0;

/// How far ends of lines may be from the corner where they meet, in units of the scale reached, and
/// the degrees by which they fold. So creases of parts are led to their corners, even if one fades
/// before; lines of scans that fold less do not meet.
constexpr double CornerReach = 6.0;
constexpr double CornerAngle = 60.0;

/// What curvature at a ridge exceeds that at the foot by, as a part of itself.
constexpr double LeastRise = 0.15;

/// Where edges are longer than this part of the scale, fits to two rings are wider than it: there
/// one ring has to do. So a coarse mesh has nearly the same lines as a fine one.
constexpr double LongestEdgeForTwoRings = 0.64;
constexpr int PointsOfTwoRings = 18;
constexpr int PointsOfOneRing = 7;

/// What noise asks for in addition, in units of the angle by which it folds the surface. The larger
/// folds that noise adds to true ones count less; and a line must exceed what noise alone makes on
/// spheres, planes, cylinders, cones and tori.
constexpr double NoiseInAngle = 0.6;
constexpr double LeastAngleOverNoise = 7.0;
constexpr double LeastWeakAngleOverNoise = 4.2;

} // namespace

/// The stages, and what runs them.
class vtkSalientRidges::vtkInternals
{
public:
  explicit vtkInternals(vtkSalientRidges* filter)
    : Filter(filter)
  {
    for (vtkJetFitting* fit : this->GetFits())
    {
      fit->SetDegree(2);
      fit->SetMongeOrder(2);
      fit->SetNeighborhoodToPointCount();
    }
    for (vtkPolyDataAlgorithm* stage :
      std::array<vtkPolyDataAlgorithm*, 3>{ this->jets, this->noisyJets, this->umbilics })
    {
      stage->AddObserver(vtkCommand::ProgressEvent, this, &vtkInternals::ForwardProgress);
      stage->AddObserver(vtkCommand::WarningEvent, this, &vtkInternals::ForwardMessage);
      stage->AddObserver(vtkCommand::ErrorEvent, this, &vtkInternals::ForwardMessage);
      stage->GetExecutive()->AddObserver(
        vtkCommand::ErrorEvent, this, &vtkInternals::ForwardMessage);
    }
  }

  /// The output of a stage for this input, its own, which has the adjacency of the mesh with it;
  /// null after an error or where the user aborted.
  vtkPolyData* Run(vtkPolyDataAlgorithm* stage, vtkPolyData* input, double from, double to);

  /// Makes `smoothed` the mesh with the smooth field. False after an error or where the user
  /// aborted.
  bool Smooth(vtkPolyData* input, vtkPolyData* smoothed);

  /// Chooses the neighbourhoods of fits by how coarse the mesh is against the scale.
  void ChooseNeighborhoods(vtkPolyData* input);

  /// The deviation of curvatures that is due to noise; false where the user aborted.
  bool FindNoiseFloor(vtkPolyData* smoothed, double& floor);

  /// Stores the lines; false where the user aborted.
  bool FindLines(vtkPolyData* marked, double floor, vtkPolyData* output);

  std::string errorText;
  vtkNew<vtkJetFitting> jets;
  vtkNew<vtkJetFitting> noisyJets; ///< Of points with noise added.
  vtkNew<vtkUmbilicDetection> umbilics;

private:
  void ForwardProgress(vtkObject* stage, unsigned long, void*);
  void ForwardMessage(vtkObject*, unsigned long event, void* text);
  bool FindColor(ridges::Color color, const vtkRidgesSearch& search,
    const vtkRidgesMongeInput& monge, const ridges::FoldRule& rule, double from,
    std::vector<ridges::RidgeTrace>& found, std::vector<ridges::RidgeFolds>& folds);
  std::array<vtkJetFitting*, 2> GetFits() { return { this->jets, this->noisyJets }; }
  vtkSmartPointer<vtkPolyData> AddNoise(vtkPolyData* smoothed, const ridges::MongeField& field);
  ridges::SalientRule MakeRule(double sigma, double floor, double diameter) const;

  vtkSalientRidges* Filter;
  vtkRidgesFieldSmoothing Smoothing;
  double From = 0.0; ///< Progress of the stage that runs.
  double To = 1.0;
  bool Silent = false; ///< While stages repeat with noise what they have done.
};

void vtkSalientRidges::vtkInternals::ForwardProgress(vtkObject* stage, unsigned long, void*)
{
  auto* algorithm = static_cast<vtkAlgorithm*>(stage);
  this->Filter->UpdateProgress(this->From + (this->To - this->From) * algorithm->GetProgress());
  if (vtkRidgesCompatibility::IsAborted(this->Filter))
  {
    algorithm->SetAbortExecute(1);
  }
}

void vtkSalientRidges::vtkInternals::ForwardMessage(vtkObject*, unsigned long event, void* text)
{
  const std::string bare = vtkRidgesBareText(static_cast<const char*>(text));
  if (event == vtkCommand::WarningEvent)
  {
    if (!this->Silent)
    {
      vtkWarningWithObjectMacro(this->Filter, << bare);
    }
  }
  else if (this->errorText.empty()) // then the executive only adds that its stage has failed
  {
    this->errorText = bare;
  }
}

vtkPolyData* vtkSalientRidges::vtkInternals::Run(
  vtkPolyDataAlgorithm* stage, vtkPolyData* input, double from, double to)
{
  this->From = from;
  this->To = to;
  stage->SetInputData(input);
  stage->Update();
  if (vtkRidgesCompatibility::IsAborted(this->Filter))
  {
    // Taken back, as VTK after 9.1 does not do so itself; and what it has left is not its output.
    stage->SetAbortExecute(0);
    stage->Modified();
    return nullptr;
  }
  return this->errorText.empty() ? stage->GetOutput() : nullptr;
}

void vtkSalientRidges::vtkInternals::ChooseNeighborhoods(vtkPolyData* input)
{
  vtkRidgesMesh mesh;
  if (!mesh.Build(input).empty())
  {
    return; // the fit reports it
  }
  const ridges::TriangleMesh& triangles = mesh.GetTriangles();
  const double scale =
    this->Filter->RelativeScale * 2.0 * ridges::SmallestEnclosingSphere(triangles).radius;
  const bool isCoarse = triangles.MeanEdgeLength() > LongestEdgeForTwoRings * scale;
  for (vtkJetFitting* fit : this->GetFits())
  {
    fit->SetMinimumNumberOfPoints(isCoarse ? PointsOfOneRing : PointsOfTwoRings);
  }
  if (mesh.GetPolyData() == input)
  {
    mesh.HandOnWith(input);
  }
}

bool vtkSalientRidges::vtkInternals::Smooth(vtkPolyData* input, vtkPolyData* smoothed)
{
  vtkPolyData* fitted = this->Run(this->jets, input, 0.0, 0.2);
  vtkRidgesFieldSmoothing::Rule rule;
  rule.relativeSigma = this->Filter->RelativeScale;
  return fitted && this->Smoothing.Run(this->Filter, fitted, rule, smoothed, 0.2, 0.4) &&
    !vtkRidgesCompatibility::IsAborted(this->Filter);
}

/// The mesh with as much noise added as it has; null where the user aborted.
vtkSmartPointer<vtkPolyData> vtkSalientRidges::vtkInternals::AddNoise(
  vtkPolyData* smoothed, const ridges::MongeField& field)
{
  const ridges::TriangleMesh& mesh = this->Smoothing.GetMesh();
  const std::vector<Id> sample = ridges::PositionSample(mesh, 2000.0);
  std::vector<double> heights;
  ridges::NoiseMeter(mesh, this->Smoothing.GetRings())
    .Measure({ sample.data(), sample.data() + sample.size() }, heights);
  const double deviation = ridges::NoiseMeter::Deviation(heights);

  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh.NumberOfPoints());
  const auto displace = [&mesh, &field, &points, deviation](vtkIdType begin, vtkIdType end)
  {
    for (auto p = static_cast<Id>(begin); p < end; ++p)
    {
      const Eigen::Vector3d x = mesh.Point(p);
      const Eigen::Vector3d n = field.D1(p).cross(field.D2(p));
      const Eigen::Vector3d moved = x + deviation * ridges::NormalNoise(x) * n;
      points->SetPoint(p, moved.data());
    }
  };
  if (!vtkRidgesForBatches(this->Filter, mesh.NumberOfPoints(), 0.42, 0.44, displace))
  {
    return nullptr;
  }
  auto noisy = vtkSmartPointer<vtkPolyData>::New();
  noisy->SetPoints(points);
  noisy->SetPolys(smoothed->GetPolys());
  return noisy;
}

bool vtkSalientRidges::vtkInternals::FindNoiseFloor(vtkPolyData* smoothed, double& floor)
{
  vtkRidgesMongeArrays clean;
  if (!clean.FetchSecondOrder(this->Filter, smoothed).empty())
  {
    return false;
  }
  const vtkSmartPointer<vtkPolyData> noisy = this->AddNoise(smoothed, clean.GetField());
  this->Silent = true;
  vtkPolyData* fitted = noisy ? this->Run(this->noisyJets, noisy, 0.44, 0.54) : nullptr;
  this->Silent = false;
  vtkRidgesMongeArrays arrays;
  if (!fitted || !arrays.FetchSecondOrder(this->Filter, fitted).empty())
  {
    return false;
  }
  const ridges::TriangleMesh& mesh = this->Smoothing.GetMesh();
  const ridges::MongeField& field = clean.GetField();
  std::vector<double> differences(mesh.NumberOfPoints());
  const auto compare = [&field, &differences](Id p, const ridges::MongeForm& form)
  { differences[p] = ridges::SquaredDifference(field, p, form); };
  if (!this->Smoothing.SmoothAgain(this->Filter, arrays, compare, 0.54, 0.6))
  {
    return false;
  }
  floor = ridges::CurvatureDeviation(mesh, differences);
  return true;
}

bool vtkSalientRidges::vtkInternals::FindColor(ridges::Color color, const vtkRidgesSearch& search,
  const vtkRidgesMongeInput& monge, const ridges::FoldRule& rule, double from,
  std::vector<ridges::RidgeTrace>& found, std::vector<ridges::RidgeFolds>& folds)
{
  if (!search.Find(this->Filter, color, from, from + 0.05, found) ||
    !vtkRidgesMeasureFolds(this->Filter, from + 0.05, from + 0.15, monge.mesh.GetTriangles(),
      monge.arrays.GetField(), rule, this->Filter->CrestOnly, found, folds))
  {
    return false;
  }
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    ridges::EvenFolds(found[i], rule.slack, LeastRise, folds[i]); // over the scale
  }
  return true;
}

/// At the median point of the mesh.
ridges::SalientRule vtkSalientRidges::vtkInternals::MakeRule(
  double sigma, double floor, double diameter) const
{
  const vtkSalientRidges& filter = *this->Filter;
  const double angle = vtkMath::RadiansFromDegrees(filter.FoldAngle);
  const double noise = filter.NoiseFactor * floor * sigma;
  ridges::SalientRule rule;
  rule.angle = std::max(angle + NoiseInAngle * noise, LeastAngleOverNoise * noise);
  rule.weakAngle =
    std::max(filter.Hysteresis * angle + NoiseInAngle * noise, LeastWeakAngleOverNoise * noise);
  rule.longestGap = filter.LongestGap * filter.RelativeScale * diameter;
  rule.leastMass = filter.LeastMass * diameter * angle;
  rule.floor = filter.NoiseFactor * floor;
  rule.crestOnly = filter.CrestOnly;
  return rule;
}

bool vtkSalientRidges::vtkInternals::FindLines(
  vtkPolyData* marked, double floor, vtkPolyData* output)
{
  vtkRidgesMongeInput monge;
  if (!monge.Fetch(this->Filter, marked, true))
  {
    return false;
  }
  const ridges::TriangleMesh& mesh = monge.mesh.GetTriangles();
  if (ridges::IsInsideOut(mesh))
  {
    vtkWarningWithObjectMacro(this->Filter,
      "The surface is inside out: crests and valleys change places (vtkPolyDataNormals with "
      "AutoOrientNormals turns it).");
  }
  const vtkRidgesUmbilicMarks marks(monge.mesh);
  const vtkRidgesSearch search(monge, marks);
  const double diameter = 2.0 * ridges::SmallestEnclosingSphere(mesh).radius;
  const double scale = this->Filter->RelativeScale * diameter;
  ridges::FoldRule folding;
  folding.reach = Reach * scale;
  folding.slack = scale;
  const double sigma =
    ridges::SmoothingPlan::MedianSigma(monge.arrays.GetErrors().fitScale, mesh.NumberOfPoints());
  const ridges::SalientRule rule = this->MakeRule(sigma, floor, diameter);

  std::array<std::vector<ridges::RidgeTrace>, 2> found;
  std::array<std::vector<ridges::RidgeFolds>, 2> folds;
  vtkRidgesSalientLines lines(mesh, diameter);
  for (int i = 0; i < 2; ++i)
  {
    const ridges::Color color = i == 0 ? ridges::Color::Blue : ridges::Color::Red;
    if (!this->FindColor(color, search, monge, folding, 0.7 + 0.15 * i, found[i], folds[i]))
    {
      return false;
    }
    lines.Add(found[i], folds[i], ridges::SelectSalient(found[i], folds[i], rule));
  }
  const double reach = CornerReach * sigma;
  const double angle = std::max(rule.angle, vtkMath::RadiansFromDegrees(CornerAngle));
  lines.MeetAtCorners(monge.arrays.GetField(), { reach, angle });
  lines.Store(monge.arrays.GetField(), this->Filter->LineSmoothing * scale, output);
  return true;
}

vtkSalientRidges::vtkSalientRidges()
  : Internals(new vtkInternals(this))
{
  this->SetNumberOfOutputPorts(3);
}

vtkSalientRidges::~vtkSalientRidges() = default;

int vtkSalientRidges::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkRidgesGetPolyData(this, inputVector[0]);
  if (!input)
  {
    return 0;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector, RIDGES);
  vtkPolyData* mesh = vtkPolyData::GetData(outputVector, MESH);
  if (input->GetNumberOfPoints() > 0 && input->GetNumberOfPolys() + input->GetNumberOfStrips() == 0)
  {
    vtkErrorMacro("The input has points, but no triangles: give the mesh of a surface.");
    return 0;
  }
  if (!vtkRidgesAreNumbers(this,
        { { "FoldAngle", this->FoldAngle }, { "RelativeScale", this->RelativeScale },
          { "Hysteresis", this->Hysteresis }, { "LongestGap", this->LongestGap },
          { "LeastMass", this->LeastMass }, { "NoiseFactor", this->NoiseFactor },
          { "LineSmoothing", this->LineSmoothing } }))
  {
    return 0;
  }
  vtkInternals& stages = *this->Internals;
  stages.errorText.clear();

  vtkNew<vtkPolyData> copy; // a pipeline of its own must not leave its marks on the input
  copy->ShallowCopy(input);
  stages.ChooseNeighborhoods(copy);
  vtkNew<vtkPolyData> smoothed;
  double floor = 0.0;
  const bool isSmooth = stages.Smooth(copy, smoothed) &&
    (this->NoiseFactor == 0.0 || smoothed->GetNumberOfPoints() == 0 ||
      stages.FindNoiseFloor(smoothed, floor));
  vtkPolyData* marked = isSmooth ? stages.Run(stages.umbilics, smoothed, 0.6, 0.7) : nullptr;
  if (!stages.errorText.empty())
  {
    vtkErrorMacro(<< stages.errorText);
    return 0;
  }
  if (!marked || !stages.FindLines(marked, floor, output))
  {
    return 1; // aborted
  }
  mesh->ShallowCopy(marked);
  vtkPolyData::GetData(outputVector, UMBILICS)
    ->ShallowCopy(stages.umbilics->GetOutputDataObject(1));
  for (vtkPolyData* data : { mesh, output })
  {
    vtkRidgesAddFieldValue<vtkDoubleArray>(vtkRidgesOwnFieldData(data), names::NoiseFloor, floor);
  }
  return 1;
}

void vtkSalientRidges::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FoldAngle: " << this->FoldAngle << "\n";
  os << indent << "RelativeScale: " << this->RelativeScale << "\n";
  os << indent << "Hysteresis: " << this->Hysteresis << "\n";
  os << indent << "LongestGap: " << this->LongestGap << "\n";
  os << indent << "LeastMass: " << this->LeastMass << "\n";
  os << indent << "CrestOnly: " << (this->CrestOnly ? "On\n" : "Off\n");
  os << indent << "NoiseFactor: " << this->NoiseFactor << "\n";
  os << indent << "LineSmoothing: " << this->LineSmoothing << "\n";
}
