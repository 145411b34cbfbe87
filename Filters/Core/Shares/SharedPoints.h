// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_SharedPoints_h
#define ridges_SharedPoints_h

#include "Base/RankRows.h"
#include "Mesh/Triangle.h"

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace ridges
{

/// What a rank has of a mesh to begin with, owned by somebody else.
struct MeshPiece
{
  const double* points = nullptr; ///< x, y, z
  Id numberOfPoints = 0;
  Span<Triangle> triangles;
  const std::int64_t* globalIds = nullptr; ///< Of points; may be null.
};

/**
 * The points of a mesh that comes in pieces, each owned by one rank, and numbered through: first
 * those of rank 0. What belongs to whom is decided by position, so that ranks own about as many
 * points each, and such as lie together, whatever the pieces are.
 *
 * Points at one place, in different pieces, are one point. Where a piece has several at one place,
 * and another piece has one there, too, global ids decide which are the same.
 */
class SharedPoints
{
public:
  /// All ranks have to call this. What is wrong with the piece, if anything is.
  std::string Share(Ranks& ranks, const MeshPiece& piece);

  Id NumberOfOwned() const { return static_cast<Id>(this->Owned_.size() / 3); }

  /// x, y, z of the owned points.
  const std::vector<double>& Owned() const { return this->Owned_; }

  /// Those that share a place with another, in ascending order.
  const std::vector<Id>& Coincident() const { return this->Coincident_; }

  /// The number of the first point that a rank owns; of the rank after the last: how many there
  /// are.
  std::int64_t First(int rank) const { return this->First_[rank]; }
  std::int64_t NumberOfAll() const { return this->First_.back(); }
  int OwnerOf(std::int64_t number) const;

  /// Takes points that are all on one rank.
  void TakeWhole(std::vector<double> positions, std::vector<Id> coincident);

  /// Of this rank's piece.
  Id NumberOfPoints() const;

  /// The numbers of the points of the piece. All ranks have to call this.
  std::vector<std::int64_t> NumbersOfPiece(Ranks& ranks) const;

  /// Points of the piece by the rank that owns them.
  const std::vector<std::vector<Id>>& SentTo() const { return this->SentTo_; }

  /// Which owned points those are that each rank has sent.
  const std::vector<std::vector<Id>>& ReceivedFrom() const { return this->ReceivedFrom_; }

  /// Rows of `width` values for the owned points become rows for the points of the piece. All
  /// ranks have to call this.
  template <typename T>
  std::vector<T> ToPiece(Ranks& ranks, const T* owned, int width) const;

  /// The same into memory that there is.
  template <typename T>
  void ToPiece(Ranks& ranks, const T* owned, int width, T* ofPiece) const
  {
    ExchangeRows(ranks, owned, width, this->ReceivedFrom_, this->SentTo_, ofPiece);
  }

private:
  struct Arrivals;

  void Number(Ranks& ranks, const Arrivals& arrivals, std::vector<std::vector<Id>>& pointOf);

  std::vector<double> Owned_;
  std::vector<Id> Coincident_;
  std::vector<std::int64_t> First_;
  std::vector<std::vector<Id>> SentTo_;       ///< Points of the piece, by owner.
  std::vector<std::vector<Id>> ReceivedFrom_; ///< Which owned points those of other pieces are.
};

/// What is wrong with so many places, one of which is here, and what would help.
std::string TextOfAmbiguousPlaces(Id count, const std::array<double, 3>& x, const char* help);

template <typename T>
std::vector<T> SharedPoints::ToPiece(Ranks& ranks, const T* owned, int width) const
{
  return ExchangeRows(ranks, owned, width, this->ReceivedFrom_, this->SentTo_);
}

} // namespace ridges

#endif
