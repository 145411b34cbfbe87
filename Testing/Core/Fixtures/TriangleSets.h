// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// Sets of triangles of a mesh: drawn at random, and what they are as surfaces.

#ifndef RIDGES_TESTING_TRIANGLE_SETS_H
#define RIDGES_TESTING_TRIANGLE_SETS_H

#include "Fixtures/TestFields.h"

#include <cstdint>
#include <random>
#include <vector>

namespace ridges
{
namespace testing
{

// The triangle and those that can be reached from it through edges between triangles of the set,
// in order of discovery.
std::vector<Id> ComponentOf(const TriangleMesh& mesh, Id first, const std::vector<bool>& isInSet);

bool IsConnected(const TriangleMesh& mesh, const std::vector<Id>& triangles);

// Points - edges + triangles of connected triangles, glued along the edges between them only: a
// point where they merely touch counts for each of its sides.
int EulerCharacteristicOf(const TriangleMesh& mesh, const std::vector<Id>& triangles);

// Edges of the triangles without another one of them on the other side.
std::vector<Id> ContourEdges(const TriangleMesh& mesh, const std::vector<Id>& triangles);

// So many connected triangles, or all that there are, grown at random.
std::vector<Id> RandomRegion(
  const TriangleMesh& mesh, std::mt19937_64& generator, std::size_t count);

// Flips edges at random wherever no edge is made twice: points of any valence from 3 on.
Mesh FlipEdges(const Mesh& mesh, std::uint64_t seed, int rounds = 1);

// A renumbered mesh, and what its triangles were before.
struct Renumbered
{
  Renumbered(const Mesh& mesh, std::uint64_t seed);

  std::vector<std::int32_t> oldPoint; // By new number.
  MeshedSurface surface;
  std::vector<Id> newTriangle; // By old number.
};

} // namespace testing
} // namespace ridges

#endif
