// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Foliation/SurfaceWalk.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ridges
{
namespace
{

/// Of the angle between a step and the edge it starts from: where the directions at both sides of
/// an edge point towards it, the walk goes on along the edge rather than to and fro.
constexpr double LeastInward = 1e-4;

/// Steps end at least this fraction of an edge away from its ends: a point is never in more than
/// two triangles.
constexpr double CornerMargin = 1e-6;

/// Of the turn to half way of a step: 0.05 radians.
const double LeastCosine = std::cos(0.05);

constexpr int MostHalvings = 10;

/// Around a corner there may be many short steps, but not so many.
constexpr int MostShortSteps = 200;
constexpr double ShortStep = 1e-4;

} // namespace

SurfaceWalk::SurfaceWalk(
  const TriangleMesh& mesh, const MongeField& field, const std::vector<std::uint8_t>& closed)
  : Mesh_(mesh)
  , Field_(field)
  , Closed_(closed)
{
}

void SurfaceWalk::Start(
  WalkRule rule, Id triangle, const Eigen::Vector3d& point, const Eigen::Vector2d& along)
{
  this->Rule_ = rule;
  this->Triangle_ = triangle;
  this->Face_ = FlatTriangle(this->Mesh_, this->Field_, triangle);
  this->Position_ = point;
  this->Flat_ = this->Face_.ToFlat(point);
  this->Direction_ = along;
  this->StepLength_ = 0.0;
  this->EntrySide_ = -1;
  this->ExitSide_ = -1;
  this->ShortSteps_ = 0;
}

Eigen::Vector2d SurfaceWalk::DirectionAt(
  const Eigen::Vector2d& flat, const Eigen::Vector2d& along) const
{
  return this->Rule_ == WalkRule::Straight
    ? along
    : this->Face_.Direction(this->Rule_ == WalkRule::Blue ? Color::Blue : Color::Red, flat, along);
}

Eigen::Vector2d SurfaceWalk::TurnedInward(const Eigen::Vector2d& direction) const
{
  if (this->EntrySide_ < 0)
  {
    return direction;
  }
  const FlatTriangle::Side& side = this->Face_.SideAt(this->EntrySide_);
  if (direction.dot(side.inward) >= LeastInward)
  {
    return direction;
  }
  return std::copysign(std::sqrt(1.0 - LeastInward * LeastInward), direction.dot(side.along)) *
    side.along +
    LeastInward * side.inward;
}

/// The side that a ray from the current position leaves through.
SurfaceWalk::Exit SurfaceWalk::FindExit(const Eigen::Vector2d& direction) const
{
  Exit exit{ -1, std::numeric_limits<double>::infinity() };
  for (int i = 0; i < 3; ++i)
  {
    const FlatTriangle::Side& side = this->Face_.SideAt(i);
    const double outward = -direction.dot(side.inward);
    if (i == this->EntrySide_ || !(outward > 0.0))
    {
      continue;
    }
    const double height = std::max(0.0, (this->Flat_ - side.start).dot(side.inward));
    if (height < exit.distance * outward)
    {
      exit = { i, height / outward };
    }
  }
  return exit;
}

/// Into the triangle at the other side of the edge that the last step ended on.
bool SurfaceWalk::Cross()
{
  const FlatTriangle::Side from = this->Face_.SideAt(this->ExitSide_);
  if (from.neighbor < 0 || this->Closed_[from.neighbor])
  {
    return false;
  }
  const FlatTriangle next(this->Mesh_, this->Field_, from.neighbor);
  if (next.IsDegenerate())
  {
    return false;
  }
  const double distance = (this->Flat_ - from.start).dot(from.along);
  const double along = this->Direction_.dot(from.along);
  const double across = std::abs(this->Direction_.dot(from.inward));
  this->Triangle_ = from.neighbor;
  this->Face_ = next;
  this->EntrySide_ = next.SideOf(from.edge);
  const FlatTriangle::Side& to = next.SideAt(this->EntrySide_);
  this->Flat_ = to.start + distance * to.along;
  this->Direction_ = along * to.along + across * to.inward;
  this->ExitSide_ = -1;
  return true;
}

bool SurfaceWalk::Step(double longest)
{
  if (this->Face_.IsDegenerate() || (this->ExitSide_ >= 0 && !this->Cross()))
  {
    return false;
  }

  const Eigen::Vector2d first =
    this->TurnedInward(this->DirectionAt(this->Flat_, this->Direction_));
  const double toFirstExit = this->FindExit(first).distance;
  double length = std::min(longest, toFirstExit);
  Eigen::Vector2d direction = this->DirectionAt(this->Flat_ + 0.5 * length * first, first);
  for (int i = 0; i < MostHalvings && direction.dot(first) < LeastCosine; ++i)
  {
    length *= 0.5;
    direction = this->DirectionAt(this->Flat_ + 0.5 * length * first, first);
  }
  direction = this->TurnedInward(direction);
  if (!(direction.squaredNorm() > 0.5))
  {
    return false; // at an umbilic
  }

  // An edge a little behind the end of the step is the end of it: no tiny steps follow. The
  // direction is then that half way to the edge, or errors of first order would add up.
  Exit exit = this->FindExit(direction);
  if (exit.distance <= 1.25 * length)
  {
    direction = this->TurnedInward(
      this->DirectionAt(this->Flat_ + 0.5 * exit.distance * direction, direction));
    exit = this->FindExit(direction);
    length = std::min(exit.distance, 1.5 * length);
  }
  if (exit.distance <= length)
  {
    const FlatTriangle::Side& side = this->Face_.SideAt(exit.side);
    const double along =
      (this->Flat_ + exit.distance * direction - side.start).dot(side.along) / side.length;
    this->Flat_ =
      side.start + std::clamp(along, CornerMargin, 1.0 - CornerMargin) * side.length * side.along;
    this->ExitSide_ = exit.side;
  }
  else
  {
    this->Flat_ += length * direction;
  }
  this->EntrySide_ = -1;

  const Eigen::Vector3d before = this->Position_;
  this->Position_ = this->Face_.ToSpace(this->Flat_);
  this->StepLength_ = (this->Position_ - before).norm();
  // Where the direction ends up, rather than what it was half way.
  const Eigen::Vector2d last = this->DirectionAt(this->Flat_, direction);
  this->Direction_ = last.squaredNorm() > 0.5 ? last : direction;
  if (this->ExitSide_ >= 0 &&
    this->Direction_.dot(this->Face_.SideAt(this->ExitSide_).inward) > 0.0)
  {
    this->Direction_ = direction;
  }
  return this->MakesProgress();
}

bool SurfaceWalk::MakesProgress()
{
  this->ShortSteps_ =
    this->StepLength_ < ShortStep * this->Face_.SideAt(0).length ? this->ShortSteps_ + 1 : 0;
  return this->ShortSteps_ < MostShortSteps;
}

} // namespace ridges
