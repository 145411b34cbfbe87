// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// From fitted polynomials to Monge forms: the formulas of MongeForm.cxx, for a batch. Included by
// JetBatchKernel.h only.
#ifndef ridges_JetBatchMonge_h
#define ridges_JetBatchMonge_h

#include "Fit/Batch/JetBatchFrame.h"

namespace
{

/// As SymmetricTensor.h, for lanes.
template <int Order>
struct LaneTensor
{
  Vec values[Order + 1];
};

struct Axis
{
  Vec u, v;
};

template <int Order>
inline LaneTensor<Order - 1> Contract(const LaneTensor<Order>& tensor, const Axis& w)
{
  LaneTensor<Order - 1> result;
#pragma GCC unroll 5
  for (int j = 0; j < Order; ++j)
  {
    result.values[j] = tensor.values[j] * w.u + tensor.values[j + 1] * w.v;
  }
  return result;
}

template <int Order>
inline LaneTensor<Order> InBasis(const LaneTensor<Order>& tensor, const Axis& e, const Axis& f)
{
  if constexpr (Order == 0)
  {
    return tensor;
  }
  else
  {
    const auto withE = InBasis(Contract(tensor, e), e, f);
    const auto withF = InBasis(Contract(tensor, f), e, f);
    LaneTensor<Order> result;
    result.values[0] = withE.values[0];
#pragma GCC unroll 5
    for (int j = 1; j <= Order; ++j)
    {
      result.values[j] = withF.values[j - 1];
    }
    return result;
  }
}

/// The derivatives of one order, from coefficients of monomials in units of the radius; zero
/// where the polynomial does not have them.
template <int Order, int Degree>
inline LaneTensor<Order> Derivatives(const Vec* coefficients, const Vec& perRadius)
{
  constexpr double factorials[] = { 1.0, 1.0, 2.0, 6.0, 24.0 };
  LaneTensor<Order> tensor{};
  if constexpr (Order <= Degree)
  {
    Vec scale = Broadcast(1.0);
#pragma GCC unroll 5
    for (int i = 1; i < Order; ++i)
    {
      scale *= perRadius;
    }
#pragma GCC unroll 5
    for (int j = 0; j <= Order; ++j)
    {
      tensor.values[j] =
        factorials[Order - j] * factorials[j] * scale * coefficients[Order * (Order + 1) / 2 + j];
    }
  }
  return tensor;
}

/// Cosine and sine of half the angle of (x, y), with (1, 0) for a zero vector.
inline Axis HalfAngle(const Vec& x, const Vec& y, const Vec& length)
{
  const Vec safe = length > 0.0 ? length : Broadcast(1.0);
  const Vec sum = safe + Abs(x);
  const Vec perNorm = 1.0 / Sqrt(2.0 * safe * sum);
  const Vec larger = perNorm * sum;
  const Vec smaller = perNorm * Abs(y);
  const Vec cosine = x >= 0.0 ? larger : smaller;
  const Vec sine = WithSign(x >= 0.0 ? smaller : larger, y);
  return { length > 0.0 ? cosine : Broadcast(1.0), length > 0.0 ? sine : Vec{} };
}

/// The result is zero in lanes where all values are finite.
template <int Degree>
inline Vec StoreMongeForm(
  ridges::JetBatch& batch, const Frame& frame, const Vec* coefficients, const Vec& perRadius)
{
  const Vec fu = coefficients[1];
  const Vec fv = coefficients[2];
  const Vec perG = 1.0 / Sqrt(1.0 + fu * fu + fv * fv);
  const Vec3 n{ -fu * perG, -fv * perG, perG };
  const Vec perLength = 1.0 / Sqrt(1.0 + fu * fu);
  const Vec3 t1{ perLength, Vec{}, fu * perLength };
  const Vec3 t2 = Cross(n, t1);

  const auto second = Derivatives<2, Degree>(coefficients, perRadius);
  const auto third = Derivatives<3, Degree>(coefficients, perRadius);
  const auto fourth = Derivatives<4, Degree>(coefficients, perRadius);

  const auto fundamental = InBasis(second, Axis{ t1.x, t1.y }, Axis{ t2.x, t2.y });
  const Vec mean = 0.5 * perG * (fundamental.values[0] + fundamental.values[2]);
  const Vec difference = 0.5 * perG * (fundamental.values[0] - fundamental.values[2]);
  const Vec mixed = perG * fundamental.values[1];
  const Vec deviation = Sqrt(difference * difference + mixed * mixed);
  const Axis turn = HalfAngle(difference, mixed, deviation);
  const Vec3 d1 = turn.u * t1 + turn.v * t2;
  const Vec3 d2 = turn.u * t2 + (-turn.v) * t1;
  const Vec k1 = mean + deviation;
  const Vec k2 = mean - deviation;

  const Axis e1{ d1.x, d1.y };
  const Axis e2{ d2.x, d2.y };
  const Axis m{ n.x, n.y };
  const LaneTensor<1> pTensor = InBasis(Contract(second, m), e1, e2);
  const LaneTensor<2> qTensor = InBasis(Contract(third, m), e1, e2);
  const Vec* p = pTensor.values;
  const Vec* q = qTensor.values;
  const Vec s = 0.5 * Contract(Contract(second, m), m).values[0];

  LaneTensor<3> thirdOrder = InBasis(third, e1, e2);
  Vec* b = thirdOrder.values;
  b[0] = (b[0] + 3.0 * p[0] * k1) * perG;
  b[1] = (b[1] + p[1] * k1) * perG;
  b[2] = (b[2] + p[0] * k2) * perG;
  b[3] = (b[3] + 3.0 * p[1] * k2) * perG;

  LaneTensor<4> fourthOrder = InBasis(fourth, e1, e2);
  Vec* c = fourthOrder.values;
  c[0] = (c[0] + 6.0 * q[0] * k1 + 4.0 * p[0] * b[0] + 6.0 * s * k1 * k1) * perG;
  c[1] = (c[1] + 3.0 * q[1] * k1 + 3.0 * p[0] * b[1] + p[1] * b[0]) * perG;
  c[2] =
    (c[2] + q[0] * k2 + q[2] * k1 + 2.0 * (p[0] * b[2] + p[1] * b[1]) + 2.0 * s * k1 * k2) * perG;
  c[3] = (c[3] + 3.0 * q[1] * k2 + p[0] * b[3] + 3.0 * p[1] * b[2]) * perG;
  c[4] = (c[4] + 6.0 * q[2] * k2 + 4.0 * p[1] * b[3] + 6.0 * s * k2 * k2) * perG;

  const Vec gap = k1 - k2;
  const Vec P1 = 3.0 * b[1] * b[1] + gap * (c[0] - 3.0 * k1 * k1 * k1);
  const Vec P2 = 3.0 * b[2] * b[2] - gap * (c[4] - 3.0 * k2 * k2 * k2);
  const auto inSpace = [&frame](const Vec3& a)
  { return a.x * frame.u + a.y * frame.v + a.z * frame.n; };
  Store3(batch.d1, inSpace(d1));
  Store3(batch.d2, inSpace(d2));
  Store3(batch.n, inSpace(n));
  Store(batch.k1, k1);
  Store(batch.k2, k2);
  Store(batch.P1, P1);
  Store(batch.P2, P2);
  Vec zeros = 0.0 * P1 + 0.0 * P2 + 0.0 * d1.x + 0.0 * n.x;
#pragma GCC unroll 5
  for (int j = 0; j < 4; ++j)
  {
    Store(batch.b + j * Lanes, b[j]);
    zeros += 0.0 * b[j];
  }
#pragma GCC unroll 5
  for (int j = 0; j < 5; ++j)
  {
    Store(batch.c + j * Lanes, c[j]);
    zeros += 0.0 * c[j];
  }
  return zeros;
}

} // namespace

#endif
