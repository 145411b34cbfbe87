// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_ZoneDoubt_h
#define ridges_ZoneDoubt_h

#include "Mesh/IdTable.h"
#include "Ridges/ExtremalityErrors.h"
#include "Ridges/RidgeAssembly.h"

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
  /// Both have to outlive the object. Errors that have not begun.
  ZoneDoubt(const TriangleMesh& mesh, ExtremalityErrors& errors)
    : Mesh_(mesh)
    , Errors_(errors)
  {
  }

  bool IsOutside(const Ridge& ridge);

private:
  bool IsNearOthers(Id p);
  bool LooksNearOthers(Id p);
  bool IsInNone(Id p);
  bool GrowsIntoNone(Id first);

  const TriangleMesh& Mesh_;
  ExtremalityErrors& Errors_;
  IdTable<bool> IsNear_;   ///< Of points that were asked for.
  IdTable<bool> IsInNone_; ///< Of the points of regions: whether these are certainly no zones.
};

} // namespace ridges

#endif
