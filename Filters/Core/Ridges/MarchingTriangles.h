// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_MarchingTriangles_h
#define ridges_MarchingTriangles_h

#include "Ridges/RidgeCrossings.h"
#include "Ridges/RidgeType.h"

#include <vector>

namespace ridges
{

/**
 * A piece of a ridge inside one triangle: from edge to edge in a regular triangle, from an edge
 * to the umbilic in a singular one.
 */
struct RidgeSegment
{
  static constexpr Id ToUmbilic = -1;
  static constexpr Id NoPath = -1;

  Id triangle;
  Id edge0;
  Id edge1; ///< Or ToUmbilic.
  RidgeType type;
  Id path = NoPath; ///< Index of a RidgePath, for a piece that passes through more triangles.
};

/// What a piece of a ridge passes through on its way from edge0 to edge1.
struct RidgePath
{
  std::vector<Id> edges;
  std::vector<RidgePoint> points;
};

/**
 * Appends the pieces of ridges inside a triangle, between the crossings of its edges: none or one
 * in a regular triangle, one or three in a singular one.
 *
 * By the fourth order a piece has the type of P at its middle, so that of two ends of different
 * type the one nearer to the turning point takes the change. A piece that ends at an umbilic is
 * hyperbolic, as every ridge is there (section 6.5); one between crossings of different colours,
 * by the Gaussian rule, is undecided.
 */
void MarchTriangle(
  const RidgeCrossings& crossings, TypeRule rule, Id triangle, std::vector<RidgeSegment>& segments);

} // namespace ridges

#endif
