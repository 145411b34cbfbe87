// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Condition number and noise gain of a batch, degrees 5 to 8. Included by JetBatchTiledKernel.h
// only.
#ifndef ridges_JetBatchTiledQuality_h
#define ridges_JetBatchTiledQuality_h

#include "Fit/Batch/JetBatchDerivativeForms.h"
#include "Fit/Batch/JetBatchTiledEquations.h"
#include "Fit/DiskMoment.h"

namespace
{

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
  for (int row = 0; row < Equations::First; ++row)
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
    for (int row = first; row < Equations::Rows; ++row)
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
  equations.Solve(products);
  Vec again[Equations::Rows];
  const Vec after = ProductsOverDisk<Degree>(products, again);
  const Vec estimate = longest * Sqrt(totalWeight * Sqrt(after / before));
  const Vec singular = Broadcast(ridges::JetBatchKernel::Singular);
  Store(
    batch.conditionNumber, frame.failed ? Vec{} : (equations.excess > 0.0 ? estimate : singular));
  const Vec counts = Load(batch.counts);
  const Vec freedom = Max(counts - static_cast<double>(Equations::Size), Broadcast(1.0));
  Store(batch.noiseGain, Sqrt(VarianceOfThirdOrder<Degree>(equations, extents) * counts / freedom));
}

} // namespace

#endif
