// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_UmbilicChecks_h
#define ridges_UmbilicChecks_h

#include "Coherence/CoherenceCheck.h"
#include "Coherence/WholeRidges.h"

namespace ridges
{

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

} // namespace ridges

#endif
