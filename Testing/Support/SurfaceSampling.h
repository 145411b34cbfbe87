// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Samples of the analytic surfaces, and finite differences on them.

#ifndef RIDGES_TESTING_SURFACE_SAMPLING_H
#define RIDGES_TESTING_SURFACE_SAMPLING_H

#include "AnalyticSurface.h"

#include <Eigen/Core>

#include <functional>
#include <string>
#include <vector>

namespace ridges
{
namespace testing
{

struct NamedSurface
{
  std::string name;
  AnalyticSurface surface;
  Eigen::Vector3d center; // a point inside
};

// An ellipsoid and three surfaces without any symmetry, one of them of genus 2.
std::vector<NamedSurface> GenericSurfaces();

// The length over which the Monge form changes: 1 / max(|k|, |b|^(1/2), |c|^(1/3)).
double LocalLength(const ExactMonge& monge);

// Points met by random rays from the center, where (k1 - k2) * LocalLength > 0.1: finite
// differences need a distance to the umbilics, where the directions turn.
std::vector<Eigen::Vector3d> RandomPoints(const NamedSurface& item, int count);

// The point at arc length s from start on its curvature line of k1 (maximum) or k2, on the side of
// direction for s > 0; error s^5.
Eigen::Vector3d OnCurvatureLine(const AnalyticSurface& surface, const Eigen::Vector3d& start,
  const Eigen::Vector3d& direction, bool maximum, double s);

// Derivatives at 0 by central differences with steps h and 2 h; error h^4.
double FirstDerivative(const std::function<double(double)>& f, double h);
double SecondDerivative(const std::function<double(double)>& f, double h);

} // namespace testing
} // namespace ridges

#endif
