// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrientFaces_h
#define OrientFaces_h

#include "Reading/PolygonMesh.h"

#include <cstddef>

namespace program
{

struct Orientation
{
  std::size_t turnedFaces = 0;
  /// Edges between two faces that cannot be oriented alike, as on a Moebius strip.
  std::size_t oddEdges = 0;
};

/**
 * Turns faces around so that neighbours run through their edge in opposite senses. Neighbours share
 * an edge that has no third face. Each connected part becomes oriented outwards if it is closed,
 * and as most of its area was before otherwise.
 */
Orientation OrientFaces(PolygonMesh& mesh);

/// Whether the mesh is closed and consistently oriented, but inwards.
bool IsInsideOut(const PolygonMesh& mesh);

} // namespace program

#endif
