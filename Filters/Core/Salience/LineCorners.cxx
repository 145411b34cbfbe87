// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Salience/LineCorners.h"

#include "Mesh/PositionOrder.h"

#include <Eigen/Dense>

#include <algorithm>
#include <iterator>
#include <utility>

namespace ridges
{
namespace
{

constexpr Id None = -1;

/// What the squared sine of the angle between two ends exceeds where they have a point to meet in.
constexpr double LeastSquaredSine = 0.03;

/// How far behind an end its corner may be, and how far two ends may miss each other, in reaches.
constexpr double MostBehind = 0.1;
constexpr double LargestMiss = 0.4;

/// The point of the mesh that is nearest to a place, on the way downhill from an edge.
Id NearestPoint(const TriangleMesh& mesh, Id edge, const Eigen::Vector3d& place)
{
  const auto isNearer = [&mesh, &place](Id a, Id b)
  {
    const double ofA = (mesh.Point(a) - place).squaredNorm();
    const double ofB = (mesh.Point(b) - place).squaredNorm();
    return ofA < ofB || (ofA == ofB && ComesBefore(mesh.Point(a), mesh.Point(b)));
  };
  const OrderedEdge ends(mesh, edge);
  Id at = isNearer(ends.q, ends.p) ? ends.q : ends.p;
  for (Id before = None; before != at;)
  {
    before = at;
    for (const Id t : mesh.TrianglesAround(before))
    {
      for (const Id q : mesh.Corners(t))
      {
        at = isNearer(q, at) ? q : at;
      }
    }
  }
  return at;
}

/// One end of a line, seen from there.
class End
{
public:
  End(const LineOfRidge& line, bool isLast)
    : Line_(line)
    , IsLast_(isLast)
  {
  }

  const RidgeVertex& Vertex(std::size_t i = 0) const
  {
    return this->Line_.ridge->vertices[this->Index(i)];
  }
  const Fold& FoldHere() const { return (*this->Line_.folds)[this->Index(0)]; }

  /// Whether the line folds by the angle within a distance of its end. Finds where that points to.
  bool IsStrong(const CornerRule& rule)
  {
    double distance = 0.0;
    double angle = 0.0;
    Eigen::Vector3d inside = this->Position();
    for (std::size_t i = 0; i < this->Line_.line->vertices.size() && distance < 0.5 * rule.reach;
         ++i)
    {
      const Eigen::Vector3d here = this->Vertex(i).point.position;
      distance += (here - inside).norm();
      inside = here;
      angle = std::max(angle, (*this->Line_.folds)[this->Index(i)].angle);
    }
    this->Direction_ = (this->Position() - inside).normalized();
    return angle >= rule.angle && distance > 0.0;
  }

  Eigen::Vector3d Position() const { return this->Vertex().point.position; }
  const Eigen::Vector3d& Direction() const { return this->Direction_; }

  /// Whether a place is one that the line could go on to.
  bool CanReach(const Eigen::Vector3d& place, double reach) const
  {
    const Eigen::Vector3d way = place - this->Position();
    return way.squaredNorm() <= reach * reach && way.dot(this->Direction_) > -MostBehind * reach;
  }

  void Meet(const RidgeVertex& corner) const
  {
    SalientLine& line = *this->Line_.line;
    (this->IsLast_ ? line.endCorner : line.startCorner) = corner;
    line.mass += this->FoldHere().angle * (corner.point.position - this->Position()).norm();
  }

private:
  Id Index(std::size_t i) const
  {
    const std::vector<Id>& vertices = this->Line_.line->vertices;
    return this->IsLast_ ? vertices[vertices.size() - 1 - i] : vertices[i];
  }

  LineOfRidge Line_;
  bool IsLast_;
  Eigen::Vector3d Direction_ = Eigen::Vector3d::Zero();
};

/// Whether two ends, gone on straight, come close to each other within the reach.
bool AreMeeting(const End& a, const End& b, double reach)
{
  const Eigen::Vector3d between = b.Position() - a.Position();
  const double cosine = a.Direction().dot(b.Direction());
  const double square = 1.0 - cosine * cosine;
  if (between.squaredNorm() > 4.0 * reach * reach || square < LeastSquaredSine)
  {
    return false;
  }
  const double alongA = between.dot(a.Direction());
  const double alongB = between.dot(b.Direction());
  const Eigen::Vector3d ofA = a.Position() + (alongA - cosine * alongB) / square * a.Direction();
  const Eigen::Vector3d ofB = b.Position() + (cosine * alongA - alongB) / square * b.Direction();
  return (ofA - ofB).norm() <= LargestMiss * reach && a.CanReach(ofA, reach) &&
    b.CanReach(ofB, reach);
}

/// The place that has the least sum of squared distances from the ends, gone on straight. Two that
/// are not quite parallel may meet far off; their middle has a say as well.
Eigen::Vector3d MeetingPlace(const std::vector<End>& ends)
{
  constexpr double sayOfMiddle = 0.02;
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const End& end : ends)
  {
    const Eigen::Matrix3d across = (1.0 + sayOfMiddle) * Eigen::Matrix3d::Identity() -
      end.Direction() * end.Direction().transpose();
    matrix += across;
    right += across * end.Position();
  }
  return matrix.ldlt().solve(right);
}

/// The corner as a point of that edge whose other end comes first.
RidgeVertex VertexAt(const TriangleMesh& mesh, const MongeField& field, Color color, Id corner)
{
  Id best = None;
  Id bestOther = None;
  for (const Id t : mesh.TrianglesAround(corner))
  {
    for (int i = 0; i < 3; ++i)
    {
      const Id e = mesh.EdgeOf(t, i);
      const Edge& edge = mesh.EdgeAt(e);
      const Id other = edge.v0 == corner ? edge.v1 : edge.v0;
      if ((edge.v0 == corner || edge.v1 == corner) &&
        (best == None || ComesBefore(mesh.Point(other), mesh.Point(bestOther))))
      {
        best = e;
        bestOther = other;
      }
    }
  }
  RidgeVertex vertex;
  vertex.edge = best;
  vertex.point =
    RidgePointAt(mesh, field, color, best, OrderedEdge(mesh, best).p == corner ? 0.0 : 1.0);
  return vertex;
}

/// Ends that meet each other, directly or by way of others; two or more.
std::vector<std::vector<std::size_t>> GroupsOf(const std::vector<End>& ends, double reach)
{
  std::vector<std::vector<std::size_t>> groups;
  std::vector<bool> isGrouped(ends.size(), false);
  for (std::size_t first = 0; first < ends.size(); ++first)
  {
    if (isGrouped[first])
    {
      continue;
    }
    std::vector<std::size_t> group{ first };
    isGrouped[first] = true;
    for (std::size_t i = 0; i < group.size(); ++i)
    {
      for (std::size_t other = 0; other < ends.size(); ++other)
      {
        if (!isGrouped[other] && AreMeeting(ends[group[i]], ends[other], reach))
        {
          isGrouped[other] = true;
          group.push_back(other);
        }
      }
    }
    if (group.size() > 1)
    {
      groups.push_back(std::move(group));
    }
  }
  return groups;
}

} // namespace

void MeetAtCorners(const TriangleMesh& mesh, const MongeField& field, const CornerRule& rule,
  const std::vector<LineOfRidge>& lines)
{
  std::vector<End> ends;
  for (const LineOfRidge& line : lines)
  {
    for (const bool isLast : { false, true })
    {
      End end(line, isLast);
      if (!line.line->closed && end.Vertex().edge != RidgeVertex::None && end.IsStrong(rule))
      {
        ends.push_back(end);
      }
    }
  }
  for (const std::vector<std::size_t>& group : GroupsOf(ends, rule.reach))
  {
    std::vector<End> meeting;
    std::transform(group.begin(), group.end(), std::back_inserter(meeting),
      [&ends](std::size_t i) { return ends[i]; });
    const Eigen::Vector3d place = MeetingPlace(meeting);
    const Id corner = NearestPoint(mesh, meeting.front().Vertex().edge, place);
    const Eigen::Vector3d at = mesh.Point(corner);
    const bool isOnSurface = (at - place).norm() <= LargestMiss * rule.reach;
    for (const End& end : meeting)
    {
      if (isOnSurface && end.CanReach(at, rule.reach))
      {
        end.Meet(VertexAt(mesh, field, end.Vertex().point.color, corner));
      }
    }
  }
}

} // namespace ridges
