// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Coherence/CheckCoherence.h"

#include "Coherence/EdgeChecks.h"
#include "Coherence/PatchChecks.h"
#include "Coherence/RidgeChecks.h"
#include "Coherence/UmbilicChecks.h"

#include <type_traits>

namespace ridges
{

// Where a formula of the surface is known, two more belong here, which would be given exact
// directions and extremalities besides the picture: that at every edge the acute rule orients as
// continuity along it does (definition 5), and that no edge is crossed more than once by the exact
// ridges (2.2d and hypothesis 3), to be found by subdivision.

std::vector<CoherenceCheck> CheckCoherence(
  const RidgePicture& picture, double leastCosine, const Monitor& monitor)
{
  std::vector<WholeRidge> ridges;
  std::vector<CoherenceCheck> results;
  constexpr double steps = 15.0; // with the ridges
  const Monitor within = [&monitor, &results](double done)
  { return monitor((1.0 + static_cast<double>(results.size()) + done) / steps); };
  const std::function<CoherenceCheck()> checks[] = {
    [&picture] { return CheckIndexSum(picture); },
    [&picture] { return CheckUmbilicsPerTriangle(picture); },
    [&picture, &ridges] { return CheckRidgesAtUmbilics(picture, ridges); },
    [&picture, &ridges] { return CheckTypesAtUmbilics(picture, ridges); },
    [&picture, &ridges] { return CheckRidgeEnds(picture, ridges); },
    [&picture, &ridges] { return CheckTurningPoints(picture, ridges); },
    [&picture, &ridges, &within] { return CheckNoIntersections(picture, ridges, within); },
    [&picture] { return CheckPatches(picture); },
    [&picture, &ridges] { return CheckRidgesInPatches(picture, ridges); },
    [&picture, &ridges] { return CheckPatchContours(picture, ridges); },
    [&picture, leastCosine] { return CheckRightAngles(picture, leastCosine); },
    [&picture, &ridges] { return CheckSingleCrossings(picture, ridges); },
    [&picture, &ridges] { return CheckPointsOnEdges(picture, ridges); },
    [&picture, &ridges] { return CheckCrossings(picture, ridges); },
  };
  static_assert(std::extent_v<decltype(checks)> + 1 == static_cast<std::size_t>(steps));
  ridges = FindWholeRidges(picture);
  for (const std::function<CoherenceCheck()>& check : checks)
  {
    if (!within(0.0))
    {
      return {};
    }
    results.push_back(check());
  }
  return results;
}

} // namespace ridges
