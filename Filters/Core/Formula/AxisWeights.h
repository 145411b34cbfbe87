// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_AxisWeights_h
#define ridges_AxisWeights_h

#include <cstddef>
#include <vector>

namespace ridges
{

/**
 * Weights of the samples along an axis of an image that give its Taylor coefficients of order 0 to
 * 4, smoothed by a Gaussian, at a place between samples: those of the Gaussian times a polynomial
 * of degree 4, such that every polynomial of degree 4 is smoothed exactly, near the ends as well.
 */
struct AxisWeights
{
  static constexpr int Orders = 5;

  /// `smoothing` is the deviation of the Gaussian; both it and `index` are in samples.
  AxisWeights() = default;
  AxisWeights(double index, double smoothing, int size);

  int first = 0; ///< Sample that the first weight is for.
  int count = 0;

  double operator()(int order, int i) const
  {
    return this->Weights_[static_cast<std::size_t>(order) * this->count + i];
  }
  /// Whether too few samples are within reach.
  bool IsEmpty() const { return this->count < Orders; }

private:
  std::vector<double> Weights_; ///< Order after order.
};

} // namespace ridges

#endif
