// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_TensorSmoothing_h
#define ridges_TensorSmoothing_h

#include "Monge/AcuteRule.h"
#include "Monge/MongeForm.h"
#include "Salience/OneRings.h"

#include <array>

namespace ridges
{

/**
 * Monge forms as tensors in space, which can be averaged over points whose frames differ: no sign
 * has to be chosen for a direction, and umbilics are nothing special.
 *
 * The second-order form is T = k1 d1 d1' + k2 d2 d2', 6 numbers, stored after the normal; the third
 * order one has 10 numbers, the fourth order one 15. Where that is missing P1 and P2 are averaged
 * as they are.
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

/**
 * How many averages over one-rings smooth a field to a Gaussian of standard deviation sigma, and
 * which share of each a point takes (see RingAveraging).
 *
 * A step adds OneRings::Variance at a point, more where triangles are larger. So that the scale is
 * the same all over a mesh, points in large triangles take a part of each step only. A fit of
 * degree two to the points within a radius r counts as a Gaussian of 0.4 r.
 */
class SmoothingPlan
{
public:
  /// Of a radius of a fit of degree two.
  static constexpr double SigmaPerRadius = 0.4;

  /// Steps that all points take part in, however coarse the mesh is: derivatives need one. More
  /// would smooth coarse meshes farther than fine ones of the same shape.
  static constexpr int LeastSteps = 1;

  /// As many steps average over 46 edges; more are not taken, so that a scale that is large by
  /// mistake, as where one point lies far off, does not take forever.
  static constexpr int MostSteps = 5000;

  /// `fitScale` has the radius of the fit at each point; null stands for 0.
  SmoothingPlan(const OneRings& rings, const double* fitScale, double sigma);

  /// That many steps, in which all points take part in full.
  SmoothingPlan(const OneRings& rings, const double* fitScale, int steps);

  int Steps() const { return this->Steps_; }

  /// Whether the scale was out of reach for MostSteps.
  bool IsCut() const { return this->IsCut_; }
  double Share(Id p) const;

  /// The standard deviation that comes out at p.
  double Sigma(Id p) const;

  /// Of the Gaussians that the fits at all points count as; 0 where no radius is known.
  static double MedianSigma(const double* fitScale, Id numberOfPoints);

private:
  double FitVariance(Id p) const;
  /// Steps that p alone would take, with a fraction.
  double StepsFor(Id p) const;

  const OneRings& Rings_;
  const double* FitScale_;
  double Variance_ = 0.0;
  int Steps_ = LeastSteps;
  bool IsCut_ = false;
  bool IsEven_ = false;
};

} // namespace ridges

#endif
