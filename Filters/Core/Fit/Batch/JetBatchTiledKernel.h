// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// What FitJetBatch... do in degrees 5 to 8, for RIDGES_LANES lanes: see JetBatch.h. As
// JetBatchKernel.h, but sums and factors do not fit in registers, so that they are done in tiles,
// and points are in units of their extents along principal axes, as in JetFitter.
#ifndef ridges_JetBatchTiledKernel_h
#define ridges_JetBatchTiledKernel_h

#include "Fit/Batch/JetBatchErrors.h"
#include "Fit/Batch/JetBatchLocal.h"
#include "Fit/Batch/JetBatchMonge.h"
#include "Fit/Batch/JetBatchTiles.h"
#include "Fit/DiskMoment.h"

namespace
{

/// Turns u and v to the directions in which the points spread most and least.
inline void TurnToPrincipalAxes(const ridges::JetBatch& batch, LocalPoints& points, Frame& frame)
{
  Vec u{};
  Vec v{};
  Vec uu{};
  Vec uv{};
  Vec vv{};
  for (int row = 1; row < points.rows; ++row)
  {
    const Vec3& p = points.at[row];
    u += p.x;
    v += p.y;
    uu += p.x * p.x;
    uv += p.x * p.y;
    vv += p.y * p.y;
  }
  const Vec perCount = 1.0 / Load(batch.counts);
  const Vec difference = uu - u * u * perCount - (vv - v * v * perCount);
  const Vec mixed = 2.0 * (uv - u * v * perCount);
  const Axis turn = HalfAngle(difference, mixed, Sqrt(difference * difference + mixed * mixed));
  for (int row = 1; row < points.rows; ++row)
  {
    const Vec3 p = points.at[row];
    points.at[row] = { turn.u * p.x + turn.v * p.y, turn.u * p.y - turn.v * p.x, p.z };
  }
  const Vec3 before = frame.u;
  frame.u = turn.u * before + turn.v * frame.v;
  frame.v = turn.u * frame.v - turn.v * before;
}

inline Extents DivideByExtents(LocalPoints& points)
{
  Vec u{};
  Vec v{};
  for (int row = 1; row < points.rows; ++row)
  {
    u = Max(u, Abs(points.at[row].x));
    v = Max(v, Abs(points.at[row].y));
  }
  const Extents extents{ 1.0 / u, 1.0 / v };
  for (int row = 1; row < points.rows; ++row)
  {
    points.at[row].x *= extents.perU;
    points.at[row].y *= extents.perV;
  }
  return extents;
}

/// Coefficients by rows of the equations; those that fill up the last tile are zero.
template <int Degree>
inline void ToRows(const PowerSums<Degree>& table, Vec* rows)
{
  using Equations = TiledEquations<Degree>;
  for (int row = Equations::Size; row < Equations::Rows; ++row)
  {
    rows[row] = Vec{};
  }
  for (int d = 0; d <= Degree; ++d)
  {
    for (int j = 0; j <= d; ++j)
    {
      rows[Equations::RowOf(MonomialIndex(d - j, j))] = table.at[j][d - j];
    }
  }
}

template <int Degree>
inline void AddRowsTo(PowerSums<Degree>& table, const Vec* rows)
{
  for (int d = 0; d <= Degree; ++d)
  {
    for (int j = 0; j <= d; ++j)
    {
      table.at[j][d - j] += rows[TiledEquations<Degree>::RowOf(MonomialIndex(d - j, j))];
    }
  }
}

/// By the exponents of v and u. Static, as tables of functions are copied in each call.
template <int Degree>
struct DiskMoments
{
  struct Table
  {
    double at[2 * Degree + 1][2 * Degree + 1];
  };

  static constexpr Table Make()
  {
    Table all{};
    for (int j = 0; j <= 2 * Degree; ++j)
    {
      for (int i = 0; i <= 2 * Degree; ++i)
      {
        all.at[j][i] = ridges::DiskMoment(i, j);
      }
    }
    return all;
  }

  static constexpr Table Of = Make();
};

/// The scalar products over the unit disk of a polynomial and all monomials; the result is that
/// with itself.
template <int Degree>
inline Vec ProductsOverDisk(const Vec* rows, Vec* products)
{
  using Equations = TiledEquations<Degree>;
  Vec table[Degree + 1][Degree + 1];
  for (int row = Equations::Size; row < Equations::Rows; ++row)
  {
    products[row] = Vec{};
  }
  for (int d = 0; d <= Degree; ++d)
  {
    for (int j = 0; j <= d; ++j)
    {
      table[j][d - j] = rows[Equations::RowOf(MonomialIndex(d - j, j))];
    }
  }
  Vec square{};
  for (int j = 0; j <= Degree; ++j)
  {
    for (int i = 0; i + j <= Degree; ++i)
    {
      Vec sum{};
      for (int l = j % 2; l <= Degree; l += 2) // those of odd exponents are zero
      {
        const double* moments = DiskMoments<Degree>::Of.at[j + l] + i;
        for (int k = i % 2; k + l <= Degree; k += 2)
        {
          sum += moments[k] * table[l][k];
        }
      }
      products[Equations::RowOf(MonomialIndex(i, j))] = sum;
      square += sum * table[j][i];
    }
  }
  return square;
}

/// The variance of the third derivatives as a tensor, in units of the radius, for heights of unit
/// variance.
template <int Degree>
inline Vec VarianceOfThirdOrder(const TiledEquations<Degree>& equations, const Extents& extents)
{
  using Equations = TiledEquations<Degree>;
  Vec sum{};
  for (int j = 0; j <= 3; ++j)
  {
    Vec unit = Broadcast(j == 0 || j == 3 ? 6.0 : 3.4641016151377544); // i! j! sqrt(3 over j)
    for (int k = 0; k < 3; ++k)
    {
      unit *= k < j ? extents.perV : extents.perU;
    }
    const int first = Equations::RowOf(MonomialIndex(3 - j, j));
    Vec x[NumberOfMonomials(3)];
    for (int row = first; row < Equations::Size; ++row)
    {
      Vec value = row == first ? unit : Vec{};
      for (int k = first; k < row; ++k)
      {
        value -= equations.Element(row, k) * x[k - first];
      }
      x[row - first] = value;
      sum += value * value * equations.inverseD[row];
    }
  }
  return sum;
}

/// What is known of the least squares.
template <int Degree>
inline void StoreTiledQuality(ridges::JetBatch& batch, const Frame& frame,
  const TiledEquations<Degree>& equations, const Vec& totalWeight, const Extents& extents)
{
  using Equations = TiledEquations<Degree>;
  // In terms of polynomials that are orthonormal over the unit disk, the inverse of the least
  // singular value, by one step of inverse iteration. By experience their longest column is about
  // this much longer than that of ones.
  constexpr double longest = 1.7;
  Vec probe[Equations::Rows];
  Vec products[Equations::Rows];
  equations.Probe(probe);
  const Vec before = ProductsOverDisk<Degree>(probe, products);
  Vec next[Equations::Rows];
  for (int row = 0; row < Equations::Rows; ++row)
  {
    next[row] = products[row];
  }
  equations.Solve(next);
  const Vec after = ProductsOverDisk<Degree>(next, products);
  const Vec estimate = longest * Sqrt(totalWeight * Sqrt(after / before));
  const Vec singular = Broadcast(ridges::JetBatchKernel::Singular);
  Store(
    batch.conditionNumber, frame.failed ? Vec{} : (equations.excess > 0.0 ? estimate : singular));
  const Vec counts = Load(batch.counts);
  const Vec freedom = Max(counts - static_cast<double>(Equations::Size), Broadcast(1.0));
  Store(batch.noiseGain, Sqrt(VarianceOfThirdOrder<Degree>(equations, extents) * counts / freedom));
}

/// The coefficients up to order 4, in units of the radius, in rising order.
template <int Degree>
inline void ToUnitsOfRadius(
  const PowerSums<Degree>& table, const Extents& extents, Vec (&coefficients)[15])
{
  Vec powerOfV = Broadcast(1.0);
  for (int j = 0; j <= 4; ++j)
  {
    Vec power = powerOfV;
    for (int i = 0; i + j <= 4; ++i)
    {
      coefficients[MonomialIndex(i, j)] = power * table.at[j][i];
      power *= extents.perU;
    }
    powerOfV *= extents.perV;
  }
}

/// As in JetBatchKernel.h. The gradients are of the last rows only; those left of the diagonal
/// tiles come in before.
template <int Degree>
inline void SolveGradients(
  const TiledEquations<Degree>& equations, Gradients& gradients, UnitVariances& unit)
{
  using Equations = TiledEquations<Degree>;
  for (int q = 0; q < Quantities; ++q)
  {
    unit.of[q] = Vec{};
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
        x, equations.inverseD, Equations::Size, solved, MongeCoefficients,
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

template <int Degree>
inline void FitTiled(ridges::JetBatch& batch)
{
  using Equations = TiledEquations<Degree>;
  LocalPoints points;
  Frame frame = SetLocalPoints(batch, points);
  TurnToPrincipalAxes(batch, points, frame);
  const Extents extents = DivideByExtents(points);

  PowerSums<2 * Degree> moments;
  PowerSums<Degree> coefficients; // at first the right-hand side
  SumMoments<Degree>(points, moments, coefficients);
  const Vec totalWeight = moments.at[0][0];
  Equations equations;
  equations.Factor(moments);
  StoreTiledQuality<Degree>(batch, frame, equations, totalWeight, extents);

  Vec solution[Equations::Rows];
  ToRows<Degree>(coefficients, solution);
  equations.Solve(solution);
  coefficients.Clear();
  AddRowsTo<Degree>(coefficients, solution);

  // Iterative refinement: what the polynomial misses at the points, fitted once more.
  Vec squares{};
  PowerSums<Degree> missing;
  missing.Sum(points,
    [&points, &coefficients, &squares](int row)
    {
      const Vec weight = points.Weight(row);
      const Vec3& p = points.at[row];
      const Vec missed = p.z - EvaluateTable<Degree>(coefficients, p.x, p.y);
      squares += weight * missed * missed;
      return weight * missed;
    });
  ToRows<Degree>(missing, solution);
  equations.Solve(solution);
  AddRowsTo<Degree>(coefficients, solution);

  const Vec residual = Sqrt(squares / totalWeight);
  Store(batch.residual, residual);
  Store(batch.radius, frame.radius);
  Vec low[15];
  ToUnitsOfRadius<Degree>(coefficients, extents, low);
  const Vec zeros = StoreMongeForm<4>(batch, frame, low, 1.0 / frame.radius);
  const auto good = equations.excess > 0.0 && !frame.failed && zeros + 0.0 * residual == 0.0;
  Store(batch.good, good ? Broadcast(1.0) : Vec{});
  StoreDoubt<Degree>(batch, frame, residual);
  if (batch.standardErrors)
  {
    StoreErrorsOf<Degree>(batch, frame, points, extents, equations, totalWeight);
  }
}

inline void FitTiledLanes(ridges::JetBatch& batch)
{
  switch (batch.degree)
  {
    case 5:
      return FitTiled<5>(batch);
    case 6:
      return FitTiled<6>(batch);
    case 7:
      return FitTiled<7>(batch);
    default:
      return FitTiled<8>(batch);
  }
}

} // namespace

#endif
