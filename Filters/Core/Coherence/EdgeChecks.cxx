// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Coherence/EdgeChecks.h"

#include "Coherence/LostCrossings.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <set>

namespace ridges
{
namespace
{

/// What positions may differ by, in edges: more than round-off, also that of single precision.
constexpr double PositionTolerance = 1e-5;

Offender AtEdge(const TriangleMesh& mesh, Id edge)
{
  const Edge& ends = mesh.EdgeAt(edge);
  return { { ends.v0, ends.v1 }, 0.5 * (mesh.Point(ends.v0) + mesh.Point(ends.v1)) };
}

/// In a triangle, however thin: distances count, as the longest side's length allows.
bool IsInTriangle(const TriangleMesh& mesh, Id triangle, const Eigen::Vector3d& x)
{
  const Triangle& corners = mesh.Corners(triangle);
  const Eigen::Vector3d normal = mesh.AreaNormal(triangle).normalized();
  double longest = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    longest = std::max(longest, (mesh.Point(corners[i]) - mesh.Point(corners[(i + 1) % 3])).norm());
  }
  const double tolerance = PositionTolerance * longest;
  bool isIn = std::abs(normal.dot(x - mesh.Point(corners[0]))) <= tolerance;
  for (int i = 0; i < 3; ++i)
  {
    const Eigen::Vector3d from = mesh.Point(corners[i]);
    const Eigen::Vector3d inward =
      normal.cross(mesh.Point(corners[(i + 1) % 3]) - from).normalized();
    isIn = isIn && inward.dot(x - from) >= -tolerance;
  }
  return isIn;
}

bool IsOnItsEdge(const TriangleMesh& mesh, const PicturePoint& point)
{
  if (point.edge == PicturePoint::NoEdge || !(point.parameter >= 0.0 && point.parameter <= 1.0))
  {
    return false;
  }
  const Eigen::Vector3d p = mesh.Point(mesh.EdgeAt(point.edge).v0);
  const Eigen::Vector3d q = mesh.Point(mesh.EdgeAt(point.edge).v1);
  const Eigen::Vector3d expected = (1.0 - point.parameter) * p + point.parameter * q;
  return (point.position - expected).norm() <= PositionTolerance * (q - p).norm();
}

double LengthOf(const TriangleMesh& mesh, Id edge)
{
  return edge < 0 ? 0.0
                  : (mesh.Point(mesh.EdgeAt(edge).v0) - mesh.Point(mesh.EdgeAt(edge).v1)).norm();
}

/// A turning point on the segment between two points of a ridge, which may be next to each other.
bool IsBetween(const TriangleMesh& mesh, const Eigen::Vector3d& x, const PicturePoint& before,
  const PicturePoint& after)
{
  const Eigen::Vector3d along = after.position - before.position;
  const double square = along.squaredNorm();
  const double t = square > 0.0 ? along.dot(x - before.position) / square : 0.0;
  const Eigen::Vector3d nearest = before.position + std::min(1.0, std::max(0.0, t)) * along;
  return (x - nearest).norm() <=
    PositionTolerance * std::max(LengthOf(mesh, before.edge), LengthOf(mesh, after.edge));
}

/// Points of a chain that are not where they have to be.
void FindMisplaced(const RidgePicture& picture, const RidgeChain& chain, std::set<Id>& misplaced)
{
  const TriangleMesh& mesh = *picture.mesh;
  const std::size_t count = chain.points.size();
  const auto pointAt = [&picture, &chain](std::size_t i) -> const PicturePoint&
  { return picture.points[chain.points[i]]; };
  for (std::size_t i = 0; i < count; ++i)
  {
    const PicturePoint& point = pointAt(i);
    bool good = true;
    if (point.edge != PicturePoint::None)
    {
      good = IsOnItsEdge(mesh, point);
    }
    else if (point.umbilic >= 0)
    {
      const PictureUmbilic* umbilic = picture.UmbilicOf(point.umbilic);
      good =
        !umbilic || umbilic->triangle < 0 || IsInTriangle(mesh, umbilic->triangle, point.position);
    }
    else if (point.turning && (chain.closed || (i > 0 && i + 1 < count)))
    {
      // A loop has its first point at its end again.
      good = IsBetween(mesh, point.position, pointAt(i > 0 ? i - 1 : count - 2),
        pointAt(i + 1 < count ? i + 1 : 1));
    }
    if (!good)
    {
      misplaced.insert(chain.points[i]);
    }
  }
}

} // namespace

CoherenceCheck CheckRightAngles(const RidgePicture& picture, double leastCosine)
{
  CoherenceCheck check(CheckKind::RightAngles, OffenderKind::Edge);
  const TriangleMesh& mesh = *picture.mesh;
  Cosines cosines;
  cosines.expected = leastCosine;
  for (Id e = 0; e < mesh.NumberOfEdges(); ++e)
  {
    if (picture.IsOutside(e))
    {
      const Edge& edge = mesh.EdgeAt(e);
      const double cosine = std::abs(picture.field.D1(edge.v0).dot(picture.field.D1(edge.v1)));
      cosines.least = std::min(cosines.least, cosine);
      if (cosine < leastCosine)
      {
        check.offenders.push_back(AtEdge(mesh, e));
      }
    }
  }
  check.numbers = cosines;
  check.applies = mesh.NumberOfEdges() > 0;
  return check;
}

CoherenceCheck CheckSingleCrossings(
  const RidgePicture& picture, const std::vector<WholeRidge>& ridges)
{
  CoherenceCheck check(CheckKind::DoubleCrossings, OffenderKind::Edge);
  const TriangleMesh& mesh = *picture.mesh;
  std::set<Id> offenders;
  for (const Color color : { Color::Blue, Color::Red })
  {
    const std::vector<int> passages = CountPassages(picture, ridges, color);
    for (Id e = 0; e < mesh.NumberOfEdges(); ++e)
    {
      // Where more than two triangles meet, a ridge of each of them may end.
      const bool counts = mesh.EdgeAt(e).t1 != TriangleMesh::NonManifold;
      if (passages[e] > 1 && counts && picture.IsOutside(e))
      {
        offenders.insert(e);
      }
    }
  }
  for (const Id e : offenders)
  {
    check.offenders.push_back(AtEdge(mesh, e));
  }
  check.applies = !ridges.empty();
  return check;
}

CoherenceCheck CheckPointsOnEdges(
  const RidgePicture& picture, const std::vector<WholeRidge>& ridges)
{
  CoherenceCheck check(CheckKind::PointsOnEdges, OffenderKind::RidgePoint);
  std::set<Id> misplaced;
  for (const WholeRidge& ridge : ridges)
  {
    for (const RidgeChain& chain : ridge.chains)
    {
      FindMisplaced(picture, chain, misplaced);
    }
  }
  for (const Id p : misplaced)
  {
    check.offenders.push_back({ { p, -1 }, picture.points[p].position });
  }
  check.applies = !ridges.empty();
  check.numbers = picture.points.size();
  return check;
}

CoherenceCheck CheckCrossings(const RidgePicture& picture, const std::vector<WholeRidge>& ridges)
{
  CoherenceCheck check(CheckKind::Crossings, OffenderKind::Edge);
  CrossingCounts counts;
  for (const Color color : { Color::Blue, Color::Red })
  {
    const LostCrossings lost = FindLostCrossings(picture, ridges, color);
    const std::size_t i = color == Color::Blue ? 0 : 1;
    counts.lost[i] = lost.edges.size();
    counts.crossed[i] = lost.crossed;
    counts.smallLoops += lost.smallLoops;
    for (const Id e : lost.edges)
    {
      check.offenders.push_back(AtEdge(*picture.mesh, e));
    }
  }
  check.numbers = counts;
  check.applies = picture.mesh->NumberOfEdges() > 0;
  return check;
}

} // namespace ridges
