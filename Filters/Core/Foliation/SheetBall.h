// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_SheetBall_h
#define ridges_SheetBall_h

#include "Mesh/TriangleMesh.h"

#include <cstdint>
#include <vector>

namespace ridges
{

/// Squared distance from x to the segment between a and b.
inline double SquaredDistance(
  const Eigen::Vector3d& x, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  const Eigen::Vector3d ab = b - a;
  const double square = ab.squaredNorm();
  const double along = (x - a).dot(ab);
  const double fraction = along <= 0.0 ? 0.0 : along >= square ? 1.0 : along / square;
  return (x - a - fraction * ab).squaredNorm();
}

/**
 * Visits the triangles that a ball cuts out of the sheet of the surface that its centre is on:
 * those that are met on the way over edges inside the ball. The other side of a thin wall is not
 * visited, near as it may be, and neither is what lies behind a border or a non-manifold edge.
 *
 * Holds scratch memory: use one per thread.
 */
class SheetBall
{
public:
  explicit SheetBall(const TriangleMesh& mesh)
    : Mesh_(mesh)
    , Stamps_(mesh.NumberOfTriangles(), 0)
  {
  }

  /// Calls visit(t), which returns the square of the radius from then on: that of the ball, or a
  /// smaller one, and 0 to be called no more. The triangle of the centre is the first.
  template <typename Visitor>
  void Visit(const Eigen::Vector3d& center, Id triangle, double squaredRadius, const Visitor& visit)
  {
    if (++this->Stamp_ == 0)
    {
      this->Stamps_.assign(this->Stamps_.size(), 0);
      this->Stamp_ = 1;
    }
    this->Queue_.assign(1, triangle);
    this->Stamps_[triangle] = this->Stamp_;
    for (std::size_t next = 0; next < this->Queue_.size(); ++next)
    {
      const Id t = this->Queue_[next];
      squaredRadius = visit(t);
      if (!(squaredRadius > 0.0))
      {
        break;
      }
      for (int i = 0; i < 3; ++i)
      {
        const Id neighbor = this->Mesh_.Neighbor(t, i);
        if (neighbor >= 0 && this->Stamps_[neighbor] != this->Stamp_)
        {
          const Triangle& corners = this->Mesh_.Corners(t);
          const double square = SquaredDistance(
            center, this->Mesh_.Point(corners[i]), this->Mesh_.Point(corners[(i + 1) % 3]));
          if (square < squaredRadius)
          {
            this->Stamps_[neighbor] = this->Stamp_;
            this->Queue_.push_back(neighbor);
          }
        }
      }
    }
  }

  /// How many triangles the last visit came to, about: what it took.
  std::size_t Size() const { return this->Queue_.size(); }

private:
  const TriangleMesh& Mesh_;
  std::vector<std::uint32_t> Stamps_;
  std::uint32_t Stamp_ = 0;
  std::vector<Id> Queue_;
};

} // namespace ridges

#endif
