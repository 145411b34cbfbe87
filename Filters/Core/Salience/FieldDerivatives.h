// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_FieldDerivatives_h
#define ridges_FieldDerivatives_h

#include "Monge/AcuteRule.h"
#include "Salience/OneRings.h"

#include <array>

namespace ridges
{

/**
 * The third- and fourth-order coefficients that belong to a field of curvatures and principal
 * directions over a mesh: its covariant derivatives.
 *
 * The form of each neighbour is brought to the plane of the point by the smallest turn between
 * their normals; its gradient is the mean of those of the triangles around the point, weighted by
 * area. Derivatives are made symmetric, as those of a surface are by the equations of Codazzi and
 * Mainardi. Umbilics need no care: forms are differentiated, not curvatures.
 *
 * The field needs k1, k2, d1 and d2, and for FourthOrder its b at all points.
 */
class FieldDerivatives
{
public:
  FieldDerivatives(const OneRings& rings, const MongeField& field)
    : Rings_(rings)
    , Field_(field)
  {
  }

  /// b0 to b3 at p. 0 where the triangles around p form no fan.
  std::array<double, 4> ThirdOrder(Id p) const;

  /// c0 to c4 at p.
  std::array<double, 5> FourthOrder(Id p) const;

private:
  const OneRings& Rings_;
  MongeField Field_;
};

} // namespace ridges

#endif
