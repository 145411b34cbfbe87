// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesMesh.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace
{

/// Calls visit(cell, size, points) for each cell, straight from the array's own storage.
struct ForEachCell
{
  template <typename CellState, typename Visitor>
  void operator()(CellState& state, Visitor& visit)
  {
    const auto* offsets = state.GetOffsets()->GetPointer(0);
    const auto* points = state.GetConnectivity()->GetPointer(0);
    for (vtkIdType cell = 0; cell < state.GetNumberOfCells(); ++cell)
    {
      visit(cell, offsets[cell + 1] - offsets[cell], points + offsets[cell]);
    }
  }
};

} // namespace

void vtkRidgesMesh::CountTriangulatedCells(vtkPolyData* input)
{
  vtkIdType polygons = 0;
  const auto count = [&polygons](vtkIdType, vtkIdType size, const auto*)
  { polygons += size > 3 ? 1 : 0; };
  input->GetPolys()->Visit(ForEachCell{}, count);
  this->NumberOfTriangulatedCells = polygons + input->GetNumberOfStrips();
}

bool vtkRidgesMesh::Build(
  vtkPolyData* input, const std::vector<std::uint8_t>& usable, ridges::TriangleMesh::Edges edges)
{
  // Three corners of every triangle are numbered in 32 bits.
  constexpr vtkIdType largest = std::numeric_limits<ridges::Id>::max() / 3;

  this->PolyData = input;
  this->CountTriangulatedCells(input);
  if (this->NumberOfTriangulatedCells > 0)
  {
    vtkNew<vtkTriangleFilter> triangulate;
    triangulate->SetInputData(input);
    triangulate->Update();
    this->PolyData = triangulate->GetOutput();
  }
  vtkCellArray* polys = this->PolyData->GetPolys();
  const vtkIdType numberOfPoints = this->PolyData->GetNumberOfPoints();
  if (numberOfPoints > largest || polys->GetNumberOfCells() > largest)
  {
    return false;
  }

  this->FetchPoints();
  std::vector<std::uint8_t> isUsable(numberOfPoints, 0);
  for (vtkIdType p = 0; p < numberOfPoints; ++p)
  {
    const double* x = this->Points + 3 * p;
    const bool finite = std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
    isUsable[p] = finite && (usable.empty() || usable[p] != 0) ? 1 : 0;
  }
  this->FirstPoly = this->PolyData->GetNumberOfVerts() + this->PolyData->GetNumberOfLines();
  std::vector<ridges::Triangle> triangles;
  triangles.reserve(polys->GetNumberOfCells());
  this->PolyIds.clear();
  this->PolyIds.reserve(polys->GetNumberOfCells());
  const auto add = [&](vtkIdType cell, vtkIdType size, const auto* points)
  {
    const auto isGood = [&](vtkIdType p) { return p >= 0 && p < numberOfPoints && isUsable[p]; };
    const bool good = size == 3 && points[0] != points[1] && points[1] != points[2] &&
      points[2] != points[0] && std::all_of(points, points + 3, isGood);
    if (good)
    {
      triangles.push_back({ static_cast<ridges::Id>(points[0]), static_cast<ridges::Id>(points[1]),
        static_cast<ridges::Id>(points[2]) });
      this->PolyIds.push_back(static_cast<ridges::Id>(cell));
    }
  };
  polys->Visit(ForEachCell{}, add);
  this->NumberOfUnusableTriangles =
    polys->GetNumberOfCells() - static_cast<vtkIdType>(triangles.size());
  this->Triangles = ridges::TriangleMesh(this->Points, static_cast<ridges::Id>(numberOfPoints),
    std::move(triangles), ridges::TriangleMesh::Edges::NotBuilt);
  if (edges == ridges::TriangleMesh::Edges::Built)
  {
    this->BuildEdges();
  }
  return true;
}

void vtkRidgesMesh::BuildEdges()
{
  this->Triangles.BuildEdges(
    [](ridges::Id count, const std::function<void(ridges::Id, ridges::Id)>& body)
    {
      const auto range = [&body](vtkIdType begin, vtkIdType end)
      { body(static_cast<ridges::Id>(begin), static_cast<ridges::Id>(end)); };
      vtkSMPTools::For(0, count, range);
    });
}

void vtkRidgesMesh::FetchPoints()
{
  vtkPoints* points = this->PolyData->GetPoints();
  if (vtkDoubleArray* exact = points ? vtkDoubleArray::SafeDownCast(points->GetData()) : nullptr)
  {
    this->Points = exact->GetPointer(0);
    return;
  }
  const vtkIdType count = this->PolyData->GetNumberOfPoints();
  this->ConvertedPoints.resize(3 * count);
  for (vtkIdType p = 0; p < count; ++p)
  {
    points->GetPoint(p, this->ConvertedPoints.data() + 3 * p);
  }
  this->Points = this->ConvertedPoints.data();
}

vtkIdType vtkRidgesMesh::CountCoincidentPoints() const
{
  std::vector<vtkIdType> order;
  for (vtkIdType p = 0; p < this->Triangles.NumberOfPoints(); ++p)
  {
    if (this->Triangles.TrianglesAround(static_cast<ridges::Id>(p)).size() > 0)
    {
      order.push_back(p);
    }
  }
  const auto position = [this](vtkIdType p) { return this->Points + 3 * p; };
  std::sort(order.begin(), order.end(),
    [&](vtkIdType p, vtkIdType q)
    {
      return std::lexicographical_compare(
        position(p), position(p) + 3, position(q), position(q) + 3);
    });
  vtkIdType count = 0;
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    count += std::equal(position(order[i]), position(order[i]) + 3, position(order[i - 1])) ? 1 : 0;
  }
  return count;
}
