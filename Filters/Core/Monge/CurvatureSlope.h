// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_CurvatureSlope_h
#define ridges_CurvatureSlope_h

#include "Mesh/MeanGradient.h"
#include "Monge/MongeField.h"

namespace ridges
{

/// The derivative of a principal curvature along its direction, from its values at the points
/// around. The extremality is that by the fit.
inline double CurvatureSlope(const TriangleMesh& mesh, const MongeField& field, Color color, Id p)
{
  const double here = field.Curvature(color, p);
  return GradientAround(
    mesh, p, [&field, color, here](Id q) { return field.Curvature(color, q) - here; })
    .Along(field.Direction(color, p));
}

} // namespace ridges

#endif
