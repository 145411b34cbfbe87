// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Ranks that are threads of one process, and meshes cut into pieces for them.

#ifndef RIDGES_TESTING_THREAD_RANKS_H
#define RIDGES_TESTING_THREAD_RANKS_H

#include "Base/Ranks.h"
#include "TestMeshes.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace ridges
{
namespace testing
{

/// Runs body(ranks) on so many ranks at the same time. Throws what any of them throws.
void OnThreadRanks(int count, const std::function<void(Ranks&)>& body);

/// Ways to cut a mesh into pieces.
enum class Partition
{
  Blocks,     ///< Runs of triangles, as they are numbered.
  Strips,     ///< Along x, each two triangles wide or so, in turn.
  Random,     ///< Each triangle anywhere.
  AllOnFirst, ///< One rank has all.
  LastIsEmpty ///< Blocks, but for the last rank.
};
constexpr Partition AllPartitions[] = { Partition::Blocks, Partition::Strips, Partition::Random,
  Partition::AllOnFirst, Partition::LastIsEmpty };

/// The rank that each triangle goes to.
std::vector<int> PartsOf(const Mesh& mesh, Partition partition, int ranks);

/// The triangles of a part, and their points; which of the mesh these are.
struct PieceOfMesh
{
  Mesh mesh;
  std::vector<std::int32_t> points;
  std::vector<std::int32_t> triangles;
};
PieceOfMesh PieceOf(const Mesh& mesh, const std::vector<int>& parts, int part);

} // namespace testing
} // namespace ridges

#endif
