// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ClosedManifold.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <cstddef>
#include <unordered_map>
#include <vector>

namespace ridges
{
namespace testing
{

bool IsClosedManifold(vtkPolyData* mesh)
{
  const vtkIdType numberOfPoints = mesh->GetNumberOfPoints();
  // From an edge to the one before it around the point that both lead to.
  std::unordered_map<vtkIdType, vtkIdType> before;
  before.reserve(mesh->GetPolys()->GetNumberOfConnectivityIds());
  std::vector<std::size_t> degree(numberOfPoints, 0);
  const auto key = [numberOfPoints](vtkIdType p, vtkIdType q) { return p * numberOfPoints + q; };
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    mesh->GetPolys()->GetCellAtId(cell, ids);
    const vtkIdType count = ids->GetNumberOfIds();
    for (vtkIdType i = 0; i < count; ++i)
    {
      const vtkIdType p = ids->GetId(i);
      const vtkIdType q = ids->GetId((i + 1) % count);
      if (p == q || !before.insert({ key(q, ids->GetId((i + 2) % count)), p }).second)
      {
        return false;
      }
      ++degree[q];
    }
  }
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    mesh->GetPolys()->GetCellAtId(cell, ids);
    const vtkIdType count = ids->GetNumberOfIds();
    for (vtkIdType i = 0; i < count; ++i)
    {
      const vtkIdType p = ids->GetId(i);
      const vtkIdType start = ids->GetId((i + 1) % count);
      vtkIdType at = start;
      std::size_t steps = 0;
      do
      {
        const auto next = before.find(key(p, at));
        if (next == before.end())
        {
          return false; // An edge without the opposite one.
        }
        at = next->second;
        ++steps;
      } while (at != start && steps <= degree[p]);
      if (steps != degree[p])
      {
        return false;
      }
    }
  }
  return mesh->GetNumberOfPolys() > 0;
}

} // namespace testing
} // namespace ridges
