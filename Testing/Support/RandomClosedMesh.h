// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Closed meshes as bad as they can be.

#ifndef RIDGES_TESTING_RANDOM_CLOSED_MESH_H
#define RIDGES_TESTING_RANDOM_CLOSED_MESH_H

#include "TestMeshes.h"

#include <cstdint>

namespace ridges
{
namespace testing
{

struct RandomClosedMesh
{
  Mesh mesh;
  int eulerCharacteristic = 0; // Of the surface, cut apart where it touches itself in a point.
};

// A sphere, a torus or two surfaces, oriented; triangles divided at random, so that points have any
// valence; flattened, noisy, of a size between 1e-150 and 1e150; maybe with points where it touches
// itself. Coordinates are rounded so coarsely that about a share of the triangles between none and
// one half have no area.
RandomClosedMesh MakeRandomClosedMesh(std::uint64_t seed);

// The share of triangles of no area.
double ShareWithoutArea(const Mesh& mesh);

} // namespace testing
} // namespace ridges

#endif
