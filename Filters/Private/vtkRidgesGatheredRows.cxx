// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesGatheredRows.h"

#include "vtkRidgesArrayMessages.h"
#include "vtkRidgesMakeArray.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <numeric>
#include <string>

using ridges::Id;

namespace
{

vtkSmartPointer<vtkDataArray> SomeRows(vtkDataArray* array, const std::vector<Id>& rows)
{
  if (static_cast<vtkIdType>(rows.size()) == array->GetNumberOfTuples())
  {
    return array;
  }
  vtkNew<vtkIdList> ids;
  ids->SetNumberOfIds(static_cast<vtkIdType>(rows.size()));
  std::copy(rows.begin(), rows.end(), ids->begin());
  auto some = vtkRidgesMakeArrayLike(array);
  some->SetNumberOfTuples(ids->GetNumberOfIds());
  array->GetTuples(ids, some);
  return some;
}

} // namespace

void vtkRidgesPackPoints(ridges::Bytes& message, vtkPolyData* piece, const std::vector<Id>& points)
{
  vtkNew<vtkFieldData> coordinates;
  vtkNew<vtkFieldData> rows;
  if (!points.empty())
  {
    coordinates->AddArray(SomeRows(piece->GetPoints()->GetData(), points));
    vtkPointData* values = piece->GetPointData();
    for (int i = 0; i < values->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = values->GetArray(i);
      if (array && array->GetName() &&
        std::string(array->GetName()) != vtkDataSetAttributes::GhostArrayName())
      {
        rows->AddArray(SomeRows(array, points));
      }
    }
  }
  vtkRidgesPackArrays(message, coordinates);
  vtkRidgesPackArrays(message, rows);
}

void vtkRidgesPutRows(vtkFieldData* from, const std::vector<vtkIdType>& places, vtkIdType count,
  bool areCoordinates, vtkFieldData* to)
{
  vtkNew<vtkIdList> sources;
  vtkNew<vtkIdList> targets;
  sources->SetNumberOfIds(static_cast<vtkIdType>(places.size()));
  targets->SetNumberOfIds(sources->GetNumberOfIds());
  std::iota(sources->begin(), sources->end(), 0);
  std::copy(places.begin(), places.end(), targets->begin());
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* part = from->GetArray(i);
    const auto arrayOf = [part, to, areCoordinates]
    { return areCoordinates ? to->GetArray(0) : to->GetArray(part->GetName()); };
    if (!arrayOf())
    {
      const auto array = vtkRidgesMakeArrayLike(part);
      array->SetNumberOfTuples(count);
      to->AddArray(array);
    }
    arrayOf()->InsertTuples(targets, sources, part);
  }
}
