// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgeExtraction.h"

#include "Core/EnclosingSphere.h"
#include "Core/MarchingTriangles.h"
#include "Core/RidgeAssembly.h"
#include "Core/RidgeCrossings.h"
#include "Core/RidgeMeasures.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesBatches.h"
#include "vtkRidgesMongeInput.h"
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

struct FindCrossings
{
  ridges::RidgeCrossings& crossings;

  void operator()(vtkIdType begin, vtkIdType end)
  {
    this->crossings.Find(static_cast<ridges::Id>(begin), static_cast<ridges::Id>(end));
  }
};

struct PlaceCrossings
{
  ridges::RidgeCrossings& crossings;

  void operator()(vtkIdType begin, vtkIdType end)
  {
    this->crossings.Place(static_cast<ridges::Id>(begin), static_cast<ridges::Id>(end));
  }
};

/// Marches chunks of triangles, each into segments of its own: their order does not depend on the
/// threads.
class MarchTriangles
{
public:
  MarchTriangles(const ridges::RidgeCrossings& crossings, ridges::TypeRule rule)
    : Crossings(crossings)
    , Rule(rule)
    , Segments((crossings.Mesh().NumberOfTriangles() + ChunkSize - 1) / ChunkSize)
  {
  }

  vtkIdType GetNumberOfChunks() const { return static_cast<vtkIdType>(this->Segments.size()); }

  void operator()(vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType chunk = begin; chunk < end; ++chunk)
    {
      const auto first = static_cast<ridges::Id>(chunk * ChunkSize);
      const ridges::Id last =
        std::min<ridges::Id>(first + ChunkSize, this->Crossings.Mesh().NumberOfTriangles());
      for (ridges::Id t = first; t < last; ++t)
      {
        ridges::MarchTriangle(this->Crossings, this->Rule, t, this->Segments[chunk]);
      }
    }
  }

  std::vector<ridges::RidgeSegment> Collect() const
  {
    std::vector<ridges::RidgeSegment> all;
    for (const auto& chunk : this->Segments)
    {
      all.insert(all.end(), chunk.begin(), chunk.end());
    }
    return all;
  }

private:
  static constexpr ridges::Id ChunkSize = 8192;

  const ridges::RidgeCrossings& Crossings;
  ridges::TypeRule Rule;
  std::vector<std::vector<ridges::RidgeSegment>> Segments;
};

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

  vtkRidgesMongeInput monge;
  if (!monge.Fetch(this, input, this->TypeRule == FOURTH_ORDER))
  {
    return 0;
  }
  const vtkRidgesMesh& mesh = monge.mesh;
  const ridges::TriangleMesh& triangles = mesh.GetTriangles();
  const ridges::MongeField& field = monge.arrays.GetField();
  this->UpdateProgress(0.1);

  const double modelSize = this->ModelSize > 0.0 ? this->ModelSize : EnclosingRadius(triangles);
  const ridges::UmbilicCutOff cutOff(
    UmbilicPositions(mesh.GetPolyData(), triangles, field), this->UmbilicCutOff * modelSize);
  const auto crossingRule =
    this->CrossingRule == FORM ? ridges::CrossingRule::Form : ridges::CrossingRule::Linear;
  const auto typeRule =
    this->TypeRule == FOURTH_ORDER ? ridges::TypeRule::FourthOrder : ridges::TypeRule::ThirdOrder;
  vtkRidgesPolylines lines(mesh, field, cutOff, modelSize);
  lines.SetCrestOnly(this->CrestOnly);

  for (const ridges::Color color : { ridges::Color::Blue, ridges::Color::Red })
  {
    const bool blue = color == ridges::Color::Blue;
    if (!(blue ? this->ExtractMaximum : this->ExtractMinimum))
    {
      continue;
    }
    const double from = blue ? 0.1 : 0.55;
    ridges::RidgeCrossings crossings(triangles, field, color, crossingRule);
    FindCrossings find{ crossings };
    if (!vtkRidgesForBatches(this, triangles.NumberOfEdges(), from, from + 0.1, find))
    {
      return 1;
    }
    crossings.Number();
    PlaceCrossings place{ crossings };
    MarchTriangles march(crossings, typeRule);
    if (!vtkRidgesForBatches(this, crossings.Size(), from + 0.1, from + 0.2, place) ||
      !vtkRidgesForBatches(this, march.GetNumberOfChunks(), from + 0.2, from + 0.3, march, 64))
    {
      return 1;
    }
    std::vector<ridges::RidgeSegment> segments = march.Collect();
    for (ridges::Ridge& ridge : ridges::AssembleRidges(triangles, segments))
    {
      lines.AddRidge(ridge, segments, crossings);
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
