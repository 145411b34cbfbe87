// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Salience/LineSmoothing.h"

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

/// The vertices of a line with their distances, those of a closed one going around.
class Track
{
public:
  Track(const std::vector<RidgeVertex>& vertices, bool closed)
    : Vertices_(vertices)
    , Closed_(closed)
    , Pieces_(static_cast<Id>(vertices.size()) - 1)
    , Arc_(vertices.size(), 0.0)
  {
    for (Id i = 0; i < this->Pieces_; ++i)
    {
      this->Arc_[i + 1] = this->Arc_[i] + (this->At(i + 1) - this->At(i)).norm();
    }
  }

  /// The average around a vertex, with a Gaussian that does not reach over the ends.
  Eigen::Vector3d Average(Id vertex, double sigma) const
  {
    const double length = this->Arc_.back();
    const double toEnd =
      this->Closed_ ? 0.5 * length : std::min(this->Arc_[vertex], length - this->Arc_[vertex]);
    const double deviation = std::min(sigma, toEnd / Reach);
    const Eigen::Vector3d& center = this->At(vertex);
    if (!(deviation > 0.0))
    {
      return center;
    }
    // Both sides on their own: a line turned around gives the same.
    Eigen::Vector3d sums[2] = { Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero() };
    double weights[2] = { 0.0, 0.0 };
    for (const int side : { 0, 1 })
    {
      double distance = 0.0;
      for (Id at = vertex; this->HasPiece(at, side);)
      {
        distance += this->PieceLength(at, side);
        if (distance > Reach * deviation)
        {
          break;
        }
        at = this->Next(at, side);
        const double ratio = distance / deviation;
        const double weight = this->Share(at) * Bell(ratio);
        sums[side] += weight * (this->At(at) - center);
        weights[side] += weight;
      }
    }
    const double all = this->Share(vertex) * Bell(0.0) + (weights[0] + weights[1]);
    return all > 0.0 ? Eigen::Vector3d(center + (sums[0] + sums[1]) / all) : center;
  }

private:
  const Eigen::Vector3d& At(Id vertex) const { return this->Vertices_[vertex].point.position; }
  Id Next(Id vertex, int side) const
  {
    const Id next = vertex + (side == 1 ? 1 : -1);
    return this->Closed_ ? (next + this->Pieces_) % this->Pieces_ : next;
  }
  bool HasPiece(Id vertex, int side) const
  {
    return this->Closed_ || (side == 1 ? vertex < this->Pieces_ : vertex > 0);
  }
  double PieceLength(Id vertex, int side) const
  {
    const Id piece = side == 1 ? vertex : (vertex > 0 ? vertex : this->Pieces_) - 1;
    return this->Arc_[piece + 1] - this->Arc_[piece];
  }
  /// The length of the line that a vertex stands for.
  double Share(Id vertex) const
  {
    const double before = this->HasPiece(vertex, 0) ? this->PieceLength(vertex, 0) : 0.0;
    const double behind = this->HasPiece(vertex, 1) ? this->PieceLength(vertex, 1) : 0.0;
    return 0.5 * (before + behind);
  }

  const std::vector<RidgeVertex>& Vertices_;
  bool Closed_;
  Id Pieces_;
  std::vector<double> Arc_;
};

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
  const Track track(vertices, closed);
  const std::size_t last = vertices.size() - 1;
  std::vector<Eigen::Vector3d> places(vertices.size());
  for (std::size_t i = 0; i < last; ++i)
  {
    places[i] = track.Average(static_cast<Id>(i), this->Sigma_);
  }
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
