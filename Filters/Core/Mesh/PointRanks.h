// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_PointRanks_h
#define ridges_PointRanks_h

#include "Base/Types.h"

#include <cstdint>
#include <mutex>
#include <utility>
#include <vector>

namespace ridges
{

class TriangleMesh;

/**
 * An order of points that share one place, as rounding may leave them, which does not depend on
 * their numbers: they are ordered by what lies around them.
 *
 * This is color refinement. The first color of a point is its position. Each round mixes in the
 * colors of its triangles, until a round distinguishes no further points. Colors are hashed to 64
 * bits. Points whose colors are equal at the end are alike: exchanging them leaves the mesh
 * as it was.
 */
class PointRanks
{
public:
  /// The same number for points that nothing distinguishes, and 0 for points that are alone in
  /// their place. The first call, from whatever thread, computes the ranks of all points.
  std::uint64_t RankOf(const TriangleMesh& mesh, Id point);

  /// What RankOf shall give, by id in ascending order, and 0 for all others. Before its first call.
  void Set(std::vector<std::pair<Id, std::uint64_t>> ranks)
  {
    std::call_once(this->Once_, [this, &ranks] { this->Ranks_ = std::move(ranks); });
  }

private:
  void Build(const TriangleMesh& mesh);

  std::once_flag Once_;
  std::vector<std::pair<Id, std::uint64_t>> Ranks_; ///< Of points that share a place, by id.
};

} // namespace ridges

#endif
