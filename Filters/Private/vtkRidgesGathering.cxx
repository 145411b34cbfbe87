// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesGathering.h"

#include "vtkRidgesArrayMessages.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesFieldData.h"
#include "vtkRidgesMakeArray.h"
#include "vtkRidgesPiece.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <string>
#include <utility>

namespace names = vtkRidgesArrayNames;
using ridges::Id;

vtkSmartPointer<vtkPolyData> vtkRidgesGathering::Gather(ridges::Ranks& ranks, vtkPolyData* piece)
{
  // The fit has found nothing wrong.
  this->Piece.Build(
    piece, {}, ridges::TriangleMesh::Edges::NotBuilt, vtkRidgesMesh::Duplicates::LeftOut);
  const ridges::TriangleMesh& mesh = this->Piece.GetTriangles();
  this->Points.Share(ranks, vtkRidgesPiece(this->Piece).GetView());
  this->First = { 0 };
  for (const Id count : ridges::GatherAllOne(ranks, mesh.NumberOfTriangles()))
  {
    this->First.push_back(this->First.back() + count);
  }
  std::vector<ridges::Bytes> messages(ranks.Size());
  this->Pack(messages[0]);
  messages = ranks.Exchange(std::move(messages));
  vtkSmartPointer<vtkPolyData> whole;
  std::vector<std::vector<vtkIdType>> ids(ranks.Size());
  if (ranks.Rank() == 0)
  {
    whole = this->Join(messages, ids);
    whole->GetFieldData()->ShallowCopy(piece->GetFieldData());
  }
  this->PointIds = ridges::ExchangeValues(ranks, std::move(ids)).front();
  return whole;
}

void vtkRidgesGathering::Pack(ridges::Bytes& message) const
{
  const ridges::TriangleMesh& mesh = this->Piece.GetTriangles();
  vtkPolyData* piece = this->Piece.GetPolyData();
  const std::vector<std::int64_t>& numbers = this->Points.NumbersOfPiece();
  ridges::Pack(message, numbers);
  std::vector<std::int64_t> corners;
  corners.reserve(3 * static_cast<std::size_t>(mesh.NumberOfTriangles()));
  for (const ridges::Triangle& triangle : mesh.Triangles())
  {
    for (const Id p : triangle)
    {
      corners.push_back(numbers[p]);
    }
  }
  ridges::Pack(message, corners);

  vtkNew<vtkFieldData> rows;
  if (!numbers.empty())
  {
    rows->AddArray(piece->GetPoints()->GetData());
    vtkPointData* values = piece->GetPointData();
    for (int i = 0; i < values->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = values->GetArray(i);
      if (array && array->GetName() &&
        std::string(array->GetName()) != vtkDataSetAttributes::GhostArrayName())
      {
        rows->AddArray(array);
      }
    }
  }
  vtkRidgesPackArrays(message, rows);
}

/// Points in the order of the pieces, so that one piece that is all keeps its numbers.
vtkSmartPointer<vtkPolyData> vtkRidgesGathering::Join(
  const std::vector<ridges::Bytes>& messages, std::vector<std::vector<vtkIdType>>& ids) const
{
  const std::int64_t count = this->Points.NumberOfAll();
  std::vector<vtkIdType> idOf(count, -1);
  vtkIdType next = 0;
  auto whole = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkFieldData> rows; // The first are the coordinates.
  vtkNew<vtkCellArray> polys;
  for (std::size_t rank = 0; rank < messages.size(); ++rank)
  {
    ridges::Unpacker message(messages[rank]);
    const std::vector<std::int64_t> numbers = message.Take<std::int64_t>();
    const std::vector<std::int64_t> corners = message.Take<std::int64_t>();
    for (const std::int64_t number : numbers)
    {
      idOf[number] = idOf[number] < 0 ? next++ : idOf[number];
      ids[rank].push_back(idOf[number]);
    }
    for (std::size_t i = 0; i < corners.size(); i += 3)
    {
      const vtkIdType triangle[] = { idOf[corners[i]], idOf[corners[i + 1]], idOf[corners[i + 2]] };
      polys->InsertNextCell(3, triangle);
    }
    vtkNew<vtkFieldData> part;
    vtkRidgesTakeArrays(message, part);
    for (int k = 0; k < part->GetNumberOfArrays(); ++k)
    {
      vtkDataArray* from = part->GetArray(k);
      if (rows->GetNumberOfArrays() <= k)
      {
        const auto array = vtkRidgesMakeArrayLike(from);
        array->SetNumberOfTuples(count);
        rows->AddArray(array);
      }
      vtkDataArray* to = k == 0 ? rows->GetArray(0) : rows->GetArray(from->GetName());
      for (std::size_t i = 0; i < numbers.size(); ++i)
      {
        to->SetTuple(ids[rank][i], static_cast<vtkIdType>(i), from);
      }
    }
  }
  vtkNew<vtkPoints> points;
  if (rows->GetNumberOfArrays() > 0)
  {
    points->SetDataType(rows->GetArray(0)->GetDataType());
    points->SetData(rows->GetArray(0));
  }
  whole->SetPoints(points);
  whole->SetPolys(polys);
  for (int k = 1; k < rows->GetNumberOfArrays(); ++k)
  {
    whole->GetPointData()->AddArray(rows->GetArray(k));
  }
  return whole;
}

void vtkRidgesGathering::GiveBack(ridges::Ranks& ranks, vtkPolyData* whole, vtkPolyData* output)
{
  std::vector<ridges::Bytes> messages(ranks.Size());
  for (int rank = 0; whole && rank < ranks.Size(); ++rank)
  {
    vtkNew<vtkFieldData> part;
    vtkCellData* cells = whole->GetCellData();
    for (int i = 0; i < cells->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = cells->GetArray(i);
      const auto rows = vtkRidgesMakeArrayLike(array);
      rows->InsertTuples(0, this->First[rank + 1] - this->First[rank], this->First[rank], array);
      part->AddArray(rows);
    }
    vtkRidgesPackArrays(messages[rank], part);
    vtkRidgesPackArrays(messages[rank], whole->GetFieldData());
  }
  const std::vector<ridges::Bytes> received = ranks.Exchange(std::move(messages));
  ridges::Unpacker message(received[0]);
  vtkNew<vtkFieldData> rows;
  vtkRidgesTakeArrays(message, rows);

  output->ShallowCopy(this->Piece.GetPolyData());
  const ridges::TriangleMesh& mesh = this->Piece.GetTriangles();
  auto cellNumbers = vtkRidgesMakeArray<vtkIdTypeArray>(names::GatheredCellId);
  for (vtkIdType t = this->First[ranks.Rank()]; t < this->First[ranks.Rank() + 1]; ++t)
  {
    cellNumbers->InsertNextValue(t);
  }
  rows->AddArray(cellNumbers);
  for (int i = 0; i < rows->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* from = rows->GetArray(i);
    const auto array = vtkRidgesMakeArrayLike(from);
    array->SetNumberOfTuples(output->GetNumberOfCells());
    array->Fill(-1.0);
    for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
    {
      array->SetTuple(this->Piece.GetCellId(t), t, from);
    }
    output->GetCellData()->AddArray(array);
  }
  auto pointNumbers = vtkRidgesMakeArray<vtkIdTypeArray>(names::GatheredPointId);
  for (const vtkIdType id : this->PointIds)
  {
    pointNumbers->InsertNextValue(id);
  }
  output->GetPointData()->AddArray(pointNumbers);
  vtkRidgesTakeArrays(message, vtkRidgesOwnFieldData(output));
}
