// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// How the Monge forms of a batch follow the coefficients: the formulas of JetErrors.cxx. Included
// by JetBatchErrors.h only.
#ifndef ridges_JetBatchGradients_h
#define ridges_JetBatchGradients_h

#include "Fit/Batch/JetBatchDerivativeForms.h"

namespace
{

constexpr int Quantities = ridges::JetBatch::NumberOfErrors; // k1, k2, b0, b1, b2, b3, P1, P2
constexpr int MongeCoefficients = NumberOfMonomials(4);

/// By coefficient of the polynomial, up to order 4, and quantity.
struct Gradients
{
  Vec at[MongeCoefficients][Quantities];
};

/// The Monge forms of the lanes, as they were stored.
struct LaneMonge
{
  Vec k1, k2;
  Vec b[4];
  Vec c[5];

  inline explicit LaneMonge(const ridges::JetBatch& batch)
    : k1(Load(batch.k1))
    , k2(Load(batch.k2))
  {
    for (int i = 0; i < 4; ++i)
    {
      this->b[i] = Load(batch.b + i * Lanes);
    }
    for (int i = 0; i < 5; ++i)
    {
      this->c[i] = Load(batch.c + i * Lanes);
    }
  }
};

/// See ChangeOfMongeForm in JetErrors.cxx, of which these are the derivatives.
inline void SetGradients(const LaneMonge& m, const DerivativeForms& d, Gradients& gradients)
{
  enum
  {
    K1 = 0,
    K2 = 1,
    B0 = 2,
    P1 = 6,
    P2 = 7
  };
  auto& g = gradients.at;
  const Vec perGap = 1.0 / (m.k1 - m.k2);
  const Vec* b = m.b;
  const Vec* c = m.c;
  const Vec turn[4] = { 3.0 * b[1] * perGap, (2.0 * b[2] - b[0]) * perGap,
    (b[3] - 2.0 * b[1]) * perGap, -3.0 * b[2] * perGap };
  const Vec tilt[4] = { -3.0 * m.k1 * m.k1, -m.k1 * m.k2, -m.k1 * m.k2, -3.0 * m.k2 * m.k2 };
  const Vec gap = m.k1 - m.k2;
  const Vec excess1 = c[0] - 3.0 * m.k1 * m.k1 * m.k1;
  const Vec excess2 = c[4] - 3.0 * m.k2 * m.k2 * m.k2;
  for (int q = 0; q < Quantities; ++q)
  {
    g[0][q] = Vec{};
  }
  for (int j = 0; j <= 1; ++j)
  {
    auto& row = g[MonomialIndex(1 - j, j)];
    row[K1] = Vec{};
    row[K2] = Vec{};
    for (int i = 0; i < 4; ++i)
    {
      row[B0 + i] = tilt[i] * d.first[i % 2][j];
    }
    row[P1] = 6.0 * b[1] * row[B0 + 1] -
      gap * m.k1 * (10.0 * b[0] * d.first[0][j] + 6.0 * b[1] * d.first[1][j]);
    row[P2] = 6.0 * b[2] * row[B0 + 2] +
      gap * m.k2 * (6.0 * b[2] * d.first[0][j] + 10.0 * b[3] * d.first[1][j]);
  }
  for (int j = 0; j <= 2; ++j)
  {
    auto& row = g[MonomialIndex(2 - j, j)];
    row[K1] = d.second[0][j];
    row[K2] = d.second[2][j];
    for (int i = 0; i < 4; ++i)
    {
      row[B0 + i] = turn[i] * d.second[1][j];
    }
    // Times the gap, turning is the second derivative itself.
    row[P1] = 6.0 * b[1] * row[B0 + 1] + (row[K1] - row[K2]) * excess1 +
      4.0 * c[1] * d.second[1][j] - 9.0 * gap * m.k1 * m.k1 * row[K1];
    row[P2] = 6.0 * b[2] * row[B0 + 2] + (row[K2] - row[K1]) * excess2 +
      4.0 * c[3] * d.second[1][j] + 9.0 * gap * m.k2 * m.k2 * row[K2];
  }
  for (int j = 0; j <= 3; ++j)
  {
    auto& row = g[MonomialIndex(3 - j, j)];
    row[K1] = Vec{};
    row[K2] = Vec{};
    for (int i = 0; i < 4; ++i)
    {
      row[B0 + i] = d.third[i][j];
    }
    row[P1] = 6.0 * b[1] * d.third[1][j];
    row[P2] = 6.0 * b[2] * d.third[2][j];
  }
  for (int j = 0; j <= 4; ++j)
  {
    auto& row = g[MonomialIndex(4 - j, j)];
    for (int q = 0; q < P1; ++q)
    {
      row[q] = Vec{};
    }
    row[P1] = gap * d.fourth1[j];
    row[P2] = -gap * d.fourth2[j];
  }
}

inline void SetGradients(
  const ridges::JetBatch& batch, const Frame& frame, const Extents& extents, Gradients& gradients)
{
  const Vec3 d1 = Load3(batch.d1);
  const Vec3 d2 = Load3(batch.d2);
  const DerivativeForms forms({ Dot(d1, frame.u), Dot(d1, frame.v) },
    { Dot(d2, frame.u), Dot(d2, frame.v) }, Dot(Load3(batch.n), frame.n), 1.0 / frame.radius,
    extents);
  SetGradients(LaneMonge(batch), forms, gradients);
}

} // namespace

#endif
