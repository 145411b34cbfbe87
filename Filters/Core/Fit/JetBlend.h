// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_JetBlend_h
#define ridges_JetBlend_h

#include <array>

namespace ridges
{

struct BlendedJet
{
  int degree;
  int numberOfRings;
};

/**
 * Fits that are blended at each point, for meshes with hardly any noise: each has hardly more
 * points than its degree needs. Where the surface is resolved well the highest degree is by far the
 * most exact, where it is not it is the worst.
 *
 * Each fit counts by one over the square of its error, as it is best for errors that are
 * independent. What a fit leaves over shows its error, and changes gently from point to point, as
 * it is the mean over a neighbourhood: so does the blend.
 */
constexpr std::array<BlendedJet, 3> BlendedJets{ { { 4, 2 }, { 6, 3 }, { 8, 4 } } };

/// What a fit counts for: what is left over is `residual`, in units of the radius; see JetFit.
double WeightInBlend(const BlendedJet& jet, double residual, double radius, double noiseGain);

} // namespace ridges

#endif
