// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_RingAveraging_h
#define ridges_RingAveraging_h

#include "Salience/OneRings.h"

#include <array>

namespace ridges
{

/**
 * Replaces the values at all points, again and again, by their averages over one-rings, weighted by
 * area. Each step is a diffusion: many of them are a Gaussian on the surface.
 *
 * Set and Prepare work on ranges of points, then Step on ranges and Swap in turn. Ranges of one
 * step may be done at the same time.
 */
template <int Components>
class RingAveraging
{
public:
  using Values = std::array<double, Components>;

  explicit RingAveraging(const OneRings& rings);

  /// The values of p at the start. At a point that does not count they are ignored.
  void Set(Id p, const Values& values, bool counts = true);

  /// How much of each average p takes, 0 to 1: the variance of a step is that part of
  /// OneRings::Variance. After all points are set.
  void Prepare(Id p, double share);

  void Step(Id begin, Id end);
  void Swap();

  /// The values of p after the last step; false if neither p nor any point near it counts.
  bool Get(Id p, Values& values) const;

private:
  const OneRings& Rings_;
  // Values times area, and the area that counts, so that a step has nothing to multiply with.
  static constexpr int Stride = Components;
  Buffer<double> Now_;
  Buffer<double> Next_;
  Buffer<double> Areas_;
  Buffer<double> Own_;  ///< What of the own value stays.
  Buffer<double> Ring_; ///< What is taken of the sum over p and its neighbours.
};

} // namespace ridges

#endif
