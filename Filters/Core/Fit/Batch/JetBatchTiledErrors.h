// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Standard errors of a batch, degrees 5 to 8. Included by JetBatchTiledKernel.h only.
#ifndef ridges_JetBatchTiledErrors_h
#define ridges_JetBatchTiledErrors_h

#include "Fit/Batch/JetBatchErrors.h"
#include "Fit/Batch/JetBatchTiledEquations.h"

namespace
{

/// As in JetBatchKernel.h. The gradients are of the last rows only; those left of the diagonal
/// tiles come in before.
template <int Degree>
inline void SolveGradients(
  const TiledEquations<Degree>& equations, Gradients& gradients, UnitVariances& unit)
{
  using Equations = TiledEquations<Degree>;
  for (Vec& variance : unit.of)
  {
    variance = Vec{};
  }
  for (int index = MongeCoefficients - 1; index >= 0; --index)
  {
    const int row = Equations::RowOf(index);
    auto& rest = gradients.at[index];
    for (int before = MongeCoefficients - 1; before > index; --before)
    {
      const Vec factor = equations.Element(row, Equations::RowOf(before));
#pragma GCC unroll 8
      for (int q = 0; q < Quantities; ++q)
      {
        rest[q] -= factor * gradients.at[before][q];
      }
    }
    const Vec inverse = equations.inverseD[row];
#pragma GCC unroll 8
    for (int q = 0; q < Quantities; ++q)
    {
      unit.of[q] += rest[q] * rest[q] * inverse;
    }
  }
}

template <int Degree>
inline void WeighVariances(const LocalPoints& points, const TiledEquations<Degree>& equations,
  const Gradients& solved, const Vec& totalWeight, UnitVariances& unit)
{
  using Equations = TiledEquations<Degree>;
  BeginWeighted(unit, totalWeight);
  ForMonomials<Degree>(points,
    [&equations, &solved, &unit](const auto& monomials, const auto& weights)
    {
      Vec x[Equations::Rows][Together]{};
      for (int k = 0; k < Equations::Size; ++k)
      {
        for (int i = 0; i < Together; ++i)
        {
          x[Equations::RowOf(k)][i] = monomials[k][i];
        }
      }
      equations.SolveForward(x);
      AddWeighted(
        x, equations.inverseD, Equations::Rows, solved, MongeCoefficients,
        [](int k) { return Equations::RowOf(k); }, weights, unit);
    });
}

template <int Degree>
__attribute__((noinline)) void StoreErrorsOf(ridges::JetBatch& batch, const Frame& frame,
  const LocalPoints& points, const Extents& extents, const TiledEquations<Degree>& equations,
  const Vec& totalWeight)
{
  Gradients gradients;
  SetGradients(batch, frame, extents, gradients);
  UnitVariances unit;
  SolveGradients<Degree>(equations, gradients, unit);
  unit.freedom = Load(batch.counts) - static_cast<double>(TiledEquations<Degree>::Size);
  if (batch.weighted)
  {
    WeighVariances<Degree>(points, equations, gradients, totalWeight, unit);
  }
  StoreErrors<Degree>(batch, totalWeight, unit);
}

} // namespace

#endif
