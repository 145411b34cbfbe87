// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/EnclosingSphere.h"

#include "Mesh/PositionOrder.h"

#include <Eigen/Geometry>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <vector>

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
// in practice after about ten steps, each linear in the number of points. What comes first by
// position starts and decides between equals: not even round-off depends on the numbering.
Sphere SmallestEnclosingSphere(const Eigen::Ref<const Eigen::Matrix3Xd>& points)
{
  if (points.cols() == 0)
  {
    return {};
  }
  Eigen::Index first = 0;
  for (Eigen::Index i = 1; i < points.cols(); ++i)
  {
    first = ComesBefore(points.col(i), points.col(first)) ? i : first;
  }
  Support support;
  support.Add(points.col(first));
  Sphere sphere{ points.col(first), 0.0 };
  for (;;)
  {
    Eigen::Index farthest = 0;
    double squared = -1.0;
    for (Eigen::Index i = 0; i < points.cols(); ++i)
    {
      const double other = (points.col(i) - sphere.center).squaredNorm();
      if (other > squared || (other == squared && ComesBefore(points.col(i), points.col(farthest))))
      {
        squared = other;
        farthest = i;
      }
    }
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

// Let c be any centre and R the distance of the farthest point. The smallest sphere, of radius r
// about c + d, has points on the far side of c: |d|^2 + r^2 <= R^2. So with a lower bound of r,
// half the distance of two points, |d| is bounded, and what lies nearer to c than r - |d| is
// inside.
Sphere SmallestEnclosingSphere(const TriangleMesh& mesh)
{
  Eigen::AlignedBox3d box;
  const auto isUsed = [&mesh](Id p) { return mesh.TrianglesAround(p).size() > 0; };
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    if (isUsed(p))
    {
      box.extend(mesh.Point(p));
    }
  }
  if (box.isEmpty())
  {
    return {};
  }
  const auto farthestFrom = [&mesh, &isUsed](const Eigen::Vector3d& center)
  {
    Eigen::Vector3d farthest = center;
    double squared = 0.0;
    for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
    {
      const double other = (mesh.Point(p) - center).squaredNorm();
      const bool isFarther =
        other > squared || (other == squared && ComesBefore(mesh.Point(p), farthest));
      if (isFarther && isUsed(p))
      {
        squared = other;
        farthest = mesh.Point(p);
      }
    }
    return farthest;
  };
  const Eigen::Vector3d center = box.center();
  const Eigen::Vector3d end = farthestFrom(center);
  const double outer = (end - center).norm();
  const double inner = 0.5 * (farthestFrom(end) - end).norm();
  const double shift = std::sqrt(std::max(0.0, outer * outer - inner * inner));
  const double least = std::max(0.0, (inner - shift) * (1.0 - 1e-12) - 1e-12 * outer);

  std::vector<Eigen::Vector3d> outermost;
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    if ((mesh.Point(p) - center).squaredNorm() >= least * least && isUsed(p))
    {
      outermost.emplace_back(mesh.Point(p));
    }
  }
  return SmallestEnclosingSphere(Eigen::Map<const Eigen::Matrix3Xd>(
    outermost.front().data(), 3, static_cast<Eigen::Index>(outermost.size())));
}

} // namespace ridges
