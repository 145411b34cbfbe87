// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The normal equations of any degree, in tiles. Included by JetBatchTiledKernel.h only.
#ifndef ridges_JetBatchTiledEquations_h
#define ridges_JetBatchTiledEquations_h

#include "Fit/Batch/JetBatchTiledFactors.h"

namespace
{

/// LDL^T of the matrix of moments: see TiledFactors.
template <int Degree>
struct TiledEquations : TiledFactors<Degree>
{
  using Factors = TiledFactors<Degree>;
  using Factors::First;
  using Factors::RowOf;
  using Factors::Rows;
  using Factors::Size;
  using Moments = PowerSums<2 * Degree>;

  Vec excess; ///< Least of what pivots have above SmallestPivotRatio.

  inline void Factor(const Moments& moments)
  {
    this->excess = moments.at[0][0];
    for (int first = 0; first < Rows; first += Tile)
    {
      this->FactorRows(moments, first);
    }
  }

private:
  /// Where the products of monomials are in the table of moments: the sum of two of these.
  struct Places
  {
    int of[Rows];
  };

  static constexpr Places MakePlaces()
  {
    Places places{};
    for (int d = 0; d <= Degree; ++d)
    {
      for (int j = 0; j <= d; ++j)
      {
        places.of[RowOf(MonomialIndex(d - j, j))] = j * Moments::Size + d - j;
      }
    }
    return places;
  }

  // Static, as tables of functions are copied in each call.
  static constexpr Places PlaceOf = MakePlaces();

  static inline Vec MatrixElement(const Moments& moments, int row, int column)
  {
    if (First > 0 && column < First)
    {
      return Broadcast(row == column ? 1.0 : 0.0);
    }
    return (&moments.at[0][0])[PlaceOf.of[row] + PlaceOf.of[column]];
  }

  /// A tile of the matrix, less the products of `scaled` and the factors left of it.
  template <bool IsDiagonal>
  inline void Eliminate(const Moments& moments, const Vec (*scaled)[Tile], int firstRow,
    int firstColumn, Vec (&rest)[Tile][Tile]) const
  {
#pragma GCC unroll 3
    for (int t = 0; t < Tile; ++t)
    {
#pragma GCC unroll 3
      for (int s = 0; s < (IsDiagonal ? t + 1 : Tile); ++s)
      {
        rest[t][s] = MatrixElement(moments, firstRow + t, firstColumn + s);
      }
    }
    const Vec(*factors)[Tile] = this->L[firstColumn / Tile];
    for (int k = First; k < firstColumn; ++k)
    {
#pragma GCC unroll 3
      for (int t = 0; t < Tile; ++t)
      {
#pragma GCC unroll 3
        for (int s = 0; s < (IsDiagonal ? t + 1 : Tile); ++s)
        {
          rest[t][s] -= scaled[k][t] * factors[k][s];
        }
      }
    }
  }

  inline void FactorRows(const Moments& moments, int first)
  {
    Vec(*factors)[Tile] = this->L[first / Tile];
    Vec scaled[Rows][Tile]; // L times D
    Vec rest[Tile][Tile];
    for (int column = 0; column < first; column += Tile)
    {
      this->template Eliminate<false>(moments, scaled, first, column, rest);
      const Vec(*above)[Tile] = this->L[column / Tile];
#pragma GCC unroll 3
      for (int t = 0; t < Tile; ++t)
      {
        const Vec s0 = rest[t][0];
        const Vec s1 = rest[t][1] - s0 * above[column][1];
        const Vec s2 = rest[t][2] - s0 * above[column][2] - s1 * above[column + 1][2];
        scaled[column][t] = s0;
        scaled[column + 1][t] = s1;
        scaled[column + 2][t] = s2;
        factors[column][t] = s0 * this->inverseD[column];
        factors[column + 1][t] = s1 * this->inverseD[column + 1];
        factors[column + 2][t] = s2 * this->inverseD[column + 2];
      }
    }
    this->template Eliminate<true>(moments, scaled, first, first, rest);
    this->FactorTile(moments, first, rest);
  }

  inline void FactorTile(const Moments& moments, int first, const Vec (&rest)[Tile][Tile])
  {
    Vec(*factors)[Tile] = this->L[first / Tile];
    this->Accept(moments, first, rest[0][0]);
    const Vec l10 = rest[1][0] * this->inverseD[first];
    const Vec l20 = rest[2][0] * this->inverseD[first];
    this->Accept(moments, first + 1, rest[1][1] - rest[1][0] * l10);
    const Vec s21 = rest[2][1] - rest[2][0] * l10;
    const Vec l21 = s21 * this->inverseD[first + 1];
    this->Accept(moments, first + 2, rest[2][2] - rest[2][0] * l20 - s21 * l21);
    factors[first][1] = l10;
    factors[first][2] = l20;
    factors[first + 1][2] = l21;
  }

  inline void Accept(const Moments& moments, int row, const Vec& pivot)
  {
    const Vec diagonal = MatrixElement(moments, row, row);
    // Not finite once means not finite in the last row.
    this->excess = Min(this->excess, pivot - ridges::JetBatchKernel::SmallestPivotRatio * diagonal);
    this->inverseD[row] = 1.0 / pivot;
  }
};

} // namespace

#endif
