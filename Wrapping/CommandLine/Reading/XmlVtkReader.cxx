// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reading/XmlVtkReader.h"

#include "Console.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkXMLPolyDataReader.h"

#include <cstdlib>

namespace program
{
namespace
{

void CheckComplete(const std::string& bytes, const std::string& fileName)
{
  if (bytes.find("<VTKFile") == std::string::npos)
  {
    throw Failure(fileName + " is not a file in VTK's XML format, it has no element VTKFile",
      "give a mesh in that format");
  }
  const std::size_t last = bytes.find_last_not_of(" \t\r\n");
  const std::string end = "</VTKFile>";
  if (last + 1 < end.size() || bytes.compare(last + 1 - end.size(), end.size(), end) != 0)
  {
    throw Failure(fileName + " does not end with " + end, "give a complete file");
  }
}

/// A false count cannot make VTK allocate: compression saves at most a factor of about 1000, and
/// the least array of a count has 4 bytes for each.
void CheckCounts(const std::string& bytes, const std::string& fileName)
{
  const bool isCompressed = bytes.find("compressor=") != std::string::npos;
  const double most = (isCompressed ? 250.0 : 1.0) * static_cast<double>(bytes.size());
  const std::string attribute = " NumberOf";
  for (std::size_t at = bytes.find(attribute); at != std::string::npos;
       at = bytes.find(attribute, at + 1))
  {
    const std::size_t quote = bytes.find_first_of("\"'", at);
    const double count =
      quote == std::string::npos ? 0.0 : std::strtod(bytes.c_str() + quote + 1, nullptr);
    if (!(count >= 0.0 && count <= most))
    {
      throw Failure(fileName + ": " + bytes.substr(at + 1, bytes.find('=', at) - at - 1) +
          " is more than the file can hold",
        "give a complete file");
    }
  }
}

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
  CheckComplete(bytes, fileName);
  CheckCounts(bytes, fileName);
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
