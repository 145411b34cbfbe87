// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Rows that ranks ask each other for, more than go into one message.

#include "Base/RankRows.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <vector>

using namespace ridges;
using namespace ridges::testing;

// Rank r asks each rank for 100,000 - 30,000 r rows, from the last to the first, so that some ranks
// have nothing left where others still have.
TEST(RankRows, GoWhereTheyWereAskedFor)
{
  constexpr int count = 3;
  constexpr Id rows = 100000;
  const auto askedBy = [](int rank) { return rows - 30000 * rank; };
  OnThreadRanks(count,
    [&askedBy](Ranks& ranks)
    {
      const int own = ranks.Rank();
      std::vector<Id> values; // two a row
      for (Id row = 0; row < rows; ++row)
      {
        values.push_back(own);
        values.push_back(row);
      }
      std::vector<std::vector<Id>> asked(count);
      std::vector<std::vector<Id>> places(count);
      for (int rank = 0; rank < count; ++rank)
      {
        for (Id i = 0; i < askedBy(rank); ++i)
        {
          asked[rank].push_back(rows - 1 - i);
        }
        for (Id i = 0; i < askedBy(own); ++i)
        {
          places[rank].push_back(count * i + rank);
        }
      }
      const std::vector<Id> received = ExchangeRows(ranks, values.data(), 2, asked, places);
      ASSERT_EQ(received.size(), 2U * count * askedBy(own));
      for (Id place = 0; place < count * askedBy(own); ++place)
      {
        ASSERT_EQ(received[2 * place], place % count);
        ASSERT_EQ(received[2 * place + 1], rows - 1 - place / count);
      }
    });
}
