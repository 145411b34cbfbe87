// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesStreamedGathering.h"

#include "Core/Fit/JetFit.h"
#include "Core/Mesh/CoordinateRounding.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesGatheredRows.h"
#include "vtkRidgesJetSelection.h"
#include "vtkRidgesMakeArray.h"
#include "vtkRidgesStreamedFit.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <numeric>

namespace names = vtkRidgesArrayNames;
using ridges::Id;

namespace
{

/// Points of a mesh with arrays.
vtkSmartPointer<vtkPolyData> DataOf(
  const ridges::TriangleMesh& mesh, const std::vector<Id>& points, int type, vtkPointData* values)
{
  vtkNew<vtkPoints> positions;
  positions->SetDataType(type);
  positions->SetNumberOfPoints(static_cast<vtkIdType>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    positions->SetPoint(static_cast<vtkIdType>(i), mesh.Point(points[i]).data());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(positions);
  data->GetPointData()->ShallowCopy(values);
  return data;
}

vtkSmartPointer<vtkIdTypeArray> ArrayOf(const char* name, const std::vector<std::int64_t>& ids)
{
  auto array = vtkRidgesMakeArray<vtkIdTypeArray>(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(ids.size()));
  std::copy(ids.begin(), ids.end(), array->GetPointer(0));
  return array;
}

} // namespace

bool vtkRidgesStreamedGathering::Take(
  vtkRidgesStreamedFit& fit, vtkJetFitting* jets, vtkAlgorithm* filter, const Extent& extent)
{
  this->Fit = &fit;
  this->Mesh = &fit.GetMesh().Around();
  this->First = { 0, this->Mesh->NumberOfTriangles() };
  const auto count = static_cast<std::size_t>(this->Mesh->NumberOfPoints());
  this->Known.assign(count, ridges::TriangleContent::Nothing);
  this->Radii.assign(count, 0.0);
  this->IdInPiece.assign(count, -1);
  this->WithContent = 0;
  this->Rounding = ridges::FindCoordinateRounding(*this->Mesh).Height();
  this->PartMayDo = !extent.isAll && fit.GetMesh().Points().Coincident().empty();
  if (!fit.Choose(jets))
  {
    return false;
  }
  const int pieces = fit.GetNumberOfPieces();
  for (int piece = 0; piece < pieces && this->PartMayDo; ++piece)
  {
    constexpr double begin = 0.3;
    constexpr double share = 0.6;
    fit.GetFits().SetProgress(begin + share * piece / pieces, begin + share * (piece + 1) / pieces);
    if (!this->TakePiece(piece, filter, extent))
    {
      return false;
    }
  }
  this->IdInPiece = {};
  // Else the fits of all points, which are made as they are packed, are what there is to warn of.
  this->WarnsLater = this->PartMayDo ? nullptr : jets;
  if (this->PartMayDo)
  {
    fit.Warn(jets);
    ridges::SharedSurface surface;
    fit.GetFits().KeepSurface(surface);
    ridges::OneRank alone;
    this->Know(alone, surface, surface.onBorder, this->Radii.data());
  }
  this->Radii = {};
  return true;
}

/// Whether the pieces so far leave no doubt that all triangles will be needed, as with noise: then
/// the other pieces are not fitted twice.
bool vtkRidgesStreamedGathering::NeedsAll(
  ridges::Span<ridges::Triangle> triangles, const Contents& contents, Id taken)
{
  constexpr double fewest = 0.1; // of the mesh
  constexpr double most = 0.9;   // of what was looked at
  this->WithContent += std::count_if(triangles.begin(), triangles.end(),
    [&contents](const ridges::Triangle& corners)
    {
      return std::any_of(corners.begin(), corners.end(),
        [&contents](Id p) { return contents[p] != ridges::TriangleContent::Nothing; });
    });
  return taken > fewest * this->Mesh->NumberOfTriangles() &&
    static_cast<double>(this->WithContent) > most * taken;
}

/// Fits the points of a piece.
bool vtkRidgesStreamedGathering::TakePiece(int piece, vtkAlgorithm* filter, const Extent& extent)
{
  std::vector<Id> points = this->Fit->GetPieces().PointsOf(piece);
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  vtkNew<vtkPointData> values;
  if (!this->Fit->GetFits().FitAndAverage(points, values))
  {
    return false;
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    this->IdInPiece[points[i]] = static_cast<Id>(i);
  }
  const Id first = this->Fit->GetPieces().FirstTriangle(piece);
  std::vector<ridges::Triangle> triangles(this->Fit->GetPieces().FirstTriangle(piece + 1) - first);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const ridges::Triangle& corners = this->Mesh->Corners(first + static_cast<Id>(t));
    std::transform(corners.begin(), corners.end(), triangles[t].begin(),
      [this](Id p) { return this->IdInPiece[p]; });
  }
  const auto data = DataOf(*this->Mesh, points, this->Fit->GetCoordinateType(), values);
  const ridges::Span<ridges::Triangle> ofPiece = { triangles.data(),
    triangles.data() + triangles.size() };
  const Contents contents =
    vtkRidgesGathering::ContentsOf(filter, data, ofPiece, extent, this->Rounding);
  const Id taken = this->Fit->GetPieces().FirstTriangle(piece + 1);
  this->PartMayDo = !this->NeedsAll(ofPiece, contents, taken);
  auto* status = vtkIntArray::SafeDownCast(data->GetPointData()->GetArray(names::FitStatus));
  auto* scale = vtkDoubleArray::SafeDownCast(data->GetPointData()->GetArray(names::FitScale));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Id p = points[i];
    const auto row = static_cast<vtkIdType>(i);
    this->Known[p] = std::max(this->Known[p], contents[i]);
    this->Radii[p] = scale ? scale->GetValue(row) : 0.0;
    this->IdInPiece[p] = -1;
    const bool lacksFit = (status->GetValue(row) & ridges::FitInvalid) != 0 &&
      this->Mesh->TrianglesAround(p).size() > 0;
    this->PartMayDo = this->PartMayDo && !lacksFit;
  }
  return true;
}

vtkRidgesGathering::Contents vtkRidgesStreamedGathering::ContentsOf(vtkAlgorithm*, const Extent&)
{
  return this->Known;
}

void vtkRidgesStreamedGathering::PackPoints(ridges::Bytes& message, const std::vector<Id>& points)
{
  vtkNew<vtkPointData> values;
  if (!this->Fit->GetFits().FitAndAverage(points, values))
  {
    return; // aborted
  }
  if (this->WarnsLater)
  {
    this->Fit->Warn(this->WarnsLater);
    this->WarnsLater = nullptr;
  }
  const auto data = DataOf(*this->Mesh, points, this->Fit->GetCoordinateType(), values);
  std::vector<Id> all(points.size());
  std::iota(all.begin(), all.end(), 0);
  vtkRidgesPackPoints(message, data, all);
}

void vtkRidgesStreamedGathering::AddFieldData(vtkPolyData* part)
{
  vtkRidgesStoreJetChoice(part, this->Fit->GetFits().GetChoice());
}

void vtkRidgesStreamedGathering::Release()
{
  this->Fit = nullptr;
  this->Mesh = nullptr;
  this->Known = {};
  this->PartMayDo = true;
}

void vtkRidgesStreamedGathering::Store(vtkPolyData* part, vtkPolyData* output) const
{
  output->ShallowCopy(part);
  output->GetPointData()->AddArray(ArrayOf(names::GatheredPointId, this->GetPointsOfPart()));
  output->GetCellData()->AddArray(ArrayOf(names::GatheredCellId, this->GetTrianglesOfPart()));
  vtkNew<vtkFieldData> field;
  field->ShallowCopy(part->GetFieldData());
  this->NumberTriangles(field, names::UmbilicTriangle);
  output->SetFieldData(field);
}
