// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_ZoneDoubt_h
#define ridges_ZoneDoubt_h

#include "Mesh/IdTable.h"
#include "Ridges/ExtremalityErrors.h"
#include "Ridges/RidgeAssembly.h"

#include <functional>
#include <utility>

namespace ridges
{

/**
 * Whether a ridge is certainly not wholly in a zone (see RidgeZones.h), by what lies around it: for
 * who does not have the whole mesh, or has no verdicts for all of it. It looks no farther than the
 * region in which the ridge is.
 */
class ZoneDoubt
{
public:
  using VerdictOf = std::function<ExtremalityErrors::Verdict(Id)>;

  /// The mesh has to outlive the object. The verdict on a point is asked for where it is needed.
  ZoneDoubt(const TriangleMesh& mesh, VerdictOf verdictOf)
    : Mesh_(mesh)
    , VerdictOf_(std::move(verdictOf))
  {
  }

  bool IsOutside(const Ridge& ridge);

private:
  bool IsNearOthers(Id p);
  bool LooksNearOthers(Id p);
  bool IsInNone(Id p);
  bool GrowsIntoNone(Id first);

  const TriangleMesh& Mesh_;
  VerdictOf VerdictOf_;
  IdTable<bool> IsNear_;   ///< Of points that were asked for.
  IdTable<bool> IsInNone_; ///< Of the points of regions: whether these are certainly no zones.
};

} // namespace ridges

#endif
