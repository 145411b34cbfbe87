// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_RingAveraging_h
#define ridges_RingAveraging_h

#include "Salience/OneRings.h"

#include <array>

namespace ridges
{

/// What is done in one sweep over all points.
struct AveragingSweep
{
  int step = 0;   ///< Of a box, counted from 1; 0 is a plain average.
  int length = 0; ///< Of the box, in steps.
};

/**
 * Replaces the values at all points, again and again, by their averages over one-rings, weighted by
 * area. Each average is a diffusion: many of them are a Gaussian on the surface.
 *
 * A box smooths farther with as many sweeps. With the operator A of a plain average and Chebyshev
 * polynomials T, one of n steps is (1 + 2 T_1(A) + ... + 2 T_n(A)) / (2 n + 1): along a row of
 * points the mean of 2 n + 1 of them. It has the variance of n (n + 1) / 3 averages.
 *
 * Set and Prepare are for points; then Step on ranges of places and Swap take turns. Ranges of one
 * step may be done at the same time. A point's place is where its values lie in memory: with boxes,
 * which are for large scales and so for many sweeps, places follow a curve through the mesh
 * (CurveOrder.h).
 */
template <int Components>
class RingAveraging
{
public:
  using Values = std::array<double, Components>;

  explicit RingAveraging(const OneRings& rings, bool hasBoxes = false);
  RingAveraging(const RingAveraging&) = delete;
  RingAveraging& operator=(const RingAveraging&) = delete;

  /// The values of p at the start. At a point that does not count they are ignored.
  void Set(Id p, const Values& values, bool counts = true);

  /// How much of each average p takes, 0 to 1: the variance of a step is that part of
  /// OneRings::Variance. After all points are set.
  void Prepare(Id p, double share);

  /// The steps of a box follow each other.
  void Step(Id begin, Id end, const AveragingSweep& sweep = {});
  void Swap(const AveragingSweep& sweep = {});

  /// The values of p after the last step; false if neither p nor any point near it counts.
  bool Get(Id p, Values& values) const;

private:
  void SetPlaces(bool alongCurve);
  double* At(Buffer<double>& values, Id place)
  {
    return values.data() + static_cast<std::size_t>(Stride) * place;
  }

  const OneRings& Rings_;
  std::vector<Id> Places_;    ///< By point.
  std::vector<Id> Begins_;    ///< By place, in the list below; one more at the end.
  std::vector<Id> Neighbors_; ///< Their places, in the order of OneRings.
  // Values times area, and the area that counts, so that a step has nothing to multiply with.
  static constexpr int Stride = Components;
  Buffer<double> Now_;
  Buffer<double> Next_; ///< In a box what T of the step before gives, until it is overwritten.
  Buffer<double> Sum_;  ///< Of a box.
  Buffer<double> Areas_;
  Buffer<double> Own_;  ///< What of the own value stays.
  Buffer<double> Ring_; ///< What is taken of the sum over p and its neighbours.
};

} // namespace ridges

#endif
