// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Triangular solves of any degree, in tiles. Included by JetBatchTiledEquations.h only.
#ifndef ridges_JetBatchTiledFactors_h
#define ridges_JetBatchTiledFactors_h

#include "Fit/Batch/JetBatchTiledSums.h"

namespace
{

/**
 * The factors L and D of a matrix of moments. The monomials come in falling order, so that the rows
 * of those up to order 4 are the last: the factors of the last rows alone give the covariance of
 * their coefficients. Rows that fill up the first tile are those of the identity.
 */
template <int Degree>
struct TiledFactors
{
  static constexpr int Size = NumberOfMonomials(Degree);
  static constexpr int Rows = Padded(Size);
  static constexpr int First = Rows - Size; ///< Those before are of the identity.

  Vec L[Rows / Tile][Rows][Tile]; ///< Row Tile * b + t, column k at [b][k][t].
  Vec inverseD[Rows];

  /// The row of a monomial, by its place in rising order.
  static constexpr int RowOf(int index) { return Rows - 1 - index; }

  inline const Vec& Element(int row, int column) const
  {
    return this->L[row / Tile][column][row % Tile];
  }

  /// L x = b.
  inline void SolveForward(Vec* x) const
  {
    for (int first = 0; first < Rows; first += Tile)
    {
      this->SolveForward(first, x);
    }
  }

  /// The same for some right-hand sides at once.
  template <int Sides>
  inline void SolveForward(Vec (&x)[Rows][Sides]) const
  {
    for (int first = 0; first < Rows; first += Tile)
    {
      const Vec(*factors)[Tile] = this->L[first / Tile];
      Vec rest[Tile][Sides];
#pragma GCC unroll 3
      for (int t = 0; t < Tile; ++t)
      {
#pragma GCC unroll 4
        for (int i = 0; i < Sides; ++i)
        {
          rest[t][i] = x[first + t][i];
        }
      }
      for (int k = First; k < first; ++k)
      {
#pragma GCC unroll 3
        for (int t = 0; t < Tile; ++t)
        {
#pragma GCC unroll 4
          for (int i = 0; i < Sides; ++i)
          {
            rest[t][i] -= factors[k][t] * x[k][i];
          }
        }
      }
#pragma GCC unroll 4
      for (int i = 0; i < Sides; ++i)
      {
        rest[1][i] -= factors[first][1] * rest[0][i];
        rest[2][i] -= factors[first][2] * rest[0][i] + factors[first + 1][2] * rest[1][i];
        x[first][i] = rest[0][i];
        x[first + 1][i] = rest[1][i];
        x[first + 2][i] = rest[2][i];
      }
    }
  }

  inline void Solve(Vec* x) const
  {
    this->SolveForward(x);
    for (int row = 0; row < Rows; ++row)
    {
      x[row] *= this->inverseD[row];
    }
    for (int first = Rows - Tile; first >= 0; first -= Tile)
    {
      this->SolveInTile(first, x);
      this->Subtract(first, x, x);
    }
  }

  /// A y with L^T y = D^(-1/2) s, to within 4 %: see NormalEquations::Probe.
  inline void Probe(Vec* y) const
  {
    for (int row = 0; row < Rows; ++row)
    {
      y[row] = Vec{};
    }
    for (int first = Rows - Tile; first >= 0; first -= Tile)
    {
      const Vec(*factors)[Tile] = this->L[first / Tile];
#pragma GCC unroll 3
      for (int t = Tile - 1; t >= 0; --t)
      {
        Vec sum = y[first + t];
#pragma GCC unroll 3
        for (int below = Tile - 1; below > t; --below)
        {
          sum -= factors[first + t][below] * y[first + below];
        }
        y[first + t] = sum + CopySign(RoughRoot(this->inverseD[first + t]), sum);
      }
      this->Subtract(first, y, y);
    }
  }

private:
  /// Of L x = b, the rows of a tile.
  inline void SolveForward(int first, Vec* x) const
  {
    const Vec(*factors)[Tile] = this->L[first / Tile];
    Vec rest[Tile] = { x[first], x[first + 1], x[first + 2] };
    for (int k = First; k < first; ++k)
    {
#pragma GCC unroll 3
      for (int t = 0; t < Tile; ++t)
      {
        rest[t] -= factors[k][t] * x[k];
      }
    }
    x[first] = rest[0];
    x[first + 1] = rest[1] - factors[first][1] * x[first];
    x[first + 2] = rest[2] - factors[first][2] * x[first] - factors[first + 1][2] * x[first + 1];
  }

  /// Of L^T x = b, the rows of a tile.
  inline void SolveInTile(int first, Vec* x) const
  {
    const Vec(*factors)[Tile] = this->L[first / Tile];
    x[first + 1] -= factors[first + 1][2] * x[first + 2];
    x[first] -= factors[first][2] * x[first + 2] + factors[first][1] * x[first + 1];
  }

  /// What the solution x in the rows of a tile takes from all rows above it.
  inline void Subtract(int first, const Vec* x, Vec* from) const
  {
    const Vec(*factors)[Tile] = this->L[first / Tile];
    const Vec x0 = x[first];
    const Vec x1 = x[first + 1];
    const Vec x2 = x[first + 2];
    for (int k = First; k < first; ++k)
    {
      from[k] -= factors[k][0] * x0 + factors[k][1] * x1 + factors[k][2] * x2;
    }
  }
};

} // namespace

#endif
