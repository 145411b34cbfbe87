// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_MeanGradient_h
#define ridges_MeanGradient_h

#include "Mesh/Triangle.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Geometry>

namespace ridges
{

/// The gradient of a function at a point: the mean of those of the triangles around it, in each of
/// which the function is linear, weighted by area.
class MeanGradient
{
public:
  /// A triangle: its sides from the point, and by how much the function rises along them.
  void Add(const Eigen::Vector3d& e1, const Eigen::Vector3d& e2, double rise1, double rise2)
  {
    const Eigen::Vector3d normal = e1.cross(e2);
    const double length = normal.norm();
    if (length > 0.0)
    {
      this->Sum_ += (rise1 * e2.cross(normal) + rise2 * normal.cross(e1)) / length;
      this->Area_ += length;
    }
  }

  /// The derivative along a unit vector; 0 where no triangle has an area.
  double Along(const Eigen::Vector3d& direction) const
  {
    return this->Area_ > 0.0 ? this->Sum_.dot(direction) / this->Area_ : 0.0;
  }

private:
  Eigen::Vector3d Sum_ = Eigen::Vector3d::Zero();
  double Area_ = 0.0;
};

/// Of a function that rises by rise(q) from p to its neighbour q.
template <typename Rise>
MeanGradient GradientAround(const TriangleMesh& mesh, Id p, const Rise& rise)
{
  MeanGradient gradient;
  for (const Id t : mesh.TrianglesAround(p))
  {
    const Triangle& c = mesh.Corners(t);
    const int corner = CornerOf(c, p);
    const Id q = c[(corner + 1) % 3];
    const Id r = c[(corner + 2) % 3];
    gradient.Add(mesh.Point(q) - mesh.Point(p), mesh.Point(r) - mesh.Point(p), rise(q), rise(r));
  }
  return gradient;
}

} // namespace ridges

#endif
