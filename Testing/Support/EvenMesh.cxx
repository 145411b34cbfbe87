// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EvenMesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace ridges
{
namespace testing
{

using Eigen::Vector3d;
using Id = std::int32_t;
using Edge = std::pair<Id, Id>;

namespace
{

const double Pi = 3.14159265358979323846;

//------------------------------------------------------------------------------
Edge Sorted(Id i, Id j)
{
  return { std::min(i, j), std::max(i, j) };
}

//------------------------------------------------------------------------------
// The angle at apex over the edge from i to j.
double Angle(const Mesh& mesh, Id apex, Id i, Id j)
{
  const Vector3d u = mesh.Point(i) - mesh.Point(apex);
  const Vector3d v = mesh.Point(j) - mesh.Point(apex);
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

//------------------------------------------------------------------------------
Vector3d Normal(const Mesh& mesh, Id i, Id j, Id k)
{
  return (mesh.Point(j) - mesh.Point(i)).cross(mesh.Point(k) - mesh.Point(i));
}

//------------------------------------------------------------------------------
// The sides of triangles, side s of triangle t as 3 t + s, by their edges: opposite sides are
// consecutive.
std::vector<std::pair<Edge, Id>> SidesByEdge(const Mesh& mesh)
{
  std::vector<std::pair<Edge, Id>> sides;
  sides.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    const Id next = mesh.triangles[i % 3 == 2 ? i - 2 : i + 1];
    sides.emplace_back(Sorted(mesh.triangles[i], next), static_cast<Id>(i));
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

//------------------------------------------------------------------------------
// One pass over all edges; triangles that have changed are left for the next. Returns how many
// edges were flipped.
int FlipEdges(Mesh& mesh)
{
  const std::vector<std::pair<Edge, Id>> sides = SidesByEdge(mesh);
  std::vector<bool> changed(mesh.TriangleCount(), false);
  std::set<Edge> added;
  int flips = 0;
  for (std::size_t s = 0; s + 1 < sides.size(); ++s)
  {
    if (sides[s].first != sides[s + 1].first)
    {
      continue;
    }
    const Id side0 = sides[s].second;
    const Id side1 = sides[s + 1].second;
    if (changed[side0 / 3] || changed[side1 / 3])
    {
      continue;
    }
    const Id i = mesh.triangles[side0];
    const Id j = mesh.triangles[side1];
    const Id k = mesh.triangles[3 * (side0 / 3) + (side0 + 2) % 3];
    const Id l = mesh.triangles[3 * (side1 / 3) + (side1 + 2) % 3];
    if (Angle(mesh, k, i, j) + Angle(mesh, l, i, j) <= Pi + 1e-9)
    {
      continue;
    }
    const Edge other = Sorted(k, l);
    const auto before = std::lower_bound(sides.begin(), sides.end(), std::make_pair(other, Id(0)));
    const bool doubled =
      (before != sides.end() && before->first == other) || added.count(other) > 0;
    const Vector3d normal = Normal(mesh, i, j, k) + Normal(mesh, j, i, l);
    const bool folds =
      Normal(mesh, l, k, i).dot(normal) <= 0.0 || Normal(mesh, k, l, j).dot(normal) <= 0.0;
    if (doubled || folds)
    {
      continue;
    }
    const Id first[3] = { k, i, l };
    const Id second[3] = { l, j, k };
    std::copy_n(first, 3, mesh.triangles.begin() + 3 * (side0 / 3));
    std::copy_n(second, 3, mesh.triangles.begin() + 3 * (side1 / 3));
    changed[side0 / 3] = changed[side1 / 3] = true;
    added.insert(other);
    ++flips;
  }
  return flips;
}

} // namespace

//------------------------------------------------------------------------------
Mesh FlipToDelaunay(const Mesh& mesh)
{
  Mesh result = mesh;
  for (int pass = 0; pass < 50 && FlipEdges(result) > 0; ++pass)
  {
  }
  return result;
}

//------------------------------------------------------------------------------
Mesh EvenMesh(const AnalyticSurface& surface, const Vector3d& halfSize, int points)
{
  // The number of points grows as the square of n: a coarse mesh tells the factor.
  int n = 48;
  const auto count = static_cast<double>(ClosedMesh(surface, halfSize, n).PointCount());
  n = static_cast<int>(std::lround(n * std::sqrt(points / count)));
  Mesh mesh = ClosedMesh(surface, halfSize, n);
  for (int round = 0; round < 3; ++round)
  {
    mesh = Relax(FlipToDelaunay(mesh), surface, 3);
  }
  return FlipToDelaunay(mesh);
}

} // namespace testing
} // namespace ridges
