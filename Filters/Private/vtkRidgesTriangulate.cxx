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
#include "vtkTriangleFilter.h"
#include "vtkVersionMacros.h"

#include <algorithm>

namespace
{

/// Triangles that all the polygons and strips make up.
vtkIdType CountTriangles(vtkPolyData* data)
{
  vtkNew<vtkIdList> ids;
  vtkIdType count = 0;
  for (vtkCellArray* cells : { data->GetPolys(), data->GetStrips() })
  {
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
    {
      cells->GetCellAtId(cell, ids);
      count += std::max<vtkIdType>(0, ids->GetNumberOfIds() - 2);
    }
  }
  return count;
}

bool CutEars(vtkPolygon* polygon, vtkIdList* triangles)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 20240617) // as in ParaView 5.13
  return polygon->TriangulateLocalIds(0, triangles) != 0;
#else
  return polygon->Triangulate(triangles) != 0;
#endif
}

/// Local numbers of the corners of the triangles that make up a polygon.
void CutPolygon(vtkPoints* points, vtkIdList* polygon, vtkIdList* triangles)
{
  const vtkIdType size = polygon->GetNumberOfIds();
  vtkNew<vtkPolygon> cell;
  cell->Initialize(static_cast<int>(size), polygon->GetPointer(0), points);
  triangles->Reset();
  if (size > 3 && CutEars(cell, triangles) && triangles->GetNumberOfIds() == 3 * (size - 2))
  {
    return;
  }
  triangles->Reset();
  for (vtkIdType i = 1; i + 1 < size; ++i)
  {
    for (const vtkIdType corner : { vtkIdType{ 0 }, i, i + 1 })
    {
      triangles->InsertNextId(corner);
    }
  }
}

/// Each second triangle of a strip runs the other way.
void CutStrip(vtkIdList* strip, vtkIdList* triangles)
{
  triangles->Reset();
  for (vtkIdType i = 0; i + 2 < strip->GetNumberOfIds(); ++i)
  {
    for (const vtkIdType corner : { i, i + 1 + i % 2, i + 2 - i % 2 })
    {
      triangles->InsertNextId(corner);
    }
  }
}

vtkSmartPointer<vtkPolyData> CutAll(vtkPolyData* input)
{
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->SetPoints(input->GetPoints());
  output->SetVerts(input->GetVerts());
  output->SetLines(input->GetLines());
  output->GetPointData()->PassData(input->GetPointData());
  output->SetFieldData(input->GetFieldData());
  vtkCellData* cellData = output->GetCellData();
  cellData->CopyAllOn();
  cellData->CopyAllocate(input->GetCellData());

  vtkIdType from = 0;
  vtkIdType to = 0;
  for (; from < input->GetNumberOfVerts() + input->GetNumberOfLines(); ++from, ++to)
  {
    cellData->CopyData(input->GetCellData(), from, to);
  }
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkIdList> ids;
  vtkNew<vtkIdList> triangles;
  for (vtkCellArray* cells : { input->GetPolys(), input->GetStrips() })
  {
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell, ++from)
    {
      cells->GetCellAtId(cell, ids);
      if (cells == input->GetPolys())
      {
        CutPolygon(input->GetPoints(), ids, triangles);
      }
      else
      {
        CutStrip(ids, triangles);
      }
      for (vtkIdType i = 0; i + 2 < triangles->GetNumberOfIds(); i += 3, ++to)
      {
        polys->InsertNextCell({ ids->GetId(triangles->GetId(i)),
          ids->GetId(triangles->GetId(i + 1)), ids->GetId(triangles->GetId(i + 2)) });
        cellData->CopyData(input->GetCellData(), from, to);
      }
    }
  }
  output->SetPolys(polys);
  return output;
}

} // namespace

vtkSmartPointer<vtkPolyData> vtkRidgesTriangulate(vtkPolyData* input)
{
  vtkNew<vtkTriangleFilter> filter;
  filter->SetInputData(input);
  filter->Update();
  vtkSmartPointer<vtkPolyData> output = filter->GetOutput();
  return output->GetNumberOfPolys() < CountTriangles(input) ? CutAll(input) : output;
}
