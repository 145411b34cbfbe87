// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// How far ridges are from those they should lie on.

#ifndef RIDGES_TESTING_RIDGE_COVERAGE_H
#define RIDGES_TESTING_RIDGE_COVERAGE_H

#include "FoundPicture.h"
#include "TrueRidges.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace ridges
{
namespace testing
{

// Of all lines of a colour; distances in edges, none above 6.
struct Coverage
{
  double mean = 0.0;
  double percentile95 = 0.0;
  double greatest = 0.0;
  Eigen::Vector3d farthest = Eigen::Vector3d::Zero();
  double off = 0.0;       // length farther than an edge
  double wrongType = 0.0; // length within an edge, of another type, not by a turning point
};

struct FoundCoverage
{
  std::array<Coverage, 2> colors; // blue, red
  std::vector<int> ridges;        // of each the true one that most of it lies on, -1 if spurious
};

struct TrueCoverage
{
  std::array<Coverage, 2> colors; // blue, red
  std::vector<double> missing;    // of each ridge the length that is not found
};

// The found ridges against the true ones, and the other way round. The edge is the mean one.
FoundCoverage MeasureFound(
  const std::vector<TrueRidge>& truth, const std::vector<FoundRidge>& found, double edge);
TrueCoverage MeasureTrue(
  const std::vector<TrueRidge>& truth, const std::vector<FoundRidge>& found, double edge);

} // namespace testing
} // namespace ridges

#endif
