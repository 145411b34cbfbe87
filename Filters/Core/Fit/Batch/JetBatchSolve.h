// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The normal equations of a batch of neighbourhoods. Included by JetBatchKernel.h only.
#ifndef ridges_JetBatchSolve_h
#define ridges_JetBatchSolve_h

#include "Fit/Batch/JetBatchMoments.h"

namespace
{

/// LDL^T of the matrix of moments, two rows at a time: with the pivot p of the first, and with s
/// and q what is left in the second below p and on the diagonal, the next pivot is q - s^2 / p, and
/// the inverse of that p / (p q - s^2) does not have to wait for 1 / p.
template <int Degree>
struct NormalEquations
{
  static constexpr int Size = NumberOfMonomials(Degree);
  using Moments = Vec[2 * Degree + 1][2 * Degree + 1];

  Vec L[Size][Size];
  Vec inverseD[Size];
  Vec excess; ///< Least of what pivots have above SmallestPivotRatio.

  inline void Factor(const Moments& moments)
  {
    this->excess = moments[0][0];
#pragma GCC unroll 8
    for (int row = 0; row < Size; row += 2)
    {
      Vec scaled[Size];
      const Vec pivot = this->Eliminate(moments, row, row, scaled);
      const Vec perPivot = 1.0 / pivot;
      this->Accept(moments, row, pivot, perPivot);
      if (row + 1 < Size)
      {
        const Vec rest = this->Eliminate(moments, row + 1, row, scaled);
        const Vec below = scaled[row];
        const Vec determinant = pivot * rest - below * below;
        this->L[row + 1][row] = below * perPivot;
        this->Accept(moments, row + 1, determinant * perPivot, pivot / determinant);
      }
    }
  }

  inline void Solve(Vec* x) const
  {
#pragma GCC unroll 15
    for (int row = 1; row < Size; ++row)
    {
#pragma GCC unroll 15
      for (int column = 0; column < row; ++column)
      {
        x[row] -= this->L[row][column] * x[column];
      }
    }
#pragma GCC unroll 15
    for (int row = Size - 1; row >= 0; --row)
    {
      // The latest value comes last, so that only its product has to be waited for.
      x[row] *= this->inverseD[row];
#pragma GCC unroll 15
      for (int below = Size - 1; below > row; --below)
      {
        x[row] -= this->L[below][row] * x[below];
      }
    }
  }

  /// The first of the coefficients that are probed: those of the degree, and of degree 3.
  static constexpr int FirstProbed = NumberOfMonomials(Degree > 3 ? 2 : Degree - 1);

  /**
   * Fixes the elements of y from FirstProbed on, where L^T y = D^(-1/2) s, to within 4 %, for signs
   * s that are chosen one after the other so that y grows.
   *
   * With A^T A being what was factored, |y|^2 / |s|^2 is a lower bound of
   * 1 / (least singular value of A)^2. It finds the polynomial that is nearly zero at all points
   * whatever its coefficients are: some of those of the degree are large. Pivots alone do not: the
   * last of them is small only if the last coefficient of that polynomial is large. For signs at
   * random the mean of the square of an element would be the variance of the coefficient, for
   * values of unit variance.
   */
  inline void Probe(Vec* y) const
  {
#pragma GCC unroll 15
    for (int row = Size - 1; row >= FirstProbed; --row)
    {
      Vec sum{};
#pragma GCC unroll 15
      for (int below = Size - 1; below > row; --below)
      {
        sum -= this->L[below][row] * y[below];
      }
      y[row] = sum + CopySign(RoughRoot(this->inverseD[row]), sum);
    }
  }

private:
  /// A row of L times D left of the diagonal, and of L left of `end`; the result is what that
  /// leaves of the diagonal.
  inline Vec Eliminate(const Moments& moments, int row, int end, Vec (&scaled)[Size])
  {
    const Monomial r = Monomials[row];
#pragma GCC unroll 15
    for (int column = 0; column < row; ++column)
    {
      const Monomial c = Monomials[column];
      Vec value = moments[r.j + c.j][r.i + c.i];
#pragma GCC unroll 15
      for (int k = 0; k < column; ++k)
      {
        value -= scaled[k] * this->L[column][k];
      }
      scaled[column] = value;
    }
    Vec rest = moments[2 * r.j][2 * r.i];
#pragma GCC unroll 15
    for (int column = 0; column < end; ++column)
    {
      this->L[row][column] = scaled[column] * this->inverseD[column];
      rest -= scaled[column] * this->L[row][column];
    }
    return rest;
  }

  inline void Accept(const Moments& moments, int row, const Vec& pivot, const Vec& perPivot)
  {
    const Vec diagonal = moments[2 * Monomials[row].j][2 * Monomials[row].i];
    // Not finite once means not finite in the last row.
    this->excess = Min(this->excess, pivot - ridges::JetBatchKernel::SmallestPivotRatio * diagonal);
    this->inverseD[row] = perPivot;
  }
};

} // namespace

#endif
