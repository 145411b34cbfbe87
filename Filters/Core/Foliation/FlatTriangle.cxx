// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Foliation/FlatTriangle.h"

#include "Mesh/PositionOrder.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace ridges
{
namespace
{

/// The corners of a triangle, as 0, 1, 2, in the order of their coordinates.
std::array<int, 3> OrderOfCorners(const TriangleMesh& mesh, const Triangle& corners)
{
  std::array<int, 3> order = { 0, 1, 2 };
  std::sort(order.begin(), order.end(),
    [&mesh, &corners](int i, int j) { return PointComesBefore(mesh, corners[i], corners[j]); });
  return order;
}

/// The traceless second fundamental form of a point in the plane of two axes.
Eigen::Vector2d TurningAt(
  const MongeField& field, Id p, const Eigen::Vector3d& axisX, const Eigen::Vector3d& axisY)
{
  const Eigen::Vector3d d1 = field.D1(p);
  const Eigen::Vector3d n = d1.cross(field.D2(p));
  Eigen::Vector3d normal = axisX.cross(axisY);
  if (n.dot(normal) < 0.0)
  {
    normal = -normal;
  }
  // The smallest turn that takes n to the normal.
  const Eigen::Vector3d turned = d1 - d1.dot(normal) / (1.0 + n.dot(normal)) * (n + normal);
  const double x = turned.dot(axisX);
  const double y = turned.dot(axisY);
  const double square = x * x + y * y;
  if (!(square > 0.0))
  {
    return Eigen::Vector2d::Zero();
  }
  const double scale = (field.k1[p] - field.k2[p]) / square;
  return { scale * (x * x - y * y), scale * 2.0 * x * y };
}

FlatTriangle::Side MakeSide(
  const Eigen::Vector2d& start, const Eigen::Vector2d& end, const Eigen::Vector2d& opposite)
{
  FlatTriangle::Side side;
  side.start = start;
  side.length = (end - start).norm();
  side.along = (end - start) / side.length;
  side.inward = { -side.along[1], side.along[0] };
  if (side.inward.dot(opposite - start) < 0.0)
  {
    side.inward = -side.inward;
  }
  return side;
}

} // namespace

FlatTriangle::FlatTriangle(const TriangleMesh& mesh, const MongeField& field, Id triangle)
{
  const Triangle& corners = mesh.Corners(triangle);
  const std::array<int, 3> order = OrderOfCorners(mesh, corners);
  const std::array<Id, 3> p = { corners[order[0]], corners[order[1]], corners[order[2]] };
  this->Origin_ = mesh.Point(p[0]);
  const Eigen::Vector3d base = mesh.Point(p[1]) - this->Origin_;
  const Eigen::Vector3d side = mesh.Point(p[2]) - this->Origin_;
  this->Base_ = base.norm();
  if (!(this->Base_ > 0.0))
  {
    return;
  }
  this->AxisX_ = base / this->Base_;
  this->Apex_ = side.dot(this->AxisX_);
  const Eigen::Vector3d up = side - this->Apex_ * this->AxisX_;
  this->Height_ = up.norm();
  if (this->IsDegenerate())
  {
    return;
  }
  this->AxisY_ = up / this->Height_;

  const std::array<Eigen::Vector2d, 3> flat = { Eigen::Vector2d::Zero(),
    Eigen::Vector2d(this->Base_, 0.0), Eigen::Vector2d(this->Apex_, this->Height_) };
  constexpr int ends[3][3] = { { 0, 1, 2 }, { 1, 2, 0 }, { 0, 2, 1 } };
  for (int i = 0; i < 3; ++i)
  {
    const auto& [from, to, opposite] = ends[i];
    this->Sides_[i] = MakeSide(flat[from], flat[to], flat[opposite]);
    const int first = order[from];
    const int second = order[to];
    const int inMesh = second == (first + 1) % 3 ? first : second;
    this->Sides_[i].edge = mesh.EdgeOf(triangle, inMesh);
    this->Sides_[i].neighbor = mesh.Neighbor(triangle, inMesh);
    this->Turnings_.col(i) = TurningAt(field, p[i], this->AxisX_, this->AxisY_);
    this->Sums_[i] = field.k1[p[i]] + field.k2[p[i]];
  }
}

int FlatTriangle::SideOf(Id edge) const
{
  return this->Sides_[0].edge == edge ? 0 : this->Sides_[1].edge == edge ? 1 : 2;
}

Eigen::Vector3d FlatTriangle::ToSpace(const Eigen::Vector2d& flat) const
{
  return this->Origin_ + flat[0] * this->AxisX_ + flat[1] * this->AxisY_;
}

Eigen::Vector2d FlatTriangle::ToFlat(const Eigen::Vector3d& point) const
{
  const Eigen::Vector3d offset = point - this->Origin_;
  return { offset.dot(this->AxisX_), offset.dot(this->AxisY_) };
}

Eigen::Vector2d FlatTriangle::Centroid() const
{
  return { (this->Base_ + this->Apex_) / 3.0, this->Height_ / 3.0 };
}

/// Barycentric coordinates.
Eigen::Vector3d FlatTriangle::Weights(const Eigen::Vector2d& flat) const
{
  const double w2 = flat[1] / this->Height_;
  const double w1 = (flat[0] - w2 * this->Apex_) / this->Base_;
  return { 1.0 - w1 - w2, w1, w2 };
}

Eigen::Vector2d FlatTriangle::Turning(const Eigen::Vector2d& flat) const
{
  return this->Turnings_ * this->Weights(flat);
}

Eigen::Vector2d FlatTriangle::Direction(
  Color color, const Eigen::Vector2d& flat, const Eigen::Vector2d& along) const
{
  Eigen::Vector2d turning = this->Turning(flat);
  if (color == Color::Red)
  {
    turning = -turning;
  }
  // Half the angle, without trigonometry and without cancellation.
  const double length = turning.stableNorm();
  Eigen::Vector2d direction = turning[0] >= 0.0 ? Eigen::Vector2d(turning[0] + length, turning[1])
                                                : Eigen::Vector2d(turning[1], length - turning[0]);
  direction.stableNormalize();
  return direction.dot(along) < 0.0 ? Eigen::Vector2d(-direction) : direction;
}

double FlatTriangle::Curvature(Color color, const Eigen::Vector2d& flat) const
{
  const double sum = this->Sums_.dot(this->Weights(flat));
  const double gap = this->Gap(flat);
  return 0.5 * (color == Color::Blue ? sum + gap : sum - gap);
}

} // namespace ridges
