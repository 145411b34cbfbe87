// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Coherence/CheckCoherence.h"

#include "Coherence/EdgeChecks.h"
#include "Coherence/PatchChecks.h"
#include "Coherence/RidgeChecks.h"
#include "Coherence/UmbilicChecks.h"

namespace ridges
{

// Where a formula of the surface is known, two more belong here, which would be given exact
// directions and extremalities besides the picture: that at every edge the acute rule orients as
// continuity along it does (definition 5), and that no edge is crossed more than once by the exact
// ridges (2.2d and hypothesis 3), to be found by subdivision.

std::vector<CoherenceCheck> CheckCoherence(const RidgePicture& picture, double leastCosine)
{
  const std::vector<WholeRidge> ridges = FindWholeRidges(picture);
  return { CheckIndexSum(picture), CheckUmbilicsPerTriangle(picture),
    CheckRidgesAtUmbilics(picture, ridges), CheckTypesAtUmbilics(picture, ridges),
    CheckRidgeEnds(picture, ridges), CheckTurningPoints(picture, ridges),
    CheckNoIntersections(picture, ridges), CheckPatches(picture),
    CheckRidgesInPatches(picture, ridges), CheckPatchContours(picture, ridges),
    CheckRightAngles(picture, leastCosine), CheckSingleCrossings(picture, ridges),
    CheckPointsOnEdges(picture, ridges), CheckCrossings(picture, ridges) };
}

} // namespace ridges
