// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_RidgeAssembly_h
#define ridges_RidgeAssembly_h

#include "Ridges/MarchingTriangles.h"

#include <cstdint>
#include <vector>

namespace ridges
{

/**
 * A whole ridge of one colour: a loop, or a curve between umbilics and borders. Node i and i + 1
 * are the ends of segment i; a loop repeats its first node at its end.
 *
 * A node is an edge of the mesh, or, only at an end, the umbilic of a singular triangle: then it
 * is AtUmbilic(triangle).
 */
struct Ridge
{
  static constexpr Id AtUmbilic(Id triangle) { return -1 - triangle; }
  static constexpr bool IsUmbilic(Id node) { return node < 0; }
  static constexpr Id TriangleOfUmbilic(Id node) { return -1 - node; }

  std::vector<Id> nodes;
  std::vector<Id> segments; ///< Indices into the segments assembled.
  bool closed = false;
};

/**
 * Joins segments of one colour end to end, in time linear in their number. Every segment comes out
 * in exactly one ridge. Ridges stop at umbilics, on the border and at non-manifold edges, and
 * nowhere else.
 */
std::vector<Ridge> AssembleRidges(
  const RidgeCrossings& crossings, const std::vector<RidgeSegment>& segments);

/// Removes the ridges with a mark other than 0; the others stay in order.
void LeaveOut(std::vector<Ridge>& ridges, const std::vector<std::uint8_t>& isLeftOut);

} // namespace ridges

#endif
