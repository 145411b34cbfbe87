// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// What is known exactly of the umbilics and ridges of the ellipsoid with semi-axes a > b > c along
// x, y, z.

#ifndef RIDGES_TESTING_ELLIPSOID_RIDGES_H
#define RIDGES_TESTING_ELLIPSOID_RIDGES_H

#include <Eigen/Core>

#include <array>
#include <vector>

namespace ridges
{
namespace testing
{

// The values of the array RidgeType.
constexpr int MaximumElliptic = 1;   // blue: maximum of k1, P1 < 0
constexpr int MaximumHyperbolic = 2; // green: minimum of k1, P1 > 0
constexpr int MinimumElliptic = 3;   // red: minimum of k2, P2 < 0
constexpr int MinimumHyperbolic = 4; // yellow: maximum of k2, P2 > 0

// A piece of one type of the ellipse in the coordinate plane orthogonal to axis plane (0, 1, 2),
// for parameters in [begin, end].
struct EllipsoidRidgePiece
{
  int type = MaximumElliptic;
  int plane = 0;
  double begin = 0.0;
  double end = 0.0;
  bool closed = false;
  bool endsAtUmbilics = false;
  double length = 0.0;
  double strength = 0.0;
  double sharpness = 0.0;
};

// All of index +1/2, with one ridge.
std::array<Eigen::Vector3d, 4> EllipsoidUmbilics(double a, double b, double c);

// The ellipse in a coordinate plane: first remaining semi-axis times cos(t), second times sin(t).
Eigen::Vector3d EllipsoidRidgePoint(double a, double b, double c, int plane, double t);

// The type of the ridge there, from the exact Monge form; t is not at an umbilic.
int EllipsoidRidgeTypeAt(double a, double b, double c, int plane, double t);

// All the ridges, cut at umbilics and turning points, with
//   length    = the integral of ds,
//   strength  = the integral of |k| ds, k the curvature of the ridge's colour,
//   sharpness = a^2 times the integral of |P1 / (k1 - k2)| ds or |P2 / (k2 - k1)| ds, without the
//               points closer than cutoff * a to an umbilic, where it diverges (a is the radius of
//               the smallest enclosing sphere),
// to a relative error of about 1e-11.
std::vector<EllipsoidRidgePiece> EllipsoidRidgeIntegrals(
  double a, double b, double c, double cutoff = 0.01);

} // namespace testing
} // namespace ridges

#endif
