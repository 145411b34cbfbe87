// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Standard errors of a batch, degrees 2 to 4. Included by JetBatchKernel.h only.
#ifndef ridges_JetBatchSolvedErrors_h
#define ridges_JetBatchSolvedErrors_h

#include "Fit/Batch/JetBatchErrors.h"
#include "Fit/Batch/JetBatchSolve.h"

namespace
{

/// The gradients g, of the equations factored as L D L^T: L^-1 g, and variances from it.
template <int Degree>
inline void SolveGradients(
  const NormalEquations<Degree>& equations, Gradients& gradients, UnitVariances& unit)
{
  auto& y = gradients.at;
  for (Vec& variance : unit.of)
  {
    variance = Vec{};
  }
  for (int row = 1; row < NumberOfMonomials(Degree); ++row)
  {
    Vec rest[Quantities];
#pragma GCC unroll 8
    for (int q = 0; q < Quantities; ++q)
    {
      rest[q] = y[row][q];
    }
    for (int column = 1; column < row; ++column)
    {
      const Vec factor = equations.L[row][column];
#pragma GCC unroll 8
      for (int q = 0; q < Quantities; ++q)
      {
        rest[q] -= factor * y[column][q];
      }
    }
    const Vec inverse = equations.inverseD[row];
#pragma GCC unroll 8
    for (int q = 0; q < Quantities; ++q)
    {
      y[row][q] = rest[q];
      unit.of[q] += rest[q] * rest[q] * inverse;
    }
  }
}

template <int Degree>
inline void WeighVariances(const LocalPoints& points, const NormalEquations<Degree>& equations,
  const Gradients& solved, const Vec& totalWeight, UnitVariances& unit)
{
  BeginWeighted(unit, totalWeight);
  ForMonomials<Degree>(points,
    [&equations, &solved, &unit](auto& x, const auto& weights)
    {
      constexpr int size = NumberOfMonomials(Degree);
      for (int row = 0; row < size; ++row)
      {
        Vec rest[Together] = { x[row][0], x[row][1], x[row][2], x[row][3] };
        for (int column = 0; column < row; ++column)
        {
          const Vec factor = equations.L[row][column];
#pragma GCC unroll 4
          for (int i = 0; i < Together; ++i)
          {
            rest[i] -= factor * x[column][i];
          }
        }
#pragma GCC unroll 4
        for (int i = 0; i < Together; ++i)
        {
          x[row][i] = rest[i];
        }
      }
      AddWeighted(
        x, equations.inverseD, size, solved, size, [](int k) { return k; }, weights, unit);
    });
}

/// Apart from the fit, whose code is the same without it.
template <int Degree>
__attribute__((noinline)) void StoreErrorsOf(ridges::JetBatch& batch, const Frame& frame,
  const LocalPoints& points, const NormalEquations<Degree>& equations, const Vec& totalWeight)
{
  Gradients gradients;
  SetGradients(batch, frame, { Broadcast(1.0), Broadcast(1.0) }, gradients);
  UnitVariances unit;
  SolveGradients<Degree>(equations, gradients, unit);
  unit.freedom = Load(batch.counts) - static_cast<double>(NumberOfMonomials(Degree));
  if (batch.weighted)
  {
    WeighVariances<Degree>(points, equations, gradients, totalWeight, unit);
  }
  StoreErrors<Degree>(batch, totalWeight, unit);
}

} // namespace

#endif
