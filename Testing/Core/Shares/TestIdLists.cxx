// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Lists of ids that take little memory: what was put in comes out.

#include "Shares/IdRuns.h"
#include "Shares/SparseIds.h"

#include <gtest/gtest.h>

#include <vector>

using ridges::Id;
using ridges::IdRuns;
using ridges::SparseIds;

TEST(IdRuns, GivesBackAnyList)
{
  const std::vector<std::vector<Id>> lists = { {}, { 7 }, { -1 }, { -1, -1, 0, 1, 2 },
    { 5, 6, 7, 3, 4, -1, -1, 9, 9, 8, -1, 0 }, { 3, 2, 1, 0, -1 } };
  for (const std::vector<Id>& ids : lists)
  {
    const IdRuns runs(ids);
    EXPECT_EQ(runs.Ids(), ids);
    for (const std::vector<Id>& other : lists)
    {
      EXPECT_EQ(runs == IdRuns(other), ids == other);
    }
  }
}

TEST(SparseIds, IsMinusOneWhereNothingWasSet)
{
  constexpr Id count = 10000;
  SparseIds ids(count);
  ids.Set(0, 4);
  ids.Set(count - 1, 5);
  ids.Grow(2 * count);
  ids.Set(2 * count - 1, 6);
  for (Id p = 0; p < 2 * count; ++p)
  {
    ASSERT_EQ(ids[p], p == 0 ? 4 : (p == count - 1 ? 5 : (p == 2 * count - 1 ? 6 : -1)));
  }
}
