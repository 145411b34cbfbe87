// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_Weighting_h
#define ridges_Weighting_h

#include <cmath>

namespace ridges
{

/// How much the points of a neighbourhood count in a fit.
enum class Weighting
{
  Uniform, ///< All the same.
  Gaussian ///< By GaussianWeight().
};

/// A Gaussian whose standard deviation is half the radius: 1 at the vertex, 0.135 at the radius.
inline double GaussianWeight(double squaredDistance, double squaredRadius)
{
  return std::exp(-2.0 * squaredDistance / squaredRadius);
}

} // namespace ridges

#endif
