// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_RingNeighborhood_h
#define ridges_RingNeighborhood_h

#include "Mesh/OrderedRings.h"

#include <functional>

namespace ridges
{

/// How far a neighbourhood reaches.
struct NeighborhoodRule
{
  enum class Kind
  {
    PointCount,         ///< Whole rings until there are at least `minimumNumberOfPoints` points.
    Rings,              ///< Exactly `numberOfRings` rings.
    RingsAndPointCount, ///< Whole rings until there are at least that many rings and points.
    Radius              ///< The points connected to the vertex inside the ball of that `radius`.
  };
  Kind kind = Kind::PointCount;
  int minimumNumberOfPoints = 18;
  int numberOfRings = 2;
  double radius = 0.0;
};

/**
 * Gathers the points around a vertex, walking along edges only, so that the other side of a thin
 * wall is never taken. From a point with very many neighbours the walk goes on to some of them
 * only, all around it (see OrderedRings): so neighbourhoods stay balanced, and of a bounded size.
 * Holds scratch memory: use one per thread.
 */
class RingNeighborhood
{
public:
  RingNeighborhood(const TriangleMesh& mesh, const OrderedRings& rings);

  /**
   * The vertex, and then ring after ring of the points around it, in an order that does not depend
   * on the numbering of the mesh, so that neither does a sum taken in it. Valid until the next
   * call.
   */
  Span<Id> Gather(Id vertex, const NeighborhoodRule& rule);

  /// The same of points that are accepted only, and reached over such points.
  Span<Id> Gather(
    Id vertex, const NeighborhoodRule& rule, const std::function<bool(Id)>& isAccepted);

  /// The last neighbourhood with one ring more; the same one if there is nothing around it.
  Span<Id> Grow();

  /// Number of rings that the last call completed (0 for a radius).
  int NumberOfRings() const { return this->NumberOfRings_; }

  /// The most rings that any call since the last one of this kind has reached over, by radius or
  /// not: what lies around farther points was not looked at.
  int TakeReach()
  {
    const int reach = this->Reach_;
    this->Reach_ = 0;
    return reach;
  }

  /// Whether the last call gave the vertex and then its ring in order, as OrderedRings has it.
  /// Where points share a place, so that the order of rings would depend on the numbering, it gave
  /// all points by distance.
  bool IsInRings() const { return this->IsInRings_; }

private:
  void Begin(Id vertex);
  template <typename Accept>
  void AddRings(const NeighborhoodRule& rule, Accept accept);
  bool AddTwoRings();
  template <typename Accept>
  bool AddRing(Accept accept);
  Span<Id> NeighborsOfIrregular(Id p);
  bool ComesBefore(Id center, Id p, Id q) const;
  Span<Id> Result();

  const TriangleMesh& Mesh_;
  const OrderedRings& Rings_;
  std::vector<std::uint16_t> Stamps_; ///< Of the whole mesh: faster than a table of those around.
  std::uint16_t Stamp_ = 0;
  std::vector<Id> Points_; ///< Longer than the neighbourhood, which has Count_ points.
  Id Count_ = 0;
  Id RingBegin_ = 0;
  int NumberOfRings_ = 0;
  int RingsWalked_ = 0; ///< As NumberOfRings_, but for a radius, too.
  int Reach_ = 0;
  bool IsInRings_ = true;
  std::vector<Id> Irregular_; ///< Neighbours of the irregular point visited last.
  std::vector<Id> Sorted_;
};

} // namespace ridges

#endif
