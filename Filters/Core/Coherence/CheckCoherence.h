// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_CheckCoherence_h
#define ridges_CheckCoherence_h

#include "Coherence/CoherenceCheck.h"
#include "Coherence/RidgePicture.h"

#include <functional>

namespace ridges
{

/// All checks of coherence, in the order in which a reader wants them. Before each, `goesOn`, if
/// given, is called with the fraction that is done; if it returns false there are no results.
std::vector<CoherenceCheck> CheckCoherence(const RidgePicture& picture, double leastCosine,
  const std::function<bool(double done)>& goesOn = {});

} // namespace ridges

#endif
