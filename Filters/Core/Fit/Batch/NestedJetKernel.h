// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// What FitNestedJets... and BlendNestedJets... do, for RIDGES_LANES lanes: see NestedJetBatch.h.
#ifndef ridges_NestedJetKernel_h
#define ridges_NestedJetKernel_h

#include "Fit/Batch/NestedJetSums.h"

namespace
{

/// What of the squares of heights a polynomial leaves, in units of the radius, from the right-hand
/// side of its equations.
inline Vec ResidualOf(
  const Vec& squares, const Vec* rightHandSide, const Vec* solution, int size, const Vec& count)
{
  Vec rest = squares;
  for (int k = 0; k < size; ++k)
  {
    rest -= rightHandSide[k] * solution[k];
  }
  return Sqrt(Max(rest, Vec{}) / count);
}

template <int Degree>
inline void StoreNestedFit(ridges::JetBatch& batch, const Frame& frame, const Vec& residual,
  const Vec& excess, const Vec* coefficients)
{
  Store(batch.residual, residual);
  Store(batch.radius, frame.radius);
  Vec zeros = 0.0 * residual;
  for (int k = 0; k < ridges::NestedJetBatch::NumberOfCoefficients; ++k)
  {
    zeros += 0.0 * coefficients[k];
  }
  Store(batch.good, excess > 0.0 && !frame.failed && zeros == 0.0 ? Broadcast(1.0) : Vec{});
  StoreDoubt<Degree>(batch, frame, residual);
}

/// In units of the radius of that neighbourhood, and then of the largest.
inline void FitInner(ridges::JetBatch& batch, const NestedPoints& points, const NestedSums& sums,
  const Frame& frame, double* jet)
{
  constexpr int degree = ridges::NestedJetBatch::Degrees[0];
  constexpr int order = 2 * degree;
  constexpr int size = NumberOfMonomials(degree);
  const Vec perRadius = 1.0 / frame.radius;
  Vec powersOfU[order + 1];
  powersOfU[0] = Broadcast(1.0);
  for (int i = 1; i <= order; ++i)
  {
    powersOfU[i] = powersOfU[i - 1] * points.unitOfU * perRadius;
  }
  const Vec height = points.radius[NestedFits - 1] * perRadius;
  Vec moments[order + 1][order + 1];
  Vec coefficients[size];
  Vec powerOfV = Broadcast(1.0);
  for (int j = 0; j <= order; ++j)
  {
    for (int i = 0; i + j <= order; ++i)
    {
      moments[j][i] = powersOfU[i] * powerOfV * sums.moments.at[j][i];
      if (i + j <= degree)
      {
        coefficients[MonomialIndex(i, j)] =
          height * powersOfU[i] * powerOfV * sums.heights.at[j][i];
      }
    }
    powerOfV *= points.unitOfV * perRadius;
  }
  NormalEquations<degree> equations;
  equations.Factor(moments);
  StoreQuality<degree>(batch, frame, equations, moments[0][0]);
  Vec rightHandSide[size];
  for (int k = 0; k < size; ++k)
  {
    rightHandSide[k] = coefficients[k];
  }
  equations.Solve(coefficients);
  const Vec residual =
    ResidualOf(height * height * sums.squares, rightHandSide, coefficients, size, moments[0][0]);
  StoreNestedFit<degree>(batch, frame, residual, equations.excess, coefficients);
  Vec scale = 1.0 / height;
  for (int d = 0; d <= degree; ++d)
  {
    for (int j = 0; j <= d; ++j)
    {
      const int k = MonomialIndex(d - j, j);
      Store(jet + k * Lanes, scale * coefficients[k]);
    }
    scale *= height;
  }
}

inline void FitLargest(ridges::JetBatch& batch, const NestedPoints& points, const NestedSums& sums,
  const Frame& frame, double* jet)
{
  using Equations = TiledEquations<NestedDegree>;
  const Extents extents{ frame.radius / points.unitOfU, frame.radius / points.unitOfV };
  Equations equations;
  equations.Factor(sums.moments);
  const Vec count = sums.moments.at[0][0];
  StoreTiledQuality<NestedDegree>(batch, frame, equations, count, extents);
  Vec rightHandSide[Equations::Rows];
  Vec solution[Equations::Rows];
  ToRows<NestedDegree>(sums.heights, rightHandSide);
  ToRows<NestedDegree>(sums.heights, solution);
  equations.Solve(solution);
  const Vec residual = ResidualOf(sums.squares, rightHandSide, solution, Equations::Rows, count);
  PowerSums<NestedDegree> coefficients;
  coefficients.Clear();
  AddRowsTo<NestedDegree>(coefficients, solution);
  Vec low[ridges::NestedJetBatch::NumberOfCoefficients];
  ToUnitsOfRadius<NestedDegree>(coefficients, extents, low);
  StoreNestedFit<NestedDegree>(batch, frame, residual, equations.excess, low);
  for (int k = 0; k < ridges::NestedJetBatch::NumberOfCoefficients; ++k)
  {
    Store(jet + k * Lanes, low[k]);
  }
}

inline void FitNested(ridges::NestedJetBatch& nested)
{
  NestedPoints points;
  SetNestedPoints(nested, points);
  Store3(nested.axes, points.frame.u);
  Store3(nested.axes + 3 * Lanes, points.frame.v);
  Store3(nested.axes + 6 * Lanes, points.frame.n);
  points.local.at[0] = Vec3{};

  NestedSums sums;
  sums.moments.Clear();
  sums.heights.Clear();
  Vec before{};
  for (int i = 0; i < NestedFits; ++i)
  {
    ridges::JetBatch& batch = nested.fits[i];
    const Vec counts = Load(batch.counts);
    int first = batch.rows;
    for (int lane = 0; lane < Lanes; ++lane)
    {
      const int end = static_cast<int>(before[lane]);
      first = end < first ? end : first;
    }
    sums.Add(points.local, first, batch.rows, before, counts);
    before = counts;
    Frame frame = points.frame;
    frame.radius = points.radius[i];
    JudgeSpread(points, sums, frame);
    double* jet = nested.jets + i * ridges::NestedJetBatch::NumberOfCoefficients * Lanes;
    if (i + 1 < NestedFits)
    {
      FitInner(batch, points, sums, frame, jet);
    }
    else
    {
      FitLargest(batch, points, sums, frame, jet);
    }
  }
}

inline void BlendNested(ridges::NestedJetBatch& nested)
{
  constexpr int size = ridges::NestedJetBatch::NumberOfCoefficients;
  ridges::JetBatch& batch = nested.fits[NestedFits - 1];
  Frame frame;
  frame.u = Load3(nested.axes);
  frame.v = Load3(nested.axes + 3 * Lanes);
  frame.n = Load3(nested.axes + 6 * Lanes);
  Vec mean[size]{};
  for (int i = 0; i < NestedFits; ++i)
  {
    const Vec share = Load(nested.shares + i * Lanes);
    for (int k = 0; k < size; ++k)
    {
      mean[k] += share * Load(nested.jets + (i * size + k) * Lanes);
    }
  }
  const Vec zeros = StoreMongeForm<4>(batch, frame, mean, 1.0 / Load(batch.radius));
  Store(batch.good, zeros == 0.0 ? Load(batch.good) : Vec{});
}

} // namespace

#endif
