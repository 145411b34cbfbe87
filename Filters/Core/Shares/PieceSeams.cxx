// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shares/PieceSeams.h"

#include "Base/RankGathering.h"

namespace ridges
{

std::vector<std::int64_t> NumbersByPieces(Ranks& ranks, const SharedPoints& points)
{
  // The owners know which rank has a point first.
  const std::vector<std::vector<Id>>& received = points.ReceivedFrom();
  const std::vector<std::vector<Id>>& sent = points.SentTo();
  std::vector<std::uint8_t> isKnown(points.NumberOfOwned(), 0);
  std::vector<std::vector<std::uint8_t>> isFirst(received.size());
  for (std::size_t rank = 0; rank < received.size(); ++rank)
  {
    for (const Id p : received[rank])
    {
      isFirst[rank].push_back(isKnown[p] != 0 ? 0 : 1);
      isKnown[p] = 1;
    }
  }
  std::vector<std::vector<std::uint8_t>> isOurs = isFirst;
  isOurs = ExchangeValues(ranks, std::move(isOurs));
  std::vector<std::int64_t> numbers(points.NumberOfPoints(), -1);
  for (std::size_t rank = 0; rank < sent.size(); ++rank)
  {
    for (std::size_t i = 0; i < sent[rank].size(); ++i)
    {
      numbers[sent[rank][i]] = isOurs[rank][i] != 0 ? 0 : -1;
    }
  }
  std::int64_t count = 0;
  for (std::int64_t& number : numbers)
  {
    number = number == 0 ? count++ : -1;
  }
  std::int64_t before = 0;
  const std::vector<std::int64_t> counts = GatherAllOne(ranks, count);
  for (int rank = 0; rank < ranks.Rank(); ++rank)
  {
    before += counts[rank];
  }
  std::vector<std::vector<std::int64_t>> firsts(sent.size());
  for (std::size_t rank = 0; rank < sent.size(); ++rank)
  {
    for (const Id p : sent[rank])
    {
      if (numbers[p] >= 0)
      {
        firsts[rank].push_back(before + numbers[p]);
      }
    }
  }
  firsts = ExchangeValues(ranks, std::move(firsts));
  std::vector<std::int64_t> owned(points.NumberOfOwned(), -1);
  for (std::size_t rank = 0; rank < received.size(); ++rank)
  {
    std::size_t next = 0;
    for (std::size_t i = 0; i < received[rank].size(); ++i)
    {
      if (isFirst[rank][i] != 0)
      {
        owned[received[rank][i]] = firsts[rank][next++];
      }
    }
  }
  return points.ToPiece(ranks, owned.data(), 1);
}

PieceSeams::PieceSeams(Ranks& ranks, const SharedPoints& points)
  : SentTo_(points.SentTo().size())
  , ReceivedFrom_(points.ReceivedFrom().size())
{
  const std::vector<std::vector<Id>>& received = points.ReceivedFrom();
  std::vector<Id> seamOf(points.NumberOfOwned(), 0); // At first how many have the point.
  for (const std::vector<Id>& from : received)
  {
    for (const Id p : from)
    {
      ++seamOf[p];
    }
  }
  for (Id& seam : seamOf)
  {
    seam = seam > 1 ? this->NumberOfOwned_++ : -1;
  }
  std::vector<std::vector<std::uint8_t>> isSeam(received.size());
  for (std::size_t rank = 0; rank < received.size(); ++rank)
  {
    for (const Id p : received[rank])
    {
      isSeam[rank].push_back(seamOf[p] >= 0 ? 1 : 0);
      if (seamOf[p] >= 0)
      {
        this->ReceivedFrom_[rank].push_back(seamOf[p]);
      }
    }
  }
  isSeam = ExchangeValues(ranks, std::move(isSeam));
  for (std::size_t rank = 0; rank < isSeam.size(); ++rank)
  {
    for (std::size_t i = 0; i < isSeam[rank].size(); ++i)
    {
      if (isSeam[rank][i] != 0)
      {
        this->SentTo_[rank].push_back(points.SentTo()[rank][i]);
      }
    }
  }
}

} // namespace ridges
