// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Standard errors of the Monge forms of a batch: the formulas of JetErrors.cxx. Included by
// JetBatchKernel.h and JetBatchTiledKernel.h only.
#ifndef ridges_JetBatchErrors_h
#define ridges_JetBatchErrors_h

#include "Fit/Batch/JetBatchLocal.h"
#include "Fit/Batch/JetBatchMonge.h"

namespace
{

constexpr int Quantities = ridges::JetBatch::NumberOfErrors; // k1, k2, b0, b1, b2, b3, P1, P2
constexpr int MongeCoefficients = NumberOfMonomials(4);

/// The largest of |u| and |v|, inverted: the units of the monomials.
struct Extents
{
  Vec perU;
  Vec perV;
};

/// By coefficient of the polynomial, up to order 4, and quantity.
struct Gradients
{
  Vec at[MongeCoefficients][Quantities];
};

/// A form of an order in (u, v), by the power of v, times a linear one.
template <int Order>
inline void Multiply(const Vec* form, const Axis& linear, Vec* product)
{
  product[0] = form[0] * linear.u;
#pragma GCC unroll 4
  for (int j = 1; j <= Order; ++j)
  {
    product[j] = form[j] * linear.u + form[j - 1] * linear.v;
  }
  product[Order + 1] = form[Order] * linear.v;
}

/// What coefficients of the polynomial add to derivatives along d1 (taken `Order` - k times) and d2
/// (k times) at [k], of the order that they belong to.
struct DerivativeForms
{
  Vec first[2][2];
  Vec second[3][3];
  Vec third[4][4];
  Vec fourth1[5]; ///< Along d1 only.
  Vec fourth2[5]; ///< Along d2 only.

  inline DerivativeForms(
    const Axis& e1, const Axis& e2, const Vec& perG, const Vec& perRadius, const Extents& extents)
  {
    const Vec u1[2] = { e1.u, e1.v };
    const Vec u2[2] = { e2.u, e2.v };
    this->first[0][0] = e1.u;
    this->first[0][1] = e1.v;
    this->first[1][0] = e2.u;
    this->first[1][1] = e2.v;
    Multiply<1>(u1, e1, this->second[0]);
    Multiply<1>(u1, e2, this->second[1]);
    Multiply<1>(u2, e2, this->second[2]);
    Multiply<2>(this->second[0], e1, this->third[0]);
    Multiply<2>(this->second[0], e2, this->third[1]);
    Multiply<2>(this->second[2], e1, this->third[2]);
    Multiply<2>(this->second[2], e2, this->third[3]);
    Multiply<3>(this->third[0], e1, this->fourth1);
    Multiply<3>(this->third[3], e2, this->fourth2);
    // From coefficients to derivatives: see JetFit::DerivativePerCoefficient.
    constexpr double factorials[] = { 1.0, 1.0, 2.0, 6.0, 24.0 };
    Vec perLength = perG;
    for (int order = 1; order <= 4; ++order)
    {
      for (int j = 0; j <= order; ++j)
      {
        Vec factor = factorials[order - j] * factorials[j] * perLength;
        for (int k = 0; k < order; ++k)
        {
          factor *= k < j ? extents.perV : extents.perU;
        }
        this->Scale(order, j, factor);
      }
      perLength *= perRadius;
    }
  }

private:
  inline void Scale(int order, int j, const Vec& factor)
  {
    for (int k = 0; k <= order; ++k)
    {
      switch (order)
      {
        case 1:
          this->first[k][j] *= factor;
          break;
        case 2:
          this->second[k][j] *= factor;
          break;
        case 3:
          this->third[k][j] *= factor;
          break;
        default:
          this->fourth1[j] *= k == 0 ? factor : Broadcast(1.0);
          this->fourth2[j] *= k == 0 ? factor : Broadcast(1.0);
      }
    }
  }
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

/// The variances of the quantities for heights of unit variance, and how much of the weights is
/// left for estimating that variance.
struct UnitVariances
{
  Vec of[Quantities];
  Vec freedom;
};

template <int Degree>
inline void StoreErrors(ridges::JetBatch& batch, const Vec& totalWeight, const UnitVariances& unit)
{
  const Vec residual = Load(batch.residual);
  const Vec variance = residual * residual * totalWeight / unit.freedom;
  const auto isFree = Load(batch.counts) > static_cast<double>(NumberOfMonomials(Degree));
  const Vec unknown = Broadcast(ridges::JetBatch::UnknownError);
  for (int q = 0; q < Quantities; ++q)
  {
    constexpr int orders[] = { 2, 2, 3, 3, 3, 3, 4, 4 };
    const Vec error = Sqrt(variance * unit.of[q]);
    const bool isKnown = orders[q] <= Degree;
    Store(batch.errors + q * Lanes, isKnown && isFree && error - error == 0.0 ? error : unknown);
  }
}

/// Points whose monomials are solved for side by side, as none of them alone keeps the processor
/// busy.
constexpr int Together = 4;

/// Visits all points, some at once: visit(monomials, weights), with the monomials in rising order
/// and then by point, and weights of 0 for what is past the end.
template <int Degree, typename Visit>
inline void ForMonomials(const LocalPoints& points, Visit visit)
{
  for (int first = 0; first < points.rows; first += Together)
  {
    Vec monomials[NumberOfMonomials(Degree)][Together];
    Vec weights[Together];
    for (int i = 0; i < Together; ++i)
    {
      const bool isPast = first + i >= points.rows;
      const int row = isPast ? first : first + i;
      const Vec3& point = points.at[row];
      weights[i] = isPast ? Vec{} : points.Weight(row);
      monomials[0][i] = Broadcast(1.0);
      for (int d = 1; d <= Degree; ++d)
      {
        for (int j = 0; j < d; ++j)
        {
          monomials[MonomialIndex(d - j, j)][i] =
            monomials[MonomialIndex(d - 1 - j, j)][i] * point.x;
        }
        monomials[MonomialIndex(0, d)][i] = monomials[MonomialIndex(0, d - 1)][i] * point.y;
      }
    }
    visit(monomials, weights);
  }
}

/// With weights each point counts with the square of its weight, and takes a part of the freedom.
/// Takes L^-1 times the monomials, by row; rowOf(k) is the row of coefficient k, of which the first
/// `count` have a gradient.
template <typename RowOf>
inline void AddWeighted(const Vec (*solution)[Together], const Vec* inverseD, int rows,
  const Gradients& solved, int count, RowOf rowOf, const Vec (&weights)[Together],
  UnitVariances& unit)
{
  Vec leverage[Together]{};
  for (int row = 0; row < rows; ++row)
  {
#pragma GCC unroll 4
    for (int i = 0; i < Together; ++i)
    {
      leverage[i] += solution[row][i] * solution[row][i] * inverseD[row];
    }
  }
  for (int i = 0; i < Together; ++i)
  {
    unit.freedom -= weights[i] * weights[i] * leverage[i];
    Vec shares[Quantities]{};
    for (int k = 0; k < count; ++k)
    {
      const int row = rowOf(k);
      const Vec scaled = solution[row][i] * inverseD[row];
#pragma GCC unroll 8
      for (int q = 0; q < Quantities; ++q)
      {
        shares[q] += solved.at[k][q] * scaled;
      }
    }
#pragma GCC unroll 8
    for (int q = 0; q < Quantities; ++q)
    {
      const Vec share = weights[i] * shares[q];
      unit.of[q] += share * share;
    }
  }
}

inline void BeginWeighted(UnitVariances& unit, const Vec& totalWeight)
{
  for (Vec& variance : unit.of)
  {
    variance = Vec{};
  }
  unit.freedom = totalWeight;
}

} // namespace

#endif
