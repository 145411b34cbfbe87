// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesPartsToPieces.h"

#include "Core/Base/RankMessages.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

using ridges::Id;

namespace
{

/// What is sent at a time should be small against the fits of a part, for the memory it takes.
constexpr std::size_t SlicesOfPart = 4;

std::vector<Id> SliceBegins(const std::vector<Id>& begins)
{
  std::vector<Id> slices = { begins.front() };
  for (std::size_t i = 0; i + 1 < begins.size(); ++i)
  {
    const auto size = static_cast<std::size_t>(begins[i + 1] - begins[i]);
    for (std::size_t k = 1; k <= SlicesOfPart; ++k)
    {
      slices.push_back(begins[i] + static_cast<Id>(size * k / SlicesOfPart));
    }
  }
  return slices;
}

} // namespace

vtkRidgesPartsToPieces::vtkRidgesPartsToPieces(ridges::Ranks& ranks,
  const ridges::SharedPoints& shared, const std::vector<Id>& points, const std::vector<Id>& begins)
  : Ranks(ranks)
  , Shared(shared)
{
  const std::vector<Id> slices = SliceBegins(begins);
  std::vector<Id> sliceOf(points.size()); // of owned points
  for (std::size_t slice = 0; slice + 1 < slices.size(); ++slice)
  {
    for (Id i = slices[slice]; i < slices[slice + 1]; ++i)
    {
      sliceOf[points[i]] = static_cast<Id>(slice);
    }
  }
  for (const std::vector<Id>& received : shared.ReceivedFrom())
  {
    std::vector<Id>& sliceBegins = this->WantedBegins.emplace_back(slices.size(), 0);
    for (const Id p : received)
    {
      ++sliceBegins[sliceOf[p] + 1];
    }
    std::partial_sum(sliceBegins.begin(), sliceBegins.end(), sliceBegins.begin());
    std::vector<Id> next = sliceBegins;
    std::vector<Id>& wanted = this->Wanted.emplace_back(received.size());
    for (std::size_t i = 0; i < received.size(); ++i)
    {
      wanted[next[sliceOf[received[i]]]++] = static_cast<Id>(i);
    }
  }
}

void vtkRidgesPartsToPieces::Send(std::size_t number, const std::vector<Id>& part,
  const vtkRidgesFormArrays& values, vtkRidgesFormArrays& piece) const
{
  for (std::size_t k = 0; k < SlicesOfPart; ++k)
  {
    this->SendSlice(number * SlicesOfPart + k, part, values, piece);
  }
}

void vtkRidgesPartsToPieces::SendSlice(std::size_t slice, const std::vector<Id>& part,
  const vtkRidgesFormArrays& values, vtkRidgesFormArrays& piece) const
{
  std::vector<ridges::Bytes> messages(this->Ranks.Size());
  for (std::size_t rank = 0; rank < messages.size(); ++rank)
  {
    const auto all = this->Wanted[rank].begin();
    const std::vector<Id>& begins = this->WantedBegins[rank];
    const std::vector<Id> wanted(all + begins[slice], all + begins[slice + 1]);
    std::vector<Id> rows(wanted.size());
    std::transform(wanted.begin(), wanted.end(), rows.begin(),
      [&part, &received = this->Shared.ReceivedFrom()[rank]](Id i)
      {
        return static_cast<Id>(
          std::lower_bound(part.begin(), part.end(), received[i]) - part.begin());
      });
    ridges::Pack(messages[rank], wanted);
    values.PackRows(messages[rank], rows);
  }
  messages = this->Ranks.Exchange(std::move(messages));
  for (std::size_t rank = 0; rank < messages.size(); ++rank)
  {
    ridges::Unpacker unpacker(messages[rank]);
    std::vector<Id> ids = unpacker.Take<Id>();
    const std::vector<Id>& sent = this->Shared.SentTo()[rank];
    std::transform(ids.begin(), ids.end(), ids.begin(), [&sent](Id i) { return sent[i]; });
    piece.StoreRows(unpacker.Rest(), ids);
    messages[rank] = {};
  }
}
