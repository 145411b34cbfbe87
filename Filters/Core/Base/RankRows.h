// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_RankRows_h
#define ridges_RankRows_h

#include "Base/RankGathering.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <utility>
#include <vector>

namespace ridges
{

/// Of the rows for each rank, and from each rank, those from `begin` up to `end`.
template <typename T>
void ExchangeSomeRows(Ranks& ranks, const T* values, int width,
  const std::vector<std::vector<Id>>& asked, const std::vector<std::vector<Id>>& places, T* rows,
  std::size_t begin, std::size_t end)
{
  const std::size_t size = sizeof(T) * width;
  const int own = ranks.Rank();
  std::vector<Bytes> messages(asked.size());
  for (int rank = 0; rank < ranks.Size(); ++rank)
  {
    const std::size_t last = std::min(end, asked[rank].size());
    messages[rank].resize(rank == own || begin >= last ? 0 : size * (last - begin));
    char* to = messages[rank].data();
    for (std::size_t i = begin; i < last; ++i)
    {
      const T* row = values + static_cast<std::size_t>(width) * asked[rank][i];
      if (rank == own)
      {
        std::memcpy(rows + static_cast<std::size_t>(width) * places[own][i], row, size);
      }
      else
      {
        std::memcpy(to, row, size);
        to += size;
      }
    }
  }
  messages = ranks.Exchange(std::move(messages));
  for (int rank = 0; rank < ranks.Size(); ++rank)
  {
    const char* from = messages[rank].data();
    for (std::size_t i = begin; rank != own && i < std::min(end, places[rank].size()); ++i)
    {
      std::memcpy(rows + static_cast<std::size_t>(width) * places[rank][i], from, size);
      from += size;
    }
  }
}

/**
 * Rows of `width` values that other ranks have asked for: `asked` has the rows of `values` for each
 * rank, `places` where those from each rank belong in the result, each place once. Some at a time,
 * so that messages take little memory.
 */
template <typename T>
void ExchangeRows(Ranks& ranks, const T* values, int width,
  const std::vector<std::vector<Id>>& asked, const std::vector<std::vector<Id>>& places, T* rows)
{
  constexpr std::size_t atATime = std::size_t(1) << 16;
  std::size_t most = 0;
  for (const std::vector<Id>& ofRank : asked)
  {
    most = std::max(most, ofRank.size());
  }
  for (const std::size_t here : GatherAllOne(ranks, most))
  {
    most = std::max(most, here);
  }
  for (std::size_t begin = 0; begin < most; begin += atATime)
  {
    ExchangeSomeRows(ranks, values, width, asked, places, rows, begin, begin + atATime);
  }
}

/// The same in memory of its own.
template <typename T>
std::vector<T> ExchangeRows(Ranks& ranks, const T* values, int width,
  const std::vector<std::vector<Id>>& asked, const std::vector<std::vector<Id>>& places)
{
  std::size_t numberOfRows = 0;
  for (const std::vector<Id>& from : places)
  {
    numberOfRows += from.size();
  }
  std::vector<T> rows(numberOfRows * width);
  ExchangeRows(ranks, values, width, asked, places, rows.data());
  return rows;
}

} // namespace ridges

#endif
