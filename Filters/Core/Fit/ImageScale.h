// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_ImageScale_h
#define ridges_ImageScale_h

#include "Base/Types.h"
#include "Formula/ImageFunction.h"

namespace ridges
{

/**
 * The standard deviation of a Gaussian that smooths the noise of an image as far as ridges need: at
 * half of the surface, where the image has a value, the standard error of b is a quarter of b (or,
 * where b hardly differs from 0, of a twentieth of k1^2 + k2^2).
 *
 * Noise is measured as by EstimateImageNoise, and its errors at some 300 places of the surface,
 * with deviations of `least`, twice and four times as much, and so on. The first that will do is
 * made as small as theory allows: errors of b fall with the power 4.5 of the deviation. `least` is
 * also the answer where there is no noise, or no surface. The loop lends threads.
 */
double ChooseImageScale(const ImageGrid& grid, double value, double least, const RangeLoop& loop);

} // namespace ridges

#endif
