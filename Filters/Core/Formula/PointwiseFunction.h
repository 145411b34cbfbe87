// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_PointwiseFunction_h
#define ridges_PointwiseFunction_h

#include "Formula/JetFunction.h"

#include <Eigen/Core>

#include <array>

namespace ridges
{

/**
 * A function that is evaluated point by point, by the coefficients of its Taylor polynomial in
 * coordinates of its own: these are a linear map of the offset from the point.
 */
class PointwiseFunction : public JetFunction
{
public:
  explicit PointwiseFunction(const Eigen::Matrix3d& toOwn = Eigen::Matrix3d::Identity())
    : ToOwn_(toOwn)
  {
  }

  Jet1 Linear(const LaneVector3& x) const override;
  Jet4 Full(const LaneVector3& x, const std::array<LaneVector3, 3>& axes) const override;

protected:
  /// The coefficients of degree up to `order`, 1 or 4, in the order of Taylor3.
  virtual void Evaluate(const Eigen::Vector3d& x, int order, double* coefficients) const = 0;

private:
  Eigen::Matrix3d ToOwn_;
};

} // namespace ridges

#endif
