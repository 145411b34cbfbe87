// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_PieceSeams_h
#define ridges_PieceSeams_h

#include "Shares/SharedPoints.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ridges
{

/// Numbers of the points of a rank's piece: those of all ranks, one piece after the other, as they
/// come first. If one piece is all, its points keep their ids. All ranks have to call this.
std::vector<std::int64_t> NumbersByPieces(Ranks& ranks, const SharedPoints& points);

/**
 * The points that several pieces have, by which ranks that walk over their pieces go on into
 * others.
 */
class PieceSeams
{
public:
  PieceSeams() = default;

  /// All ranks have to call this.
  PieceSeams(Ranks& ranks, const SharedPoints& points);

  /// Gives each point of the seams the least value that any rank has for it; which points of the
  /// piece it is less for than before. All ranks have to call this.
  template <typename T>
  std::vector<Id> TakeLeast(Ranks& ranks, std::vector<T>& ofPiece) const;

private:
  std::vector<std::vector<Id>> SentTo_;       ///< Points of the piece, by owner.
  std::vector<std::vector<Id>> ReceivedFrom_; ///< Which points of seams those of others are.
  Id NumberOfOwned_ = 0;                      ///< Points of seams.
};

template <typename T>
std::vector<Id> PieceSeams::TakeLeast(Ranks& ranks, std::vector<T>& ofPiece) const
{
  std::vector<std::vector<T>> values(this->SentTo_.size());
  for (std::size_t rank = 0; rank < values.size(); ++rank)
  {
    for (const Id p : this->SentTo_[rank])
    {
      values[rank].push_back(ofPiece[p]);
    }
  }
  values = ExchangeValues(ranks, std::move(values));
  std::vector<T> least(this->NumberOfOwned_);
  std::vector<std::uint8_t> isKnown(least.size(), 0);
  for (std::size_t rank = 0; rank < values.size(); ++rank)
  {
    for (std::size_t i = 0; i < values[rank].size(); ++i)
    {
      const Id seam = this->ReceivedFrom_[rank][i];
      least[seam] = isKnown[seam] != 0 ? std::min(least[seam], values[rank][i]) : values[rank][i];
      isKnown[seam] = 1;
    }
  }
  for (std::size_t rank = 0; rank < values.size(); ++rank)
  {
    for (std::size_t i = 0; i < values[rank].size(); ++i)
    {
      values[rank][i] = least[this->ReceivedFrom_[rank][i]];
    }
  }
  values = ExchangeValues(ranks, std::move(values));
  std::vector<Id> lowered;
  for (std::size_t rank = 0; rank < values.size(); ++rank)
  {
    for (std::size_t i = 0; i < values[rank].size(); ++i)
    {
      const Id p = this->SentTo_[rank][i];
      if (values[rank][i] < ofPiece[p])
      {
        ofPiece[p] = values[rank][i];
        lowered.push_back(p);
      }
    }
  }
  return lowered;
}

} // namespace ridges

#endif
