// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_EdgeChecks_h
#define ridges_EdgeChecks_h

#include "Coherence/CoherenceCheck.h"
#include "Coherence/WholeRidges.h"

namespace ridges
{

/// At no edge outside patches and regions of cancelled umbilics the cosine of the angle between the
/// maximum directions is this small (S1). This is a question of luck and of how fine the mesh is,
/// rather than of coherence.
CoherenceCheck CheckRightAngles(const RidgePicture& picture, double leastCosine);

/// Outside, no edge is crossed twice by ridges of one colour (2.2d).
CoherenceCheck CheckSingleCrossings(
  const RidgePicture& picture, const std::vector<WholeRidge>& ridges);

/// Points of ridges are where their edges and parameters say; those at umbilics in the triangles
/// of these, turning points between their neighbours.
CoherenceCheck CheckPointsOnEdges(
  const RidgePicture& picture, const std::vector<WholeRidge>& ridges);

/// Outside, ridges pass where the acute rule says. Small loops may be missing.
CoherenceCheck CheckCrossings(const RidgePicture& picture, const std::vector<WholeRidge>& ridges);

} // namespace ridges

#endif
