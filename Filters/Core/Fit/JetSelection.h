// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_JetSelection_h
#define ridges_JetSelection_h

#include "Fit/JetBlend.h"
#include "Fit/JetTrial.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace ridges
{

/// A degree and a number of rings to fit with, and how often to average the result over one-rings.
struct JetChoice
{
  int degree = 4;
  int numberOfRings = 2;
  int numberOfAverages = 0;
  double noise = 0.0; ///< Standard deviation of the heights.
  double edge = 0.0;  ///< Roughly, that of the mesh.

  /// Of an edge: single precision has less.
  static constexpr double HardlyAnyNoise = 1e-5;

  /// See JetTrial.h: where it is not about 0, the noise is not what `noise` says.
  double correlation = 0.0;

  /// Several fits to be blended, the one above among them; none if that is to be taken alone.
  std::vector<BlendedJet> blend = {};

  /// That their weights allow for: 0 where there is hardly any.
  double noiseInBlend = 0.0;
};

/**
 * Chooses the degree and the number of rings with which the second or third derivatives of a
 * surface have the least error, by trials on a sample of its points, made with more and more rings.
 *
 * The error has two parts. Noise gives the derivatives a variance that falls with the rings and
 * grows with the degree; it is known from that of the heights, which is the least that a band of
 * coefficients has (JetTrial): in the others there may be some of the surface. Noise that is
 * correlated from point to point, as in scans that were smoothed, has less variance on fewer rings:
 * so it is measured for each number of rings. What a degree leaves out of the surface grows with
 * the rings: it is what the band above it adds, less what noise adds there.
 *
 * Errors that change from point to point make short ridges and flickering types. So averages
 * over one-rings may follow the fit, and the variance counts more than the rest of the error: the
 * sum of both has a flat minimum, near which this costs little.
 */
class JetSelection
{
public:
  static constexpr int MostRings = 24;
  static constexpr int MostAverages = 2;

  /// `order`: of the derivatives, 2 or 3. `degree`: if it is not 0, only the rings are chosen.
  explicit JetSelection(int order, int degree = 0);

  /// The number of rings to try next, and up to which band; 0 after the last.
  int NextRings() const;
  int NextBands() const;

  /// One trial for each point of the sample, the same points each time.
  void Add(const std::vector<JetTrial>& trials);

  const JetChoice& Choice() const { return this->Choice_; }

private:
  /// Of one number of rings, on average: by degree, as numbered in JetTrial. Variances are for
  /// heights of unit variance. Negative where there is none.
  struct Terms
  {
    double radius;
    std::array<double, JetTrial::NumberOfBands> variance;
    std::array<double, JetTrial::NumberOfBands> varianceOfNext; ///< Of what the next band adds.
    std::array<double, JetTrial::NumberOfBands> squareOfNext;
  };
  /// Points around which the surface bends about as much.
  using Group = std::vector<Terms>;

  void Sort(const std::vector<JetTrial>& trials);
  Terms TermsOf(const std::vector<JetTrial>& trials, std::size_t group) const;
  double NoiseAt(std::size_t step) const;
  double SquaredBias(const Group& group, std::size_t step, int degree) const;
  bool MayAverage(std::size_t step) const;
  double MeanError(std::size_t step, int degree, int averages) const;
  void Choose();
  void MayBlend();

  int Order_;
  int Degree_;
  std::size_t Step_ = 0;
  std::vector<std::vector<std::size_t>> Sample_; ///< Of each group.
  std::vector<Group> Groups_;
  std::vector<double> Noise_;         ///< Variance of each number of rings.
  std::vector<std::uint8_t> IsSteep_; ///< Whether so many are, at every second point: see JetTrial.
  double LeftOver_ = std::numeric_limits<double>::infinity(); ///< Variance of noise, by residuals.
  double Edge_ = 0.0;
  double Least_ = 0.0;
  bool IsPastLeast_ = false;
  JetChoice Choice_;
};

} // namespace ridges

#endif
