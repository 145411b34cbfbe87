// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Meshes of closed surfaces with even triangles but no regularity, as good real meshes are.

#ifndef RIDGES_TESTING_EVEN_MESH_H
#define RIDGES_TESTING_EVEN_MESH_H

#include "TestMeshes.h"

#include <Eigen/Core>

namespace ridges
{
namespace testing
{

// ClosedMesh with about this number of points (to some percent), its points spread evenly over the
// surface and its edges flipped to Delaunay's rule. Throws std::runtime_error if these are too few
// for a manifold.
Mesh EvenMesh(const AnalyticSurface& surface, const Eigen::Vector3d& halfSize, int points);

// Edges whose opposite angles add up to more than pi are replaced by the other diagonal of their
// two triangles, until there is none, unless that would fold the surface or double an edge.
Mesh FlipToDelaunay(const Mesh& mesh);

} // namespace testing
} // namespace ridges

#endif
