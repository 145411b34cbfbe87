// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_PointFitter_h
#define ridges_PointFitter_h

#include "Fit/JetFit.h"
#include "Mesh/NormalCache.h"
#include "Mesh/RingNeighborhood.h"

namespace ridges
{

/**
 * Fits to a neighbourhood whatever it takes, one point after the other.
 *
 * - The height axis is that of least spread, if it is within 60 degrees of the normal; else the
 *   mean normal of the neighbourhood. Around a rod that is meshed finely along its axis only,
 *   points spread least along that axis.
 * - A one-sided neighbourhood may hold enough points in too few rows. If the rule asks for a number
 *   of points, up to four rings more are taken, until the least squares is well conditioned.
 * - The surface may fold over within the neighbourhood, as on a coarse sphere, around a thin rod,
 *   or at the rim of a plate: the normals of some points are at right angles to the height axis,
 *   or beyond, and there is no height function. Then only points are taken that face the same side
 *   as the vertex, and are reached over such points, in the degree that they determine. The fit is
 *   flagged as FitFolded, unless these points say how the surface curves: they determine the whole
 *   degree, the normals of neighbours are within 41 degrees, and the residual leaves the normal
 *   within the radius certain to 0.1 rad.
 * - What stays ill conditioned is fitted in a lower degree that the points determine.
 *
 * Holds scratch memory: use one per thread.
 */
class PointFitter
{
public:
  /// Condition numbers that another ring or a lower degree may improve.
  static constexpr double GrowAbove = JetFitter::WellConditionedBelow;
  static constexpr int MostRingsAdded = 4;

  PointFitter(const TriangleMesh& mesh, const OrderedRings& rings, const NeighborhoodRule& rule,
    int degree, Weighting weighting);

  /// Whether the rule allows more rings.
  bool MayGrow() const;

  /// The neighbourhood by the rule, and so many rings more, if there are.
  Span<Id> Gather(Id vertex, int ringsAdded = 0);

  /// The last neighbourhood with one ring more; the same one if there is nothing around it.
  Span<Id> Grow() { return this->Neighborhood_.Grow(); }

  /// Whether the points that were gathered last are in the order of the rings.
  bool IsInRings() const { return this->Neighborhood_.IsInRings(); }

  /// See RingNeighborhood.
  int TakeReach() { return this->Neighborhood_.TakeReach(); }

  /// Without growth, if it was found to be of no use.
  enum class Growth
  {
    Allowed,
    OfNoUse
  };
  JetFit Fit(Id vertex, Growth growth = Growth::Allowed);

  /// To these points, the vertex first.
  JetFit FitTo(Span<Id> points, int degree);
  JetFit FitTo(Span<Id> points) { return this->FitTo(points, this->Degree_); }

  const JetFitter& Fitter() const { return this->Fitter_; }

  /// Whether the surface is nearly upright anywhere in a neighbourhood, or beyond. Where it is not,
  /// it does not fold over.
  bool IsSteep(Span<Id> points, const Eigen::Vector3d& axis);

private:
  Id CountBelow(double cosine, Span<Id> points, const Eigen::Vector3d& axis);
  bool FoldsOver(Span<Id> points, const JetFit& fit);
  void SetOffsets(Span<Id> points);
  JetFit FitGrown(Id vertex, const JetFit& first, Span<Id>& points);
  JetFit FitBeforeFold(Id vertex, const JetFit& folded);
  bool TurnsLittleAround(Id vertex);
  JetFit FitLower(Span<Id> points, const JetFit& fit, double mostCondition);

  const TriangleMesh& Mesh_;
  NeighborhoodRule Rule_;
  int Degree_;
  Weighting Weighting_;
  NormalCache Normals_;
  RingNeighborhood Neighborhood_;
  JetFitter Fitter_;
  Eigen::Matrix3Xd Offsets_;
};

} // namespace ridges

#endif
