// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_BorderStrip_h
#define ridges_BorderStrip_h

#include "Mesh/TriangleMesh.h"

#include <cstdint>
#include <vector>

namespace ridges
{

/**
 * Per point, whether its neighbourhood is one-sided: whether the border is no farther than the
 * radius of its fit, along edges; without radii, whether it is on the border. Empty on a mesh
 * without a border. The edges of the mesh have to be built.
 */
std::vector<std::uint8_t> BorderStrip(const TriangleMesh& mesh, const double* radii);

/**
 * Distances along edges, as far as they are not larger than `farthest`: those of the points `from`
 * are given, and others become smaller where a way from these is shorter.
 */
void SpreadDistances(const TriangleMesh& mesh, const std::vector<Id>& from, double farthest,
  std::vector<double>& distances);

/// The strip from the distances to the border.
std::vector<std::uint8_t> StripWithin(const std::vector<double>& distances, const double* radii);

/// Whether any corner of a triangle is in the strip.
inline bool IsInStrip(const TriangleMesh& mesh, const std::vector<std::uint8_t>& strip, Id triangle)
{
  const Triangle& c = mesh.Corners(triangle);
  return !strip.empty() && (strip[c[0]] != 0 || strip[c[1]] != 0 || strip[c[2]] != 0);
}

} // namespace ridges

#endif
