// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Formula/EdgeOperations.h"

#include "Formula/TrianglesOfPoints.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace ridges
{
namespace
{

constexpr Id None = -1;
constexpr double Pi = 3.14159265358979323846;

/// Side s of triangle t is number 3 t + s, from its corner s to the next.
struct Side
{
  Id low;
  Id high;
  Id number;

  bool operator<(const Side& other) const
  {
    return std::tie(this->low, this->high, this->number) <
      std::tie(other.low, other.high, other.number);
  }
};

/// An edge between two triangles, from the corner of the first that its side begins at.
struct InnerEdge
{
  Id from;
  Id to;
  Id first;  ///< Triangle on its left
  Id second; ///< and on its right.
  Id left;   ///< Corners opposite to the edge.
  Id right;
  double length;
};

/// By counting those of each lower end, as there are many.
std::vector<Side> SortedSides(const EditableMesh& mesh)
{
  const auto forSides = [&mesh](const auto& visit)
  {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
      for (int s = 0; s < 3; ++s)
      {
        const Id a = mesh.triangles[t][s];
        const Id b = mesh.triangles[t][(s + 1) % 3];
        visit(Side{ std::min(a, b), std::max(a, b), static_cast<Id>(3 * t) + s });
      }
    }
  };
  std::vector<Id> end(mesh.points.size() + 1, 0); // of the sides of each point, then the beginning
  forSides([&end](const Side& side) { ++end[side.low]; });
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<Side> sides(3 * mesh.triangles.size());
  forSides([&end, &sides](const Side& side) { sides[--end[side.low]] = side; });
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    std::sort(sides.begin() + end[p], sides.begin() + end[p + 1]);
  }
  return sides;
}

/// Between two looks whether to stop, which take some hundredths of a second.
constexpr std::size_t SidesAtATime = 1 << 16;

/// Calls visit(first, count) for the sides of each edge; false if it was stopped.
template <typename Visit>
bool ForEdges(
  const std::vector<Side>& sides, const Visit& visit, const Monitor& monitor = NeverStops)
{
  std::size_t next = SidesAtATime;
  for (std::size_t i = 0; i < sides.size();)
  {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high)
    {
      ++end;
    }
    visit(&sides[i], static_cast<int>(end - i));
    i = end;
    if (i >= next)
    {
      if (!monitor(static_cast<double>(i) / static_cast<double>(sides.size())))
      {
        return false;
      }
      next += SidesAtATime;
    }
  }
  return true;
}

/// The edges for which `isWanted(edge)` holds, by growing length. None if it was stopped.
template <typename IsWanted>
std::vector<InnerEdge> InnerEdges(const EditableMesh& mesh, const std::vector<Side>& sides,
  const IsWanted& isWanted, const Monitor& monitor)
{
  std::vector<InnerEdge> edges;
  const auto visit = [&mesh, &edges, &isWanted](const Side* side, int count)
  {
    if (count != 2)
    {
      return;
    }
    const Triangle& first = mesh.triangles[side[0].number / 3];
    const Triangle& second = mesh.triangles[side[1].number / 3];
    const int s = side[0].number % 3;
    const double length = (mesh.points[side->low] - mesh.points[side->high]).norm();
    const InnerEdge edge{ first[s], first[(s + 1) % 3], side[0].number / 3, side[1].number / 3,
      first[(s + 2) % 3], second[(side[1].number % 3 + 2) % 3], length };
    if (isWanted(edge))
    {
      edges.push_back(edge);
    }
  };
  if (!ForEdges(sides, visit, monitor))
  {
    return {};
  }
  std::stable_sort(edges.begin(), edges.end(),
    [](const InnerEdge& a, const InnerEdge& b) { return a.length < b.length; });
  return edges;
}

Eigen::Vector3d NormalOf(
  const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  return (b - a).cross(c - a);
}

/// Whether two normals are less than 60 degrees apart.
bool AreAlike(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return a.dot(b) > 0.5 * a.norm() * b.norm();
}

double AngleAt(const Eigen::Vector3d& apex, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::atan2((a - apex).cross(b - apex).norm(), (a - apex).dot(b - apex));
}

/// Whether Delaunay's rule wants the other diagonal of the two triangles.
bool IsNotDelaunay(const EditableMesh& mesh, const InnerEdge& edge)
{
  constexpr double roundOff = 1e-9;
  const Eigen::Vector3d& a = mesh.points[edge.from];
  const Eigen::Vector3d& b = mesh.points[edge.to];
  return AngleAt(mesh.points[edge.left], a, b) + AngleAt(mesh.points[edge.right], a, b) >
    Pi + roundOff;
}

std::vector<std::uint8_t> BorderPoints(const EditableMesh& mesh, const std::vector<Side>& sides)
{
  std::vector<std::uint8_t> isBorder(mesh.points.size(), 0);
  ForEdges(sides,
    [&isBorder](const Side* side, int count)
    {
      if (count != 2)
      {
        isBorder[side->low] = isBorder[side->high] = 1;
      }
    });
  return isBorder;
}

/// Calls visit(edge) until it is stopped, which is looked at now and then.
template <typename Visit>
bool ForEach(const std::vector<InnerEdge>& edges, const Visit& visit, const Monitor& monitor)
{
  constexpr std::size_t atATime = 1 << 12;
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    if (i % atATime == 0 && !monitor(static_cast<double>(i) / static_cast<double>(edges.size())))
    {
      return false;
    }
    visit(edges[i]);
  }
  return true;
}

/// Contracts single edges of a mesh, of which it marks the triangles that are to go.
class Contraction
{
public:
  Contraction(
    EditableMesh& mesh, const std::vector<Side>& sides, double longest, const PlacePoint& place)
    : Mesh_(mesh)
    , Around_(static_cast<Id>(mesh.points.size()), mesh.triangles)
    , IsBorder_(BorderPoints(mesh, sides))
    , IsTouched_(mesh.points.size(), 0)
    , Longest_(longest)
    , Place_(place)
  {
  }

  bool Contract(const InnerEdge& edge)
  {
    Id kept = edge.from;
    Id lost = edge.to;
    if (this->IsBorder_[lost])
    {
      std::swap(kept, lost);
    }
    const bool isFree = !this->IsBorder_[lost] && !this->IsTouched_[kept] &&
      !this->IsTouched_[lost] && !this->IsTouched_[edge.left] && !this->IsTouched_[edge.right];
    if (!isFree || !this->KeepsTopology(edge))
    {
      return false;
    }
    Eigen::Vector3d target = this->Mesh_.points[kept];
    if (!this->IsBorder_[kept])
    {
      target = 0.5 * (target + this->Mesh_.points[lost]);
      if (!this->Place_(target))
      {
        return false;
      }
    }
    if (!this->FitsAround(kept, edge, target) || !this->FitsAround(lost, edge, target))
    {
      return false;
    }
    for (const Id point : { kept, lost })
    {
      for (const Id t : this->Around_[point])
      {
        for (const Id corner : this->Mesh_.triangles[t])
        {
          this->IsTouched_[corner] = 1;
        }
      }
    }
    for (const Id t : this->Around_[lost])
    {
      Triangle& corners = this->Mesh_.triangles[t];
      std::replace(corners.begin(), corners.end(), lost, kept);
    }
    this->Mesh_.triangles[edge.first] = { None, None, None };
    this->Mesh_.triangles[edge.second] = { None, None, None };
    this->Mesh_.points[kept] = target;
    return true;
  }

private:
  std::set<Id> NeighborsOf(Id point) const
  {
    std::set<Id> neighbors;
    for (const Id t : this->Around_[point])
    {
      neighbors.insert(this->Mesh_.triangles[t].begin(), this->Mesh_.triangles[t].end());
    }
    return neighbors;
  }

  /// The ends have no neighbours in common but the two opposite corners.
  bool KeepsTopology(const InnerEdge& edge) const
  {
    if (this->Around_[edge.left].size() < 4 || this->Around_[edge.right].size() < 4)
    {
      return false;
    }
    const std::set<Id> a = this->NeighborsOf(edge.from);
    const std::set<Id> b = this->NeighborsOf(edge.to);
    constexpr std::ptrdiff_t common = 4; // with the ends themselves
    return std::count_if(a.begin(), a.end(), [&b](Id point) { return b.count(point) > 0; }) ==
      common;
  }

  /// Whether the triangles that stay around an end would be good ones.
  bool FitsAround(Id point, const InnerEdge& edge, const Eigen::Vector3d& target) const
  {
    const auto fits = [this, point, &edge, &target](Id t)
    {
      if (t == edge.first || t == edge.second)
      {
        return true;
      }
      const Triangle& corners = this->Mesh_.triangles[t];
      std::array<Eigen::Vector3d, 3> before;
      std::array<Eigen::Vector3d, 3> after;
      bool isShort = true;
      for (int i = 0; i < 3; ++i)
      {
        before[i] = this->Mesh_.points[corners[i]];
        after[i] = corners[i] == point ? target : before[i];
        isShort = isShort && (after[i] - target).norm() < this->Longest_;
      }
      return isShort &&
        AreAlike(NormalOf(before[0], before[1], before[2]), NormalOf(after[0], after[1], after[2]));
    };
    const Span<Id> around = this->Around_[point];
    return std::all_of(around.begin(), around.end(), fits);
  }

  EditableMesh& Mesh_;
  TrianglesOfPoints Around_; ///< Of points that are not touched.
  std::vector<std::uint8_t> IsBorder_;
  std::vector<std::uint8_t> IsTouched_;
  double Longest_;
  const PlacePoint& Place_;
};

/// Removes triangles that are marked, and points without triangles.
void Compact(EditableMesh& mesh)
{
  const auto isMarked = [](const Triangle& corners) { return corners[0] == None; };
  mesh.triangles.erase(
    std::remove_if(mesh.triangles.begin(), mesh.triangles.end(), isMarked), mesh.triangles.end());
  std::vector<Id> numbers(mesh.points.size(), None);
  for (const Triangle& corners : mesh.triangles)
  {
    for (const Id corner : corners)
    {
      numbers[corner] = 0;
    }
  }
  Id next = 0;
  for (std::size_t p = 0; p < numbers.size(); ++p)
  {
    if (numbers[p] != None)
    {
      mesh.points[next] = mesh.points[p];
      numbers[p] = next++;
    }
  }
  mesh.points.resize(static_cast<std::size_t>(next));
  for (Triangle& corners : mesh.triangles)
  {
    for (Id& corner : corners)
    {
      corner = numbers[corner];
    }
  }
}

} // namespace

Id SplitLongEdges(
  EditableMesh& mesh, double longest, const PlacePoint& place, const Monitor& monitor)
{
  std::vector<InnerEdge> edges = InnerEdges(
    mesh, SortedSides(mesh), [longest](const InnerEdge& edge) { return edge.length > longest; },
    monitor);
  std::reverse(edges.begin(), edges.end());
  std::vector<std::uint8_t> isTouched(mesh.triangles.size(), 0);
  Id count = 0;
  const auto split = [&mesh, &place, &isTouched, &count](const InnerEdge& edge)
  {
    if (isTouched[edge.first] || isTouched[edge.second])
    {
      return;
    }
    Eigen::Vector3d middle = 0.5 * (mesh.points[edge.from] + mesh.points[edge.to]);
    if (!place(middle))
    {
      return;
    }
    const auto added = static_cast<Id>(mesh.points.size());
    mesh.points.push_back(middle);
    mesh.triangles[edge.first] = { edge.from, added, edge.left };
    mesh.triangles[edge.second] = { edge.to, added, edge.right };
    mesh.triangles.push_back({ added, edge.to, edge.left });
    mesh.triangles.push_back({ added, edge.from, edge.right });
    isTouched[edge.first] = isTouched[edge.second] = 1;
    ++count;
  };
  return ForEach(edges, split, monitor) ? count : 0;
}

Id CollapseShortEdges(EditableMesh& mesh, double shortest, double longest, const PlacePoint& place,
  const Monitor& monitor)
{
  const std::vector<Side> sides = SortedSides(mesh);
  const std::vector<InnerEdge> edges = InnerEdges(
    mesh, sides, [shortest](const InnerEdge& edge) { return edge.length < shortest; }, monitor);
  Contraction contraction(mesh, sides, longest, place);
  Id count = 0;
  const auto contract = [&contraction, &count](const InnerEdge& edge)
  { count += contraction.Contract(edge) ? 1 : 0; };
  const bool isDone = ForEach(edges, contract, monitor);
  Compact(mesh);
  return isDone ? count : 0;
}

Id FlipToDelaunay(EditableMesh& mesh, const Monitor& monitor)
{
  const std::vector<Side> sides = SortedSides(mesh);
  std::vector<std::uint8_t> isTouched(mesh.triangles.size(), 0);
  std::set<std::pair<Id, Id>> added;
  Id count = 0;
  const auto flip = [&mesh, &sides, &isTouched, &added, &count](const InnerEdge& edge)
  {
    if (isTouched[edge.first] || isTouched[edge.second])
    {
      return;
    }
    const Eigen::Vector3d& a = mesh.points[edge.from];
    const Eigen::Vector3d& b = mesh.points[edge.to];
    const Eigen::Vector3d& c = mesh.points[edge.left];
    const Eigen::Vector3d& d = mesh.points[edge.right];
    const Side other{ std::min(edge.left, edge.right), std::max(edge.left, edge.right), 0 };
    const auto before = std::lower_bound(sides.begin(), sides.end(), other);
    const bool isDoubled =
      (before != sides.end() && before->low == other.low && before->high == other.high) ||
      added.count({ other.low, other.high }) > 0;
    const Eigen::Vector3d normal = NormalOf(a, b, c) + NormalOf(b, a, d);
    if (isDoubled || !AreAlike(NormalOf(c, a, d), normal) || !AreAlike(NormalOf(d, b, c), normal))
    {
      return;
    }
    mesh.triangles[edge.first] = { edge.left, edge.from, edge.right };
    mesh.triangles[edge.second] = { edge.right, edge.to, edge.left };
    isTouched[edge.first] = isTouched[edge.second] = 1;
    added.insert({ other.low, other.high });
    ++count;
  };
  const std::vector<InnerEdge> edges = InnerEdges(
    mesh, sides, [&mesh](const InnerEdge& edge) { return IsNotDelaunay(mesh, edge); }, monitor);
  return ForEach(edges, flip, monitor) ? count : 0;
}

std::vector<std::uint8_t> FindBorderPoints(const EditableMesh& mesh)
{
  return BorderPoints(mesh, SortedSides(mesh));
}

Id CountBorderEdges(const EditableMesh& mesh)
{
  Id border = 0;
  ForEdges(SortedSides(mesh), [&border](const Side*, int count) { border += count == 1 ? 1 : 0; });
  return border;
}

} // namespace ridges
