// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ridges/Patch/PatchPaths.h"

#include "Mesh/PositionOrder.h"
#include "Monge/FieldOrder.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <utility>

namespace ridges
{

PatchPaths::PatchPaths(
  const TriangleMesh& mesh, const MongeField& field, const PatchContour& contour)
  : Mesh_(mesh)
  , Field_(field)
  , Contour_(contour)
  , Depth_(contour.Sides().size(), 0)
{
}

std::vector<std::vector<EdgeCrossing>> PatchPaths::ToPoint(const std::vector<std::size_t>& sides,
  const std::vector<Eigen::Vector3d>& points, Id target, const Eigen::Vector3d& position)
{
  std::vector<std::vector<EdgeCrossing>> paths(sides.size());
  bool straight = true;
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    straight = straight && this->Straight(sides[i], points[i], target, position, paths[i]);
  }
  if (!straight)
  {
    paths = this->OverFewest(sides, target);
  }
  if (target >= 0 && !sides.empty())
  {
    this->TakeCorners(target, position);
  }
  for (const auto& path : paths)
  {
    for (const EdgeCrossing& crossing : path)
    {
      auto inserted = this->Taken_.insert({ crossing.edge, { 1.0, 0.0 } });
      auto& range = inserted.first->second;
      range.least = std::min(range.least, crossing.parameter);
      range.greatest = std::max(range.greatest, crossing.parameter);
    }
  }
  return paths;
}

// A path around a corner of the target has to pass between the corner and the point: nearer to the
// corner than the point is, as told by the barycentric coordinate.
void PatchPaths::TakeCorners(Id target, const Eigen::Vector3d& position)
{
  const Triangle& corners = this->Mesh_.Corners(target);
  const Eigen::Vector3d normal = AreaNormalInOrder(this->Mesh_, target);
  const double square = normal.squaredNorm();
  for (int i = 0; i < 3; ++i)
  {
    const Eigen::Vector3d p = this->Mesh_.Point(corners[(i + 1) % 3]);
    const Eigen::Vector3d q = this->Mesh_.Point(corners[(i + 2) % 3]);
    const double weight = square > 0.0 ? normal.dot((q - p).cross(position - p)) / square : 0.0;
    const double room = std::min(1.0, std::max(0.0, 1.0 - weight));
    for (const int side : { i, (i + 2) % 3 })
    {
      const Id edge = this->Mesh_.EdgeOf(target, side);
      const bool fromFirst = EndsInOrder(this->Mesh_, this->Field_, edge).p == corners[i];
      Range& range = this->Taken_.insert({ edge, { 1.0, 0.0 } }).first->second;
      range.least = fromFirst ? std::min(range.least, room) : range.least;
      range.greatest = fromFirst ? range.greatest : std::max(range.greatest, 1.0 - room);
    }
  }
}

bool PatchPaths::Straight(std::size_t side, const Eigen::Vector3d& from, Id target,
  const Eigen::Vector3d& position, std::vector<EdgeCrossing>& path) const
{
  // Which side of the line through both, seen along the normal of the target.
  const Eigen::Vector3d normal = AreaNormalInOrder(this->Mesh_, target);
  const Eigen::Vector3d across = normal.cross(position - from);
  const auto offset = [this, &across, &from](Id p)
  { return across.dot(this->Mesh_.Point(p) - from); };
  // On the way it comes nearer all the time: on a fold it might come from the other side.
  const Eigen::Vector3d along = across.cross(normal);
  double passed = 0.0;
  const double whole = along.dot(position - from);

  // The crossing stays off the corners, so that the paths along the contour find room there.
  constexpr double margin = 1e-3;
  Id triangle = this->Contour_.Sides()[side].triangle;
  Id edge = this->Contour_.Sides()[side].edge;
  path.clear();
  for (std::size_t steps = 0; triangle != target; ++steps)
  {
    const Edge& entry = this->Mesh_.EdgeAt(edge);
    const Triangle& corners = this->Mesh_.Corners(triangle);
    const int apex = corners[0] != entry.v0 && corners[0] != entry.v1
      ? 0
      : (corners[1] != entry.v0 && corners[1] != entry.v1 ? 1 : 2);
    const double atApex = offset(corners[apex]);
    const bool leavesAfter = (offset(corners[(apex + 1) % 3]) > 0.0) != (atApex > 0.0);
    const bool leavesBefore = (offset(corners[(apex + 2) % 3]) > 0.0) != (atApex > 0.0);
    if (leavesAfter == leavesBefore || steps > this->Depth_.size() + 100)
    {
      return false;
    }
    edge = this->Mesh_.EdgeOf(triangle, leavesAfter ? apex : (apex + 2) % 3);
    const OrderedEdge exit = EndsInOrder(this->Mesh_, this->Field_, edge);
    const double at0 = offset(exit.p);
    const double at1 = offset(exit.q);
    const double parameter = std::min(1.0 - margin, std::max(margin, at0 / (at0 - at1)));
    const Eigen::Vector3d point =
      (1.0 - parameter) * this->Mesh_.Point(exit.p) + parameter * this->Mesh_.Point(exit.q);
    const double reached = along.dot(point - from);
    if (reached < passed || reached > whole)
    {
      return false;
    }
    passed = reached;
    path.push_back({ edge, parameter });
    triangle = this->Contour_.Across(triangle, edge);
    if (triangle < 0)
    {
      return false;
    }
  }
  return true;
}

// The ways from triangle to triangle are those of a tree around the target; where several run over
// one edge they keep the order in which they come in, so that they do not cross.
std::vector<std::vector<EdgeCrossing>> PatchPaths::OverFewest(
  const std::vector<std::size_t>& sides, Id target) const
{
  struct Node
  {
    Id edge;                                       ///< Towards the target.
    std::array<std::vector<std::size_t>, 3> paths; ///< By the side through which they come in.
  };
  std::vector<Id> reached{ target };
  std::unordered_map<Id, Node> nodes;
  nodes[target].edge = -1;
  for (std::size_t i = 0; i < reached.size(); ++i)
  {
    for (const NeighborAcross& next : NeighborsByPosition(this->Mesh_, reached[i]))
    {
      if (this->Contour_.Across(reached[i], next.edge) >= 0 && nodes.count(next.triangle) == 0)
      {
        nodes[next.triangle].edge = next.edge;
        reached.push_back(next.triangle);
      }
    }
  }
  const auto sideOf = [this](Id triangle, Id edge)
  {
    int side = 0;
    while (this->Mesh_.EdgeOf(triangle, side) != edge)
    {
      ++side;
    }
    return side;
  };

  std::vector<std::vector<EdgeCrossing>> paths(sides.size());
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    const PatchContour::Side& start = this->Contour_.Sides()[sides[i]];
    nodes[start.triangle].paths[sideOf(start.triangle, start.edge)].push_back(i);
  }
  // The farthest first: all that comes in is known when a triangle's turn has come.
  for (std::size_t r = reached.size(); r-- > 1;)
  {
    const Id triangle = reached[r];
    Node& node = nodes[triangle];
    const int side = sideOf(triangle, node.edge);
    // Counter-clockwise from the end of the side: first what comes through the next one.
    std::vector<std::size_t> leaving = std::move(node.paths[(side + 1) % 3]);
    const auto& last = node.paths[(side + 2) % 3];
    leaving.insert(leaving.end(), last.begin(), last.end());
    const bool forward =
      EndsInOrder(this->Mesh_, this->Field_, node.edge).p == this->Mesh_.Corners(triangle)[side];
    for (std::size_t k = 0; k < leaving.size(); ++k)
    {
      const double fromEnd =
        (static_cast<double>(k) + 1.0) / (static_cast<double>(leaving.size()) + 1.0);
      paths[leaving[k]].push_back({ node.edge, forward ? 1.0 - fromEnd : fromEnd });
    }
    const Id next = this->Contour_.Across(triangle, node.edge);
    nodes[next].paths[sideOf(next, node.edge)] = std::move(leaving);
  }
  return paths;
}

std::vector<EdgeCrossing> PatchPaths::AlongContour(std::size_t first, std::size_t last)
{
  const auto& sides = this->Contour_.Sides();
  const auto next = [&sides](std::size_t i) { return (i + 1) % sides.size(); };
  int depth = 0;
  for (std::size_t i = first; i != last; i = next(i))
  {
    depth = std::max(depth, this->Depth_[i] + 1);
  }
  std::vector<EdgeCrossing> path;
  for (std::size_t i = first; i != last; i = next(i))
  {
    this->Depth_[i] = depth;
    for (const Id edge : sides[i].spokes)
    {
      // At most half of what is free: there may be as many paths around the other end.
      const bool fromFirst = EndsInOrder(this->Mesh_, this->Field_, edge).p == sides[i].end;
      const auto taken = this->Taken_.find(edge);
      const double room = taken == this->Taken_.end()
        ? 0.5
        : std::min(0.5, fromFirst ? taken->second.least : 1.0 - taken->second.greatest);
      const double fraction = room * depth / (depth + 1.0);
      path.push_back({ edge, fromFirst ? fraction : 1.0 - fraction });
    }
  }
  return path;
}

} // namespace ridges
