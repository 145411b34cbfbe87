// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_RidgeRules_h
#define ridges_RidgeRules_h

namespace ridges
{

/// Which sign changes are ridges.
enum class ExtremalityRule
{
  Principal, ///< Of b0 or b3, by the acute rule: ridges of one colour.
  /// Of the Gaussian extremality b0 b3, which needs no rule (sections 4.2.2 and 5.2.3): ridges of
  /// both colours, cut and joined to each other at purple points, and broken at umbilics.
  Gaussian
};

/// Where on a crossed edge the crossing is put.
enum class CrossingRule
{
  Form,  ///< Where the extremality of MongeInterpolation vanishes.
  Linear ///< By equation (4). The same wherever the principal frames of the ends are parallel.
};

/// What decides whether a ridge is elliptic or hyperbolic.
enum class TypeRule
{
  FourthOrder, ///< The sign of P, equation (3).
  ThirdOrder   ///< Section 5.3, see IsEllipticByThirdOrder.
};

} // namespace ridges

#endif
