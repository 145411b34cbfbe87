// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fixtures/TriangleSets.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace ridges
{
namespace testing
{

namespace
{

std::vector<bool> FlagsOf(const TriangleMesh& mesh, const std::vector<Id>& triangles)
{
  std::vector<bool> isInSet(mesh.NumberOfTriangles(), false);
  for (const Id t : triangles)
  {
    isInSet[t] = true;
  }
  return isInSet;
}

//------------------------------------------------------------------------------
// Flips the edge between triangles t and u, which run through it in opposite senses, if that makes
// no edge twice.
void FlipEdge(
  Mesh& mesh, std::set<std::pair<Id, Id>>& edges, std::size_t t, int side, std::size_t u)
{
  const Id p = mesh.triangles[3 * t + side];
  const Id q = mesh.triangles[3 * t + (side + 1) % 3];
  const Id a = mesh.triangles[3 * t + (side + 2) % 3];
  Id b = -1;
  bool shared = false;
  for (int i = 0; i < 3; ++i)
  {
    shared = shared || (mesh.triangles[3 * u + i] == q && mesh.triangles[3 * u + (i + 1) % 3] == p);
    const Id corner = mesh.triangles[3 * u + i];
    b = corner != p && corner != q ? corner : b;
  }
  if (!shared || a == b || edges.count(std::minmax(a, b)))
  {
    return;
  }
  edges.erase(std::minmax(p, q));
  edges.insert(std::minmax(a, b));
  const std::array<Id, 6> flipped = { a, p, b, b, q, a };
  std::copy_n(flipped.begin(), 3, &mesh.triangles[3 * t]);
  std::copy_n(flipped.begin() + 3, 3, &mesh.triangles[3 * u]);
}

} // namespace

//------------------------------------------------------------------------------
std::vector<Id> ComponentOf(const TriangleMesh& mesh, Id first, const std::vector<bool>& isInSet)
{
  std::vector<bool> isReached(mesh.NumberOfTriangles(), false);
  std::vector<Id> reached{ first };
  isReached[first] = true;
  for (std::size_t i = 0; i < reached.size(); ++i)
  {
    for (int side = 0; side < 3; ++side)
    {
      const Id next = mesh.Neighbor(reached[i], side);
      if (next >= 0 && isInSet[next] && !isReached[next])
      {
        isReached[next] = true;
        reached.push_back(next);
      }
    }
  }
  return reached;
}

//------------------------------------------------------------------------------
bool IsConnected(const TriangleMesh& mesh, const std::vector<Id>& triangles)
{
  return ComponentOf(mesh, triangles.front(), FlagsOf(mesh, triangles)).size() == triangles.size();
}

//------------------------------------------------------------------------------
int EulerCharacteristicOf(const TriangleMesh& mesh, const std::vector<Id>& triangles)
{
  const std::vector<bool> isInSet = FlagsOf(mesh, triangles);
  std::set<Id> edges;
  int fans = 0;
  std::set<std::pair<Id, Id>> counted; // Triangle and point.
  for (const Id t : triangles)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      edges.insert(mesh.EdgeOf(t, corner));
      const Id p = mesh.Corners(t)[corner];
      if (counted.count({ t, p }))
      {
        continue;
      }
      // All of the fan around p that hangs together with t.
      std::vector<bool> isInFan(mesh.NumberOfTriangles(), false);
      for (const Id s : mesh.TrianglesAround(p))
      {
        isInFan[s] = isInSet[s];
      }
      for (const Id s : ComponentOf(mesh, t, isInFan))
      {
        counted.insert({ s, p });
      }
      ++fans;
    }
  }
  return fans - static_cast<int>(edges.size()) + static_cast<int>(triangles.size());
}

//------------------------------------------------------------------------------
std::vector<Id> ContourEdges(const TriangleMesh& mesh, const std::vector<Id>& triangles)
{
  const std::vector<bool> isInSet = FlagsOf(mesh, triangles);
  std::vector<Id> edges;
  for (const Id t : triangles)
  {
    for (int side = 0; side < 3; ++side)
    {
      const Id neighbor = mesh.Neighbor(t, side);
      if (neighbor < 0 || !isInSet[neighbor])
      {
        edges.push_back(mesh.EdgeOf(t, side));
      }
    }
  }
  return edges;
}

//------------------------------------------------------------------------------
std::vector<Id> RandomRegion(
  const TriangleMesh& mesh, std::mt19937_64& generator, std::size_t count)
{
  const auto below = [&generator](std::size_t n)
  { return static_cast<std::size_t>(Uniform(generator) * static_cast<double>(n)); };
  std::vector<Id> region{ static_cast<Id>(below(mesh.NumberOfTriangles())) };
  std::set<Id> taken(region.begin(), region.end());
  for (std::size_t tries = 0; region.size() < count && tries < 20 * count; ++tries)
  {
    const Id next = mesh.Neighbor(region[below(region.size())], static_cast<int>(below(3)));
    if (next >= 0 && taken.insert(next).second)
    {
      region.push_back(next);
    }
  }
  return region;
}

//------------------------------------------------------------------------------
Mesh FlipEdges(const Mesh& mesh, std::uint64_t seed, int rounds)
{
  std::mt19937_64 generator(seed);
  Mesh result = mesh;
  for (int round = 0; round < rounds; ++round)
  {
    const MeshedSurface surface(result);
    const TriangleMesh& triangles = surface.Triangles();
    std::set<std::pair<Id, Id>> edges;
    for (Id e = 0; e < triangles.NumberOfEdges(); ++e)
    {
      edges.insert({ triangles.EdgeAt(e).v0, triangles.EdgeAt(e).v1 });
    }
    std::vector<bool> isChanged(triangles.NumberOfTriangles(), false);
    for (Id t = 0; t < triangles.NumberOfTriangles(); ++t)
    {
      const int side = static_cast<int>(3.0 * Uniform(generator));
      const Id u = triangles.Neighbor(t, side);
      if (u >= 0 && !isChanged[t] && !isChanged[u])
      {
        FlipEdge(result, edges, t, side, u);
        isChanged[t] = isChanged[u] = true;
      }
    }
  }
  return result;
}

//------------------------------------------------------------------------------
Renumbered::Renumbered(const Mesh& mesh, std::uint64_t seed)
  : surface(Permute(mesh, seed, &this->oldPoint))
  , newTriangle(mesh.TriangleCount())
{
  const auto sorted = [](Triangle corners)
  {
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  std::map<Triangle, Id> found;
  const TriangleMesh& triangles = this->surface.Triangles();
  for (Id t = 0; t < triangles.NumberOfTriangles(); ++t)
  {
    const Triangle& c = triangles.Corners(t);
    found[sorted({ this->oldPoint[c[0]], this->oldPoint[c[1]], this->oldPoint[c[2]] })] = t;
  }
  for (std::size_t t = 0; t < mesh.TriangleCount(); ++t)
  {
    this->newTriangle[t] = found.at(
      sorted({ mesh.triangles[3 * t], mesh.triangles[3 * t + 1], mesh.triangles[3 * t + 2] }));
  }
}

} // namespace testing
} // namespace ridges
