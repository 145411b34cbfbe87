// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_DirectionIndex_h
#define ridges_DirectionIndex_h

#include "Mesh/TriangleMesh.h"
#include "Monge/MongeField.h"
#include "Umbilics/DirectionFan.h"

#include <array>

namespace ridges
{

/// Whether directions may turn around a triangle: not if it is regular and they turn by less than
/// 60 degrees on each of its edges, as long as the surface does not bend much there.
bool DirectionsMayTurn(const MongeField& field, const Triangle& corners);

/**
 * The index of the principal directions around triangles: a number of half turns that, summed over
 * a closed oriented surface, is twice its Euler characteristic. Not nearly: on any mesh and with
 * any directions, as nothing in it is measured twice in different ways (Poincare-Hopf).
 *
 * Around each point the angles of its triangles are stretched so that they sum to a full turn. A
 * direction is carried along an edge by keeping its angle with the edge, and its turn on the edge
 * is what it then differs by from the direction at the other end, which the acute rule picks from
 * the two possible ones. Around a triangle the turns of the edges and the turn of what is carried
 * around, by which its three stretched angles exceed half a turn, make whole half turns. Over a
 * surface the former cancel, as each edge is run through in both senses, and the latter sum to
 * the Euler characteristic.
 *
 * An odd number of half turns is what IsRegular tells: the index says the sign as well.
 *
 * On a border, where nothing has to sum to anything, a triangle with hardly any area may be folded
 * back, as between the nearly coincident points of a seam that is closed in parts. Its angles turn
 * though the directions do not: then there are no half turns.
 */
class DirectionIndex
{
public:
  /// `usable` tells the points that have directions, one flag for each; null means all.
  DirectionIndex(const TriangleMesh& mesh, const MongeField& field, const std::uint8_t* usable);

  bool IsUsable(Id triangle) const
  {
    return AreUsable(this->Mesh_.Corners(triangle), this->Usable_);
  }

  /// Whether all triangles are known to be.
  bool AllAreUsable() const { return this->Usable_ == nullptr; }

  /**
   * Whether the triangle may have an index other than 0: it is singular, or the surface or the
   * directions turn so fast there that two half turns are possible. A cheap test, by rule of
   * thumb: who needs certainty compares the sum of all indices with the Euler characteristic.
   * `isTame` holds a flag for each point.
   */
  bool MayTurn(Id triangle, const std::vector<std::uint8_t>& isTame) const;

  /// Half turns around a triangle whose points are all usable: 0, 1, -1, and hardly ever more.
  int HalfTurns(Id triangle, DirectionFans::Memory& memory) const;
  int HalfTurns(Id triangle) const;

  /// Half turns around connected triangles of which some may not be usable, but all next to them
  /// are.
  int HalfTurns(const std::vector<Id>& region) const;

private:
  using Directions = std::array<CornerDirection, 3>;

  Directions DirectionsAt(Id triangle, DirectionFans::Memory& memory) const;
  double TurnWithin(Id triangle, int side, const Directions& at) const;
  double TurnForBoth(Id triangle, int side, DirectionFans::Memory& memory) const;
  double Turned(Id triangle, DirectionFans::Memory& memory) const;
  bool IsFoldOnBorder(Id triangle) const;

  const TriangleMesh& Mesh_;
  MongeField Field_;
  const std::uint8_t* Usable_;
  DirectionFans Fans_;
};

} // namespace ridges

#endif
