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
 * An order of points at one place, where rounding has put them, that the numbering has no part in:
 * by what lies around them.
 *
 * Each point has a color, first its position. Then it is that and the colors of its triangles, as
 * long as this tells more points at one place apart (color refinement). Colors are hashed to 64
 * bits. Points that are equal in the end are alike: to exchange them leaves the mesh as it was.
 */
class PointRanks
{
public:
  /// The same number for points that nothing distinguishes, and 0 for all that are alone in their
  /// place. All ranks are computed when one is asked for first, by whatever thread.
  std::uint64_t RankOf(const TriangleMesh& mesh, Id point);

private:
  void Build(const TriangleMesh& mesh);

  std::once_flag Once_;
  std::vector<std::pair<Id, std::uint64_t>> Ranks_; ///< Of points that share a place, by id.
};

} // namespace ridges

#endif
