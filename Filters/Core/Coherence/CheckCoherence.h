// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_CheckCoherence_h
#define ridges_CheckCoherence_h

#include "Base/Monitor.h"
#include "Coherence/CoherenceCheck.h"
#include "Coherence/RidgePicture.h"

#include <vector>

namespace ridges
{

/// All checks of coherence, in the order in which a reader wants them; none if the monitor, which
/// is called before each, stops them.
std::vector<CoherenceCheck> CheckCoherence(
  const RidgePicture& picture, double leastCosine, const Monitor& monitor = NeverStops);

} // namespace ridges

#endif
