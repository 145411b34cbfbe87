// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_SharedMesh_h
#define ridges_SharedMesh_h

#include "Mesh/TriangleMesh.h"
#include "Shares/MergedPieces.h"
#include "Shares/SharedPoints.h"
#include "Shares/SparseIds.h"

#include <array>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ridges
{

/// Triangles that one rank sends to another, and the positions of those corners that the other does
/// not have.
/// Points and triangles have numbers in the whole mesh.
struct MeshPatch
{
  struct Corner
  {
    std::int64_t number;
    std::array<double, 3> x;
  };
  struct Cell
  {
    std::int64_t number;
    std::array<std::int64_t, 3> corners;
  };
  std::vector<Corner> points;
  std::vector<Cell> triangles;
  std::vector<Id> counts; ///< Of the points that were asked for: how many triangles they have,
  std::vector<Id> around; ///< and which.
};

/**
 * A mesh that comes in pieces, any pieces, and of which each rank then owns some points, with all
 * triangles around them. Whoever needs the surroundings of points gets them as a MeshShare: the
 * ranks that own what is missing are asked, ring after ring.
 */
class SharedMesh
{
public:
  /// All ranks have to call this. What is wrong with the pieces, the same text on all of them.
  std::string Share(Ranks& ranks, const MeshPiece& piece);

  /// Takes a mesh that is all on one rank, whose pieces came one after the other.
  void TakeWhole(MergedPieces& pieces, const RangeLoop& loop = TriangleMesh::InOneRange);

  const SharedPoints& Points() const { return this->Points_; }

  /// The points go to somebody else, and nothing else is left.
  SharedPoints TakePoints() { return std::move(this->Points_); }

  Id NumberOfOwned() const { return this->Points_.NumberOfOwned(); }

  /// The owned points, first, and the triangles around them. There are other points, but it is not
  /// known here where.
  const TriangleMesh& Around() const { return this->Around_; }

  /// Forgets everything but the points.
  void Release();

  /// Of all ranks.
  std::int64_t NumberOfTriangles() const { return this->NumberOfTriangles_; }

private:
  friend class MeshShare;

  void SendTriangles(Ranks& ranks, const MeshPiece& piece);
  void SendSome(Ranks& ranks, const MeshPiece& piece, const std::vector<std::int64_t>& numbers,
    Id begin, Id end, std::int64_t first);
  void RankCoincident(Ranks& ranks);
  MeshPatch PatchAround(const std::vector<Id>& owned) const;
  std::vector<Id> Take(const MeshPatch& patch);
  Id LocalOf(std::int64_t number) const;
  Id AddPoint(const MeshPatch::Corner& corner);
  std::int64_t NumberOf(Id local) const;
  void Ask(Ranks& ranks, const std::vector<Id>& points);
  bool IsComplete(Id local) const
  {
    return local < this->NumberOfOwned() || this->RowOf_[local - this->NumberOfOwned()].first >= 0;
  }
  Span<Id> TrianglesAround(Id local) const;

  SharedPoints Points_;
  int Rank_ = 0;
  std::int64_t NumberOfTriangles_ = 0;

  const double* Position(Id local) const
  {
    const Id owned = this->NumberOfOwned();
    return local < owned
      ? this->Points_.Owned().data() + 3 * static_cast<std::size_t>(local)
      : this->PositionsOfOthers_.data() + 3 * static_cast<std::size_t>(local - owned);
  }
  const Triangle& Corners(Id t) const
  {
    const Id first = this->Around_.NumberOfTriangles();
    return t < first ? this->Around_.Corners(t) : this->Triangles_[t - first];
  }
  std::size_t NumberOfTrianglesHere() const
  {
    return static_cast<std::size_t>(this->Around_.NumberOfTriangles()) + this->Triangles_.size();
  }
  Id NumberOfPoints() const
  {
    return this->NumberOfOwned() + static_cast<Id>(this->NumbersOfOthers_.size());
  }

  // Owned points and the triangles around them come first. Others stay once they are known.
  std::vector<double> PositionsOfOthers_;
  std::vector<std::int64_t> NumbersOfOthers_;
  std::unordered_map<std::int64_t, Id> Others_; ///< By number.
  std::vector<Triangle> Triangles_;             ///< Those that are not in Around_.
  std::vector<std::int64_t> TriangleNumbers_;
  std::unordered_map<std::int64_t, Id> TriangleOf_; ///< Those at points of others.
  TriangleMesh Around_;                             ///< Those around owned points.
  std::vector<std::pair<std::int64_t, Id>> RowOf_;  ///< Of others: where in Rows_; -1: unknown.
  std::vector<Id> Rows_;
  std::vector<std::pair<std::int64_t, std::uint64_t>> RanksAtPlace_; ///< By number: see PointRanks.
};

/**
 * Some points, first, and the triangles around all points that are within so many rings of them:
 * of the rings up to that one nothing is missing.
 */
class MeshShare
{
public:
  /// All ranks have to call this, each with owned points of its own, or none.
  MeshShare(Ranks& ranks, SharedMesh& shared, std::vector<Id> points, int rings,
    const RangeLoop& loop = TriangleMesh::InOneRange, Id shares = 1);

  const TriangleMesh& Mesh() const { return this->Mesh_; }

  /// The mesh goes to somebody else; the points, whose memory stays, are needed as long as it is.
  TriangleMesh TakeMesh() { return std::move(this->Mesh_); }

  /// Whether an edge from one of the points that come first to any other belongs to this one: each
  /// edge belongs to one end.
  bool IsFirstEnd(Id p, Id q) const { return this->Numbers_[p] < this->Numbers_[q]; }

  /// Its points, if all are this rank's own.
  std::vector<Id> Owned() const;

  /// So many points come first.
  Id NumberOfInner() const { return this->NumberOfInner_; }

  /// Rows of `width` values for the owned points of each rank become rows for the points of the
  /// share. All ranks have to call this.
  template <typename T>
  std::vector<T> Rows(Ranks& ranks, const T* owned, int width) const;

private:
  static std::vector<Id> Spread(
    Ranks& ranks, SharedMesh& shared, std::vector<Id>& points, SparseIds& ownId, int rings);

  std::vector<std::int64_t> Numbers_;
  std::vector<double> Positions_;
  TriangleMesh Mesh_;
  Id NumberOfInner_ = 0;
  const SharedPoints& Owners_;
};

template <typename T>
std::vector<T> MeshShare::Rows(Ranks& ranks, const T* owned, int width) const
{
  std::vector<std::vector<std::int64_t>> wanted(ranks.Size());
  std::vector<std::vector<Id>> places(ranks.Size());
  for (std::size_t p = 0; p < this->Numbers_.size(); ++p)
  {
    const int owner = this->Owners_.OwnerOf(this->Numbers_[p]);
    wanted[owner].push_back(this->Numbers_[p]);
    places[owner].push_back(static_cast<Id>(p));
  }
  const std::int64_t first = this->Owners_.First(ranks.Rank());
  std::vector<std::vector<Id>> asked(ranks.Size());
  const auto numbers = ExchangeValues(ranks, std::move(wanted));
  for (std::size_t rank = 0; rank < numbers.size(); ++rank)
  {
    asked[rank].reserve(numbers[rank].size());
    for (const std::int64_t number : numbers[rank])
    {
      asked[rank].push_back(static_cast<Id>(number - first));
    }
  }
  return ExchangeRows(ranks, owned, width, asked, places);
}

} // namespace ridges

#endif
