// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/PositionOrder.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <utility>

namespace ridges
{

bool ComesBefore(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

bool PointComesBefore(const TriangleMesh& mesh, Id p, Id q)
{
  const auto x = mesh.Point(p);
  const auto y = mesh.Point(q);
  for (int i = 0; i < 3; ++i)
  {
    if (x[i] != y[i])
    {
      return x[i] < y[i];
    }
  }
  return p != q && mesh.RankAtPlace(p) < mesh.RankAtPlace(q);
}

namespace
{

bool ComesBefore(const TriangleMesh& mesh, const Triangle& a, const Triangle& b)
{
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
    [&mesh](Id p, Id q) { return PointComesBefore(mesh, p, q); });
}

/// In their order around the triangle, from the first.
Triangle CornersInOrder(const TriangleMesh& mesh, Id triangle)
{
  const Triangle& c = mesh.Corners(triangle);
  const double x[] = { mesh.Point(c[0])[0], mesh.Point(c[1])[0], mesh.Point(c[2])[0] };
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    if (x[i] < x[j] && x[i] < x[k])
    {
      return { c[i], c[j], c[k] };
    }
  }
  Triangle first = c;
  Triangle turned = first;
  for (int turn = 1; turn < 3; ++turn)
  {
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    first = ComesBefore(mesh, turned, first) ? turned : first;
  }
  return first;
}

} // namespace

bool ComesBefore(const TriangleMesh& mesh, Id a, Id b)
{
  const Eigen::Vector3d x = mesh.Centroid(a);
  const Eigen::Vector3d y = mesh.Centroid(b);
  if (x != y || a == b)
  {
    return ComesBefore(x, y);
  }
  return ComesBefore(mesh, CornersInOrder(mesh, a), CornersInOrder(mesh, b));
}

void SortByPosition(const TriangleMesh& mesh, std::vector<std::vector<Id>>& groups)
{
  const auto precedes = [&mesh](Id a, Id b) { return ComesBefore(mesh, a, b); };
  std::vector<std::pair<Id, std::size_t>> firsts;
  for (std::size_t i = 0; i < groups.size(); ++i)
  {
    firsts.emplace_back(*std::min_element(groups[i].begin(), groups[i].end(), precedes), i);
  }
  std::sort(firsts.begin(), firsts.end(),
    [&precedes](const auto& a, const auto& b) { return precedes(a.first, b.first); });
  std::vector<std::vector<Id>> sorted;
  sorted.reserve(firsts.size());
  for (const auto& first : firsts)
  {
    sorted.push_back(std::move(groups[first.second]));
  }
  groups = std::move(sorted);
}

Eigen::Vector3d AreaNormalInOrder(const TriangleMesh& mesh, Id triangle)
{
  const Triangle c = CornersInOrder(mesh, triangle);
  const Eigen::Vector3d first = mesh.Point(c[0]);
  return (mesh.Point(c[1]) - first).cross(mesh.Point(c[2]) - first);
}

OrderedEdge::OrderedEdge(const TriangleMesh& mesh, Id edge)
  : p(mesh.EdgeAt(edge).v0)
  , q(mesh.EdgeAt(edge).v1)
  , swaps(PointComesBefore(mesh, q, p))
{
  if (this->swaps)
  {
    std::swap(this->p, this->q);
  }
}

NeighborsByPosition::NeighborsByPosition(const TriangleMesh& mesh, Id triangle)
{
  for (int side = 0; side < 3; ++side)
  {
    const Id neighbor = mesh.Neighbor(triangle, side);
    if (neighbor >= 0)
    {
      this->Neighbors_[this->Size_++] = { mesh.EdgeOf(triangle, side), neighbor };
    }
  }
  std::sort(this->Neighbors_.begin(), this->Neighbors_.begin() + this->Size_,
    [&mesh](const NeighborAcross& a, const NeighborAcross& b)
    { return ComesBefore(mesh, a.triangle, b.triangle); });
}

} // namespace ridges
