// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_OrderedRings_h
#define ridges_OrderedRings_h

#include "Mesh/TriangleMesh.h"

namespace ridges
{

/**
 * The neighbours of each point in the order in which its triangles turn around it, from a start
 * that does not depend on the numbering of the mesh: on the border the first point of the fan, else
 * the first neighbour by position. Walking over neighbourhoods in this order makes sums over them
 * reproducible under renumbering, and needs no sorting.
 */
class OrderedRings
{
public:
  /// Room for the rings of all points, none of them known yet.
  explicit OrderedRings(const TriangleMesh& mesh);

  /// Finds the rings of the points [begin, end). Different ranges may be built at the same time.
  void Build(Id begin, Id end);

  /// So many ids can be read from where any ring begins, whatever its size.
  static constexpr Id ReadableIds = 8;

  /// Points with more triangles are not regular, and so many of their neighbours stand for all.
  static constexpr Id LargestFan = 32;
  static constexpr Id NeighborsOfLargeFan = 16;

  /// The neighbours of p in order. Empty for a point without triangles, and for one that is not
  /// regular; but of the neighbours of a point with more than `LargestFan` triangles so many that
  /// lie around it as evenly as possible.
  Span<Id> Around(Id p) const
  {
    const Id* first = this->Rings_.data() + this->Offset(p);
    return { first, first + this->Sizes_[p] };
  }

  /// Whether the triangles at p form one fan, open or closed, in one orientation.
  bool IsRegular(Id p) const { return this->Kinds_[p] <= Kind::Open; }

  /// Whether they form a closed fan in one orientation.
  bool IsClosed(Id p) const { return this->Kinds_[p] <= Kind::ClosedFromAny; }

  /// Whether two neighbours at one place are both the first: then the start depends on the
  /// numbering.
  bool StartsAtAny(Id p) const { return this->Kinds_[p] == Kind::ClosedFromAny; }

  /// Whether an edge at p does not have exactly two triangles.
  bool OnBorder(Id p) const
  {
    return this->Kinds_[p] == Kind::Open || this->Kinds_[p] == Kind::IrregularOnBorder;
  }

  /// Whether any point with triangles is not regular.
  bool HasIrregular() const;

private:
  enum class Kind : std::uint8_t
  {
    Closed,
    ClosedFromAny,
    Open,
    Irregular,
    IrregularOnBorder
  };

  /// An open fan has a neighbour more than triangles.
  std::size_t Offset(Id p) const { return static_cast<std::size_t>(this->Mesh_.Offset(p)) + p; }
  bool BuildSmallRing(Id p, Id* ring, Kind& kind) const;
  Kind BuildRing(Id p, Id* ring, std::uint8_t& size) const;
  Kind KindOfIrregular(Id p) const;
  Id FirstOf(const Id* points, Id size, Kind& kind) const;
  Id PickEvenly(Id p, Id* ring) const;

  const TriangleMesh& Mesh_;
  Buffer<Id> Rings_;
  std::vector<std::uint8_t> Sizes_;
  std::vector<Kind> Kinds_;
};

} // namespace ridges

#endif
