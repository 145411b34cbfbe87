// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// A mesh with what averages over one-rings need.

#ifndef RIDGES_TESTING_MESH_WITH_RINGS_H
#define RIDGES_TESTING_MESH_WITH_RINGS_H

#include "Fixtures/TestFields.h"
#include "Salience/OneRings.h"
#include "Salience/RingGraph.h"

#include <numeric>
#include <vector>

namespace ridges
{
namespace testing
{

struct MeshWithRings
{
  explicit MeshWithRings(const Mesh& mesh)
    : surface(mesh)
    , ordered(RingsOf(surface.Triangles()))
    , rings(surface.Triangles(), ordered)
  {
    rings.Build(0, surface.Triangles().NumberOfPoints());
  }

  const TriangleMesh& Triangles() const { return this->surface.Triangles(); }

  // Of all points in their order, with normals and, if wanted, factors.
  RingGraph Graph(bool hasFactors) const
  {
    std::vector<Id> points(this->Triangles().NumberOfPoints());
    std::iota(points.begin(), points.end(), Id{ 0 });
    RingGraph graph(this->rings, points);
    graph.SetNormals(this->rings, points, TriangleMesh::InOneRange);
    if (hasFactors)
    {
      graph.SetFactors(TriangleMesh::InOneRange);
    }
    return graph;
  }

  MeshedSurface surface;
  OrderedRings ordered;
  OneRings rings;
};

// A flat square of right triangles around the origin, edges of length 1.
inline Mesh Grid(int n)
{
  return GraphPatch([](double, double) { return 0.0; }, 0.5 * n, n);
}

// A flat square around the origin whose triangles grow with x: edges are 0.5 to 2 long.
inline Mesh GradedGrid(int n)
{
  Mesh mesh = Grid(n);
  for (std::size_t i = 0; i < mesh.points.size(); i += 3)
  {
    mesh.points[i] += 0.375 / n * (mesh.points[i] * mesh.points[i] - 0.25 * n * n) * 2.0;
  }
  return mesh;
}

} // namespace testing
} // namespace ridges

#endif
