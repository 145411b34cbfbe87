// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgeExtraction.h"

#include "Core/Mesh/BorderStrip.h"
#include "Core/Mesh/EnclosingSphere.h"
#include "Core/Monge/AcuteRule.h"
#include "Core/Ridges/PurplePoints.h"
#include "Core/Ridges/RidgeMeasures.h"
#include "Core/Umbilics/UmbilicForm.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesCollect.h"
#include "vtkRidgesFoldOutput.h"
#include "vtkRidgesGhosts.h"
#include "vtkRidgesMongeInput.h"
#include "vtkRidgesMonitor.h"
#include "vtkRidgesPolylines.h"
#include "vtkRidgesRequest.h"
#include "vtkRidgesSearch.h"
#include "vtkRidgesUmbilicMarks.h"
#include "vtkRidgesZoneOutput.h"

#include "vtkCellArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <string>
#include <vector>

namespace names = vtkRidgesArrayNames;

vtkStandardNewMacro(vtkRidgeExtraction);

static_assert(
  vtkRidgeExtraction::MAXIMUM_ELLIPTIC == static_cast<int>(ridges::RidgeType::MaximumElliptic) &&
    vtkRidgeExtraction::MAXIMUM_HYPERBOLIC ==
      static_cast<int>(ridges::RidgeType::MaximumHyperbolic) &&
    vtkRidgeExtraction::MINIMUM_ELLIPTIC == static_cast<int>(ridges::RidgeType::MinimumElliptic) &&
    vtkRidgeExtraction::MINIMUM_HYPERBOLIC ==
      static_cast<int>(ridges::RidgeType::MinimumHyperbolic),
  "RidgeTypes repeats ridges::RidgeType");

namespace
{

/// The umbilics marked on the mesh, or else those of all singular triangles.
std::vector<Eigen::Vector3d> UmbilicPositions(const vtkRidgesUmbilicMarks& umbilics,
  const ridges::TriangleMesh& mesh, const ridges::MongeField& field)
{
  if (umbilics.AreThere())
  {
    return umbilics.GetPositions();
  }
  std::vector<Eigen::Vector3d> positions;
  for (const ridges::Id t : vtkRidgesWhere(mesh.NumberOfTriangles(),
         [&mesh, &field](ridges::Id i) { return !ridges::IsRegular(mesh, field, i); }))
  {
    positions.push_back(ridges::UmbilicInTriangle(mesh, field, t));
  }
  return positions;
}

double EnclosingRadius(const ridges::TriangleMesh& mesh)
{
  return mesh.Part() ? mesh.Part()->enclosingRadius : ridges::SmallestEnclosingSphere(mesh).radius;
}

/// Red ridges are numbered on from the blue ones.
void StorePurplePoints(const vtkRidgesMesh& mesh, const std::vector<ridges::PurplePoint>& found,
  vtkIdType numberOfBlueRidges, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkIdTypeArray> maximumRidge;
  vtkNew<vtkIdTypeArray> minimumRidge;
  vtkNew<vtkIdTypeArray> triangle;
  maximumRidge->SetName(names::MaximumRidgeId);
  minimumRidge->SetName(names::MinimumRidgeId);
  triangle->SetName(names::Triangle);
  for (const ridges::PurplePoint& point : found)
  {
    if (!mesh.IsOwned(point.triangle))
    {
      continue;
    }
    const vtkIdType id = points->InsertNextPoint(point.position.data());
    vertices->InsertNextCell(1, &id);
    maximumRidge->InsertNextValue(point.blueRidge);
    minimumRidge->InsertNextValue(numberOfBlueRidges + point.redRidge);
    triangle->InsertNextValue(mesh.GetCellId(point.triangle));
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  output->GetPointData()->AddArray(maximumRidge);
  output->GetPointData()->AddArray(minimumRidge);
  output->GetPointData()->AddArray(triangle);
}

} // namespace

vtkRidgeExtraction::vtkRidgeExtraction()
{
  this->SetNumberOfOutputPorts(3);
  vtkRidgesChooseMongeArrays(this);
}

int vtkRidgeExtraction::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkRidgesRequestGhostLevels(inputVector[0], vtkRidgesGhostLevelsOf(this));
  return this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
}

int vtkRidgeExtraction::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkRidgesGetPolyData(this, inputVector[0]);
  if (!input)
  {
    return 0;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector);

  if (!vtkRidgesAreNumbers(this,
        { { "LoopSignificance", this->LoopSignificance },
          { "ZoneSignificance", this->ZoneSignificance },
          { "TypeSignificance", this->TypeSignificance },
          { "TypeHysteresis", this->TypeHysteresis }, { "ModelSize", this->ModelSize },
          { "UmbilicCutOff", this->UmbilicCutOff } }))
  {
    return 0;
  }
  vtkRidgesMongeInput monge;
  if (!monge.Fetch(this, input, this->TypeRule == FOURTH_ORDER))
  {
    return 0;
  }
  monge.mesh.SetPart(this->GetPart());
  const vtkRidgesMesh& mesh = monge.mesh;
  const ridges::TriangleMesh& triangles = mesh.GetTriangles();
  const ridges::MongeField& field = monge.arrays.GetField();
  this->UpdateProgress(0.1);

  const double modelSize = this->ModelSize > 0.0 ? this->ModelSize : EnclosingRadius(triangles);
  const vtkRidgesUmbilicMarks umbilics(mesh);
  const ridges::UmbilicCutOff cutOff(
    UmbilicPositions(umbilics, triangles, field), this->UmbilicCutOff * modelSize);
  vtkRidgesSearch search(monge, umbilics);
  search.SetCrossingRule(
    this->CrossingRule == FORM ? ridges::CrossingRule::Form : ridges::CrossingRule::Linear);
  search.SetTypeRule(
    this->TypeRule == FOURTH_ORDER ? ridges::TypeRule::FourthOrder : ridges::TypeRule::ThirdOrder);
  search.SetExtremalityRule(this->ExtremalityRule == GAUSSIAN ? ridges::ExtremalityRule::Gaussian
                                                              : ridges::ExtremalityRule::Principal);
  search.SetUsePatches(this->UmbilicJoining == PATCHES && this->ExtremalityRule == PRINCIPAL);
  search.SetLoopSignificance(this->LoopSignificance);
  search.SetZoneSignificance(this->ExtremalityRule == PRINCIPAL ? this->ZoneSignificance : 0.0);
  search.SetTypeSignificance(this->TypeSignificance);
  search.SetMeasuresTypes(true);
  search.SetShortestRun(
    this->TypeHysteresis > 0.0 ? this->TypeHysteresis * triangles.MeanEdgeLength() : 0.0);
  vtkRidgesPolylines lines(mesh, umbilics, cutOff, modelSize);
  lines.SetCrestOnly(this->CrestOnly);
  lines.SetBorderStrip(ridges::BorderStrip(triangles, monge.arrays.GetErrors().fitScale));

  const bool gaussian = this->ExtremalityRule == GAUSSIAN;
  std::vector<ridges::RidgeTrace> blue;
  std::vector<ridges::RidgeTrace> red;
  vtkRidgesZoneOutput zones;
  const bool findsPurple = this->FindPurplePoints && !gaussian;
  vtkRidgesFoldOutput folds(monge);
  const auto extract = [this, &search, &lines, &folds, findsPurple](ridges::Color color,
                         double from, double to, std::vector<ridges::RidgeTrace>& found,
                         vtkRidgesZones& zone)
  {
    const double middle = from + 0.8 * (to - from);
    const double end = from + 0.9 * (to - from);
    if (!search.Find(this, color, from, middle, found, &zone) ||
      (this->ComputeFoldAngle && !folds.Measure(this, middle, end, found)) ||
      !lines.AddRidges(
        found, this->ComputeFoldAngle ? &folds.Get() : nullptr, vtkRidgesMonitor(this, end, to)))
    {
      return false;
    }
    if (!findsPurple)
    {
      // Not kept while the other color is looked for: on noise that is most of the memory.
      found = std::vector<ridges::RidgeTrace>();
    }
    return true;
  };
  if (((gaussian || this->ExtractMaximum) &&
        !extract(ridges::Color::Blue, 0.1, 0.55, blue, zones.maximum)) ||
    (!gaussian && this->ExtractMinimum &&
      !extract(ridges::Color::Red, 0.55, 1.0, red, zones.minimum)))
  {
    return 1;
  }
  lines.Store(output, field.HasFourthOrder(), this->ComputeFoldAngle);
  if (this->ComputeFoldAngle)
  {
    folds.StoreNoiseFloor(output);
  }
  zones.MarkOnMesh(mesh, vtkPolyData::GetData(outputVector, 2));
  zones.StoreNumber(output);
  const std::string warning = zones.Warning();
  if (!warning.empty())
  {
    vtkWarningMacro(<< warning);
  }
  if (findsPurple)
  {
    const auto purple = ridges::FindPurplePoints(triangles, blue, red);
    StorePurplePoints(
      mesh, purple, static_cast<vtkIdType>(blue.size()), vtkPolyData::GetData(outputVector, 1));
  }
  return 1;
}

void vtkRidgeExtraction::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto onOff = [](bool flag) { return flag ? "On\n" : "Off\n"; };
  os << indent << "ExtractMaximum: " << onOff(this->ExtractMaximum);
  os << indent << "ExtractMinimum: " << onOff(this->ExtractMinimum);
  os << indent << "CrestOnly: " << onOff(this->CrestOnly);
  os << indent << "TypeRule: " << (this->TypeRule == FOURTH_ORDER ? "FourthOrder" : "ThirdOrder")
     << "\n";
  os << indent
     << "ExtremalityRule: " << (this->ExtremalityRule == PRINCIPAL ? "Principal" : "Gaussian")
     << "\n";
  os << indent << "FindPurplePoints: " << onOff(this->FindPurplePoints);
  os << indent << "ComputeFoldAngle: " << onOff(this->ComputeFoldAngle);
  os << indent << "CrossingRule: " << (this->CrossingRule == FORM ? "Form" : "Linear") << "\n";
  os << indent << "UmbilicJoining: " << (this->UmbilicJoining == PATCHES ? "Patches" : "Triangles")
     << "\n";
  os << indent << "LoopSignificance: " << this->LoopSignificance << "\n";
  os << indent << "ZoneSignificance: " << this->ZoneSignificance << "\n";
  os << indent << "TypeSignificance: " << this->TypeSignificance << "\n";
  os << indent << "TypeHysteresis: " << this->TypeHysteresis << "\n";
  os << indent << "ModelSize: " << this->ModelSize << "\n";
  os << indent << "UmbilicCutOff: " << this->UmbilicCutOff << "\n";
}
