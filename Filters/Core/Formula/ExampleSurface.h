// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_ExampleSurface_h
#define ridges_ExampleSurface_h

#include "Mesh/Triangle.h"

#include <Eigen/Core>

#include <vector>

#include <functional>

namespace ridges
{

/// A surface f = 0 around an inner point from which every ray meets it once.
class ImplicitSurface
{
public:
  virtual ~ImplicitSurface() = default;

  /// f, negative inside, and its gradient.
  virtual double Evaluate(const Eigen::Vector3d& x, Eigen::Vector3d& gradient) const = 0;

  /// The inner point.
  virtual Eigen::Vector3d Center() const { return Eigen::Vector3d::Zero(); }

  /// Nearest points of the surface, found by Newton's method along the gradient.
  Eigen::Vector3d Project(Eigen::Vector3d x) const;
};

/// (x/a)^2 + (y/b)^2 + (z/c)^2 = 1
class EllipsoidSurface : public ImplicitSurface
{
public:
  explicit EllipsoidSurface(const Eigen::Vector3d& semiAxes);
  double Evaluate(const Eigen::Vector3d& x, Eigen::Vector3d& gradient) const override;

private:
  Eigen::Vector3d InverseSquares_;
};

/**
 * The blend of two ellipsoids of RR-5294, Fig. 25: 1 - exp(-0.7 (A - 1)) - exp(-0.7 (B - 1)) = 0
 * with A = x²/0.15² + y²/0.25² + z²/0.35² and
 * B = (x - 0.25)²/0.1² + (y - 0.1)²/0.2² + (z - 0.1)²/0.3². (In the printed formula the "-1" and a
 * sign are lost.) It has six umbilics of index +1/2 and two of index -1/2.
 */
class BlendSurface : public ImplicitSurface
{
public:
  double Evaluate(const Eigen::Vector3d& x, Eigen::Vector3d& gradient) const override;
  Eigen::Vector3d Center() const override { return { 0.1, 0.04, 0.04 }; }
};

struct PointsAndTriangles
{
  Eigen::Matrix3Xd points;
  std::vector<Triangle> triangles;
};

/**
 * The sphere of radius 1 as a geodesic icosahedron: every edge of an icosahedron is divided into
 * `frequency` parts, which gives 10 frequency² + 2 points. Turned so that no point lies in a
 * coordinate plane.
 */
PointsAndTriangles GeodesicSphere(int frequency);

/// Runs body(begin, end) over ranges that make up [0, count), maybe at the same time. False to
/// stop.
using StoppableLoop = std::function<bool(Id count, const std::function<void(Id, Id)>& body)>;

/// The loop of callers that have no threads to lend.
inline bool LoopAtOnce(Id count, const std::function<void(Id, Id)>& body)
{
  body(0, count);
  return true;
}

/// How often MeshSurface runs a loop.
constexpr int MeshSurfaceLoops = 121;

/**
 * A mesh with its points on the surface: a geodesic sphere cast along the rays from the inner
 * point, then smoothed along the surface, so that triangles are of even size and shape. The same
 * for any loop; without points if the loop was stopped.
 */
PointsAndTriangles MeshSurface(
  const ImplicitSurface& surface, int frequency, const StoppableLoop& loop = LoopAtOnce);

/// A geodesic sphere stretched: its triangles are smaller where the ellipsoid is more curved.
PointsAndTriangles MeshEllipsoid(const Eigen::Vector3d& semiAxes, int frequency);

} // namespace ridges

#endif
