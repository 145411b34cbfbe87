// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Sums over the points of a batch, and what a polynomial is there, degrees 5 to 8. Included by
// JetBatchTiledFactors.h only.
#ifndef ridges_JetBatchTiledSums_h
#define ridges_JetBatchTiledSums_h

#include "Fit/Batch/JetBatchPowerSums.h"

namespace
{

/// The moments of the weights, and those of the heights times the weights.
template <int Degree>
inline void SumMoments(
  const LocalPoints& points, PowerSums<2 * Degree>& moments, PowerSums<Degree>& heights)
{
  constexpr int order = 2 * Degree;
  constexpr int size = PowerSums<Degree>::Size;
  Powers<order> powers;
  Vec timesHeight[Powers<order>::RowsAtOnce][size];
  moments.Clear();
  heights.Clear();
  ForRows<order>(points,
    [&points, &moments, &heights, &powers, &timesHeight](int first, int count)
    {
      for (int row = 0; row < count; ++row)
      {
        const Vec3& p = points.at[first + row];
        powers.Set(row, p, points.Weight(first + row));
        for (int k = 0; k < size; ++k)
        {
          timesHeight[row][k] = p.z * powers.ofV[row][k];
        }
      }
      moments.Add(powers.ofU, powers.ofV, count);
      heights.Add(powers.ofU, timesHeight, count);
    });
}

/// The polynomial with these coefficients at a point, by Horner's rule in v.
template <int Degree>
inline Vec EvaluateTable(const PowerSums<Degree>& coefficients, const Vec& u, const Vec& v)
{
  Vec value{};
#pragma GCC unroll 9
  for (int j = Degree; j >= 0; --j)
  {
    Vec inner = coefficients.at[j][Degree - j];
#pragma GCC unroll 9
    for (int i = Degree - j - 1; i >= 0; --i)
    {
      inner = inner * u + coefficients.at[j][i];
    }
    value = value * v + inner;
  }
  return value;
}

} // namespace

#endif
