// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Salience/CurvatureWalk.h"

#include "Mesh/PositionOrder.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ridges
{
namespace
{

/// Faces kept, a power of two: as many as stay in the cache of a core.
constexpr std::size_t KeptFaces = 2048;

/// Of the angle between a step and the side it starts from: where the directions at both sides of
/// an edge point towards it, the walk goes along the edge rather than to and fro.
constexpr double LeastInward = 1e-4;

/// Steps end at least this fraction of a side away from its ends.
constexpr double CornerMargin = 1e-6;

/// Around a corner there may be many short steps, but not so many.
constexpr int MostShortSteps = 50;
constexpr double ShortStep = 1e-4;

Eigen::Vector2d Turned(const Eigen::Vector2d& v)
{
  return { -v[1], v[0] };
}

} // namespace

CurvatureWalk::CurvatureWalk(const TriangleMesh& mesh, const MongeField& field)
  : Mesh_(mesh)
  , Field_(field)
  , Faces_(KeptFaces)
{
}

const CurvatureWalk::Face& CurvatureWalk::FaceOf(Id triangle)
{
  Face& face = this->Faces_[static_cast<std::size_t>(triangle) & (KeptFaces - 1)];
  if (face.triangle != triangle)
  {
    this->Fill(face, triangle);
  }
  return face;
}

void CurvatureWalk::Fill(Face& face, Id triangle) const
{
  const Triangle& corners = this->Mesh_.Corners(triangle);
  int first = 0;
  for (int i = 1; i < 3; ++i)
  {
    if (PointComesBefore(this->Mesh_, corners[i], corners[first]))
    {
      first = i;
    }
  }
  std::array<Id, 3> p;
  for (int i = 0; i < 3; ++i)
  {
    p[i] = corners[(first + i) % 3];
    face.edges[i] = this->Mesh_.EdgeOf(triangle, (first + i) % 3);
  }
  face.triangle = triangle;
  const Eigen::Vector3d base = this->Mesh_.Point(p[1]) - this->Mesh_.Point(p[0]);
  const Eigen::Vector3d side = this->Mesh_.Point(p[2]) - this->Mesh_.Point(p[0]);
  const Eigen::Vector3d cross = base.cross(side);
  const double length = base.norm();
  const double twice = cross.norm();
  face.hasArea = length > 0.0 && twice > 0.0;
  if (!face.hasArea)
  {
    return;
  }
  const Eigen::Vector3d normal = cross / twice;
  const Eigen::Vector3d axisX = base / length;
  const Eigen::Vector3d axisY = normal.cross(axisX);
  face.corners = { Eigen::Vector2d::Zero(), Eigen::Vector2d(length, 0.0),
    Eigen::Vector2d(side.dot(axisX), twice / length) };
  // Corner 0 comes first of all.
  face.forward = { true, PointComesBefore(this->Mesh_, p[1], p[2]), false };
  for (int i = 0; i < 3; ++i)
  {
    face.turnings[i] = this->TurningAt(p[i], axisX, axisY, normal);
    face.sums[i] = this->Field_.k1[p[i]] + this->Field_.k2[p[i]];
  }
}

/// Of d1, after the smallest turn that takes the point's normal to that of the triangle.
Eigen::Vector2d CurvatureWalk::TurningAt(Id p, const Eigen::Vector3d& axisX,
  const Eigen::Vector3d& axisY, const Eigen::Vector3d& normal) const
{
  const Eigen::Vector3d d1 = this->Field_.D1(p);
  const Eigen::Vector3d n = d1.cross(this->Field_.D2(p));
  const Eigen::Vector3d own = n.dot(normal) < 0.0 ? Eigen::Vector3d(-normal) : normal;
  const Eigen::Vector3d turned = d1 - d1.dot(own) / (1.0 + n.dot(own)) * (n + own);
  const double x = turned.dot(axisX);
  const double y = turned.dot(axisY);
  const double square = x * x + y * y;
  if (!(square > 0.0))
  {
    return Eigen::Vector2d::Zero();
  }
  const double scale = (this->Field_.k1[p] - this->Field_.k2[p]) / square;
  return { scale * (x * x - y * y), scale * 2.0 * x * y };
}

CurvatureWalk::Local CurvatureWalk::At(const Face& face, const Eigen::Vector2d& x) const
{
  const double w2 = x[1] / face.corners[2][1];
  const double w1 = (x[0] - w2 * face.corners[2][0]) / face.corners[1][0];
  const double w0 = 1.0 - w1 - w2;
  return { w0 * face.turnings[0] + w1 * face.turnings[1] + w2 * face.turnings[2],
    w0 * face.sums[0] + w1 * face.sums[1] + w2 * face.sums[2] };
}

Eigen::Vector2d CurvatureWalk::Direction(
  const Eigen::Vector2d& turning, const Eigen::Vector2d& along) const
{
  // Half the angle, without trigonometry and without cancellation.
  const Eigen::Vector2d v = this->Color_ == Color::Red ? Eigen::Vector2d(-turning) : turning;
  const double length = v.norm();
  const Eigen::Vector2d direction =
    v[0] >= 0.0 ? Eigen::Vector2d(v[0] + length, v[1]) : Eigen::Vector2d(v[1], length - v[0]);
  return direction.dot(along) < 0.0 ? Eigen::Vector2d(-direction) : direction;
}

double CurvatureWalk::CurvatureOf(const Local& local) const
{
  const double gap = local.turning.norm();
  return 0.5 * (this->Color_ == Color::Blue ? local.sum + gap : local.sum - gap);
}

Eigen::Vector2d CurvatureWalk::TurnedInward(
  const Face& face, const Eigen::Vector2d& direction) const
{
  const Eigen::Vector2d side =
    (face.corners[(this->Side_ + 1) % 3] - face.corners[this->Side_]).normalized();
  const Eigen::Vector2d inward = Turned(side);
  if (direction.dot(inward) >= LeastInward * direction.norm())
  {
    return direction;
  }
  return std::copysign(1.0, direction.dot(side)) * side + LeastInward * inward;
}

/// The side that a ray from a point of the entry side leaves through.
int CurvatureWalk::FindExit(const Face& face, const Eigen::Vector2d& x,
  const Eigen::Vector2d& direction, double& distance) const
{
  int exit = -1;
  distance = std::numeric_limits<double>::infinity();
  for (int step = 1; step < 3; ++step)
  {
    const int i = (this->Side_ + step) % 3;
    const Eigen::Vector2d inward = Turned(face.corners[(i + 1) % 3] - face.corners[i]);
    const double outward = -direction.dot(inward);
    const double height = std::max(0.0, (x - face.corners[i]).dot(inward));
    if (outward > 0.0 && height < distance * outward)
    {
      exit = i;
      distance = height / outward;
    }
  }
  return exit;
}

bool CurvatureWalk::Start(Color color, Id triangle, Id edge, const Eigen::Vector3d& point)
{
  this->Color_ = color;
  this->Triangle_ = triangle;
  this->ShortSteps_ = 0;
  this->HasNext_ = false;
  const Face& face = this->FaceOf(triangle);
  if (!face.hasArea)
  {
    return false;
  }
  this->Side_ = face.edges[0] == edge ? 0 : face.edges[1] == edge ? 1 : 2;
  const OrderedEdge ends(this->Mesh_, edge);
  const Eigen::Vector3d start = this->Mesh_.Point(ends.p);
  const Eigen::Vector3d side = this->Mesh_.Point(ends.q) - start;
  const double fraction = std::clamp((point - start).dot(side) / side.squaredNorm(), 0.0, 1.0);
  this->Fraction_ = face.forward[this->Side_] ? fraction : 1.0 - fraction;
  this->Along_ = 0.0;
  this->Inward_ = 1.0;
  this->HasNext_ = true;
  const Eigen::Vector2d x = (1.0 - this->Fraction_) * face.corners[this->Side_] +
    this->Fraction_ * face.corners[(this->Side_ + 1) % 3];
  this->Curvature_ = this->CurvatureOf(this->At(face, x));
  return true;
}

bool CurvatureWalk::Step()
{
  if (!this->HasNext_)
  {
    return false;
  }
  const Face& face = this->FaceOf(this->Triangle_);
  if (!face.hasArea)
  {
    return false;
  }
  const Eigen::Vector2d& start = face.corners[this->Side_];
  const Eigen::Vector2d side = face.corners[(this->Side_ + 1) % 3] - start;
  const Eigen::Vector2d x = start + this->Fraction_ * side;
  const Eigen::Vector2d along = this->Along_ * side + this->Inward_ * Turned(side);

  // The midpoint rule, if the way to the exit is one step.
  double distance = 0.0;
  Eigen::Vector2d direction =
    this->TurnedInward(face, this->Direction(this->At(face, x).turning, along));
  if (this->FindExit(face, x, direction, distance) < 0)
  {
    return false; // at an umbilic
  }
  direction = this->TurnedInward(
    face, this->Direction(this->At(face, x + 0.5 * distance * direction).turning, direction));
  const int exit = this->FindExit(face, x, direction, distance);
  if (exit < 0)
  {
    return false;
  }
  const Eigen::Vector2d exitStart = face.corners[exit];
  const Eigen::Vector2d exitSide = face.corners[(exit + 1) % 3] - exitStart;
  const double square = exitSide.squaredNorm();
  const double fraction = std::clamp((x + distance * direction - exitStart).dot(exitSide) / square,
    CornerMargin, 1.0 - CornerMargin);
  const Eigen::Vector2d y = exitStart + fraction * exitSide;
  const Local local = this->At(face, y);
  this->Curvature_ = this->CurvatureOf(local);
  this->StepLength_ = (y - x).norm();

  // Across the exit; the other triangle runs through it in the opposite sense.
  const Eigen::Vector2d last = this->Direction(local.turning, direction);
  const Eigen::Vector2d outward = -Turned(exitSide);
  const Eigen::Vector2d leaving = last.dot(outward) > 0.0 ? last : direction;
  this->Along_ = -leaving.dot(exitSide);
  this->Inward_ = std::max(0.0, leaving.dot(outward));
  const Edge& edge = this->Mesh_.EdgeAt(face.edges[exit]);
  this->HasNext_ = edge.t1 >= 0;
  if (this->HasNext_)
  {
    const Id exitEdge = face.edges[exit];
    this->Triangle_ = edge.t0 + edge.t1 - this->Triangle_;
    const bool forward = face.forward[exit];
    const Face& next = this->FaceOf(this->Triangle_);
    this->Side_ = next.edges[0] == exitEdge ? 0 : next.edges[1] == exitEdge ? 1 : 2;
    // Neighbours of opposite orientation run through the edge in the same sense.
    const bool same = next.hasArea && next.forward[this->Side_] == forward;
    this->Fraction_ = same ? fraction : 1.0 - fraction;
    this->Along_ = same ? -this->Along_ : this->Along_;
  }
  this->ShortSteps_ = this->StepLength_ * this->StepLength_ < ShortStep * ShortStep * square
    ? this->ShortSteps_ + 1
    : 0;
  return this->ShortSteps_ < MostShortSteps;
}

} // namespace ridges
