// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Derivatives of a batch along principal directions. Included by JetBatchGradients.h and
// JetBatchTiledQuality.h only.
#ifndef ridges_JetBatchDerivativeForms_h
#define ridges_JetBatchDerivativeForms_h

#include "Fit/Batch/JetBatchLocal.h"
#include "Fit/Batch/JetBatchMonge.h"

namespace
{

/// The largest of |u| and |v|, inverted: the units of the monomials.
struct Extents
{
  Vec perU;
  Vec perV;
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

} // namespace

#endif
