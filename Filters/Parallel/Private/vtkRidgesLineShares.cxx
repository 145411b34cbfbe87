// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesLineShares.h"

#include "vtkRidgesArrayNames.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <vector>

namespace
{

constexpr int Tag = 20052;

/// Where the lines of each rank begin, and how many there are: those of a ridge, which follow each
/// other, are not parted.
std::vector<vtkIdType> FirstLines(vtkPolyData* ridges, int ranks)
{
  vtkCellArray* lines = ridges->GetLines();
  const vtkIdType count = lines->GetNumberOfCells();
  vtkDataArray* ridgeOf = ridges->GetCellData()->GetArray(vtkRidgesArrayNames::RidgeId);
  const double all = static_cast<double>(lines->GetNumberOfConnectivityIds());
  std::vector<vtkIdType> first{ 0 };
  double points = 0.0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const bool isStart = i == 0 || ridgeOf->GetTuple1(i) != ridgeOf->GetTuple1(i - 1);
    while (isStart && static_cast<int>(first.size()) < ranks &&
      points * ranks >= all * static_cast<double>(first.size()))
    {
      first.push_back(i);
    }
    points += static_cast<double>(lines->GetCellSize(i));
  }
  first.resize(static_cast<std::size_t>(ranks) + 1, count);
  return first;
}

/// Some of the lines, with their points in the order that they had.
void Extract(vtkPolyData* ridges, vtkIdType begin, vtkIdType end, vtkPolyData* share)
{
  std::vector<vtkIdType> newId(ridges->GetNumberOfPoints(), -1);
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = begin; i < end; ++i)
  {
    ridges->GetLines()->GetCellAtId(i, corners);
    std::for_each(corners->begin(), corners->end(), [&newId](vtkIdType p) { newId[p] = 0; });
  }
  vtkPointData* values = ridges->GetPointData();
  share->GetPointData()->CopyAllOn();
  share->GetPointData()->CopyAllocate(values);
  vtkNew<vtkPoints> points;
  points->SetDataType(ridges->GetPoints()->GetDataType());
  for (vtkIdType p = 0; p < ridges->GetNumberOfPoints(); ++p)
  {
    if (newId[p] == 0)
    {
      newId[p] = points->InsertNextPoint(ridges->GetPoint(p));
      share->GetPointData()->CopyData(values, p, newId[p]);
    }
  }
  share->GetCellData()->CopyAllOn();
  share->GetCellData()->CopyAllocate(ridges->GetCellData());
  vtkNew<vtkCellArray> lines;
  for (vtkIdType i = begin; i < end; ++i)
  {
    ridges->GetLines()->GetCellAtId(i, corners);
    std::transform(corners->begin(), corners->end(), corners->begin(),
      [&newId](vtkIdType p) { return newId[p]; });
    share->GetCellData()->CopyData(ridges->GetCellData(), i, lines->InsertNextCell(corners));
  }
  share->SetPoints(points);
  share->SetLines(lines);
  share->GetFieldData()->ShallowCopy(ridges->GetFieldData());
}

} // namespace

void vtkRidgesShareLines(vtkMultiProcessController* controller, vtkPolyData* ridges)
{
  vtkNew<vtkPolyData> own;
  if (controller->GetLocalProcessId() > 0)
  {
    controller->Receive(own, 0, Tag);
  }
  else
  {
    const int ranks = controller->GetNumberOfProcesses();
    const std::vector<vtkIdType> first = FirstLines(ridges, ranks);
    for (int rank = ranks; rank-- > 0;)
    {
      own->Initialize();
      Extract(ridges, first[rank], first[rank + 1], own);
      if (rank > 0)
      {
        controller->Send(own, rank, Tag);
      }
    }
  }
  ridges->ShallowCopy(own);
}
