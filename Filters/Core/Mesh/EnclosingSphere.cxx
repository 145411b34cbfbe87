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

Eigen::Vector3d PositionOf(const FarPoint& point)
{
  return Eigen::Map<const Eigen::Vector3d>(point.x.data());
}

FarPoint MakeFarPoint(double squaredDistance, const Eigen::Vector3d& x)
{
  return { squaredDistance, { x[0], x[1], x[2] } };
}

FarPoint FarthestFrom(
  const Eigen::Vector3d& center, const Eigen::Ref<const Eigen::Matrix3Xd>& points)
{
  FarPoint farthest;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
  {
    const double other = (points.col(i) - center).squaredNorm();
    if (other >= farthest.squaredDistance)
    {
      farthest = FartherOf(farthest, MakeFarPoint(other, points.col(i)));
    }
  }
  return farthest;
}

/// Of one who has all points.
SphereOfPieces OfOne()
{
  return { [](const FarPoint& own) { return own; },
    [](const std::array<double, 6>& own) { return own; } };
}

// The farthest point outside the current sphere joins the few that determine it. The radius grows
// in every step and each sphere belongs to one of finitely many sets of points, so the loop ends;
// in practice after about ten steps, each linear in the number of points. What comes first by
// position starts and decides between equals: not even round-off depends on the numbering.
Sphere Enclose(const Eigen::Ref<const Eigen::Matrix3Xd>& points, const SphereOfPieces& ofAll)
{
  FarPoint first;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
  {
    first = FartherOf(first, MakeFarPoint(0.0, points.col(i)));
  }
  first = ofAll.farthest(first);
  if (first.squaredDistance < 0.0)
  {
    return {};
  }
  Support support;
  support.Add(PositionOf(first));
  Sphere sphere{ PositionOf(first), 0.0 };
  for (;;)
  {
    const FarPoint farthest = ofAll.farthest(FarthestFrom(sphere.center, points));
    if (!(std::sqrt(farthest.squaredDistance) > sphere.radius * (1.0 + 1e-12)))
    {
      return sphere;
    }
    support.Add(PositionOf(farthest));
    const Sphere larger = SmallestSphereOfFew(support);
    if (!(larger.radius > sphere.radius))
    {
      // Round-off: the support points are almost dependent. Enclose the last one all the same.
      sphere.radius = std::sqrt(farthest.squaredDistance);
      return sphere;
    }
    sphere = larger;
  }
}

} // namespace

FarPoint FartherOf(const FarPoint& a, const FarPoint& b)
{
  const bool isB = b.squaredDistance > a.squaredDistance ||
    (b.squaredDistance == a.squaredDistance && ComesBefore(PositionOf(b), PositionOf(a)));
  return isB ? b : a;
}

Sphere SmallestEnclosingSphere(const Eigen::Ref<const Eigen::Matrix3Xd>& points)
{
  return Enclose(points, OfOne());
}

Sphere SmallestEnclosingSphere(const TriangleMesh& mesh)
{
  return SmallestEnclosingSphere(mesh, OfOne());
}

// Let c be any centre and R the distance of the farthest point. The smallest sphere, of radius r
// about c + d, has points on the far side of c: |d|^2 + r^2 <= R^2. So with a lower bound of r,
// half the distance of two points, |d| is bounded, and what lies nearer to c than r - |d| is
// inside.
Sphere SmallestEnclosingSphere(const TriangleMesh& piece, const SphereOfPieces& ofAll)
{
  Eigen::AlignedBox3d box;
  const auto isUsed = [&piece](Id p) { return piece.TrianglesAround(p).size() > 0; };
  for (Id p = 0; p < piece.NumberOfPoints(); ++p)
  {
    if (isUsed(p))
    {
      box.extend(piece.Point(p));
    }
  }
  const std::array<double, 6> ends = ofAll.leastOfEach(
    { box.min()[0], box.min()[1], box.min()[2], -box.max()[0], -box.max()[1], -box.max()[2] });
  box = Eigen::AlignedBox3d(
    Eigen::Vector3d(ends[0], ends[1], ends[2]), Eigen::Vector3d(-ends[3], -ends[4], -ends[5]));
  if (box.isEmpty())
  {
    return {};
  }
  const auto farthestFrom = [&piece, &isUsed, &ofAll](const Eigen::Vector3d& center)
  {
    FarPoint farthest = MakeFarPoint(0.0, center);
    for (Id p = 0; p < piece.NumberOfPoints(); ++p)
    {
      const double other = (piece.Point(p) - center).squaredNorm();
      if (other >= farthest.squaredDistance && isUsed(p))
      {
        farthest = FartherOf(farthest, MakeFarPoint(other, piece.Point(p)));
      }
    }
    return PositionOf(ofAll.farthest(farthest));
  };
  const Eigen::Vector3d center = box.center();
  const Eigen::Vector3d end = farthestFrom(center);
  const double outer = (end - center).norm();
  const double inner = 0.5 * (farthestFrom(end) - end).norm();
  const double shift = std::sqrt(std::max(0.0, outer * outer - inner * inner));
  const double least = std::max(0.0, (inner - shift) * (1.0 - 1e-12) - 1e-12 * outer);

  std::vector<Eigen::Vector3d> outermost;
  for (Id p = 0; p < piece.NumberOfPoints(); ++p)
  {
    if ((piece.Point(p) - center).squaredNorm() >= least * least && isUsed(p))
    {
      outermost.emplace_back(piece.Point(p));
    }
  }
  return Enclose(
    Eigen::Map<const Eigen::Matrix3Xd>(outermost.empty() ? nullptr : outermost.front().data(), 3,
      static_cast<Eigen::Index>(outermost.size())),
    ofAll);
}

} // namespace ridges
