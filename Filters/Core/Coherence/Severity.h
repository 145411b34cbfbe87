// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_Severity_h
#define ridges_Severity_h

#include "Coherence/CoherenceCheck.h"
#include "Coherence/RidgePicture.h"

namespace ridges
{

/// What it means that a check has offenders.
enum class Severity
{
  None = 0,      ///< It has none.
  Uncertain = 1, ///< Noise or a coarse mesh explain it.
  Wrong = 2      ///< Nothing does.
};

/**
 * Most facts hold on any mesh and with any noise, as the ridges are found so that they do: those
 * about index sums, ends, types, turning points and crossings. Where they fail something is wrong.
 *
 * The others compare what was measured independently: the number of ridges at an umbilic by its
 * third-order form with those that are there, or on the contour of its patch; or they ask whether
 * the mesh is fine enough (S1, D1 and 2.2 of RR-5294). Noise makes them fail on a sound picture.
 * Ridges that cross are uncertain inside patches and cancelled regions only, where they are drawn.
 */
Severity SeverityOf(const CoherenceCheck& check, const RidgePicture& picture);

} // namespace ridges

#endif
