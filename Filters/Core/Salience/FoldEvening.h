// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_FoldEvening_h
#define ridges_FoldEvening_h

#include "Ridges/RidgeTrace.h"
#include "Salience/FoldAngle.h"

namespace ridges
{

/**
 * Fold angles averaged along a ridge, so that one bad point does not tear a line or start one: over
 * the points on edges of each elliptic run, weighted by the length that a point stands for and a
 * Gaussian, of deviation `sigma`, of the distance along the ridge. Where the curvature at the ridge
 * exceeds that at the foot by less than this part of itself the angle counts as 0: the slow bend of
 * a body adds up to a large angle over a long way, but is no feature.
 */
void EvenFolds(const RidgeTrace& trace, double sigma, double leastRise, RidgeFolds& folds);

} // namespace ridges

#endif
