// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_MeanGradient_h
#define ridges_MeanGradient_h

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

} // namespace ridges

#endif
