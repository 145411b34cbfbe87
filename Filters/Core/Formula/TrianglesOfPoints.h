// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_TrianglesOfPoints_h
#define ridges_TrianglesOfPoints_h

#include "Mesh/Triangle.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <numeric>
#include <vector>

namespace ridges
{

/// The triangles around each point, in ascending order.
class TrianglesOfPoints
{
public:
  TrianglesOfPoints(Id numberOfPoints, const std::vector<Triangle>& triangles)
    : Triangles_(triangles)
    , Offsets_(static_cast<std::size_t>(numberOfPoints) + 1, 0)
    , Incident_(3 * triangles.size())
  {
    for (const Triangle& corners : triangles)
    {
      for (const Id p : corners)
      {
        ++this->Offsets_[p + 1];
      }
    }
    std::partial_sum(this->Offsets_.begin(), this->Offsets_.end(), this->Offsets_.begin());
    std::vector<Id> next(this->Offsets_.begin(), this->Offsets_.end() - 1);
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
      for (const Id p : triangles[t])
      {
        this->Incident_[next[p]++] = static_cast<Id>(t);
      }
    }
  }

  Span<Id> operator[](Id p) const
  {
    const Id* first = this->Incident_.data();
    return { first + this->Offsets_[p], first + this->Offsets_[p + 1] };
  }

  /// Weighted by area: if points move there, large triangles shrink. `pointAt` gives the position
  /// of a point.
  template <typename PointAt>
  Eigen::Vector3d MeanCentroid(Id p, const PointAt& pointAt) const
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double weight = 0.0;
    for (const Id t : (*this)[p])
    {
      const Triangle& c = this->Triangles_[t];
      const Eigen::Vector3d a = pointAt(c[0]);
      const Eigen::Vector3d centroid = (a + pointAt(c[1]) + pointAt(c[2])) / 3.0;
      const Eigen::Vector3d e1 = pointAt(c[1]) - a;
      const Eigen::Vector3d e2 = pointAt(c[2]) - a;
      const double area = e1.cross(e2).norm();
      sum += area * centroid;
      weight += area;
    }
    return sum / weight;
  }

private:
  const std::vector<Triangle>& Triangles_;
  std::vector<Id> Offsets_;
  std::vector<Id> Incident_;
};

} // namespace ridges

#endif
