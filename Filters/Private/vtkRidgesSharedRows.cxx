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
#include <type_traits>
#include <vector>

namespace
{

/// The array of the same name and components with other rows; null if it is of another type.
template <typename Array, typename Rows>
vtkSmartPointer<vtkDataArray> WithRows(vtkDataArray* array, const Rows& rowsOf)
{
  auto* typed = Array::SafeDownCast(array);
  if (!typed)
  {
    return nullptr;
  }
  const int width = typed->GetNumberOfComponents();
  const auto rows = rowsOf(typed->GetPointer(0), width);
  auto result = vtkRidgesMakeArrayLike(typed);
  result->SetNumberOfTuples(static_cast<vtkIdType>(rows.size()) / width);
  std::copy(rows.begin(), rows.end(), Array::SafeDownCast(result)->GetPointer(0));
  return result;
}

template <typename Rows>
void ForArrays(vtkPointData* from, vtkPointData* to, const Rows& rowsOf)
{
  while (from->GetNumberOfArrays() > 0)
  {
    auto array = WithRows<vtkDoubleArray>(from->GetArray(0), rowsOf);
    if (!array)
    {
      array = WithRows<vtkIntArray>(from->GetArray(0), rowsOf);
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
  ForArrays(owned, piece,
    [&ranks, &points](const auto* values, int width)
    { return points.ToPiece(ranks, values, width); });
}

void vtkRidgesRowsOfShare(
  ridges::Ranks& ranks, const ridges::MeshShare& share, vtkPointData* owned, vtkPointData* values)
{
  ForArrays(owned, values,
    [&ranks, &share](const auto* rows, int width) { return share.Rows(ranks, rows, width); });
}

void vtkRidgesPickRows(vtkPointData* values, const std::vector<ridges::Id>& rows, vtkPointData* to)
{
  ForArrays(values, to,
    [&rows](const auto* from, int width)
    {
      std::vector<std::decay_t<decltype(*from)>> picked;
      picked.reserve(rows.size() * width);
      for (const ridges::Id row : rows)
      {
        const auto* first = from + static_cast<std::size_t>(width) * row;
        picked.insert(picked.end(), first, first + width);
      }
      return picked;
    });
}
