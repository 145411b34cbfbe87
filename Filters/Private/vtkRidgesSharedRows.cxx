// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesSharedRows.h"

#include "vtkRidgesArrayNames.h"
#include "vtkRidgesMakeArray.h"

#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace
{

/// The array of the same name and components with other rows; null if it is of another type.
template <typename Array, typename Rows>
vtkSmartPointer<vtkDataArray> WithRows(vtkDataArray* array, vtkIdType count, const Rows& setRows)
{
  auto* typed = Array::SafeDownCast(array);
  if (!typed)
  {
    return nullptr;
  }
  auto result = vtkRidgesMakeArrayLike(typed);
  result->SetNumberOfTuples(count);
  setRows(typed->GetPointer(0), typed->GetNumberOfComponents(),
    Array::SafeDownCast(result)->GetPointer(0));
  return result;
}

template <typename Rows>
void ForArrays(vtkPointData* from, vtkPointData* to, std::size_t numberOfRows, const Rows& setRows)
{
  const auto count = static_cast<vtkIdType>(numberOfRows);
  while (from->GetNumberOfArrays() > 0)
  {
    auto array = WithRows<vtkDoubleArray>(from->GetArray(0), count, setRows);
    if (!array)
    {
      array = WithRows<vtkIntArray>(from->GetArray(0), count, setRows);
    }
    to->AddArray(array);
    from->RemoveArray(0); // as both would be much
  }
  to->SetActiveNormals(vtkRidgesArrayNames::Normals);
}

} // namespace

void vtkRidgesRowsOfPiece(ridges::Ranks& ranks, const ridges::SharedPoints& points,
  vtkPointData* owned, vtkPointData* piece)
{
  ForArrays(owned, piece, points.NumbersOfPiece().size(),
    [&ranks, &points](const auto* values, int width, auto* rows)
    { points.ToPiece(ranks, values, width, rows); });
}

void vtkRidgesRowsOfShare(
  ridges::Ranks& ranks, const ridges::MeshShare& share, vtkPointData* owned, vtkPointData* values)
{
  ForArrays(owned, values, static_cast<std::size_t>(share.Mesh().NumberOfPoints()),
    [&ranks, &share](const auto* from, int width, auto* rows)
    {
      const auto ofShare = share.Rows(ranks, from, width);
      std::copy(ofShare.begin(), ofShare.end(), rows);
    });
}

void vtkRidgesPickRows(vtkPointData* values, const std::vector<ridges::Id>& rows, vtkPointData* to)
{
  ForArrays(values, to, rows.size(),
    [&rows](const auto* from, int width, auto* picked)
    {
      for (const ridges::Id row : rows)
      {
        picked = std::copy_n(from + static_cast<std::size_t>(width) * row, width, picked);
      }
    });
}
