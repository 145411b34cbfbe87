// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fit/JetBlend.h"

#include <algorithm>
#include <limits>

namespace ridges
{

double WeightInBlend(const BlendedJet& jet, double residual, double radius, double noiseGain)
{
  // What is left over of a surface is not independent from point to point: third derivatives are
  // off by several standard errors, in the median over several surfaces by 5, 2.4 and 2.
  const double ofDegree = jet.degree > 6 ? 1.0 : (jet.degree > 4 ? 1.2 : 2.5);
  const double error = ofDegree * noiseGain * residual / (radius * radius);
  return 1.0 / std::max(error * error, std::numeric_limits<double>::min());
}

} // namespace ridges
