// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_ImplicitHeight_h
#define ridges_ImplicitHeight_h

#include "Formula/Taylor3.h"
#include "Monge/MongeForm.h"

#include <array>

namespace ridges
{

/**
 * The surface f(u, v, w) = 0 near the origin as a height w over the plane w = 0, which has to be
 * its tangent plane: f and its first derivatives by u and v are taken as 0, whatever round-off has
 * left of them. The derivative by w must not be 0.
 */
HeightJet HeightOfImplicit(const Taylor3<4>& f);

/**
 * The parametric surface (x, y, z)(s, t), which is (s, t, 0) to first order, as a height z over the
 * plane of x and y; terms with the third variable of the polynomials are not looked at.
 */
HeightJet HeightOfParametric(const std::array<Taylor3<4>, 3>& xyz);

} // namespace ridges

#endif
