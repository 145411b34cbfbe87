// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_NoiseFloor_h
#define ridges_NoiseFloor_h

#include "Fit/FitErrors.h"
#include "Mesh/OrderedRings.h"
#include "Monge/AcuteRule.h"
#include "Monge/MongeForm.h"

#include <vector>

namespace ridges
{

/**
 * The standard deviation of the noise of points, which is taken to be independent from point to
 * point: from the heights that polynomials of degree four leave over in three rings, where these
 * are smallest. Detail of the surface, which leaves more over, hardly counts so.
 */
class NoiseMeter
{
public:
  NoiseMeter(const TriangleMesh& mesh, const OrderedRings& rings)
    : Mesh_(mesh)
    , Rings_(rings)
  {
  }

  /// The rms of the heights left over around each of these points, appended; points that cannot be
  /// fitted are left out. The order does not matter, and ranges may be done at the same time.
  void Measure(Span<Id> sample, std::vector<double>& heights) const;

  /// By all heights; 0 without any.
  static double Deviation(std::vector<double> heights);

private:
  const TriangleMesh& Mesh_;
  const OrderedRings& Rings_;
};

/// A number of normal distribution, of deviation 1, that depends on the point's coordinates only.
double NormalNoise(const Eigen::Vector3d& point);

/// By how much the curvature tensors of two fields differ at a point.
double SquaredDifference(const MongeField& field, Id p, const MongeForm& other);

/**
 * The standard deviation of a curvature, from these differences at all points, where one field has
 * noise that the other does not have. By a median, so that places where noise changes the shape do
 * not matter.
 */
double CurvatureDeviation(const TriangleMesh& mesh, const std::vector<double>& differences);

/// The standard error of a curvature at the median point with triangles, as far as the fits let it
/// be known; 0 for fields without errors, as exact ones.
double MedianCurvatureError(const TriangleMesh& mesh, const FitErrorSource& source);

} // namespace ridges

#endif
