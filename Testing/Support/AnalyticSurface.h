// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Implicit surfaces f(x, y, z) = 0 with their exact Monge forms (case I of the paper): the ground
// truth the tests compare with.

#ifndef RIDGES_TESTING_ANALYTIC_SURFACE_H
#define RIDGES_TESTING_ANALYTIC_SURFACE_H

#include "Formula/Taylor3Functions.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <functional>
#include <utility>

namespace ridges
{
namespace testing
{

// z = 1/2 (k1 x^2 + k2 y^2) + 1/6 (b0 x^3 + 3 b1 x^2 y + 3 b2 x y^2 + b3 y^3)
//   + 1/24 (c0 x^4 + 4 c1 x^3 y + 6 c2 x^2 y^2 + 4 c3 x y^3 + c4 y^4)
// along the outward normal n, in the direct orthonormal frame (d1, d2, n), k1 >= k2.
// P1 = 3 b1^2 + (k1 - k2)(c0 - 3 k1^3), P2 = 3 b2^2 + (k2 - k1)(c4 - 3 k2^3).
// The sign of d1 is arbitrary; changing it changes the signs of d2 and of all b.
struct ExactMonge
{
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d d1 = Eigen::Vector3d::UnitX();
  Eigen::Vector3d d2 = Eigen::Vector3d::UnitY();
  Eigen::Vector3d n = Eigen::Vector3d::UnitZ();
  double k1 = 0.0;
  double k2 = 0.0;
  std::array<double, 4> b{};
  std::array<double, 5> c{};
  double P1 = 0.0;
  double P2 = 0.0;
};

// A surface given by a formula, negative inside, so that its gradient is the outward normal.
// The formula is a generic callable: AnalyticSurface([](auto x, auto y, auto z) { ... }).
class AnalyticSurface
{
public:
  template <typename Formula>
  explicit AnalyticSurface(Formula formula)
    : FirstOrder(formula)
    , FullOrder(std::move(formula))
  {
  }

  double Value(const Eigen::Vector3d& point) const;
  Eigen::Vector3d Gradient(const Eigen::Vector3d& point) const;

  // Newton's method along the gradient, damped, until |f| is at round-off. The result is close to
  // the nearest point of the surface, not equal to it. Throws std::runtime_error on failure.
  Eigen::Vector3d Project(const Eigen::Vector3d& point) const;

  // The point of the surface on the ray from center (inside) along direction; unique if the surface
  // is star-shaped about center. Throws std::runtime_error if there is none.
  Eigen::Vector3d IntersectRay(
    const Eigen::Vector3d& center, const Eigen::Vector3d& direction) const;

  // The exact Monge form at a point that lies on the surface.
  ExactMonge Monge(const Eigen::Vector3d& pointOnSurface) const;

private:
  using Jet1 = Taylor3<1>;
  using Jet4 = Taylor3<4>;

  Jet1 Linearization(const Eigen::Vector3d& point) const;
  Jet4 HeightFunction(const Eigen::Vector3d& point, const Eigen::Vector3d& t1,
    const Eigen::Vector3d& t2, const Eigen::Vector3d& n) const;

  std::function<Jet1(Jet1, Jet1, Jet1)> FirstOrder;
  std::function<Jet4(Jet4, Jet4, Jet4)> FullOrder;
};

AnalyticSurface MakeSphere(double r);
// Infinite, around the z axis.
AnalyticSurface MakeCylinder(double r);
// R: from the z axis to the center of the tube; r < R: radius of the tube.
AnalyticSurface MakeTorus(double R, double r);
// Semi-axes along x, y, z.
AnalyticSurface MakeEllipsoid(double a, double b, double c);
// The paper's figure 25. Star-shaped about BlendCenter().
AnalyticSurface MakeBlend();
Eigen::Vector3d BlendCenter();
// x^2 + y^2 + z^2 = 1 + epsilon q, q a cubic and quartic polynomial with coefficients in [-1, 1]
// drawn from the seed. Generic, and star-shaped about the origin for epsilon <= 0.1.
AnalyticSurface MakePerturbedSphere(double epsilon, std::uint64_t seed = 1);
// A thick figure eight of genus 2, without symmetry, within DoubleTorusHalfSize() of the origin
// along each axis.
AnalyticSurface MakeDoubleTorus();
Eigen::Vector3d DoubleTorusHalfSize();

// Uniform in [0, 1): unlike the standard distributions, the same with every standard library.
template <typename Generator>
double Uniform(Generator& generator)
{
  return static_cast<double>(generator() >> 11) * 0x1p-53;
}

} // namespace testing
} // namespace ridges

#endif
