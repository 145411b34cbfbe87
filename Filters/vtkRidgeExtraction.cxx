// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgeExtraction.h"

#include "Core/EnclosingSphere.h"
#include "Core/MarchingTriangles.h"
#include "Core/RidgeAssembly.h"
#include "Core/RidgeMeasures.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesMesh.h"
#include "vtkRidgesMongeArrays.h"
#include "vtkRidgesPolylines.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
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

/// Radius of the smallest sphere around all points that a triangle has.
double EnclosingRadius(const ridges::TriangleMesh& mesh)
{
  Eigen::Matrix3Xd points(3, mesh.NumberOfPoints());
  Eigen::Index used = 0;
  for (ridges::Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    if (mesh.TrianglesAround(p).size() > 0)
    {
      points.col(used++) = mesh.Point(p);
    }
  }
  return ridges::SmallestEnclosingSphere(points.leftCols(used)).radius;
}

/// The umbilics marked on the mesh, or else those of all singular triangles.
std::vector<Eigen::Vector3d> UmbilicPositions(
  vtkPolyData* polyData, const ridges::TriangleMesh& mesh, const ridges::MongeField& field)
{
  std::vector<Eigen::Vector3d> positions;
  vtkDataArray* marked = polyData->GetFieldData()->GetArray(names::UmbilicPosition);
  if (marked && marked->GetNumberOfComponents() == 3)
  {
    positions.resize(marked->GetNumberOfTuples());
    for (vtkIdType i = 0; i < marked->GetNumberOfTuples(); ++i)
    {
      marked->GetTuple(i, positions[i].data());
    }
    return positions;
  }
  for (ridges::Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    if (!ridges::IsRegular(mesh, field, t))
    {
      positions.push_back(ridges::UmbilicInTriangle(mesh, field, t));
    }
  }
  return positions;
}

} // namespace

int vtkRidgeExtraction::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);

  vtkRidgesMongeArrays arrays;
  if (input->GetNumberOfPoints() > 0)
  {
    const std::string faults = arrays.Fetch(input, this->TypeRule == FOURTH_ORDER);
    if (!faults.empty())
    {
      vtkErrorMacro("The mesh lacks point arrays that vtkJetFitting makes: " << faults << ".");
      return 0;
    }
  }
  vtkRidgesMesh mesh;
  if (!mesh.Build(input, arrays.GetUsable()))
  {
    vtkErrorMacro("The mesh has more points or triangles than 32-bit numbering allows.");
    return 0;
  }
  if (mesh.GetNumberOfTriangulatedCells() > 0)
  {
    vtkWarningMacro(<< mesh.GetNumberOfTriangulatedCells()
                    << " polygons or strips were triangulated.");
  }
  const ridges::TriangleMesh& triangles = mesh.GetTriangles();
  const ridges::MongeField& field = arrays.GetField();
  this->UpdateProgress(0.1);

  const double modelSize = this->ModelSize > 0.0 ? this->ModelSize : EnclosingRadius(triangles);
  const ridges::UmbilicCutOff cutOff(
    UmbilicPositions(mesh.GetPolyData(), triangles, field), this->UmbilicCutOff * modelSize);
  ridges::MarchingRules rules;
  rules.type =
    this->TypeRule == FOURTH_ORDER ? ridges::TypeRule::FourthOrder : ridges::TypeRule::ThirdOrder;
  rules.crossing =
    this->CrossingRule == FORM ? ridges::CrossingRule::Form : ridges::CrossingRule::Linear;
  vtkRidgesPolylines lines(mesh, field, rules.crossing, cutOff, modelSize);
  lines.SetCrestOnly(this->CrestOnly);

  std::vector<ridges::RidgeSegment> segments;
  for (const ridges::Color color : { ridges::Color::Blue, ridges::Color::Red })
  {
    if (!(color == ridges::Color::Blue ? this->ExtractMaximum : this->ExtractMinimum))
    {
      continue;
    }
    constexpr ridges::Id batch = 1 << 16;
    segments.clear();
    for (ridges::Id t = 0; t < triangles.NumberOfTriangles(); ++t)
    {
      ridges::MarchTriangle(triangles, field, color, rules, t, segments);
      if (t % batch == 0)
      {
        this->UpdateProgress((color == ridges::Color::Blue ? 0.1 : 0.55) +
          0.3 * static_cast<double>(t) / triangles.NumberOfTriangles());
        if (this->GetAbortExecute())
        {
          return 1;
        }
      }
    }
    for (ridges::Ridge& ridge : ridges::AssembleRidges(triangles, segments))
    {
      lines.AddRidge(ridge, segments, color);
    }
  }
  lines.Store(output);
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
  os << indent << "CrossingRule: " << (this->CrossingRule == FORM ? "Form" : "Linear") << "\n";
  os << indent << "ModelSize: " << this->ModelSize << "\n";
  os << indent << "UmbilicCutOff: " << this->UmbilicCutOff << "\n";
}
