// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fit/JetBlend.h"

#include "Monge/MongeForm.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ridges
{
namespace
{

/// The square of the error of third derivatives where a fit leaves over some of the surface, for a
/// mean square of 1 and a noise gain of 1, per point. Measured on several surfaces. For noise it
/// would be 1 over the number of points; what is left of a surface is not independent.
double SquaredErrorOfRest(int degree)
{
  return degree > 6 ? 0.05 : (degree > 4 ? 0.13 : 0.88);
}

} // namespace

std::vector<BlendedJet> JetsWithoutNoise()
{
  return { { 4, 2 }, { 6, 3 }, { 8, 4 } };
}

std::vector<BlendedJet> JetsWithNoise(int numberOfRings)
{
  // Their points are many: those of 40 rings would be 5,000.
  const auto rings = [numberOfRings](double times, int least, int most)
  { return std::clamp(static_cast<int>(std::lround(times * numberOfRings)), least, most); };
  return { { 4, rings(0.67, 2, 16) }, { 4, rings(1.33, 3, 24) }, { 6, rings(1.67, 3, 28) } };
}

double WeightInBlend(const BlendedJet& jet, double residual, double radius, double noiseGain)
{
  // What is left over of a surface is not independent from point to point: third derivatives are
  // off by several standard errors, in the median over several surfaces by 5, 2.4 and 2.
  const double ofDegree = jet.degree > 6 ? 1.0 : (jet.degree > 4 ? 1.2 : 2.5);
  const double error = ofDegree * noiseGain * residual / (radius * radius);
  return 1.0 / std::max(error * error, std::numeric_limits<double>::min());
}

double WeightInNoisyBlend(
  const BlendedJet& jet, double noise, double residual, double radius, double noiseGain)
{
  const double points = 1.0 + 3.0 * jet.numberOfRings * (jet.numberOfRings + 1.0);
  const double freedom = std::max(1.0, points - HeightJet::Size(jet.degree));
  const double ofNoise = noise * noise / (radius * radius) * freedom / points;
  const double ofSurface = std::max(0.0, residual * residual - ofNoise);
  const double gain = noiseGain / (radius * radius);
  const double square =
    gain * gain * (ofNoise + SquaredErrorOfRest(jet.degree) * points * ofSurface);
  return 1.0 / std::max(square, std::numeric_limits<double>::min());
}

} // namespace ridges
