// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// What all ranks learn of each other: their values, sums of them, and their texts.

#ifndef ridges_RankGathering_h
#define ridges_RankGathering_h

#include "Base/RankMessages.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace ridges
{

/// The values of all ranks, by rank.
template <typename T>
std::vector<std::vector<T>> GatherAllValues(Ranks& ranks, const std::vector<T>& values)
{
  Bytes message;
  Pack(message, values);
  const std::vector<Bytes> ofAll = ranks.GatherAll(std::move(message));
  std::vector<std::vector<T>> received;
  received.reserve(ofAll.size());
  for (const Bytes& bytes : ofAll)
  {
    received.push_back(Unpacker(bytes).Take<T>());
  }
  return received;
}

/// The values of all ranks in an order.
template <typename T, typename Precedes>
std::vector<T> GatherInOneRow(Ranks& ranks, const std::vector<T>& values, const Precedes& precedes)
{
  std::vector<T> all;
  for (const std::vector<T>& each : GatherAllValues(ranks, values))
  {
    all.insert(all.end(), each.begin(), each.end());
  }
  std::sort(all.begin(), all.end(), precedes);
  return all;
}

/// A value of each rank, in their order.
template <typename T>
std::vector<T> GatherAllOne(Ranks& ranks, const T& value)
{
  std::vector<T> all;
  for (const std::vector<T>& one : GatherAllValues(ranks, std::vector<T>{ value }))
  {
    all.push_back(one.front());
  }
  return all;
}

/// Whether it is true on any rank.
inline bool IsAnywhere(Ranks& ranks, bool here)
{
  const std::vector<char> all = GatherAllOne<char>(ranks, here ? 1 : 0);
  return std::find(all.begin(), all.end(), 1) != all.end();
}

/// The sum over all ranks. Of integers, as it has to be the same in any order.
inline std::int64_t SumOverRanks(Ranks& ranks, std::int64_t value)
{
  std::int64_t sum = 0;
  for (const std::int64_t each : GatherAllOne(ranks, value))
  {
    sum += each;
  }
  return sum;
}

/// The texts of all ranks, by rank.
inline std::vector<std::string> GatherAllTexts(Ranks& ranks, const std::string& text)
{
  Bytes message;
  PackText(message, text);
  const std::vector<Bytes> ofAll = ranks.GatherAll(std::move(message));
  std::vector<std::string> texts;
  texts.reserve(ofAll.size());
  for (const Bytes& bytes : ofAll)
  {
    texts.push_back(Unpacker(bytes).TakeText());
  }
  return texts;
}

/// One text of what each rank has to say; empty if none has anything.
inline std::string TextOfRanks(Ranks& ranks, const std::string& text)
{
  const std::vector<std::string> texts = GatherAllTexts(ranks, text);
  const bool areEqual =
    std::adjacent_find(texts.begin(), texts.end(), std::not_equal_to<>()) == texts.end();
  if (areEqual)
  {
    return text;
  }
  std::string all;
  for (std::size_t rank = 0; rank < texts.size(); ++rank)
  {
    if (!texts[rank].empty())
    {
      all += (all.empty() ? "on rank " : "; on rank ") + std::to_string(rank) + ": " + texts[rank];
    }
  }
  return all;
}

} // namespace ridges

#endif
