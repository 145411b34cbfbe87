// SPDX-License-Identifier: BSD-3-Clause
#include "EnclosingSphere.h"

#include <Eigen/QR>

#include <cmath>

namespace ridges
{
namespace
{

/// At most four points that determine a sphere, and room for a fifth.
struct Support
{
  Eigen::Matrix<double, 3, 5> points = Eigen::Matrix<double, 3, 5>::Zero();
  int count = 0;

  void Add(const Eigen::Vector3d& point) { this->points.col(this->count++) = point; }
};

/// The sphere through the points whose centre lies in their affine hull.
Sphere CircumscribedSphere(const Support& support)
{
  Sphere sphere{ support.points.col(0), 0.0 };
  if (support.count > 1)
  {
    const Eigen::Matrix3Xd edges =
      support.points.middleCols(1, support.count - 1).colwise() - support.points.col(0);
    const Eigen::MatrixXd gram = edges.transpose() * edges;
    const Eigen::VectorXd halfSquares = 0.5 * gram.diagonal();
    const Eigen::Vector3d offset = edges * gram.colPivHouseholderQr().solve(halfSquares);
    sphere.center += offset;
    sphere.radius = offset.norm();
  }
  return sphere;
}

/// The smallest sphere around the points of `support`, which is left with those that determine it.
Sphere SmallestSphereOfFew(Support& support)
{
  Sphere best{ support.points.col(0), -1.0 };
  Support bestSupport;
  for (int subset = 1; subset < (1 << support.count); ++subset)
  {
    Support chosen;
    for (int i = 0; i < support.count; ++i)
    {
      if (subset & (1 << i))
      {
        chosen.Add(support.points.col(i));
      }
    }
    if (chosen.count > 4)
    {
      continue;
    }
    const Sphere sphere = CircumscribedSphere(chosen);
    const auto points = support.points.leftCols(support.count);
    const double farthest = (points.colwise() - sphere.center).colwise().norm().maxCoeff();
    const bool encloses = farthest <= sphere.radius * (1.0 + 1e-12);
    if (encloses && (best.radius < 0.0 || sphere.radius < best.radius))
    {
      best = sphere;
      bestSupport = chosen;
    }
  }
  support = bestSupport;
  return best;
}

} // namespace

// The farthest point outside the current sphere joins the few that determine it. The radius grows
// in every step and each sphere belongs to one of finitely many sets of points, so the loop ends;
// in practice after about ten steps, each linear in the number of points.
Sphere SmallestEnclosingSphere(const Eigen::Ref<const Eigen::Matrix3Xd>& points)
{
  if (points.cols() == 0)
  {
    return {};
  }
  Support support;
  support.Add(points.col(0));
  Sphere sphere{ points.col(0), 0.0 };
  for (;;)
  {
    Eigen::Index farthest = 0;
    const double squared =
      (points.colwise() - sphere.center).colwise().squaredNorm().maxCoeff(&farthest);
    if (!(std::sqrt(squared) > sphere.radius * (1.0 + 1e-12)))
    {
      return sphere;
    }
    support.Add(points.col(farthest));
    const Sphere larger = SmallestSphereOfFew(support);
    if (!(larger.radius > sphere.radius))
    {
      // Round-off: the support points are almost dependent. Enclose the last one all the same.
      sphere.radius = std::sqrt(squared);
      return sphere;
    }
    sphere = larger;
  }
}

Sphere SmallestEnclosingSphere(const TriangleMesh& mesh)
{
  Eigen::Matrix3Xd points(3, mesh.NumberOfPoints());
  Eigen::Index used = 0;
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    if (mesh.TrianglesAround(p).size() > 0)
    {
      points.col(used++) = mesh.Point(p);
    }
  }
  return SmallestEnclosingSphere(points.leftCols(used));
}

} // namespace ridges
