// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesTriangulate.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"
#include "vtkVersionMacros.h"

#include <cmath>

namespace
{

bool CutPolygonByShape(vtkPolygon* polygon, vtkIdList* triangles)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 20240617) // as in ParaView 5.13
  return polygon->TriangulateLocalIds(0, triangles) != 0;
#else
  return polygon->Triangulate(triangles) != 0;
#endif
}

/// Collects the triangles with the cell data of what they are cut from.
class Cutter
{
public:
  explicit Cutter(vtkPolyData* input)
    : Points(input->GetPoints())
    , InputData(input->GetCellData())
  {
    this->CellData->CopyAllOn();
    this->CellData->CopyAllocate(this->InputData);
  }

  /// Cells that stay as they are, which come before all others.
  void Keep(vtkIdType count)
  {
    for (vtkIdType i = 0; i < count; ++i, ++this->From, ++this->To)
    {
      this->CellData->CopyData(this->InputData, this->From, this->To);
    }
  }

  /// A triangle, or less than one, stays as it is.
  void CutPolygon(vtkIdList* polygon)
  {
    const vtkIdType size = polygon->GetNumberOfIds();
    if (size <= 3)
    {
      this->Insert(size, polygon->GetPointer(0));
    }
    else if (this->CutEars(polygon))
    {
      for (vtkIdType i = 0; i < this->Corners->GetNumberOfIds(); i += 3)
      {
        this->InsertCorners(polygon, this->Corners->GetId(i), this->Corners->GetId(i + 1),
          this->Corners->GetId(i + 2));
      }
    }
    else
    {
      for (vtkIdType i = 1; i + 1 < size; ++i)
      {
        this->InsertCorners(polygon, 0, i, i + 1);
      }
    }
    ++this->From;
  }

  /// Each second triangle of a strip runs the other way.
  void CutStrip(vtkIdList* strip)
  {
    for (vtkIdType i = 0; i + 2 < strip->GetNumberOfIds(); ++i)
    {
      this->InsertCorners(strip, i, i + 1 + i % 2, i + 2 - i % 2);
    }
    ++this->From;
  }

  void Store(vtkPolyData* output)
  {
    output->SetPolys(this->Triangles);
    output->GetCellData()->ShallowCopy(this->CellData);
  }

private:
  /// Finds the triangles of a polygon by its shape. False where that fails.
  bool CutEars(vtkIdList* ids)
  {
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      const vtkIdType p = ids->GetId(i);
      double x[3];
      if (p < 0 || !this->Points || p >= this->Points->GetNumberOfPoints())
      {
        return false;
      }
      this->Points->GetPoint(p, x);
      if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
      {
        return false;
      }
    }
    this->Polygon->Initialize(
      static_cast<int>(ids->GetNumberOfIds()), ids->GetPointer(0), this->Points);
    this->Corners->Reset();
    return CutPolygonByShape(this->Polygon, this->Corners) &&
      this->Corners->GetNumberOfIds() == 3 * (ids->GetNumberOfIds() - 2);
  }

  void InsertCorners(vtkIdList* ids, vtkIdType i, vtkIdType j, vtkIdType k)
  {
    const vtkIdType triangle[] = { ids->GetId(i), ids->GetId(j), ids->GetId(k) };
    this->Insert(3, triangle);
  }

  void Insert(vtkIdType size, const vtkIdType* ids)
  {
    this->Triangles->InsertNextCell(size, ids);
    this->CellData->CopyData(this->InputData, this->From, this->To++);
  }

  vtkPoints* Points;
  vtkCellData* InputData;
  vtkIdType From = 0; ///< The cell to be cut next.
  vtkIdType To = 0;   ///< The cell to be made next.
  vtkNew<vtkCellArray> Triangles;
  vtkNew<vtkCellData> CellData;
  vtkNew<vtkPolygon> Polygon;
  vtkNew<vtkIdList> Corners;
};

} // namespace

vtkSmartPointer<vtkPolyData> vtkRidgesTriangulate(vtkPolyData* input)
{
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->SetPoints(input->GetPoints());
  output->SetVerts(input->GetVerts());
  output->SetLines(input->GetLines());
  output->GetPointData()->PassData(input->GetPointData());
  output->SetFieldData(input->GetFieldData());

  Cutter cutter(input);
  cutter.Keep(input->GetNumberOfVerts() + input->GetNumberOfLines());
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < input->GetNumberOfPolys(); ++cell)
  {
    input->GetPolys()->GetCellAtId(cell, ids);
    cutter.CutPolygon(ids);
  }
  for (vtkIdType cell = 0; cell < input->GetNumberOfStrips(); ++cell)
  {
    input->GetStrips()->GetCellAtId(cell, ids);
    cutter.CutStrip(ids);
  }
  cutter.Store(output);
  return output;
}
