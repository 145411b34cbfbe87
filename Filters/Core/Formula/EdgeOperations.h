// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_EdgeOperations_h
#define ridges_EdgeOperations_h

#include "Base/Monitor.h"
#include "Mesh/Triangle.h"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <vector>

namespace ridges
{

/// A mesh whose connectivity is being changed. Triangles are consistently oriented.
struct EditableMesh
{
  std::vector<Eigen::Vector3d> points;
  std::vector<Triangle> triangles;
};

/// Moves a point to the surface; false if that is not possible near to it.
using PlacePoint = std::function<bool(Eigen::Vector3d& point)>;

// Each makes one pass over all edges, in an order of their own; what lies next to a change is left
// for the next pass. Returns how many edges were changed. Edges on the border stay as they are. A
// pass that its monitor stops leaves a valid mesh, and returns 0.

/// Divides edges that are longer, the longest first.
Id SplitLongEdges(
  EditableMesh& mesh, double longest, const PlacePoint& place, const Monitor& monitor = NeverStops);

/// Contracts edges that are shorter, the shortest first, unless that would change the topology,
/// fold the surface or make an edge longer than `longest`. Points on the border stay.
Id CollapseShortEdges(EditableMesh& mesh, double shortest, double longest, const PlacePoint& place,
  const Monitor& monitor = NeverStops);

/// Replaces edges whose opposite angles add up to more than pi by the other diagonal of their two
/// triangles, unless that would fold the surface or double an edge.
Id FlipToDelaunay(EditableMesh& mesh, const Monitor& monitor = NeverStops);

/// Which points are on the border.
std::vector<std::uint8_t> FindBorderPoints(const EditableMesh& mesh);

/// The number of edges with one triangle.
Id CountBorderEdges(const EditableMesh& mesh);

} // namespace ridges

#endif
