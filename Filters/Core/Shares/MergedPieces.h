// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_MergedPieces_h
#define ridges_MergedPieces_h

#include "Base/Buffer.h"
#include "Shares/IdRuns.h"
#include "Shares/SharedPoints.h"

#include <array>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace ridges
{

/**
 * A mesh whose pieces come one after the other, each of which is forgotten by the caller before the
 * next: positions and triangles, and which points are those of each piece. Points of different
 * pieces at one place are one point; two of one piece are two, and no other piece may have a point
 * there. Points are numbered as they come first, but those of no triangle last.
 */
class MergedPieces
{
public:
  explicit MergedPieces(int expectedPieces)
    : Expected_(expectedPieces)
  {
  }

  void Add(const MeshPiece& piece);

  /// After the last piece: what is wrong; empty if nothing is.
  std::string Finish();

  int NumberOfPieces() const { return static_cast<int>(this->PointsOf_.size()); }
  Id NumberOfPoints() const { return static_cast<Id>(this->Positions_.size() / 3); }

  /// The points that those of a piece are.
  std::vector<Id> PointsOf(int piece) const { return this->PointsOf_[piece].Ids(); }

  /// The first triangle of a piece; of the piece after the last: how many there are.
  Id FirstTriangle(int piece) const { return this->FirstTriangle_[piece]; }

  /// Both can be taken, once.
  std::vector<double>& Positions() { return this->Positions_; }
  Buffer<Triangle>& Triangles() { return this->Triangles_; }

  /// Points that share a place with another, in ascending order.
  std::vector<Id>& Coincident() { return this->Coincident_; }

private:
  struct Unused
  {
    int piece;
    Id point; ///< Of the piece.
    std::array<double, 3> x;
  };

  std::size_t SlotOf(const std::array<double, 3>& x) const;
  std::array<double, 3> PlaceOf(Id p) const;
  void MakeRoom(const MeshPiece& piece);
  Id Append(const std::array<double, 3>& x);
  Id Take(const std::array<double, 3>& x, Id firstOfPiece);
  Id AppendBeside(Id first, const std::array<double, 3>& x);
  bool IsTheOneBefore(const IdRuns& points) const;
  void TakeUnused();
  void TakeUnusedOf(
    int piece, std::vector<Unused>::const_iterator begin, std::vector<Unused>::const_iterator end);
  void GrowTable(std::size_t places);

  std::vector<double> Positions_;
  int Expected_;
  Buffer<Triangle> Triangles_; ///< Larger than it has to be, before the end.
  std::vector<IdRuns> PointsOf_;
  std::vector<Id> FirstTriangle_{ 0 };
  std::vector<Unused> Unused_; ///< By triangles.
  std::vector<Id> Coincident_;
  std::vector<Id> Table_; ///< The first point at each place, by a hash of it; -1: none.
  std::set<Id> Several_;  ///< First points at places where a piece has more.
  std::set<Id> Met_;      ///< Points of earlier pieces that the one that is added has, too.
  std::set<Id> Ambiguous_;
  bool IsRepeated_ = false; ///< Whether a piece is the same as the one before.
};

} // namespace ridges

#endif
