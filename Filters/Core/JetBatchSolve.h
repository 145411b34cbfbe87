// SPDX-License-Identifier: BSD-3-Clause
// The normal equations of a batch of neighbourhoods. Included by JetBatchKernel.h only.
#ifndef ridges_JetBatchSolve_h
#define ridges_JetBatchSolve_h

#include "JetBatchMoments.h"

namespace
{

/// LDL^T of the matrix of moments, row by row.
template <int Degree>
struct NormalEquations
{
  static constexpr int Size = NumberOfMonomials(Degree);

  Vec L[Size][Size];
  Vec inverseD[Size];
  Vec excess; ///< Least of what pivots have above SmallestPivotRatio.
  Vec largestPivot;
  Vec smallestPivot;

  inline void Factor(const Vec (&moments)[2 * Degree + 1][2 * Degree + 1])
  {
    this->excess = moments[0][0];
    this->largestPivot = moments[0][0];
    this->smallestPivot = moments[0][0];
#pragma GCC unroll 15
    for (int row = 0; row < Size; ++row)
    {
      const Monomial r = Monomials[row];
      Vec scaled[Size]; // row of L times D
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
      const Vec diagonal = moments[2 * r.j][2 * r.i];
      Vec pivot = diagonal;
#pragma GCC unroll 15
      for (int column = 0; column < row; ++column)
      {
        this->L[row][column] = scaled[column] * this->inverseD[column];
        pivot -= scaled[column] * this->L[row][column];
      }
      // Not finite once means not finite in the last row.
      this->excess =
        Min(this->excess, pivot - ridges::JetBatchKernel::SmallestPivotRatio * diagonal);
      this->largestPivot = Max(this->largestPivot, pivot);
      this->smallestPivot = Min(this->smallestPivot, pivot);
      this->inverseD[row] = 1.0 / pivot;
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
};

} // namespace

#endif
