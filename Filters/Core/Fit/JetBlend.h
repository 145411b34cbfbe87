// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_JetBlend_h
#define ridges_JetBlend_h

#include <vector>

namespace ridges
{

/// A fit among those that are blended.
struct BlendedJet
{
  int degree;
  int numberOfRings;
};

/**
 * Fits that are blended at each point, the highest degree last: one degree and one number of rings
 * suit no surface whose curvature varies. Each fit counts by one over the square of its error, as
 * it is best for errors that are independent. What a fit leaves over shows its error, and changes
 * gently from point to point, as it is the mean over a neighbourhood: so does the blend.
 *
 * Where there is hardly any noise each has hardly more points than its degree needs. Where the
 * surface is resolved well the highest degree is by far the most exact, where it is not it is the
 * worst.
 */
std::vector<BlendedJet> JetsWithoutNoise();

/// Where there is noise, and degree 4 is best for the mesh as a whole, on so many rings: fits on
/// fewer and on more. Where a higher degree is best, noise wants as many rings all over the mesh.
std::vector<BlendedJet> JetsWithNoise(int numberOfRings);

/// What a fit counts for where there is hardly any noise: what is left over is `residual`, in units
/// of the radius; see JetFit.
double WeightInBlend(const BlendedJet& jet, double residual, double radius, double noiseGain);

/// The same where heights have noise of that standard deviation.
double WeightInNoisyBlend(
  const BlendedJet& jet, double noise, double residual, double radius, double noiseGain);

} // namespace ridges

#endif
