// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reading/XmlVtkReader.h"

#include "Console.h"
#include "Reading/XmlVtkChecks.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkXMLPolyDataReader.h"

namespace program
{
namespace
{

void CheckCorners(
  const vtkIdType* ids, vtkIdType size, vtkIdType numberOfPoints, const std::string& fileName)
{
  for (vtkIdType i = 0; i < size; ++i)
  {
    if (ids[i] < 0 || ids[i] >= numberOfPoints)
    {
      throw Failure(fileName + ": a cell has the corner " + std::to_string(ids[i]) +
          ", but there are " + std::to_string(numberOfPoints) + " points",
        "correct the file");
    }
  }
}

} // namespace

vtkSmartPointer<vtkPolyData> ParseXmlVtk(const std::string& bytes, const std::string& fileName)
{
  CheckXmlVtk(bytes, fileName);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(bytes);
  reader->Update();
  return reader->GetOutput();
}

PolygonMesh ToPolygonMesh(vtkPolyData* data, const std::string& fileName)
{
  PolygonMesh mesh;
  mesh.isSinglePrecision = data->GetPoints() && data->GetPoints()->GetDataType() == VTK_FLOAT;
  mesh.points.resize(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    data->GetPoint(i, mesh.points[static_cast<std::size_t>(i)].data());
  }
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    data->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  constexpr int notShown = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
  vtkIdType cell = data->GetVerts()->GetNumberOfCells() + data->GetLines()->GetNumberOfCells();
  for (vtkCellArray* cells : { data->GetPolys(), data->GetStrips() })
  {
    if (!cells->IsValid())
    {
      throw Failure(fileName + ": the offsets of its cells are invalid", "correct the file");
    }
    auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      iterator->GetCurrentCell(size, ids);
      CheckCorners(ids, size, data->GetNumberOfPoints(), fileName);
      const bool isGhost = ghosts && cell < ghosts->GetNumberOfTuples() &&
        (static_cast<int>(ghosts->GetTuple1(cell)) & notShown) != 0;
      ++cell;
      if (isGhost)
      {
        continue;
      }
      if (cells == data->GetStrips())
      {
        mesh.AddStrip({ ids, ids + size });
        continue;
      }
      mesh.corners.insert(mesh.corners.end(), ids, ids + size);
      mesh.EndFace();
    }
  }
  return mesh;
}

} // namespace program
