// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_JetErrors_h
#define ridges_JetErrors_h

#include "Fit/JetFit.h"

#include <array>

namespace ridges
{

/// Standard errors of a Monge form, each negative where it is not known.
struct JetErrors
{
  static constexpr double Unknown = -1.0;

  double k1 = Unknown;
  double k2 = Unknown;
  std::array<double, 4> b = { Unknown, Unknown, Unknown, Unknown };
  double P1 = Unknown;
  double P2 = Unknown;
};

/// Derivatives of k1, k2, b0, b1, b2, b3, P1, P2, a column each, by those of the height, a row
/// each.
using MongeGradient = Eigen::Matrix<double, HeightJet::MaximumSize, 8>;

/**
 * How the Monge form follows the height: to first order, principal directions turning and the
 * normal tilting included. Exact where the height has no slope; with one, terms of the order of the
 * slope times a curvature times the radius of a fit are left out. Not finite where k1 = k2.
 */
MongeGradient GradientOfMongeForm(const HeightJet& jet);

/**
 * Standard errors of the Monge form of the last fit of `fitter`, which is `fit`: heights are taken
 * to be off the polynomial independently of each other, with one variance, which the residuals
 * estimate. Unknown is what the degree of the fit does not have, and all of it where there are no
 * more points than coefficients, or where these are not determined.
 */
JetErrors StandardErrors(const JetFitter& fitter, const JetFit& fit);

} // namespace ridges

#endif
