// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "AnalyticSurface.h"

#include "Mesh/IdTable.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace
{

using namespace ridges;
using namespace ridges::testing;

} // namespace

TEST(IdTable, HoldsWhatAMapHolds)
{
  std::mt19937_64 generator(1);
  IdTable<int> table;
  for (const std::size_t count : { 3u, 2000u, 10u, 0u, 300u })
  {
    table.Clear();
    std::map<Id, int> expected;
    // Ids that collide in the table, and such that follow each other.
    const Id stride = count % 3 == 0 ? 1 : 4096;
    for (std::size_t i = 0; i < count; ++i)
    {
      const auto id = static_cast<Id>(stride * static_cast<Id>(Uniform(generator) * 1000.0));
      ++table[id];
      ++expected[id];
    }
    EXPECT_EQ(table.size(), expected.size());
    for (Id i = 0; i < 1000; ++i)
    {
      const auto found = expected.find(stride * i);
      const int* value = table.Find(stride * i);
      ASSERT_EQ(value != nullptr, found != expected.end());
      EXPECT_EQ(table.Contains(stride * i), found != expected.end());
      if (value)
      {
        EXPECT_EQ(*value, found->second);
      }
    }
  }
}
