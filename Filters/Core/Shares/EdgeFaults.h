// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_EdgeFaults_h
#define ridges_EdgeFaults_h

#include "Mesh/TriangleMesh.h"

#include <functional>

namespace ridges
{

/// Edges of a mesh that is not a manifold, or not consistently oriented.
struct EdgeFaults
{
  Id nonManifold = 0;  ///< With more than two triangles.
  Id inconsistent = 0; ///< Whose two triangles run through them in the same direction.
};

/// How many edges from p have exactly two triangles. Nothing but the triangles around p is looked
/// at.
Id SharedEdgesAt(const TriangleMesh& mesh, Id p);

/// Of the edges from p to others that are counted. Nothing but the triangles around p is looked at.
EdgeFaults EdgeFaultsAt(const TriangleMesh& mesh, Id p, const std::function<bool(Id)>& isCounted);

} // namespace ridges

#endif
