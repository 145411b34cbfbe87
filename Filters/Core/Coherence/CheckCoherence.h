// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_CheckCoherence_h
#define ridges_CheckCoherence_h

#include "Coherence/CoherenceCheck.h"
#include "Coherence/RidgePicture.h"

namespace ridges
{

/// All checks of coherence, in the order in which a reader wants them.
std::vector<CoherenceCheck> CheckCoherence(const RidgePicture& picture, double leastCosine);

} // namespace ridges

#endif
