// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MeshCounts_h
#define MeshCounts_h

#include "Ranks.h"

#include "vtkPolyData.h"

#include <array>

namespace program
{

/// What the report counts on the mesh.
struct MeshCounts
{
  long long points = 0;
  long long triangles = 0;
  long long borderEdges = 0;      ///< Of one triangle.
  long long nonManifoldEdges = 0; ///< Of more than two.

  /// Points by FitStatus: on the border, with too few neighbours, ill conditioned, without any fit.
  std::array<long long, 4> degraded{};

  /// Triangles in zones: UmbilicZone, and both of RidgeZone.
  long long umbilicZone = 0;
  std::array<long long, 2> ridgeZone{};

  bool IsClosed() const { return this->borderEdges + this->nonManifoldEdges == 0; }
};

/// Of a mesh, or of one that lies on several ranks in pieces, on the first of them. All have to
/// call this.
MeshCounts CountMesh(vtkPolyData* mesh, const Ranks& ranks);

} // namespace program

#endif
