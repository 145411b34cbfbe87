// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPrincipalFoliation.h"

#include "Core/Foliation/PrincipalFoliation.h"
#include "Core/Mesh/EnclosingSphere.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesCompatibility.h"
#include "vtkRidgesMongeInput.h"
#include "vtkRidgesRequest.h"
#include "vtkRidgesUmbilicInput.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace names = vtkRidgesArrayNames;

vtkStandardNewMacro(vtkPrincipalFoliation);

namespace
{

/// A line is closed where it misses its seed by no more than this fraction of the mean edge, and of
/// the least distance between lines.
constexpr double ClosingFraction = 0.25;

/// Lines that are nearer to each other than this part of the mean edge are worth a warning: the
/// mesh is too coarse to say what lies between them, and they are very many.
constexpr double LeastSeparationInEdges = 0.1;

/// To 30 bits: what the numbering of the points changes by round-off is not to move the lines.
double Rounded(double value)
{
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  return std::ldexp(std::round(std::ldexp(fraction, 30)), exponent - 30);
}

/// Per triangle: 1 in umbilic patches; nothing if none are marked.
std::vector<std::uint8_t> TrianglesInPatches(const vtkRidgesMesh& mesh)
{
  const vtkRidgesRegions patches(mesh.GetPolyData(), names::UmbilicPatch);
  if (!patches.AreThere())
  {
    return {};
  }
  std::vector<std::uint8_t> inside(mesh.GetTriangles().NumberOfTriangles(), 0);
  for (ridges::Id t = 0; t < mesh.GetTriangles().NumberOfTriangles(); ++t)
  {
    inside[t] = patches.At(mesh.GetCellId(t)) >= 0 ? 1 : 0;
  }
  return inside;
}

/// Collects the lines of one colour and then the other.
class Collector
{
public:
  Collector()
  {
    this->Points->SetDataTypeToDouble();
    this->Curvature->SetName(names::Curvature);
    this->Direction->SetName(names::PrincipalDirection);
    this->Closed->SetName(names::Closed);
    this->Length->SetName(names::Length);
  }

  void Add(const ridges::CurvatureLine& line, int direction)
  {
    const vtkIdType first = this->Points->GetNumberOfPoints();
    const auto size = static_cast<vtkIdType>(line.points.size());
    this->Lines->InsertNextCell(static_cast<int>(size) + (line.closed ? 1 : 0));
    for (vtkIdType i = 0; i < size; ++i)
    {
      this->Lines->InsertCellPoint(this->Points->InsertNextPoint(line.points[i].data()));
      this->Curvature->InsertNextValue(line.curvatures[i]);
    }
    if (line.closed)
    {
      this->Lines->InsertCellPoint(first);
    }
    this->Direction->InsertNextValue(direction);
    this->Closed->InsertNextValue(line.closed ? 1 : 0);
    this->Length->InsertNextValue(line.length);
  }

  void Store(vtkPolyData* output)
  {
    output->SetPoints(this->Points);
    output->SetLines(this->Lines);
    output->GetPointData()->AddArray(this->Curvature);
    output->GetCellData()->AddArray(this->Direction);
    output->GetCellData()->AddArray(this->Closed);
    output->GetCellData()->AddArray(this->Length);
    output->GetCellData()->SetActiveScalars(names::PrincipalDirection);
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkDoubleArray> Curvature, Length;
  vtkNew<vtkIntArray> Direction, Closed;
};

} // namespace

vtkPrincipalFoliation::vtkPrincipalFoliation()
{
  vtkRidgesChooseMongeArrays(this);
}

int vtkPrincipalFoliation::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkRidgesGetPolyData(this, inputVector[0]);
  if (!input)
  {
    return 0;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector);

  if (!vtkRidgesAreNumbers(this,
        { { "Separation", this->Separation }, { "LeastDistance", this->LeastDistance },
          { "MinimumLength", this->MinimumLength }, { "MaximumLength", this->MaximumLength },
          { "StepSize", this->StepSize }, { "ModelSize", this->ModelSize } }))
  {
    return 0;
  }
  vtkRidgesMongeInput monge;
  if (!monge.FetchSecondOrder(this, input))
  {
    return 0;
  }
  const ridges::TriangleMesh& triangles = monge.mesh.GetTriangles();
  this->UpdateProgress(0.05);

  const double modelSize = this->ModelSize > 0.0
    ? this->ModelSize
    : Rounded(ridges::SmallestEnclosingSphere(triangles).radius);
  ridges::FoliationRule rule;
  rule.separation = this->Separation * modelSize;
  rule.leastDistance = this->LeastDistance * rule.separation;
  rule.minimumLength = this->MinimumLength * rule.separation;
  rule.maximumLength = this->MaximumLength > 0.0 ? this->MaximumLength * modelSize
                                                 : std::numeric_limits<double>::infinity();
  rule.step = this->StepSize * rule.separation;
  rule.closingDistance = ClosingFraction * std::min(triangles.MeanEdgeLength(), rule.leastDistance);
  const double edge = triangles.MeanEdgeLength();
  if (rule.separation < LeastSeparationInEdges * edge)
  {
    vtkWarningMacro(
      "Separation " << this->Separation << " puts " << edge / rule.separation
                    << " lines across an edge of the mesh, which does not resolve them: from "
                    << LeastSeparationInEdges * edge / modelSize << " on there are at most "
                    << 1.0 / LeastSeparationInEdges
                    << ". Refine the mesh, or raise the separation.");
  }
  std::vector<std::uint8_t> closed;
  if (this->StopAtUmbilicPatches)
  {
    closed = TrianglesInPatches(monge.mesh);
  }

  Collector lines;
  for (const int direction : { MAXIMUM, MINIMUM })
  {
    if (this->Direction != BOTH && this->Direction != direction)
    {
      continue;
    }
    rule.color = direction == MAXIMUM ? ridges::Color::Blue : ridges::Color::Red;
    const double share = this->Direction == BOTH ? 0.475 : 0.95;
    const double from = this->Direction == BOTH && direction == MINIMUM ? 0.525 : 0.05;
    ridges::PrincipalFoliation foliation(triangles, monge.arrays.GetField(), rule, closed);
    const auto monitor = [this, from, share](double done)
    {
      this->UpdateProgress(from + share * done);
      return !vtkRidgesCompatibility::IsAborted(this);
    };
    if (!foliation.Trace(monitor))
    {
      return 1;
    }
    for (const ridges::CurvatureLine& line : foliation.Lines())
    {
      lines.Add(line, direction);
    }
  }
  lines.Store(output);
  return 1;
}

void vtkPrincipalFoliation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  constexpr const char* directions[] = { "Maximum", "Minimum", "Both" };
  os << indent << "Direction: " << directions[this->Direction] << "\n";
  os << indent << "Separation: " << this->Separation << "\n";
  os << indent << "LeastDistance: " << this->LeastDistance << "\n";
  os << indent << "MinimumLength: " << this->MinimumLength << "\n";
  os << indent << "MaximumLength: " << this->MaximumLength << "\n";
  os << indent << "StepSize: " << this->StepSize << "\n";
  os << indent << "StopAtUmbilicPatches: " << (this->StopAtUmbilicPatches ? "On\n" : "Off\n");
  os << indent << "ModelSize: " << this->ModelSize << "\n";
}
