// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_PairCancellation_h
#define ridges_PairCancellation_h

#include "Umbilics/IndexCharge.h"

namespace ridges
{

struct Cancellation
{
  /// Connected triangles with umbilics in them whose indices sum to 0. No two regions share any.
  std::vector<std::vector<Id>> regions;
  std::vector<IndexCharge> kept;
};

/**
 * Cancels umbilics of opposite index that noise has made: those with a way between them through
 * weak triangles, on which k1 - k2 does not differ significantly from 0, and those side by side.
 * The nearest go first, as measured along such ways, until no way joins two opposite ones. The sum
 * of the indices stays what it is, in each part of the mesh.
 *
 * The result does not depend on the numbering of the mesh.
 */
Cancellation CancelPairs(const TriangleMesh& mesh, std::vector<IndexCharge> charges,
  const std::vector<std::uint8_t>& isWeak);

} // namespace ridges

#endif
