// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fit/PointFitter.h"

#include <algorithm>
#include <cmath>

namespace ridges
{
namespace
{

/// Whether two directions, of any lengths, are within 60 degrees of each other, or opposite.
bool AreNear(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::abs(a.dot(b)) > 0.5 * a.norm() * b.norm();
}

} // namespace

PointFitter::PointFitter(const TriangleMesh& mesh, const OrderedRings& rings,
  const NeighborhoodRule& rule, int degree, Weighting weighting)
  : Mesh_(mesh)
  , Rule_(rule)
  , Degree_(degree)
  , Weighting_(weighting)
  , Normals_(mesh)
  , Neighborhood_(mesh, rings)
{
}

bool PointFitter::MayGrow() const
{
  // Where the user has said how many rings, or how far, it stays at that.
  return this->Rule_.kind == NeighborhoodRule::Kind::PointCount ||
    this->Rule_.kind == NeighborhoodRule::Kind::RingsAndPointCount;
}

Span<Id> PointFitter::Gather(Id vertex, int ringsAdded)
{
  Span<Id> points = this->Neighborhood_.Gather(vertex, this->Rule_);
  for (int i = 0; i < ringsAdded; ++i)
  {
    points = this->Neighborhood_.Grow();
  }
  return points;
}

void PointFitter::SetOffsets(Span<Id> points)
{
  const Eigen::Vector3d origin = this->Mesh_.Point(points[0]);
  this->Offsets_.resize(3, points.size());
  for (Id i = 0; i < points.size(); ++i)
  {
    this->Offsets_.col(i) = this->Mesh_.Point(points[i]) - origin;
  }
}

JetFit PointFitter::FitTo(Span<Id> points, int degree)
{
  this->SetOffsets(points);
  const Eigen::Vector3d own = this->Mesh_.PointNormal(points[0]);
  JetFit fit = this->Fitter_.Fit(this->Offsets_, degree, own, this->Weighting_);
  if (AreNear(fit.frame.col(2), own))
  {
    return fit;
  }
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Id p : points)
  {
    mean += this->Normals_.At(p);
  }
  if (!AreNear(fit.frame.col(2), mean) && mean.squaredNorm() > 0.0)
  {
    mean *= mean.dot(own) < 0.0 ? -1.0 : 1.0;
    fit = this->Fitter_.FitAlong(mean, this->Offsets_, degree, this->Weighting_);
  }
  return fit;
}

JetFit PointFitter::Fit(Id vertex, Growth growth)
{
  Span<Id> points = this->Gather(vertex);
  JetFit fit = this->FitTo(points);
  bool folds = this->FoldsOver(points, fit);
  if (!folds && growth == Growth::Allowed && this->MayGrow() && fit.conditionNumber > GrowAbove)
  {
    fit = this->FitGrown(vertex, fit, points);
    folds = this->FoldsOver(points, fit);
  }
  if (folds)
  {
    return this->FitBeforeFold(vertex, fit);
  }
  return this->FitLower(points, fit, JetFitter::IllConditionedAbove);
}

/// With as few more rings as make it well conditioned. From a condition number that is of use on,
/// each ring has to make it clearly better, as a larger neighbourhood is less exact.
JetFit PointFitter::FitGrown(Id vertex, const JetFit& first, Span<Id>& points)
{
  JetFit best = first;
  int ringsOfBest = 0;
  int rings = 0;
  while (rings < MostRingsAdded && best.conditionNumber > GrowAbove)
  {
    ++rings;
    points = this->Neighborhood_.Grow();
    const JetFit fit = this->FitTo(points);
    if (fit.conditionNumber < 0.5 * best.conditionNumber)
    {
      best = fit;
      ringsOfBest = rings;
    }
    else if (best.conditionNumber <= JetFitter::IllConditionedAbove)
    {
      break;
    }
  }
  if (ringsOfBest == rings)
  {
    return best; // The last one.
  }
  points = this->Gather(vertex, ringsOfBest);
  return this->FitTo(points);
}

/// How many points have normals at such an angle to an axis.
Id PointFitter::CountBelow(double cosine, Span<Id> points, const Eigen::Vector3d& axis)
{
  return static_cast<Id>(std::count_if(points.begin(), points.end(),
    [this, cosine, &axis](Id p)
    {
      const Eigen::Vector3d normal = this->Normals_.At(p);
      return normal.dot(axis) < cosine * normal.squaredNorm();
    }));
}

bool PointFitter::IsSteep(Span<Id> points, const Eigen::Vector3d& axis)
{
  constexpr double cosine = 0.3;
  return this->CountBelow(cosine, points, axis) > 0;
}

/// Of the last fit, to these points. Near a right angle the height has an infinite slope, and a
/// polynomial has nothing to do with it: where it matters, is seen from the residual, or from how
/// many points there are. A sharp edge may be nearly upright, but it has few points.
bool PointFitter::FoldsOver(Span<Id> points, const JetFit& fit)
{
  constexpr double upright = 0.1;
  constexpr double opposite = -0.2;
  constexpr double mostUpright = 0.2;
  const Eigen::Vector3d axis = fit.frame.col(2);
  return this->IsSteep(points, axis) &&
    (this->CountBelow(opposite, points, axis) > 0 ||
      static_cast<double>(this->CountBelow(upright, points, axis)) >= mostUpright * points.size() ||
      (fit.degree >= 2 && this->Fitter_.UncertainTurn(fit) > JetFitter::MostTurn));
}

JetFit PointFitter::FitBeforeFold(Id vertex, const JetFit& folded)
{
  constexpr double cosine = 0.2; // clearly before
  const Eigen::Vector3d own = this->Normals_.At(vertex);
  const Span<Id> points = this->Neighborhood_.Gather(vertex, this->Rule_,
    [this, &own](Id p)
    {
      const Eigen::Vector3d normal = this->Normals_.At(p);
      return normal.dot(own) >= cosine * normal.squaredNorm();
    });
  // Measured on coarse ellipsoids, tori and blends, with and without noise: of the fits that these
  // limits spare the flag 1 in 200 is off by more than a quarter, of the others every second.
  constexpr double mostUncertain = 0.1;
  JetFit fit = folded;
  bool isTrusted = false;
  if (points.size() >= HeightJet::Size(std::min(2, this->Degree_)))
  {
    fit = this->FitLower(points, this->FitTo(points), GrowAbove);
    isTrusted = fit.degree >= std::max(2, this->Degree_) &&
      this->Fitter_.UncertainTurn(fit) <= mostUncertain && this->TurnsLittleAround(vertex);
  }
  const bool isIllConditioned = fit.conditionNumber > JetFitter::IllConditionedAbove;
  fit.status = static_cast<std::uint8_t>((fit.status & ~FitIllConditioned) |
    (isTrusted && !isIllConditioned ? 0 : FitFolded) | (isIllConditioned ? FitIllConditioned : 0));
  return fit;
}

/// Whether the normals of all neighbours are near to that of the vertex: else too few points before
/// the fold are left to say how the surface curves. A parabola through neighbours at 41 degrees
/// curves by a seventh more than their circle.
bool PointFitter::TurnsLittleAround(Id vertex)
{
  constexpr double cosine = 0.75;
  const Eigen::Vector3d own = this->Normals_.At(vertex);
  const Span<Id> around = this->Mesh_.TrianglesAround(vertex);
  return std::all_of(around.begin(), around.end(),
    [this, &own](Id t)
    {
      const Triangle& corners = this->Mesh_.Corners(t);
      return std::all_of(corners.begin(), corners.end(),
        [this, &own](Id q) { return this->Normals_.At(q).dot(own) >= cosine; });
    });
}

/// Lowers the degree as long as the condition number is larger, or the fit is flagged, to 2 at the
/// least.
JetFit PointFitter::FitLower(Span<Id> points, const JetFit& fit, double mostCondition)
{
  JetFit lower = fit;
  while (lower.degree > 2 &&
    (lower.conditionNumber > mostCondition || (lower.status & FitIllConditioned)))
  {
    lower = this->FitTo(points, lower.degree - 1);
  }
  lower.status |= fit.status & FitIllConditioned;
  return lower;
}

} // namespace ridges
