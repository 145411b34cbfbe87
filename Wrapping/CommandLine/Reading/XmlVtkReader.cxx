// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reading/XmlVtkReader.h"

#include "Console.h"
#include "Reading/XmlVtkChecks.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLPolyDataReader.h"

namespace program
{
namespace
{

/// Looks at the offsets of cells before it reads their corners: of these it would make room for as
/// many as the offsets ask for.
class CheckedReader : public vtkXMLPolyDataReader
{
public:
  static CheckedReader* New();
  vtkTypeMacro(CheckedReader, vtkXMLPolyDataReader);

  void SetMostCorners(double most) { this->MostCorners = most; }
  bool HasTooManyCorners() const { return this->TooManyCorners; }

protected:
  int ReadPiece(vtkXMLDataElement* piece) override
  {
    const bool good = this->Superclass::ReadPiece(piece) != 0 && this->IsPossible(piece, "Verts") &&
      this->IsPossible(piece, "Lines") && this->IsPossible(piece, "Strips") &&
      this->IsPossible(piece, "Polys");
    return good ? 1 : 0;
  }

private:
  bool IsPossible(vtkXMLDataElement* piece, const std::string& cells)
  {
    vtkIdType count = 0;
    vtkXMLDataElement* element = piece->FindNestedElementWithName(cells.c_str());
    vtkXMLDataElement* offsets = element
      ? element->FindNestedElementWithNameAndAttribute("DataArray", "Name", "offsets")
      : nullptr;
    if (!offsets || !piece->GetScalarAttribute(("NumberOf" + cells).c_str(), count) || count <= 0)
    {
      return true;
    }
    const auto array = vtk::TakeSmartPointer(this->CreateArray(offsets));
    auto* numbers = vtkDataArray::SafeDownCast(array);
    if (!numbers)
    {
      return true;
    }
    numbers->SetNumberOfComponents(1);
    numbers->SetNumberOfTuples(count);
    numbers->Fill(0.0);
    this->ReadArrayValues(offsets, 0, numbers, 0, count);
    this->TooManyCorners = !(numbers->GetRange(0)[1] <= this->MostCorners);
    return !this->TooManyCorners;
  }

  double MostCorners = 0.0;
  bool TooManyCorners = false;
};

vtkStandardNewMacro(CheckedReader);

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
  const double mostBytes = CheckXmlVtk(bytes, fileName);
  vtkNew<CheckedReader> reader;
  reader->SetMostCorners(mostBytes);
  reader->ReadFromInputStringOn();
  reader->SetInputString(bytes);
  reader->Update();
  if (reader->HasTooManyCorners())
  {
    throw Failure(
      fileName + ": its cells have more corners than the file can hold", "give a complete file");
  }
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
