// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_SmoothedImage_h
#define ridges_SmoothedImage_h

#include "Base/Buffer.h"
#include "Base/Types.h"
#include "Formula/ImageFunction.h"

namespace ridges
{

/**
 * The samples of an image, smoothed by most of a Gaussian. What is left for ImageFunction is
 * narrow, so that it sums over few samples at each place; and wide enough to know the smoothed
 * image between samples to round-off. Where the Gaussian is narrow from the start, the samples stay
 * as they are.
 */
class SmoothedImage
{
public:
  /// What is left by default, in samples: 2 pi times as much, squared and halved, are 44 powers of
  /// e down to what the samples alias.
  static constexpr double Remainder = 1.5;

  /// The loop lends threads; sigma is in the unit of the spacing. Goes on from what the image is
  /// smoothed by already.
  SmoothedImage(
    const ImageGrid& grid, double sigma, const RangeLoop& loop, double remainder = Remainder);

  /// It must not outlive this, nor the samples of the image.
  const ImageGrid& Grid() const { return this->Grid_; }

private:
  void Smooth(int axis, double deviation, const RangeLoop& loop);

  ImageGrid Grid_;
  Buffer<double> Values_;
};

} // namespace ridges

#endif
