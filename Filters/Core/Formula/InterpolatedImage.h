// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_InterpolatedImage_h
#define ridges_InterpolatedImage_h

#include "Formula/ImageFunction.h"

namespace ridges
{

/// The samples of an image, less a value, interpolated by cubic polynomials whose slopes are
/// continuous: much faster than ImageFunction, and good enough until a mesh is even. Value and
/// slope only. At the nearest place inside, outside.
class InterpolatedImage : public PointwiseFunction
{
public:
  InterpolatedImage(const ImageGrid& grid, double value);

protected:
  void Evaluate(const Eigen::Vector3d& x, int order, double* coefficients) const override;

private:
  ImageGrid Grid_;
  double Value_;
};

} // namespace ridges

#endif
