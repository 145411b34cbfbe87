// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// Meshes with their adjacency, and Monge coefficients at their points: fitted, exact or random.

#ifndef RIDGES_TESTING_TEST_FIELDS_H
#define RIDGES_TESTING_TEST_FIELDS_H

#include "AnalyticSurface.h"
#include "Mesh/TriangleMesh.h"
#include "Monge/MongeField.h"
#include "TestMeshes.h"

#include "Formula/ExampleSurface.h"
#include "Mesh/OrderedRings.h"
#include "Mesh/RingNeighborhood.h"
#include "Monge/MongeForm.h"

#include <cstdint>
#include <vector>

namespace ridges
{
namespace testing
{

std::vector<Triangle> TrianglesOf(const Mesh& mesh);

// A mesh that owns its points. Not copied or moved, as the adjacency looks at the points.
class MeshedSurface
{
public:
  explicit MeshedSurface(const Mesh& mesh);
  explicit MeshedSurface(const PointsAndTriangles& mesh);
  MeshedSurface(const MeshedSurface&) = delete;
  MeshedSurface& operator=(const MeshedSurface&) = delete;

  const TriangleMesh& Triangles() const { return this->Triangles_; }

private:
  std::vector<double> Points_;
  TriangleMesh Triangles_;
};

// The rings of all points.
OrderedRings RingsOf(const TriangleMesh& mesh);

// Monge coefficients at the points of a mesh.
struct FieldArrays
{
  explicit FieldArrays(Id numberOfPoints);
  void Set(Id p, const MongeForm& form);
  void Turn(Id p); // Turns the frame by half a turn: other signs of d1, d2 and b.
  MongeField View() const;

  std::vector<double> k1, k2, d1, d2, b, c, P1, P2;
};

// Fits of degree 4 to at least this many points, as the filter for jet fitting makes them.
FieldArrays FitField(const TriangleMesh& mesh, int minimumNumberOfPoints = 18);
// The exact forms, for points that lie on the surface.
FieldArrays ExactField(const TriangleMesh& mesh, const AnalyticSurface& surface);
// Random frames and coefficients, with no regard to the mesh. b is exactly zero at one point in
// `zeroEvery`, with either sign of zero, or nowhere if that is 0.
FieldArrays RandomField(const TriangleMesh& mesh, std::uint64_t seed, int zeroEvery = 0);

MongeForm ToMongeForm(const ExactMonge& exact);
// The offsets of neighbours from a vertex, as the fit wants them.
Eigen::Matrix3Xd OffsetsAround(const TriangleMesh& mesh, Id vertex, RingNeighborhood& neighborhood,
  const NeighborhoodRule& rule);

// Uniform in [-1, 1), and in the ball.
template <typename Generator>
double Symmetric(Generator& generator)
{
  return 2.0 * Uniform(generator) - 1.0;
}
template <typename Generator>
Eigen::Vector3d InBall(Generator& generator)
{
  Eigen::Vector3d v;
  do
  {
    v[0] = Symmetric(generator);
    v[1] = Symmetric(generator);
    v[2] = Symmetric(generator);
  } while (v.squaredNorm() > 1.0 || v.squaredNorm() < 1e-6);
  return v;
}

} // namespace testing
} // namespace ridges

#endif
