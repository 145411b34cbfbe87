// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_EdgeCertificate_h
#define ridges_EdgeCertificate_h

#include "Certification/Hypothesis.h"
#include "Certification/SurfacePiece.h"

#include <cstdint>

namespace ridges
{

/// What is known of the ridges that cross the image of an edge.
struct EdgeCertificate
{
  std::uint16_t failed = 0; ///< Bits of Hypothesis.
  Eigen::Vector3d place =
    Eigen::Vector3d::Zero(); ///< On the surface, where the first of them fails.
  /// By continuity: +1 if it leads from the first direction given to the second one, -1 if to its
  /// opposite, 0 if unknown.
  int orientation = 0;
  std::array<int, 2> crossings{}; ///< Of blue and red ridges; -1 if unknown.
  /// Of the only crossing, from corner 0 to corner 1, and where it is on the surface.
  std::array<double, 2> parameter{};
  std::array<Eigen::Vector3d, 2> position{ Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero() };
};

/**
 * Follows d1 along the image of the edge from corner 0 to corner 1 of `whole`, and separates the
 * zeros of the extremalities, by bisection. `d1` are stored directions at the two ends. Of a
 * degenerate edge it is known that it is on ridges; only umbilics are looked for.
 */
EdgeCertificate CertifyEdge(const SurfaceBounds& surface, const MappedTriangle& whole,
  const std::array<Eigen::Vector3d, 2>& d1, bool isDegenerate = false);

} // namespace ridges

#endif
