// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_RidgeChecks_h
#define ridges_RidgeChecks_h

#include "Base/Monitor.h"
#include "Coherence/CoherenceCheck.h"
#include "Coherence/WholeRidges.h"

namespace ridges
{

/// Each ridge is one chain of one colour, from triangle to triangle, that is a loop or ends at
/// umbilics and borders (definition 4).
CoherenceCheck CheckRidgeEnds(const RidgePicture& picture, const std::vector<WholeRidge>& ridges);

/// Loops and ridges between umbilics have an even number of turning points, which are where their
/// types change (section 3).
CoherenceCheck CheckTurningPoints(
  const RidgePicture& picture, const std::vector<WholeRidge>& ridges);

/// Ridges of one colour do not cross each other, nor themselves, in any triangle.
CoherenceCheck CheckNoIntersections(const RidgePicture& picture,
  const std::vector<WholeRidge>& ridges, const Monitor& monitor = NeverStops);

} // namespace ridges

#endif
