// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// What is done to meshes, and measured on them.

#include "TestMeshes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <utility>

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
std::vector<Id> RandomOrder(std::size_t count, std::mt19937_64& generator)
{
  std::vector<Id> order(count);
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = count; i > 1; --i)
  {
    std::swap(
      order[i - 1], order[static_cast<std::size_t>(Uniform(generator) * static_cast<double>(i))]);
  }
  return order;
}

//------------------------------------------------------------------------------
// The three edges of each triangle, in its direction.
std::vector<Edge> DirectedEdges(const Mesh& mesh)
{
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    edges.emplace_back(mesh.triangles[i], mesh.triangles[i % 3 == 2 ? i - 2 : i + 1]);
  }
  return edges;
}

} // namespace

//------------------------------------------------------------------------------
Mesh Permute(const Mesh& mesh, std::uint64_t seed, std::vector<Id>* newToOld)
{
  std::mt19937_64 generator(seed);
  const std::vector<Id> pointOrder = RandomOrder(mesh.PointCount(), generator);
  const std::vector<Id> triangleOrder = RandomOrder(mesh.TriangleCount(), generator);
  std::vector<Id> oldToNew(pointOrder.size());
  Mesh result;
  for (std::size_t i = 0; i < pointOrder.size(); ++i)
  {
    oldToNew[pointOrder[i]] = static_cast<Id>(i);
    result.AddPoint(mesh.Point(pointOrder[i]));
  }
  for (const Id triangle : triangleOrder)
  {
    const int turn = static_cast<int>(3 * Uniform(generator));
    const Id* old = &mesh.triangles[3 * static_cast<std::size_t>(triangle)];
    result.AddTriangle(
      oldToNew[old[turn]], oldToNew[old[(turn + 1) % 3]], oldToNew[old[(turn + 2) % 3]]);
  }
  if (newToOld)
  {
    *newToOld = pointOrder;
  }
  return result;
}

//------------------------------------------------------------------------------
Mesh Transform(const Mesh& mesh, const Eigen::Matrix3d& R, const Vector3d& t, double s)
{
  Mesh result = R.determinant() < 0.0 ? Flip(mesh) : mesh;
  for (std::size_t i = 0; i < mesh.PointCount(); ++i)
  {
    result.SetPoint(i, s * (R * mesh.Point(i)) + t);
  }
  return result;
}

//------------------------------------------------------------------------------
Mesh Flip(const Mesh& mesh)
{
  Mesh result = mesh;
  for (std::size_t i = 0; i < mesh.TriangleCount(); ++i)
  {
    std::swap(result.triangles[3 * i + 1], result.triangles[3 * i + 2]);
  }
  return result;
}

//------------------------------------------------------------------------------
void Append(Mesh& mesh, const Mesh& other, const Vector3d& offset)
{
  const auto first = static_cast<Id>(mesh.PointCount());
  for (std::size_t p = 0; p < other.PointCount(); ++p)
  {
    mesh.AddPoint(other.Point(p) + offset);
  }
  for (const Id p : other.triangles)
  {
    mesh.triangles.push_back(first + p);
  }
}

//------------------------------------------------------------------------------
Mesh AddNormalNoise(const Mesh& mesh, double standardDeviation, std::uint64_t seed)
{
  std::mt19937_64 generator(seed);
  const std::vector<Vector3d> normals = PointNormals(mesh);
  Mesh result = mesh;
  for (std::size_t i = 0; i < mesh.PointCount(); ++i)
  {
    // Box-Muller
    const double radius = std::sqrt(-2.0 * std::log(1.0 - Uniform(generator)));
    const double gaussian = radius * std::cos(2 * Pi * Uniform(generator));
    result.SetPoint(i, mesh.Point(i) + standardDeviation * gaussian * normals[i]);
  }
  return result;
}

//------------------------------------------------------------------------------
Mesh Relax(const Mesh& mesh, const AnalyticSurface& surface, int iterations)
{
  // Around an inner point of an oriented mesh each neighbour follows it once in a triangle; a
  // border point is the end of a directed edge whose opposite is in no triangle.
  std::vector<Edge> edges = DirectedEdges(mesh);
  std::sort(edges.begin(), edges.end());
  std::vector<bool> fixed(mesh.PointCount(), false);
  for (const Edge& edge : edges)
  {
    if (!std::binary_search(edges.begin(), edges.end(), Edge(edge.second, edge.first)))
    {
      fixed[edge.first] = fixed[edge.second] = true;
    }
  }

  Mesh result = mesh;
  for (int iteration = 0; iteration < iterations; ++iteration)
  {
    const Mesh previous = result;
    for (std::size_t e = 0; e < edges.size();)
    {
      const std::size_t i = static_cast<std::size_t>(edges[e].first);
      Vector3d sum = Vector3d::Zero();
      int count = 0;
      for (; e < edges.size() && static_cast<std::size_t>(edges[e].first) == i; ++e, ++count)
      {
        sum += previous.Point(edges[e].second);
      }
      if (!fixed[i])
      {
        const Vector3d p = previous.Point(i);
        const Vector3d n = surface.Gradient(p).normalized();
        const Vector3d move = sum / count - p;
        result.SetPoint(i, surface.Project(p + 0.5 * (move - move.dot(n) * n)));
      }
    }
  }
  return result;
}

//------------------------------------------------------------------------------
MeshTopology Topology(const Mesh& mesh)
{
  MeshTopology topology;
  topology.triangles = static_cast<int>(mesh.TriangleCount());
  std::map<Edge, std::pair<int, int>> uses; // forward and backward
  std::vector<bool> used(mesh.PointCount(), false);
  for (const Edge& edge : DirectedEdges(mesh))
  {
    const bool forward = edge.first < edge.second;
    used[edge.first] = true;
    topology.oriented = topology.oriented && edge.first != edge.second;
    std::pair<int, int>& use = uses[forward ? edge : Edge(edge.second, edge.first)];
    ++(forward ? use.first : use.second);
  }
  topology.points = static_cast<int>(std::count(used.begin(), used.end(), true));
  topology.edges = static_cast<int>(uses.size());
  for (const auto& edge : uses)
  {
    const std::pair<int, int>& use = edge.second;
    topology.oriented = topology.oriented && use.first <= 1 && use.second <= 1;
    topology.borderEdges += use.first + use.second == 1 ? 1 : 0;
  }
  return topology;
}

//------------------------------------------------------------------------------
int EulerCharacteristic(const Mesh& mesh)
{
  return Topology(mesh).EulerCharacteristic();
}

//------------------------------------------------------------------------------
double MeanEdgeLength(const Mesh& mesh)
{
  std::vector<Edge> edges = DirectedEdges(mesh);
  for (Edge& edge : edges)
  {
    edge = Edge(std::min(edge.first, edge.second), std::max(edge.first, edge.second));
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  double sum = 0.0;
  for (const Edge& edge : edges)
  {
    sum += (mesh.Point(edge.first) - mesh.Point(edge.second)).norm();
  }
  return edges.empty() ? 0.0 : sum / static_cast<double>(edges.size());
}

//------------------------------------------------------------------------------
double SmallestAngle(const Mesh& mesh)
{
  double smallest = Pi;
  for (std::size_t i = 0; i < mesh.TriangleCount(); ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      const Vector3d p = mesh.Point(mesh.triangles[3 * i + j]);
      const Vector3d u = mesh.Point(mesh.triangles[3 * i + (j + 1) % 3]) - p;
      const Vector3d v = mesh.Point(mesh.triangles[3 * i + (j + 2) % 3]) - p;
      smallest = std::min(smallest, std::atan2(u.cross(v).norm(), u.dot(v)));
    }
  }
  return smallest;
}

//------------------------------------------------------------------------------
double SignedVolume(const Mesh& mesh)
{
  double volume = 0.0;
  for (std::size_t i = 0; i < mesh.TriangleCount(); ++i)
  {
    const Id* t = &mesh.triangles[3 * i];
    volume += mesh.Point(t[0]).dot(mesh.Point(t[1]).cross(mesh.Point(t[2]))) / 6.0;
  }
  return volume;
}

//------------------------------------------------------------------------------
std::vector<Vector3d> PointNormals(const Mesh& mesh)
{
  std::vector<Vector3d> normals(mesh.PointCount(), Vector3d::Zero());
  for (std::size_t i = 0; i < mesh.TriangleCount(); ++i)
  {
    const Id* t = &mesh.triangles[3 * i];
    const Vector3d p = mesh.Point(t[0]);
    const Vector3d area = (mesh.Point(t[1]) - p).cross(mesh.Point(t[2]) - p);
    for (int j = 0; j < 3; ++j)
    {
      normals[t[j]] += area;
    }
  }
  for (Vector3d& normal : normals)
  {
    normal.normalize();
  }
  return normals;
}

} // namespace testing
} // namespace ridges
