// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesMesh.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

bool vtkRidgesMesh::Build(vtkPolyData* input, const std::vector<std::uint8_t>& usable)
{
  // Three corners of every triangle are numbered in 32 bits.
  constexpr vtkIdType largest = std::numeric_limits<ridges::Id>::max() / 3;

  vtkCellArray* polys = input->GetPolys();
  vtkNew<vtkIdList> corners;
  vtkIdType polygons = 0;
  for (vtkIdType cell = 0; cell < polys->GetNumberOfCells(); ++cell)
  {
    polygons += polys->GetCellSize(cell) > 3 ? 1 : 0;
  }
  this->NumberOfTriangulatedCells = polygons + input->GetNumberOfStrips();
  this->PolyData = input;
  if (this->NumberOfTriangulatedCells > 0)
  {
    vtkNew<vtkTriangleFilter> triangulate;
    triangulate->SetInputData(input);
    triangulate->Update();
    this->PolyData = triangulate->GetOutput();
    polys = this->PolyData->GetPolys();
  }
  const vtkIdType numberOfPoints = this->PolyData->GetNumberOfPoints();
  if (numberOfPoints > largest || polys->GetNumberOfCells() > largest)
  {
    return false;
  }

  this->FetchPoints();
  const auto isUsable = [&](vtkIdType p)
  {
    return p >= 0 && p < numberOfPoints && (usable.empty() || usable[p] != 0) &&
      std::all_of(
        this->Points + 3 * p, this->Points + 3 * p + 3, [](double x) { return std::isfinite(x); });
  };
  const vtkIdType firstCell =
    this->PolyData->GetNumberOfVerts() + this->PolyData->GetNumberOfLines();
  std::vector<ridges::Triangle> triangles;
  triangles.reserve(polys->GetNumberOfCells());
  this->CellIds.clear();
  this->CellIds.reserve(polys->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < polys->GetNumberOfCells(); ++cell)
  {
    polys->GetCellAtId(cell, corners);
    if (corners->GetNumberOfIds() != 3)
    {
      continue;
    }
    const vtkIdType a = corners->GetId(0);
    const vtkIdType b = corners->GetId(1);
    const vtkIdType c = corners->GetId(2);
    if (a != b && b != c && c != a && isUsable(a) && isUsable(b) && isUsable(c))
    {
      triangles.push_back(
        { static_cast<ridges::Id>(a), static_cast<ridges::Id>(b), static_cast<ridges::Id>(c) });
      this->CellIds.push_back(firstCell + cell);
    }
  }
  this->NumberOfUnusableTriangles =
    polys->GetNumberOfCells() - static_cast<vtkIdType>(triangles.size());
  this->Triangles = ridges::TriangleMesh(
    this->Points, static_cast<ridges::Id>(numberOfPoints), std::move(triangles));
  return true;
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
