// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// A random Gaussian surface, whose umbilics have known statistics, and its umbilics one by one.

#ifndef RIDGES_TESTING_WAVE_SURFACE_H
#define RIDGES_TESTING_WAVE_SURFACE_H

#include "ExactUmbilics.h"
#include "Monge/MongeForm.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace ridges
{
namespace testing
{

// z = a sqrt(2 / n) sum cos(k . x + phase) over n waves, k normally distributed with a standard
// deviation of 1 along each axis: the correlation length is 1. The lengths of the k are drawn from
// n strata of equal probability, their angles a golden section of the turn apart. So the waves are
// as isotropic, and have their moments as near to those of the distribution, as n of them can.
class WaveSurface
{
public:
  WaveSurface(int numberOfWaves, double amplitude, std::uint64_t seed);

  double Height(double x, double y) const;
  // All derivatives up to a degree, at most 4.
  HeightJet Derivatives(double x, double y, int degree) const;

  // Umbilics in a unit of area that are to be expected of isotropic Gaussian waves with the moments
  // of these: <k^6> / (4 pi <k^4>), which is 3 / (2 pi) for infinitely many.
  double ExpectedDensity() const;

private:
  struct Wave
  {
    Eigen::Vector2d k;
    double phase;
  };
  double Scale;
  std::vector<Wave> Waves;
};

// Newton's method from a point (x, y) for the two equations by which the second fundamental form of
// a graph is a multiple of the first. Whether it has converged.
bool ConvergeToUmbilic(const WaveSurface& surface, Eigen::Vector2d& point);

// All umbilics over the square [-halfSize, halfSize]^2, sorted by x, with the index that the third
// derivatives give them. Newton's method starts at each point of a grid with cells of this size
// from which it predicts an umbilic nearby, and in each cell around which directions turn. Throws
// std::runtime_error if in a cell around which directions turn, or in those around it, there is
// none.
std::vector<ExactUmbilic> FindUmbilics(const WaveSurface& surface, double halfSize, double cell);

} // namespace testing
} // namespace ridges

#endif
