// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_TensorSmoothing_h
#define ridges_TensorSmoothing_h

#include "Monge/AcuteRule.h"
#include "Monge/MongeForm.h"

#include <array>

namespace ridges
{

/**
 * Monge forms as tensors in space, which can be averaged over points whose frames differ: no sign
 * has to be chosen for a direction, and umbilics are nothing special.
 *
 * The second-order form is T = k1 d1 d1' + k2 d2 d2', 6 numbers, stored after the normal; the third
 * order one has 10 numbers, the fourth order one 15. Where that is missing P1 and P2 are averaged
 * as they are, if they are there.
 */
using SecondOrderValues = std::array<double, 9>;
using ThirdOrderValues = std::array<double, 21>;
using FourthOrderValues = std::array<double, 34>;

SecondOrderValues SecondOrderToSpace(const MongeField& field, Id p);
ThirdOrderValues ThirdOrderToSpace(const MongeField& field, Id p);
FourthOrderValues FourthOrderToSpace(const MongeField& field, Id p); ///< Needs c.

/// The principal curvatures and directions of the tensor in the plane that the averaged normal is
/// normal to. False where that normal is zero: then opposite sides of a fold were averaged.
bool SecondOrderFromSpace(const SecondOrderValues& values, MongeForm& form);

/// The same with b. P1 and P2 of a form follow from its c, which are not averaged: here they are
/// values[19] and values[20].
bool ThirdOrderFromSpace(const ThirdOrderValues& values, MongeForm& form);

/// The same with b and c.
bool FourthOrderFromSpace(const FourthOrderValues& values, MongeForm& form);

} // namespace ridges

#endif
