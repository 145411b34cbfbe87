// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Coherence/Severity.h"

#include <algorithm>

namespace ridges
{
namespace
{

bool IsInRegion(const Offender& triangle, const RidgePicture& picture)
{
  return picture.RegionOf(triangle.ids[0]) >= 0;
}

bool MayBeNoise(const CoherenceCheck& check, const RidgePicture& picture)
{
  switch (check.kind)
  {
    case CheckKind::UmbilicsPerTriangle:
    case CheckKind::RidgesAtUmbilics:
    case CheckKind::Patches:
    case CheckKind::RidgesInPatches:
    case CheckKind::PatchContours:
    case CheckKind::RightAngles:
      return true;
    case CheckKind::Intersections:
      return std::all_of(check.offenders.begin(), check.offenders.end(),
        [&picture](const Offender& triangle) { return IsInRegion(triangle, picture); });
    case CheckKind::IndexSum:
    case CheckKind::TypesAtUmbilics:
    case CheckKind::RidgeEnds:
    case CheckKind::TurningPoints:
    case CheckKind::DoubleCrossings:
    case CheckKind::PointsOnEdges:
    case CheckKind::Crossings:
      break;
  }
  return false;
}

} // namespace

Severity SeverityOf(const CoherenceCheck& check, const RidgePicture& picture)
{
  if (check.Passed())
  {
    return Severity::None;
  }
  return MayBeNoise(check, picture) ? Severity::Uncertain : Severity::Wrong;
}

} // namespace ridges
