// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// What FitJetBatch... do in degrees 5 to 8, for RIDGES_LANES lanes: see JetBatch.h. As
// JetBatchKernel.h, but sums and factors do not fit in registers, so that they are done in tiles,
// and points are in units of their extents along principal axes, as in JetFitter.
#ifndef ridges_JetBatchTiledKernel_h
#define ridges_JetBatchTiledKernel_h

#include "Fit/Batch/JetBatchLocal.h"
#include "Fit/Batch/JetBatchMonge.h"
#include "Fit/Batch/JetBatchTiledErrors.h"
#include "Fit/Batch/JetBatchTiledQuality.h"

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

/// Coefficients by rows of the equations; those that fill up the first tile are zero.
template <int Degree>
inline void ToRows(const PowerSums<Degree>& table, Vec* rows)
{
  using Equations = TiledEquations<Degree>;
  for (int row = 0; row < Equations::First; ++row)
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
