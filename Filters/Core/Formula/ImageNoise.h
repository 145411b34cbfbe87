// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_ImageNoise_h
#define ridges_ImageNoise_h

#include "Base/Types.h"
#include "Formula/ImageFunction.h"

namespace ridges
{

/**
 * The standard deviation of noise that is independent from sample to sample, near the places
 * x, y, z, x, y, ... From second differences along all three axes at once, which have hardly
 * anything of a surface left that the samples resolve, and by their median, so that a few places
 * at sharp corners do not matter. 0 without a place inside the image.
 */
double EstimateImageNoise(const ImageGrid& grid, Span<double> places);

/// The standard deviation of such noise, of deviation 1, after smoothing by a Gaussian.
double SmoothedNoise(const ImageGrid& grid, double sigma);

} // namespace ridges

#endif
