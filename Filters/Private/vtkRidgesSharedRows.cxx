// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesSharedRows.h"

#include "Core/Base/LargeMemory.h"
#include "vtkRidgesAllocate.h"
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
  vtkRidgesAllocate({ result }, count);
  setRows(typed->GetPointer(0), typed->GetNumberOfComponents(),
    Array::SafeDownCast(result)->GetPointer(0));
  return result;
}

template <typename Rows>
void ForArrays(vtkPointData* from, vtkPointData* to, std::size_t numberOfRows, const Rows& setRows)
{
  const auto count = static_cast<vtkIdType>(numberOfRows);
  std::vector<vtkSmartPointer<vtkDataArray>> arrays;
  std::vector<std::size_t> order;
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    arrays.emplace_back(from->GetArray(i));
    order.push_back(order.size());
  }
  from->Initialize();
  // Each array is given up as soon as it has another one in its place, as both would be much: the
  // largest first, whose memory then is enough for the next.
  std::stable_sort(order.begin(), order.end(),
    [&arrays](std::size_t i, std::size_t k)
    { return arrays[i]->GetNumberOfComponents() > arrays[k]->GetNumberOfComponents(); });
  for (const std::size_t i : order)
  {
    auto array = WithRows<vtkDoubleArray>(arrays[i], count, setRows);
    arrays[i] = array ? array : WithRows<vtkIntArray>(arrays[i], count, setRows);
    if (array && array->GetNumberOfComponents() > 1)
    {
      ridges::ReturnFreeMemory(); // the smaller ones take each other's
    }
  }
  for (const vtkSmartPointer<vtkDataArray>& array : arrays)
  {
    to->AddArray(array);
  }
  to->SetActiveNormals(vtkRidgesArrayNames::Normals);
}

} // namespace

void vtkRidgesRowsOfPiece(ridges::Ranks& ranks, const ridges::SharedPoints& points,
  vtkPointData* owned, vtkPointData* piece)
{
  ForArrays(owned, piece, points.NumberOfPoints(),
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
