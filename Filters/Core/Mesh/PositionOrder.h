// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_PositionOrder_h
#define ridges_PositionOrder_h

#include "Mesh/TriangleMesh.h"

namespace ridges
{

/// By x, then y, then z: an order that the numbering has no part in.
bool ComesBefore(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// The same of two points of a mesh, and of those at one place by what lies around them. Neither
/// comes before the other if nothing distinguishes them.
bool PointComesBefore(const TriangleMesh& mesh, Id p, Id q);

/// The same of two triangles, by their centroids, then by their corners.
bool ComesBefore(const TriangleMesh& mesh, Id a, Id b);

/// Sorts groups of triangles, each by that of them which comes first.
void SortByPosition(const TriangleMesh& mesh, std::vector<std::vector<Id>>& groups);

/// The normal of a triangle, as long as twice its area: the same to the last digit whatever corner
/// the triangle starts at.
Eigen::Vector3d AreaNormalInOrder(const TriangleMesh& mesh, Id triangle);

/// The ends of an edge, that first which comes first in this order: what is computed from one end
/// to the other does not depend on the numbering then.
struct OrderedEdge
{
  OrderedEdge(const TriangleMesh& mesh, Id edge);

  Id p;
  Id q;
  bool swaps; ///< Whether p is the larger point id.
};

/// A side of a triangle and the triangle across it.
struct NeighborAcross
{
  Id edge;
  Id triangle;
};

/// The up to three neighbours of a triangle, by their centroids.
class NeighborsByPosition
{
public:
  NeighborsByPosition(const TriangleMesh& mesh, Id triangle);

  const NeighborAcross* begin() const { return this->Neighbors_.data(); }
  const NeighborAcross* end() const { return this->Neighbors_.data() + this->Size_; }

private:
  std::array<NeighborAcross, 3> Neighbors_;
  int Size_ = 0;
};

} // namespace ridges

#endif
