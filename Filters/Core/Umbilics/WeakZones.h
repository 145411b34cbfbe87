// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_WeakZones_h
#define ridges_WeakZones_h

#include "Mesh/TriangleMesh.h"

namespace ridges
{

/**
 * Connected triangles on which k1 - k2 is nowhere significant, as on spheres and planes: what is
 * inside is neither an umbilic nor free of them, but undecided. Those without a point that is
 * inside are too small to speak of and left out.
 */
std::vector<std::vector<Id>> WeakZones(
  const TriangleMesh& mesh, const std::vector<std::uint8_t>& isWeak);

} // namespace ridges

#endif
