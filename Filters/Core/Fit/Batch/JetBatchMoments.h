// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Sums of monomials over a batch of neighbourhoods. Included by JetBatchKernel.h only.
#ifndef ridges_JetBatchMoments_h
#define ridges_JetBatchMoments_h

#include "Fit/Batch/JetBatch.h"
#include "Fit/Batch/LaneVector.h"

namespace
{

/// Exponents of the monomials u^i v^j by degree, and in a degree by growing j.
struct Monomial
{
  int i;
  int j;
};
constexpr Monomial Monomials[15] = { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 2, 0 }, { 1, 1 }, { 0, 2 },
  { 3, 0 }, { 2, 1 }, { 1, 2 }, { 0, 3 }, { 4, 0 }, { 3, 1 }, { 2, 2 }, { 1, 3 }, { 0, 4 } };

constexpr int MonomialIndex(int i, int j)
{
  return (i + j) * (i + j + 1) / 2 + j;
}

constexpr int NumberOfMonomials(int degree)
{
  return (degree + 1) * (degree + 2) / 2;
}

/// The points of the neighbourhoods in their frames, in units of the radius: u, v and the height.
/// The first is the vertex, which is the origin.
struct LocalPoints
{
  int rows;
  Vec3 at[ridges::JetBatch::MaximumRows + 1];
  const double* weights;

  Vec Weight(int row) const { return Load(this->weights + row * Lanes); }
};

/// The sums of w u^i v^j with i + j <= Order and j in [First, Last].
template <int Order, int First, int Last>
inline void AddMoments(const LocalPoints& points, Vec (&moments)[Order + 1][Order + 1])
{
  // Unrolled to the last, so that sums live in registers from zero to the end.
  Vec sums[Last - First + 1][Order - First + 1];
#pragma GCC unroll 8
  for (int j = 0; j <= Last - First; ++j)
  {
#pragma GCC unroll 9
    for (int i = 0; i <= Order - First; ++i)
    {
      sums[j][i] = Vec{};
    }
  }
  if (First == 0)
  {
    sums[0][0] = points.Weight(0);
  }
  for (int row = 1; row < points.rows; ++row)
  {
    const Vec u = points.at[row].x;
    const Vec v = points.at[row].y;
    Vec powersOfV[Last - First + 1]; // from v^0
    powersOfV[0] = Broadcast(1.0);
#pragma GCC unroll 8
    for (int j = 1; j <= Last - First; ++j)
    {
      powersOfV[j] = powersOfV[j - 1] * v;
    }
    Vec power = points.Weight(row); // w v^First u^i
#pragma GCC unroll 8
    for (int j = 0; j < First; ++j)
    {
      power *= v;
    }
#pragma GCC unroll 9
    for (int i = 0; i <= Order - First; ++i)
    {
      sums[0][i] += power;
#pragma GCC unroll 8
      for (int j = 1; j <= Last - First; ++j)
      {
        if (i + j <= Order - First)
        {
          sums[j][i] += power * powersOfV[j];
        }
      }
      power *= u;
    }
  }
#pragma GCC unroll 8
  for (int j = First; j <= Last; ++j)
  {
#pragma GCC unroll 9
    for (int i = 0; i + j <= Order; ++i)
    {
      moments[j][i] = sums[j - First][i];
    }
  }
}

/// The sums of value(row) u^i v^j over the rows, with the value at the vertex given.
template <int Degree, typename Value>
inline void Project(const LocalPoints& points, const Vec& atVertex, Value value, Vec* sums)
{
  constexpr int size = NumberOfMonomials(Degree);
  Vec local[size];
  local[0] = atVertex;
#pragma GCC unroll 15
  for (int k = 1; k < size; ++k)
  {
    local[k] = Vec{};
  }
  for (int row = 1; row < points.rows; ++row)
  {
    const Vec u = points.at[row].x;
    const Vec v = points.at[row].y;
    Vec powersOfV[Degree + 1];
    powersOfV[0] = Broadcast(1.0);
#pragma GCC unroll 5
    for (int j = 1; j <= Degree; ++j)
    {
      powersOfV[j] = powersOfV[j - 1] * v;
    }
    Vec power = value(row);
#pragma GCC unroll 5
    for (int i = 0; i <= Degree; ++i)
    {
      local[MonomialIndex(i, 0)] += power;
#pragma GCC unroll 5
      for (int j = 1; j <= Degree - i; ++j)
      {
        local[MonomialIndex(i, j)] += power * powersOfV[j];
      }
      power *= u;
    }
  }
#pragma GCC unroll 15
  for (int k = 0; k < size; ++k)
  {
    sums[k] = local[k];
  }
}

/// The polynomial with these coefficients at a row, by Horner's rule in v.
template <int Degree>
inline Vec Evaluate(const Vec* coefficients, const Vec& u, const Vec& v)
{
  Vec value{};
#pragma GCC unroll 5
  for (int j = Degree; j >= 0; --j)
  {
    Vec inner = coefficients[MonomialIndex(Degree - j, j)];
#pragma GCC unroll 5
    for (int i = Degree - j - 1; i >= 0; --i)
    {
      inner = inner * u + coefficients[MonomialIndex(i, j)];
    }
    value = value * v + inner;
  }
  return value;
}

} // namespace

#endif
