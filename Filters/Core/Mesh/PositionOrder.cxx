// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/PositionOrder.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace ridges
{

bool ComesBefore(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

bool ComesBefore(const TriangleMesh& mesh, Id a, Id b)
{
  return ComesBefore(mesh.Centroid(a), mesh.Centroid(b));
}

Eigen::Vector3d AreaNormalInOrder(const TriangleMesh& mesh, Id triangle)
{
  Triangle c = mesh.Corners(triangle);
  const auto precedes = [&mesh](Id p, Id q) { return ComesBefore(mesh.Point(p), mesh.Point(q)); };
  std::rotate(c.begin(), std::min_element(c.begin(), c.end(), precedes), c.end());
  const Eigen::Vector3d along = mesh.Point(c[1]) - mesh.Point(c[0]);
  return along.cross(mesh.Point(c[2]) - mesh.Point(c[0]));
}

OrderedEdge::OrderedEdge(const TriangleMesh& mesh, Id edge)
  : p(mesh.EdgeAt(edge).v0)
  , q(mesh.EdgeAt(edge).v1)
  , swaps(ComesBefore(mesh.Point(q), mesh.Point(p)))
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
