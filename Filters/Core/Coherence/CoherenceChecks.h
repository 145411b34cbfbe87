// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_CoherenceChecks_h
#define ridges_CoherenceChecks_h

#include "Coherence/CoherenceCheck.h"
#include "Coherence/WholeRidges.h"

namespace ridges
{

/// @name Umbilics
///@{
/// On each closed connected part of the mesh the indices sum to the Euler characteristic (8.2).
/// Points at which a part touches itself count once for each time.
CoherenceCheck CheckIndexSum(const RidgePicture& picture);

/// Each umbilic is the end of as many ridges of each colour as its ridge count says (section 3).
CoherenceCheck CheckRidgesAtUmbilics(
  const RidgePicture& picture, const std::vector<WholeRidge>& ridges);

/// Ridges are hyperbolic where they end at umbilics (section 3).
CoherenceCheck CheckTypesAtUmbilics(
  const RidgePicture& picture, const std::vector<WholeRidge>& ridges);

/// No triangle holds two umbilics (D1).
CoherenceCheck CheckUmbilicsPerTriangle(const RidgePicture& picture);
///@}

/// @name Ridges
///@{
/// Each ridge is one chain of one colour, from triangle to triangle, that is a loop or ends at
/// umbilics and borders (definition 4).
CoherenceCheck CheckRidgeEnds(const RidgePicture& picture, const std::vector<WholeRidge>& ridges);

/// Loops and ridges between umbilics have an even number of turning points, which are where their
/// types change (section 3).
CoherenceCheck CheckTurningPoints(
  const RidgePicture& picture, const std::vector<WholeRidge>& ridges);

/// Ridges of one colour do not cross each other, nor themselves, in any triangle.
CoherenceCheck CheckNoIntersections(
  const RidgePicture& picture, const std::vector<WholeRidge>& ridges);
///@}

/// @name Patches
///@{
/// Each patch is a disk of triangles and holds its umbilic (hypothesis 2.2a). That patches do not
/// overlap is in the way they are told: by one umbilic per triangle.
CoherenceCheck CheckPatches(const RidgePicture& picture);

/// No ridge is inside a patch as a whole, but one from its umbilic to the border (2.2b).
CoherenceCheck CheckRidgesInPatches(
  const RidgePicture& picture, const std::vector<WholeRidge>& ridges);

/// The contour of a patch is crossed as often as ridges of a colour meet at its umbilic (2.2c).
CoherenceCheck CheckPatchContours(
  const RidgePicture& picture, const std::vector<WholeRidge>& ridges);
///@}

/// @name Edges
///@{
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
///@}

// Where a formula of the surface is known, two more belong here, which would be given exact
// directions and extremalities besides the picture: that at every edge the acute rule orients as
// continuity along it does (definition 5), and that no edge is crossed more than once by the exact
// ridges (2.2d and hypothesis 3), to be found by subdivision.

/// All of them, in the order of their reading.
std::vector<CoherenceCheck> CheckCoherence(const RidgePicture& picture, double leastCosine);

} // namespace ridges

#endif
