// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "WholeRidges.h"

#include "FilterTestTools.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRidgesArrayNames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ridges
{
namespace testing
{

namespace names = vtkRidgesArrayNames;

std::vector<WholeRidge> WholeRidges(vtkPolyData* ridges)
{
  std::vector<WholeRidge> whole;
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < ridges->GetNumberOfLines(); ++line)
  {
    const auto id = static_cast<std::size_t>(Value(ridges->GetCellData(), names::RidgeId, line));
    const auto type = static_cast<int>(Value(ridges->GetCellData(), names::RidgeType, line));
    ridges->GetLines()->GetCellAtId(line, ids);
    if (id >= whole.size())
    {
      whole.resize(id + 1);
      whole[id].first = *ids->begin();
    }
    whole[id].maximum = type <= 2;
    whole[id].closed = Value(ridges->GetCellData(), names::Closed, line) != 0.0;
    whole[id].types.insert(type);
    whole[id].last = *(ids->end() - 1);
  }
  return whole;
}

int CountEndsAt(
  vtkPolyData* ridges, const std::vector<WholeRidge>& whole, vtkIdType umbilic, bool maximum)
{
  int count = 0;
  for (const WholeRidge& ridge : whole)
  {
    for (const vtkIdType end : { ridge.first, ridge.last })
    {
      const double at = Value(ridges->GetPointData(), names::Umbilic, end);
      count +=
        ridge.maximum == maximum && !ridge.closed && at == static_cast<double>(umbilic) ? 1 : 0;
    }
  }
  return count;
}

int CountLooseRidges(vtkPolyData* ridges, const std::vector<WholeRidge>& whole)
{
  const auto isLoose = [ridges](const WholeRidge& ridge)
  {
    return !ridge.closed &&
      (Value(ridges->GetPointData(), names::Umbilic, ridge.first) < 0.0 ||
        Value(ridges->GetPointData(), names::Umbilic, ridge.last) < 0.0);
  };
  return static_cast<int>(std::count_if(whole.begin(), whole.end(), isLoose));
}

void ExpectAllUmbilicsJoined(vtkPolyData* umbilics, vtkPolyData* ridges)
{
  const std::vector<WholeRidge> whole = WholeRidges(ridges);
  for (vtkIdType i = 0; i < umbilics->GetNumberOfPoints(); ++i)
  {
    const double count = Value(umbilics->GetPointData(), names::RidgeCount, i);
    EXPECT_EQ(CountEndsAt(ridges, whole, i, true), count) << "umbilic " << i;
    EXPECT_EQ(CountEndsAt(ridges, whole, i, false), count) << "umbilic " << i;
  }
}

} // namespace testing
} // namespace ridges
