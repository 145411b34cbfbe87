// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_PairCancellation_h
#define ridges_PairCancellation_h

#include "Base/Monitor.h"
#include "Mesh/TriangleGroups.h"
#include "Umbilics/IndexCharge.h"

namespace ridges
{

struct Cancellation
{
  static constexpr Id NoRegion = -1;

  /// Connected triangles with umbilics in them whose indices sum to 0. No two regions share any.
  TriangleGroups regions;
  std::vector<Id> regionOf; ///< For each triangle its region, or NoRegion. Empty without regions.
  std::vector<IndexCharge> kept; ///< By position.

  Id RegionOf(Id triangle) const
  {
    return this->regionOf.empty() ? NoRegion : this->regionOf[triangle];
  }
};

/**
 * Cancels pairs of umbilics of opposite index that noise has caused: those with a path between them
 * through weak triangles, on which k1 - k2 does not differ significantly from 0, and those in
 * neighbouring triangles. The pair with the shortest path of all is cancelled first, and so on
 * until no path joins two opposite umbilics. Of two paths, the one through fewer triangles is the
 * shorter, since noise is independent from point to point; if both have the same number, the one
 * with the shorter line through the centroids. The sum of the indices does not change, in any part
 * of the mesh.
 *
 * The result does not depend on the numbering of the mesh. The time is proportional to the number
 * of triangles, times the logarithm of the length of the longest path.
 */
Cancellation CancelPairs(const TriangleMesh& mesh, std::vector<IndexCharge> charges,
  const std::vector<std::uint8_t>& isWeak, const RangeLoop& loop = TriangleMesh::InOneRange,
  const Monitor& monitor = NeverStops);

} // namespace ridges

#endif
