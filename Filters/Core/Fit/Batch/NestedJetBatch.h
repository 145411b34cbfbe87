// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_NestedJetBatch_h
#define ridges_NestedJetBatch_h

#include "Fit/Batch/JetBatch.h"

#include <vector>

namespace ridges
{

/**
 * Three neighbourhoods of each of several vertices, each the first points of the next: two for
 * degree 4, and the largest for degree 6.
 */
struct NestedJetBatch
{
  static constexpr int Fits = 3;
  static constexpr int Degrees[Fits] = { 4, 4, 6 };

  /// Input: of all of them `rows`, `counts` and `exactGain`, and of the largest what there is
  /// besides; no weights. Output: what is known of each fit, and after the blend the Monge form in
  /// that of the largest.
  JetBatch fits[Fits];

  /// Of each lane and fit in the blend, fit after fit: its sum is 1 in each lane.
  alignas(64) double shares[Fits * JetBatch::MaximumLanes];

  /// @name From the fits to the blend
  ///@{
  alignas(64) double axes[9 * JetBatch::MaximumLanes]; ///< u, v and n.
  static constexpr int NumberOfCoefficients = 15;
  /// Up to order 4, in units of the largest radius.
  alignas(64) double jets[Fits * NumberOfCoefficients * JetBatch::MaximumLanes];
  ///@}
};

/**
 * Fits all three at once, where noise asks for so many points that sums over them take most of the
 * time: sums for a neighbourhood go on from those for the one inside it, in the principal frame of
 * the middle one and in the monomials of the largest, of which the others need the first.
 *
 * Without the refinement of JetBatchKernel, and with residuals from the sums: heights have noise,
 * which is by far larger than what rounding does to these. All else is as there; but that points
 * spread along the normal is judged in the common frame, where they do so rather more.
 */
struct NestedJetKernel
{
  const char* name;
  int lanes;
  void (*fit)(NestedJetBatch& batch);

  /// The Monge form of the mean of the polynomials.
  void (*blend)(NestedJetBatch& batch);
};

/// The kernels that this processor can run, the fastest first. None without compiler vectors.
const std::vector<NestedJetKernel>& NestedJetKernels();

} // namespace ridges

#endif
