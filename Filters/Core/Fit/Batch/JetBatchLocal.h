// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The points of a batch of neighbourhoods in their frames, and which fits to look at closely.
// Included by JetBatchKernel.h and JetBatchTiledKernel.h only.
#ifndef ridges_JetBatchLocal_h
#define ridges_JetBatchLocal_h

#include "Fit/Batch/JetBatchFrame.h"
#include "Fit/Batch/JetBatchMoments.h"

namespace
{

/// Sets the points, and weights of 1 if there are none; the result is their frame.
inline Frame SetLocalPoints(ridges::JetBatch& batch, LocalPoints& points)
{
  points.rows = batch.rows;
  points.weights = batch.weights;
  const Frame frame = PrincipalFrame(batch, points.at);
  const Vec perRadius = 1.0 / frame.radius;
  const Vec3 u = perRadius * frame.u;
  const Vec3 v = perRadius * frame.v;
  const Vec3 n = perRadius * frame.n;
  for (int row = 1; row < batch.rows; ++row)
  {
    const Vec3 offset = points.at[row];
    points.at[row] = { Dot(u, offset), Dot(v, offset), Dot(n, offset) };
  }
  if (!batch.weighted)
  {
    const Vec counts = Load(batch.counts);
    for (int row = 0; row < batch.rows; ++row)
    {
      Store(batch.weights + row * Lanes, Broadcast(row) < counts ? Broadcast(1.0) : Vec{});
    }
  }
  return frame;
}

/// Marks fits that are to be looked at closely.
template <int Degree>
inline void StoreDoubt(ridges::JetBatch& batch, const Frame& frame, const Vec& residual)
{
  constexpr double mostNoise = ridges::JetBatchKernel::MostNoise;
  const Vec counts = Load(batch.counts);
  const Vec freedom = Max(counts - static_cast<double>(NumberOfMonomials(Degree)), Broadcast(1.0));
  const auto noisy = residual * residual * counts > mostNoise * mostNoise * freedom;
  Store(batch.doubtful, (noisy && frame.bends) || frame.mayFold ? Broadcast(1.0) : Vec{});
}

} // namespace

#endif
