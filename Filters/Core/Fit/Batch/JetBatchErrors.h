// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Standard errors of the Monge forms of a batch. Included by JetBatchSolvedErrors.h and
// JetBatchTiledErrors.h only.
#ifndef ridges_JetBatchErrors_h
#define ridges_JetBatchErrors_h

#include "Fit/Batch/JetBatchGradients.h"

namespace
{

/// The variances of the quantities for heights of unit variance, and how much of the weights is
/// left for estimating that variance.
struct UnitVariances
{
  Vec of[Quantities];
  Vec freedom;
};

template <int Degree>
inline void StoreErrors(ridges::JetBatch& batch, const Vec& totalWeight, const UnitVariances& unit)
{
  const Vec residual = Load(batch.residual);
  const Vec variance = residual * residual * totalWeight / unit.freedom;
  const auto isFree = Load(batch.counts) > static_cast<double>(NumberOfMonomials(Degree));
  const Vec unknown = Broadcast(ridges::JetBatch::UnknownError);
  for (int q = 0; q < Quantities; ++q)
  {
    constexpr int orders[] = { 2, 2, 3, 3, 3, 3, 4, 4 };
    const Vec error = Sqrt(variance * unit.of[q]);
    const bool isKnown = orders[q] <= Degree;
    Store(batch.errors + q * Lanes, isKnown && isFree && error - error == 0.0 ? error : unknown);
  }
}

/// Points whose monomials are solved for side by side, as none of them alone keeps the processor
/// busy.
constexpr int Together = 4;

/// Visits all points, some at once: visit(monomials, weights), with the monomials in rising order
/// and then by point, and weights of 0 for what is past the end.
template <int Degree, typename Visit>
inline void ForMonomials(const LocalPoints& points, Visit visit)
{
  for (int first = 0; first < points.rows; first += Together)
  {
    Vec monomials[NumberOfMonomials(Degree)][Together];
    Vec weights[Together];
    for (int i = 0; i < Together; ++i)
    {
      const bool isPast = first + i >= points.rows;
      const int row = isPast ? first : first + i;
      const Vec3& point = points.at[row];
      weights[i] = isPast ? Vec{} : points.Weight(row);
      monomials[0][i] = Broadcast(1.0);
      for (int d = 1; d <= Degree; ++d)
      {
        for (int j = 0; j < d; ++j)
        {
          monomials[MonomialIndex(d - j, j)][i] =
            monomials[MonomialIndex(d - 1 - j, j)][i] * point.x;
        }
        monomials[MonomialIndex(0, d)][i] = monomials[MonomialIndex(0, d - 1)][i] * point.y;
      }
    }
    visit(monomials, weights);
  }
}

/// With weights each point counts with the square of its weight, and takes a part of the freedom.
/// Takes L^-1 times the monomials, by row; rowOf(k) is the row of coefficient k, of which the first
/// `count` have a gradient.
template <typename RowOf>
inline void AddWeighted(const Vec (*solution)[Together], const Vec* inverseD, int rows,
  const Gradients& solved, int count, RowOf rowOf, const Vec (&weights)[Together],
  UnitVariances& unit)
{
  Vec leverage[Together]{};
  for (int row = 0; row < rows; ++row)
  {
#pragma GCC unroll 4
    for (int i = 0; i < Together; ++i)
    {
      leverage[i] += solution[row][i] * solution[row][i] * inverseD[row];
    }
  }
  for (int i = 0; i < Together; ++i)
  {
    unit.freedom -= weights[i] * weights[i] * leverage[i];
    Vec shares[Quantities]{};
    for (int k = 0; k < count; ++k)
    {
      const int row = rowOf(k);
      const Vec scaled = solution[row][i] * inverseD[row];
#pragma GCC unroll 8
      for (int q = 0; q < Quantities; ++q)
      {
        shares[q] += solved.at[k][q] * scaled;
      }
    }
#pragma GCC unroll 8
    for (int q = 0; q < Quantities; ++q)
    {
      const Vec share = weights[i] * shares[q];
      unit.of[q] += share * share;
    }
  }
}

inline void BeginWeighted(UnitVariances& unit, const Vec& totalWeight)
{
  for (Vec& variance : unit.of)
  {
    variance = Vec{};
  }
  unit.freedom = totalWeight;
}

} // namespace

#endif
