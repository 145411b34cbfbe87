// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Salience/LineSmoothing.h"

#include "Salience/Trail.h"
#include "Umbilics/UmbilicForm.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace ridges
{
namespace
{

/// The Gaussian reaches this many deviations far, and is lowered so that it ends there with 0.
constexpr double Reach = 3.0;

double Bell(double ratio)
{
  return std::exp(-0.5 * ratio * ratio) - std::exp(-0.5 * Reach * Reach);
}

/// The average of a line around a point.
Eigen::Vector3d Average(
  const std::vector<RidgeVertex>& vertices, const Trail& trail, Id point, double deviation)
{
  const Eigen::Vector3d& center = vertices[point].point.position;
  if (!(deviation > 0.0))
  {
    return center;
  }
  // Both sides on their own: a line turned around gives the same.
  Eigen::Vector3d sums[2] = { Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero() };
  double weights[2] = { 0.0, 0.0 };
  for (const bool forward : { false, true })
  {
    double distance = 0.0;
    for (Id at = point; trail.Piece(at, forward) >= 0;)
    {
      distance += trail.LengthOf(trail.Piece(at, forward));
      if (distance > Reach * deviation)
      {
        break;
      }
      at = trail.Next(at, forward);
      const double weight = trail.LengthAt(at) * Bell(distance / deviation);
      sums[forward ? 1 : 0] += weight * (vertices[at].point.position - center);
      weights[forward ? 1 : 0] += weight;
    }
  }
  const double all = trail.LengthAt(point) * Bell(0.0) + (weights[0] + weights[1]);
  return all > 0.0 ? Eigen::Vector3d(center + (sums[0] + sums[1]) / all) : center;
}

/// The averages around all points, with a Gaussian that does not reach over the ends.
std::vector<Eigen::Vector3d> Averages(
  const std::vector<RidgeVertex>& vertices, bool closed, double sigma)
{
  const Trail trail(vertices, closed);
  double length = 0.0;
  for (Id i = 0; i < trail.NumberOfPoints(); ++i)
  {
    length += trail.LengthOf(trail.PieceBehind(i));
  }
  std::vector<Eigen::Vector3d> averages;
  double arc = 0.0;
  for (Id i = 0; i < trail.NumberOfPoints(); ++i)
  {
    const double toEnd = closed ? 0.5 * length : std::min(arc, length - arc);
    averages.push_back(Average(vertices, trail, i, std::min(sigma, toEnd / Reach)));
    arc += trail.LengthOf(trail.PieceBehind(i));
  }
  return averages;
}

Eigen::Vector3d NearestOnSegment(
  const Eigen::Vector3d& x, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  const Eigen::Vector3d ab = b - a;
  const double square = ab.squaredNorm();
  const double along = square > 0.0 ? (x - a).dot(ab) / square : 0.0;
  return a + std::clamp(along, 0.0, 1.0) * ab;
}

Eigen::Vector3d NearestOnTriangle(
  const Eigen::Vector3d& x, const std::array<Eigen::Vector3d, 3>& corners)
{
  const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  bool isAbove = normal.squaredNorm() > 0.0;
  Eigen::Vector3d nearest = corners[0];
  for (int i = 0; i < 3; ++i)
  {
    const Eigen::Vector3d& a = corners[i];
    const Eigen::Vector3d& b = corners[(i + 1) % 3];
    isAbove = isAbove && (b - a).cross(x - a).dot(normal) >= 0.0;
    const Eigen::Vector3d onSide = NearestOnSegment(x, a, b);
    nearest = (onSide - x).squaredNorm() < (nearest - x).squaredNorm() ? onSide : nearest;
  }
  return isAbove ? Eigen::Vector3d(x - (x - corners[0]).dot(normal) / normal.squaredNorm() * normal)
                 : nearest;
}

} // namespace

LineSmoother::LineSmoother(const TriangleMesh& mesh, const MongeField& field, double sigma)
  : Mesh_(mesh)
  , Field_(field)
  , Sigma_(sigma)
  , Ball_(mesh)
{
}

void LineSmoother::Smooth(bool closed, std::vector<RidgeVertex>& vertices)
{
  if (vertices.size() < 3 || !(this->Sigma_ > 0.0))
  {
    return;
  }
  const std::vector<Eigen::Vector3d> places = Averages(vertices, closed, this->Sigma_);
  const std::size_t last = vertices.size() - 1;
  for (std::size_t i = closed ? 0 : 1; i < last; ++i)
  {
    RidgeVertex& vertex = vertices[i];
    if (vertex.edge != RidgeVertex::None)
    {
      vertex.point.position = this->NearestOnSheet(places[i], vertex);
      vertex.point.parameter = 0.0;
      vertex.edge = RidgeVertex::None;
    }
  }
  if (closed)
  {
    vertices.back() = vertices.front();
  }
}

Eigen::Vector3d LineSmoother::NearestOnSheet(
  const Eigen::Vector3d& place, const RidgeVertex& vertex)
{
  // Triangles that share the nearest point give it with different digits: all of them are looked
  // at, in whatever order.
  constexpr double slack = 1.0 + 1e-9;
  Eigen::Vector3d best = vertex.point.position;
  double least = (best - place).squaredNorm();
  const auto isBetter = [&place, &best, &least](const Eigen::Vector3d& x)
  {
    const double square = (x - place).squaredNorm();
    return square != least
      ? square < least
      : std::lexicographical_compare(x.begin(), x.end(), best.begin(), best.end());
  };
  this->Ball_.Visit(place, this->Mesh_.EdgeAt(vertex.edge).t0, slack * least,
    [this, &place, &best, &least, &isBetter](Id t)
    {
      const Triangle corners = CornersInOrder(this->Mesh_, this->Field_, t);
      const Eigen::Vector3d x = NearestOnTriangle(place,
        { this->Mesh_.Point(corners[0]), this->Mesh_.Point(corners[1]),
          this->Mesh_.Point(corners[2]) });
      if (isBetter(x))
      {
        best = x;
        least = (x - place).squaredNorm();
      }
      return slack * least;
    });
  return best;
}

} // namespace ridges
