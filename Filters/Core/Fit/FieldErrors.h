// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_FieldErrors_h
#define ridges_FieldErrors_h

#include "Fit/JetErrors.h"

namespace ridges
{

/**
 * Standard errors of a Monge form whose surface is displaced along its normal by smoothed noise:
 * independent noise that was smoothed by a Gaussian of deviation `sigma`, so that the displacement
 * at a point has the standard deviation `deviation`. The covariance of two points at distance r is
 * deviation^2 exp(-r^2 / (4 sigma^2)); the derivatives of that are the covariances of the
 * derivatives of the height. To first order, where the surface is gentle within sigma.
 */
JetErrors ErrorsOfDisplacement(const MongeForm& form, double deviation, double sigma);

} // namespace ridges

#endif
