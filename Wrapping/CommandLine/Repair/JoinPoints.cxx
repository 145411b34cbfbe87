// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/JoinPoints.h"

#include "Repair/MeshEdges.h"
#include "Repair/RemoveInvalidFaces.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace program
{
namespace
{

using Ids = std::vector<vtkIdType>;

bool IsFinite(const PolygonMesh::Point& point)
{
  return std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]);
}

/// For each point the first one at its place, among those that may be joined.
Ids FindFirsts(const PolygonMesh& mesh, const std::vector<bool>& mayJoin)
{
  Ids order;
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    if (mayJoin[i] && IsFinite(mesh.points[i]))
    {
      order.push_back(static_cast<vtkIdType>(i));
    }
  }
  std::sort(order.begin(), order.end(),
    [&mesh](vtkIdType a, vtkIdType b)
    {
      const PolygonMesh::Point& p = mesh.points[static_cast<std::size_t>(a)];
      const PolygonMesh::Point& q = mesh.points[static_cast<std::size_t>(b)];
      return p != q ? p < q : a < b;
    });
  Ids firsts(mesh.points.size());
  std::iota(firsts.begin(), firsts.end(), 0);
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    const auto before = static_cast<std::size_t>(order[i - 1]);
    const auto here = static_cast<std::size_t>(order[i]);
    if (mesh.points[here] == mesh.points[before])
    {
      firsts[here] = firsts[before];
    }
  }
  return firsts;
}

std::size_t CountJoined(const Ids& firsts)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < firsts.size(); ++i)
  {
    count += firsts[i] != static_cast<vtkIdType>(i) ? 1 : 0;
  }
  return count;
}

std::vector<bool> OnBorder(const PolygonMesh& mesh, const std::vector<FaceSide>& sides)
{
  std::vector<bool> onBorder(mesh.points.size(), false);
  ForEachEdge(sides,
    [&onBorder](auto first, auto last)
    {
      if (last - first == 1)
      {
        onBorder[static_cast<std::size_t>(first->low)] = true;
        onBorder[static_cast<std::size_t>(first->high)] = true;
      }
    });
  return onBorder;
}

/// Faces refer to the first of their points; those that are gone leave no gap in the numbers, and
/// faces that collapse are gone too.
void Replace(PolygonMesh& mesh, const Ids& firsts)
{
  Ids numbers(firsts.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < firsts.size(); ++i)
  {
    if (firsts[i] == static_cast<vtkIdType>(i))
    {
      numbers[i] = static_cast<vtkIdType>(count);
      mesh.points[count] = mesh.points[i];
      ++count;
    }
    else
    {
      numbers[i] = numbers[static_cast<std::size_t>(firsts[i])];
    }
  }
  mesh.points.resize(count);
  for (vtkIdType& corner : mesh.corners)
  {
    corner = numbers[static_cast<std::size_t>(corner)];
  }
  RemoveInvalidFaces(mesh);
}

} // namespace

std::size_t JoinPoints(PolygonMesh& mesh, Joining joining)
{
  if (joining == Joining::None)
  {
    return 0;
  }
  // Most meshes have no points to join, and need no edges then.
  Ids firsts = FindFirsts(mesh, std::vector<bool>(mesh.points.size(), true));
  std::size_t count = CountJoined(firsts);
  if (count > 0 && joining == Joining::Borders)
  {
    const std::vector<FaceSide> sides = SortedSides(mesh);
    const std::size_t nonManifold = CountEdges(sides).nonManifold;
    firsts = FindFirsts(mesh, OnBorder(mesh, sides));
    count = CountJoined(firsts);
    PolygonMesh joined = mesh;
    Replace(joined, firsts);
    const EdgeCounts after = CountEdges(SortedSides(joined));
    if (after.nonManifold > nonManifold + after.inner)
    {
      return 0;
    }
    mesh = std::move(joined);
  }
  else if (count > 0)
  {
    Replace(mesh, firsts);
  }
  return count;
}

} // namespace program
