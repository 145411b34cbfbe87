// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_IndexCharge_h
#define ridges_IndexCharge_h

#include "Umbilics/DirectionIndex.h"

namespace ridges
{

/// A triangle around which the principal directions turn.
struct IndexCharge
{
  Id triangle;
  int halfTurns; ///< Twice the index, not 0.
};

/// All half turns together.
int SumOf(const std::vector<IndexCharge>& charges);

/// By x, then y, then z of the triangles: an order that the numbering has no part in.
void SortByPosition(const TriangleMesh& mesh, std::vector<IndexCharge>& charges);

/**
 * Where directions turn by more than half a turn around one triangle, which hardly happens where
 * they mean anything, gives the excess to the nearest triangle of the opposite sign, if there is
 * one in reach. Sums stay what they are.
 */
void SpreadLargeCharges(const TriangleMesh& mesh, std::vector<IndexCharge>& charges);

/**
 * What the directions around triangles that have none themselves, as no fit was possible, demand
 * of their inside: each connected region's half turns, one by one on triangles of it.
 */
std::vector<IndexCharge> ChargesOfUnusable(const TriangleMesh& mesh, const DirectionIndex& index);

} // namespace ridges

#endif
