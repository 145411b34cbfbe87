// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MeshCounts_h
#define MeshCounts_h

#include "Ranks.h"

#include "vtkPolyData.h"

#include <array>
#include <map>
#include <set>
#include <utility>

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

/// The same of a mesh that comes piece by piece, but for points by FitStatus and zones. Points and
/// edges along seams are known by their places.
class PieceCounts
{
public:
  void Add(vtkPolyData* piece);
  MeshCounts Counts() const;

private:
  using Place = std::array<double, 3>;

  long long InnerPoints = 0;
  long long Triangles = 0;
  long long NonManifoldEdges = 0;
  std::set<Place> OpenPoints;                       ///< Those of open edges, or of no triangle.
  std::map<std::pair<Place, Place>, int> OpenEdges; ///< How many pieces each is open in.
};

} // namespace program

#endif
