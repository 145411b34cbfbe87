// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_SmoothingPlan_h
#define ridges_SmoothingPlan_h

#include "Salience/RingAveraging.h"

#include <vector>

namespace ridges
{

/**
 * The averages over one-rings that smooth a field to a Gaussian of standard deviation sigma, and
 * which share of each a point takes (see RingAveraging).
 *
 * A plain average adds OneRings::Variance at a point, more where triangles are larger. So that the
 * scale is the same all over a mesh, points in large triangles take a part of each only. A fit of
 * degree two to the points within a radius r counts as a Gaussian of 0.4 r.
 *
 * Where many averages are needed six boxes replace them, whose number of sweeps grows with sigma
 * over the edges, not with its square. Six in a row damp waves as a Gaussian does, to 0.02.
 */
class SmoothingPlan
{
public:
  /// Of a radius of a fit of degree two.
  static constexpr double SigmaPerRadius = 0.4;

  /// Averages that all points take part in, however coarse the mesh is: derivatives need one. More
  /// would smooth coarse meshes farther than fine ones of the same shape.
  static constexpr int LeastAverages = 1;

  /// As many averages reach over 200 edges, in 1,340 sweeps; more are not taken, so that a scale
  /// that is large by mistake, as where one point lies far off, does not take forever.
  static constexpr double MostAverages = 1e5;

  /// `fitScale` has the radius of the fit at each point; null stands for 0.
  SmoothingPlan(const OneRings& rings, const double* fitScale, double sigma);

  /// That many plain averages, in which all points take part in full.
  SmoothingPlan(const OneRings& rings, const double* fitScale, int averages);

  const std::vector<AveragingSweep>& Sweeps() const { return this->Sweeps_; }

  /// Whether the scale was out of reach for MostAverages.
  bool IsCut() const { return this->IsCut_; }
  double Share(Id p) const;

  /// The standard deviation that comes out at p.
  double Sigma(Id p) const;

  /// Of the Gaussians that the fits at all points count as; 0 where no radius is known.
  static double MedianSigma(const double* fitScale, Id numberOfPoints);

private:
  void SetSweeps(double averages);
  double FitVariance(Id p) const;
  /// Averages that p alone would take, with a fraction.
  double AveragesFor(Id p) const;

  const OneRings& Rings_;
  const double* FitScale_;
  double Variance_ = 0.0;
  std::vector<AveragingSweep> Sweeps_;
  double Averages_ = LeastAverages; ///< That the sweeps are worth.
  bool IsCut_ = false;
  bool IsEven_ = false;
};

} // namespace ridges

#endif
