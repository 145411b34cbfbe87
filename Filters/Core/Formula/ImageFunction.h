// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_ImageFunction_h
#define ridges_ImageFunction_h

#include "Formula/PointwiseFunction.h"

#include <array>

namespace ridges
{

/// Samples on a grid, the first index fastest. The values must outlive it.
struct ImageGrid
{
  const double* values = nullptr;
  std::array<int, 3> size{};
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();   ///< Of sample 0, 0, 0.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); ///< Orthonormal columns.
  Eigen::Vector3d spacing = Eigen::Vector3d::Ones();
  Eigen::Vector3d smoothing = Eigen::Vector3d::Zero(); ///< Deviation, in samples, of the Gaussian
                                                       ///< that the values are smoothed by already.

  /// Of a place, in samples, with fractions.
  Eigen::Vector3d IndexOf(const Eigen::Vector3d& x) const
  {
    return (this->axes.transpose() * (x - this->origin)).cwiseQuotient(this->spacing);
  }
};

/**
 * An image smoothed by a Gaussian, less a value, with its derivatives: sums over the samples within
 * 6.5 standard deviations, separable, by AxisWeights. Axes with fewer than five samples within
 * reach give no number.
 */
class ImageFunction : public PointwiseFunction
{
public:
  /// sigma is in the unit of the spacing.
  ImageFunction(const ImageGrid& grid, double sigma, double value);

  /// Whether samples within three standard deviations are beyond the border.
  bool IsAtBorder(const Eigen::Vector3d& x) const;

protected:
  void Evaluate(const Eigen::Vector3d& x, int order, double* coefficients) const override;

private:
  ImageGrid Grid_;
  Eigen::Vector3d Sigma_;     ///< In samples.
  Eigen::Vector3d Remaining_; ///< What the values are not smoothed by yet.
  double Value_;
};

} // namespace ridges

#endif
