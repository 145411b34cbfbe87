// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_SmoothingPlan_h
#define ridges_SmoothingPlan_h

#include "Salience/SmoothingLevels.h"

#include <deque>
#include <vector>

namespace ridges
{

/**
 * The averages over one-rings that smooth a field to a Gaussian of standard deviation sigma, and
 * which share of each a point takes (see RingAveraging).
 *
 * An average adds RingGraph::Variance at a point, more where triangles are larger. So that the
 * scale is the same all over a mesh, points in large triangles take a part of each only. A fit of
 * degree two to the points within a radius r counts as a Gaussian of 0.4 r.
 *
 * Where many averages are needed six boxes replace them, whose number of sweeps grows with sigma
 * over the edges, not with its square. Six in a row damp waves as a Gaussian does, to 0.02.
 *
 * Where edges are so short that this takes long as well, cells are joined to larger ones, level by
 * level, up to a share of sigma. There most of the averages are made; on the way back values are
 * interpolated and averaged once. So the time per point does not grow as a mesh is refined.
 */
class SmoothingPlan
{
public:
  /// Of a radius of a fit of degree two.
  static constexpr double SigmaPerRadius = 0.4;

  /// Averages that all points take part in, however coarse the mesh is: derivatives need one. More
  /// would smooth coarse meshes farther than fine ones of the same shape.
  static constexpr int LeastAverages = 1;

  /// What is worth more averages of the mesh is a scale by mistake, as where one point lies far
  /// off: then the scale is that of so many.
  static constexpr double MostAverages = 1e5;

  /// `fitScale` has the radius of the fit at each point; null stands for 0.
  SmoothingPlan(const OneRings& rings, const double* fitScale, double sigma,
    const RangeLoop& loop = TriangleMesh::InOneRange);

  /// That many plain averages, weighted by area, in which all points take part in full.
  SmoothingPlan(const OneRings& rings, const double* fitScale, int averages);

  /// The finest first.
  const std::deque<SmoothingLevel>& Levels() const { return this->Levels_; }

  /// Of the finest level.
  Id CellOf(Id p) const { return this->Cells_.empty() ? p : this->Cells_[p]; }

  /// Whether the scale was out of reach for MostAverages.
  bool IsCut() const { return this->IsCut_; }

  /// The standard deviation that comes out at p.
  double Sigma(Id p) const;

  /// Of the Gaussians that the fits at all points count as; 0 where no radius is known.
  static double MedianSigma(const double* fitScale, Id numberOfPoints);

private:
  double FitVariance(Id p) const;
  double AveragesOfMesh(const OneRings& rings, double variance) const;

  const double* FitScale_;
  std::deque<SmoothingLevel> Levels_;
  std::vector<Id> Cells_; ///< By point; empty where they are the same.
  bool IsCut_ = false;
};

} // namespace ridges

#endif
