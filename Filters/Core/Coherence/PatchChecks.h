// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_PatchChecks_h
#define ridges_PatchChecks_h

#include "Coherence/CoherenceCheck.h"
#include "Coherence/WholeRidges.h"

namespace ridges
{

/// Each patch is a disk of triangles and holds its umbilic (hypothesis 2.2a). That patches do not
/// overlap is in the way they are told: by one umbilic per triangle.
CoherenceCheck CheckPatches(const RidgePicture& picture);

/// No ridge is inside a patch as a whole, but one from its umbilic to the border (2.2b).
CoherenceCheck CheckRidgesInPatches(
  const RidgePicture& picture, const std::vector<WholeRidge>& ridges);

/// The contour of a patch is crossed as often as ridges of a colour meet at its umbilic (2.2c).
CoherenceCheck CheckPatchContours(
  const RidgePicture& picture, const std::vector<WholeRidge>& ridges);

} // namespace ridges

#endif
