// SPDX-License-Identifier: BSD-3-Clause
// What FitJetBatch... do, for RIDGES_LANES lanes: see JetBatch.h. Every lane does the same
// arithmetic whatever its neighbours hold, and rows past its end add zeros, so that the result of a
// vertex does not depend on the batch it came in.
#ifndef ridges_JetBatchKernel_h
#define ridges_JetBatchKernel_h

#include "JetBatch.h"
#include "LaneVector.h"

#include "JetBatchFrame.h"
#include "JetBatchMonge.h"

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

/// The points of the neighbourhoods in their frames, in units of the radius.
struct LocalPoints
{
  int rows;
  Vec u[ridges::JetBatch::MaximumRows];
  Vec v[ridges::JetBatch::MaximumRows];
  Vec height[ridges::JetBatch::MaximumRows];
  const double* weights;
};

/// The sums of w u^i v^j with i + j <= Order and j in [First, Last].
template <int Order, int First, int Last>
inline void AddMoments(const LocalPoints& points, Vec (&moments)[Order + 1][Order + 1])
{
  Vec sums[Last - First + 1][Order - First + 1]{};
  for (int row = 0; row < points.rows; ++row)
  {
    const Vec u = points.u[row];
    const Vec v = points.v[row];
    Vec powersOfV[Last - First + 1]; // from v^0
    powersOfV[0] = Broadcast(1.0);
#pragma GCC unroll 8
    for (int j = 1; j <= Last - First; ++j)
    {
      powersOfV[j] = powersOfV[j - 1] * v;
    }
    Vec power = Load(points.weights + row * Lanes); // w v^First u^i
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
  for (int j = First; j <= Last; ++j)
  {
    for (int i = 0; i + j <= Order; ++i)
    {
      moments[j][i] = sums[j - First][i];
    }
  }
}

/// The sums of value(row) u^i v^j over the rows.
template <int Degree, typename Value>
inline void Project(const LocalPoints& points, Value value, Vec* sums)
{
  constexpr int size = NumberOfMonomials(Degree);
  Vec local[size]{};
  for (int row = 0; row < points.rows; ++row)
  {
    const Vec u = points.u[row];
    const Vec v = points.v[row];
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
  for (int k = 0; k < size; ++k)
  {
    sums[k] = local[k];
  }
}

/// LDL^T of the matrix of moments, row by row.
template <int Degree>
struct NormalEquations
{
  static constexpr int Size = NumberOfMonomials(Degree);

  Vec L[Size][Size];
  Vec inverseD[Size];
  Vec pivotRatio;
  Vec largestPivot;
  Vec smallestPivot;

  inline void Factor(const Vec (&moments)[2 * Degree + 1][2 * Degree + 1])
  {
    this->pivotRatio = Broadcast(1.0);
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
      this->pivotRatio = Min(this->pivotRatio, pivot / diagonal);
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
      x[row] *= this->inverseD[row];
#pragma GCC unroll 15
      for (int below = row + 1; below < Size; ++below)
      {
        x[row] -= this->L[below][row] * x[below];
      }
    }
  }
};

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

template <int Degree>
inline void FitDegree(ridges::JetBatch& batch)
{
  constexpr int size = NumberOfMonomials(Degree);
  constexpr int order = 2 * Degree;

  const Frame frame = PrincipalFrame(batch);
  const Vec perRadius = 1.0 / frame.radius;
  LocalPoints points;
  points.rows = batch.rows;
  points.weights = batch.weights;
  const Vec3 u = perRadius * frame.u;
  const Vec3 v = perRadius * frame.v;
  const Vec3 n = perRadius * frame.n;
  for (int row = 0; row < batch.rows; ++row)
  {
    const Vec3 offset = Load3(batch.offsets + 3 * row * Lanes);
    points.u[row] = Dot(u, offset);
    points.v[row] = Dot(v, offset);
    points.height[row] = Dot(n, offset);
  }

  // In two passes, as the sums of one would not fit in the registers.
  Vec moments[order + 1][order + 1];
  AddMoments<order, 0, 2>(points, moments);
  AddMoments<order, 3, order>(points, moments);
  NormalEquations<Degree> equations;
  equations.Factor(moments);

  Vec coefficients[size];
  Project<Degree>(
    points, [&](int row) { return Load(batch.weights + row * Lanes) * points.height[row]; },
    coefficients);
  equations.Solve(coefficients);

  // Iterative refinement: what the polynomial misses at the points, fitted once more.
  Vec squares{};
  Vec totalWeight{};
  Vec corrections[size];
  Project<Degree>(
    points,
    [&](int row)
    {
      const Vec weight = Load(batch.weights + row * Lanes);
      const Vec missed =
        points.height[row] - Evaluate<Degree>(coefficients, points.u[row], points.v[row]);
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

  Store(batch.residual, Sqrt(squares / totalWeight));
  Store(batch.conditionNumber, Sqrt(equations.largestPivot / equations.smallestPivot));
  Store(batch.radius, frame.radius);
  Store(batch.pivotRatio, frame.failed ? Vec{} : equations.pivotRatio);
  StoreMongeForm<Degree>(batch, frame, coefficients, perRadius);
}

inline void FitLanes(ridges::JetBatch& batch)
{
  switch (batch.degree)
  {
    case 2:
      return FitDegree<2>(batch);
    case 3:
      return FitDegree<3>(batch);
    default:
      return FitDegree<4>(batch);
  }
}

} // namespace

#endif
