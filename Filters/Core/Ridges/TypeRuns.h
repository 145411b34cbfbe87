// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_TypeRuns_h
#define ridges_TypeRuns_h

#include "Ridges/RidgeTrace.h"
#include "Ridges/TypeErrors.h"

#include <vector>

namespace ridges
{

/**
 * Gives runs of one type that are shorter than this length the type of their two neighbours, the
 * shortest first. Runs at the ends of a ridge stay, so that turning points vanish in pairs.
 */
void AbsorbShortRuns(RidgeTrace& trace, double length);

/**
 * The same for runs whose type is not significant: over which the integral of P does not exceed so
 * many of its standard errors.
 */
void AbsorbInsignificantRuns(RidgeTrace& trace, const TypeErrors& errors, double significance);

/// The lengths of the pieces whose type is significant, 0 for others: P exceeds so many of its
/// standard errors, and the slope of the extremality across the ridge agrees with its sign.
std::vector<double> SureLengthsOf(
  const RidgeTrace& trace, const TypeErrors& errors, double significance);

} // namespace ridges

#endif
