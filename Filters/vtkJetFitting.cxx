// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkJetFitting.h"

#include "Core/Fit/JetFit.h"
#include "Core/Mesh/OrderedRings.h"
#include "Core/Mesh/RingNeighborhood.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesBatches.h"
#include "vtkRidgesFitPoints.h"
#include "vtkRidgesGhosts.h"
#include "vtkRidgesJetSelection.h"
#include "vtkRidgesMesh.h"
#include "vtkRidgesMongeOutput.h"
#include "vtkRidgesRequest.h"
#include "vtkRidgesUmbilicMarks.h"

#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>
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

/// Where none is set, and none is chosen.
constexpr int DefaultDegree = 4;

/// The properties, as far as they are about a single fit.
vtkRidgesFitPoints::Settings SettingsOf(vtkJetFitting* filter)
{
  using Kind = ridges::NeighborhoodRule::Kind;
  constexpr Kind kinds[] = { Kind::PointCount, Kind::Rings, Kind::Radius,
    Kind::RingsAndPointCount };
  vtkRidgesFitPoints::Settings settings;
  settings.degree = filter->GetDegree() > 0 ? filter->GetDegree() : DefaultDegree;
  settings.weighting = filter->GetWeighting() == vtkJetFitting::GAUSSIAN
    ? ridges::Weighting::Gaussian
    : ridges::Weighting::Uniform;
  settings.standardErrors = filter->GetStandardErrors();
  settings.rule.kind = kinds[filter->GetNeighborhood()];
  settings.rule.minimumNumberOfPoints =
    std::max(filter->GetMinimumNumberOfPoints(), ridges::JetFitter::FewestPoints(settings.degree));
  settings.rule.numberOfRings = filter->GetNumberOfRings();
  settings.rule.radius = filter->GetRadius();
  return settings;
}

struct BuildRings
{
  ridges::OrderedRings& rings;

  void operator()(vtkIdType begin, vtkIdType end)
  {
    this->rings.Build(static_cast<ridges::Id>(begin), static_cast<ridges::Id>(end));
  }
};

/// One text for all that is wrong with the mesh or the fits; empty if all is well.
std::string Complaint(vtkRidgesMesh& mesh, const ridges::OrderedRings& rings, vtkIntArray* status)
{
  const int* statuses = status->GetPointer(0);
  const vtkIdType points = status->GetNumberOfTuples();
  int anyBits = 0;
  for (vtkIdType p = 0; p < points; ++p)
  {
    anyBits |= statuses[p];
  }
  const auto count = [statuses, points, anyBits, &mesh](int bit)
  {
    vtkIdType sum = 0;
    for (vtkIdType p = 0; (anyBits & bit) && p < points; ++p)
    {
      sum += (statuses[p] & bit) && !mesh.IsHidden(static_cast<ridges::Id>(p)) ? 1 : 0;
    }
    return sum;
  };
  std::ostringstream text;
  const auto say = [&text](vtkIdType number, const char* what)
  {
    if (number > 0)
    {
      text << (text.tellp() > 0 ? "; " : "") << number << " " << what;
    }
  };
  const vtkIdType invalid = count(vtkJetFitting::FIT_INVALID);
  const vtkIdType tooFew = count(vtkJetFitting::FIT_TOO_FEW_POINTS);
  const vtkIdType folded = count(vtkJetFitting::FIT_FOLDED);
  say(mesh.GetNumberOfTriangulatedCells(), "polygons or strips were triangulated");
  say(mesh.GetNumberOfUnusableTriangles(),
    "triangles were left out (a repeated corner, or a point that is missing or not finite)");
  // Edges are at fault only where fans are.
  if (rings.HasIrregular())
  {
    mesh.BuildEdges();
    const ridges::TriangleMesh& triangles = mesh.GetTriangles();
    say(triangles.NumberOfNonManifoldEdges(),
      "edges with more than two triangles were taken as borders");
    say(triangles.NumberOfInconsistentEdges(),
      "edges lie between triangles of opposite orientation (vtkPolyDataNormals can fix that)");
  }
  say(invalid,
    "points have no fit (isolated, or too few or collinear neighbours): their values are 0");
  say(tooFew, "points have fewer neighbours than coefficients");
  say(folded, "points lie where the surface folds over within their neighbourhood");
  say(count(vtkJetFitting::FIT_ILL_CONDITIONED), "points are ill conditioned");
  if (invalid > 0 || tooFew > 0 || folded > 0)
  {
    const vtkIdType coincident = mesh.CountCoincidentPoints();
    say(coincident, "points coincide with another (vtkStaticCleanPolyData merges them)");
    if (coincident == 0 && folded > 0)
    {
      text << " (a finer mesh there helps)";
    }
    else if (coincident == 0 && 2 * std::max(invalid, tooFew) > points)
    {
      text << "; " << mesh.GetTriangles().NumberOfTriangles()
           << " triangles are too few: refine the mesh";
    }
  }
  return text.str();
}

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

int vtkJetFitting::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkRidgesRequestGhostLevels(inputVector[0], vtkRidgesGhostLevelsOf(this));
  return this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
}

int vtkJetFitting::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkRidgesGetPolyData(this, inputVector[0]);
  if (!input)
  {
    return 0;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector);

  if (this->Neighborhood == BY_RADIUS && !(this->Radius > 0.0 && std::isfinite(this->Radius)))
  {
    vtkErrorMacro(
      "Neighborhood is by radius, but Radius is " << this->Radius << ": set a positive one.");
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
  vtkRidgesFitPoints::Settings settings = SettingsOf(this);
  const int order = isAutomatic && this->Degree == 0 ? this->MongeOrder
                                                     : std::min(this->MongeOrder, settings.degree);
  vtkRidgesMongeOutput arrays(count, order, this->StandardErrors);
  ridges::OrderedRings rings(triangles);
  BuildRings buildRings{ rings };
  if (!vtkRidgesForBatches(this, count, 0.1, 0.2, buildRings))
  {
    return 1;
  }
  ridges::JetChoice choice;
  if (isAutomatic)
  {
    const ridges::JetSelection selection(std::clamp(order, 2, 3), this->Degree);
    if (!vtkRidgesSelectJets(this, triangles, rings, selection, 0.2, 0.3, choice))
    {
      return 1;
    }
    settings.degree = choice.degree;
    settings.rule.numberOfRings = choice.numberOfRings;
    settings.rule.minimumNumberOfPoints =
      std::max(this->MinimumNumberOfPoints, ridges::JetFitter::FewestPoints(choice.degree));
  }
  vtkRidgesFitPoints fitPoints(triangles, rings, settings, arrays);
  const double begin = isAutomatic ? 0.3 : 0.2;
  const vtkIdType batch = settings.degree > 4 ? 1 << 15 : 1 << 17;
  if (!vtkRidgesForBatches(this, count, begin, 1.0, fitPoints, batch))
  {
    return 1;
  }
  vtkRidgesWarnOfMissingGhosts(this, inputVector[0]);
  const std::string complaint = Complaint(mesh, rings, arrays.GetStatus());
  if (!complaint.empty())
  {
    vtkWarningMacro(<< complaint << ".");
  }

  output->ShallowCopy(mesh.GetPolyData());
  arrays.AddTo(output->GetPointData());
  vtkRidgesUmbilicMarks::RemoveFrom(output);
  // Without P1 and P2 there are no types to flicker.
  if (isAutomatic && choice.numberOfAverages > 0 && order == 4)
  {
    vtkRidgesAverageJets(mesh, output, choice);
  }
  else
  {
    choice.numberOfAverages = 0;
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
  os << indent << "StandardErrors: " << (this->StandardErrors ? "On" : "Off") << "\n";
}
