// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// What FitJetBatch... do in degrees 2 to 4, for RIDGES_LANES lanes: see JetBatch.h. Every lane does
// the same arithmetic whatever its neighbours hold, and rows past its end add zeros, so that the
// result of a vertex does not depend on the batch it came in.
#ifndef ridges_JetBatchKernel_h
#define ridges_JetBatchKernel_h

#include "Fit/Batch/JetBatchLocal.h"
#include "Fit/Batch/JetBatchMonge.h"
#include "Fit/Batch/JetBatchSolve.h"
#include "Fit/Batch/JetBatchSolvedErrors.h"

namespace
{

/// The variance of the third derivatives as a tensor, in units of the radius, for heights of unit
/// variance.
template <int Degree>
inline Vec VarianceOfThirdOrder(const NormalEquations<Degree>& equations)
{
  constexpr int size = NumberOfMonomials(Degree);
  Vec sum{};
#pragma GCC unroll 4
  for (int j = 0; j <= 3; ++j)
  {
    const int first = NumberOfMonomials(2) + j;
    Vec x[size];
#pragma GCC unroll 15
    for (int row = first; row < size; ++row)
    {
      // i! j! sqrt(3 over j)
      Vec value = row == first ? Broadcast(j == 0 || j == 3 ? 6.0 : 3.4641016151377544) : Vec{};
#pragma GCC unroll 15
      for (int k = first; k < row; ++k)
      {
        value -= equations.L[row][k] * x[k];
      }
      x[row] = value;
      sum += value * value * equations.inverseD[row];
    }
  }
  return sum;
}

/// What is known of the least squares.
template <int Degree>
inline void StoreQuality(ridges::JetBatch& batch, const Frame& frame,
  const NormalEquations<Degree>& equations, const Vec& totalWeight)
{
  constexpr int size = NumberOfMonomials(Degree);
  constexpr int first = NormalEquations<Degree>::FirstProbed;
  Vec probe[size];
  equations.Probe(probe);
  Vec squares{};
#pragma GCC unroll 15
  for (int k = first; k < size; ++k)
  {
    squares += probe[k] * probe[k];
  }
  // No column of the least squares is longer than that of ones.
  const Vec estimate = Sqrt((1.0 / (size - first)) * totalWeight * squares);
  const Vec singular = Broadcast(ridges::JetBatchKernel::Singular);
  Store(
    batch.conditionNumber, frame.failed ? Vec{} : (equations.excess > 0.0 ? estimate : singular));
  Vec gain{};
  if constexpr (Degree >= 3)
  {
    const Vec* third = probe + NumberOfMonomials(2);
    // Signs that are not at random make it larger, on meshes of all kinds about as much.
    constexpr double tooLarge = 1.5 * 1.5;
    const Vec form = batch.exactGain ? VarianceOfThirdOrder<Degree>(equations)
                                     : (1.0 / tooLarge) *
        (36.0 * (third[0] * third[0] + third[3] * third[3]) +
          12.0 * (third[1] * third[1] + third[2] * third[2]));
    const Vec counts = Load(batch.counts);
    const Vec freedom = Max(counts - static_cast<double>(size), Broadcast(1.0));
    gain = Sqrt(form * counts / freedom);
  }
  Store(batch.noiseGain, gain);
}

template <int Degree, bool WithErrors>
inline void FitDegree(ridges::JetBatch& batch)
{
  constexpr int size = NumberOfMonomials(Degree);
  constexpr int order = 2 * Degree;

  LocalPoints points;
  const Frame frame = SetLocalPoints(batch, points);
  const Vec perRadius = 1.0 / frame.radius;

  // In two passes, as the sums of one would not fit in the registers.
  Vec moments[order + 1][order + 1];
  AddMoments<order, 0, 2>(points, moments);
  AddMoments<order, 3, order>(points, moments);
  NormalEquations<Degree> equations;
  equations.Factor(moments);
  StoreQuality<Degree>(batch, frame, equations, moments[0][0]);

  Vec coefficients[size];
  Project<Degree>(
    points, Vec{}, [&points](int row) { return points.Weight(row) * points.at[row].z; },
    coefficients);
  equations.Solve(coefficients);

  // Iterative refinement: what the polynomial misses at the points, fitted once more.
  Vec totalWeight = points.Weight(0);
  Vec squares = totalWeight * coefficients[0] * coefficients[0];
  Vec corrections[size];
  Project<Degree>(
    points, -totalWeight * coefficients[0],
    [&points, &coefficients, &squares, &totalWeight](int row)
    {
      const Vec weight = points.Weight(row);
      const Vec3& p = points.at[row];
      const Vec missed = p.z - Evaluate<Degree>(coefficients, p.x, p.y);
      squares += weight * missed * missed;
      totalWeight += weight;
      return weight * missed;
    },
    corrections);
  equations.Solve(corrections);
  for (int k = 0; k < size; ++k)
  {
    coefficients[k] += corrections[k];
  }

  const Vec residual = Sqrt(squares / totalWeight);
  Store(batch.residual, residual);
  Store(batch.radius, frame.radius);
  const Vec zeros = StoreMongeForm<Degree>(batch, frame, coefficients, perRadius);
  const auto good = equations.excess > 0.0 && !frame.failed && zeros + 0.0 * residual == 0.0;
  Store(batch.good, good ? Broadcast(1.0) : Vec{});
  StoreDoubt<Degree>(batch, frame, residual);
  if constexpr (WithErrors)
  {
    StoreErrorsOf<Degree>(batch, frame, points, equations, totalWeight);
  }
}

template <bool WithErrors>
inline void FitLanes(ridges::JetBatch& batch)
{
  switch (batch.degree)
  {
    case 2:
      return FitDegree<2, WithErrors>(batch);
    case 3:
      return FitDegree<3, WithErrors>(batch);
    default:
      return FitDegree<4, WithErrors>(batch);
  }
}

} // namespace

#endif
