// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_LinearWeights_h
#define ridges_LinearWeights_h

#include <Eigen/Geometry>

namespace ridges
{

/**
 * What makes the mean of places around a point that point, in its tangent plane: a place at the
 * offset x, of weight w, gets the weight w (1 + Slope(x)). Means of what is linear are exact then.
 */
class LinearWeights
{
public:
  /// The normal has length 1. Without one, which is zero, all slopes are 0.
  explicit LinearWeights(const Eigen::Vector3d& normal)
  {
    if (normal.squaredNorm() > 0.0)
    {
      this->U_ = normal.unitOrthogonal();
      this->V_ = normal.cross(this->U_);
    }
  }

  void Add(double weight, const Eigen::Vector3d& offset)
  {
    const double u = this->U_.dot(offset);
    const double v = this->V_.dot(offset);
    this->Sums_ += weight * Eigen::Vector2d(u, v);
    this->UU_ += weight * u * u;
    this->UV_ += weight * u * v;
    this->VV_ += weight * v * v;
  }

  /// After all places are added.
  void Solve()
  {
    const double determinant = this->UU_ * this->VV_ - this->UV_ * this->UV_;
    const double trace = this->UU_ + this->VV_;
    // Places along a line say nothing about the other direction.
    constexpr double least = 1e-3;
    if (determinant > least * trace * trace)
    {
      const double alongU = this->VV_ * this->Sums_[0] - this->UV_ * this->Sums_[1];
      const double alongV = this->UU_ * this->Sums_[1] - this->UV_ * this->Sums_[0];
      this->Slope_ = (alongU * this->U_ + alongV * this->V_) / -determinant;
    }
  }

  double Slope(const Eigen::Vector3d& offset) const { return this->Slope_.dot(offset); }

private:
  Eigen::Vector3d U_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d V_ = Eigen::Vector3d::Zero();
  Eigen::Vector2d Sums_ = Eigen::Vector2d::Zero();
  double UU_ = 0.0;
  double UV_ = 0.0;
  double VV_ = 0.0;
  Eigen::Vector3d Slope_ = Eigen::Vector3d::Zero();
};

} // namespace ridges

#endif
