// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Meshes for the tests: closed and open, inscribed in analytic surfaces, and what is done to them
// to test invariance and robustness. All are deterministic.

#ifndef RIDGES_TESTING_TEST_MESHES_H
#define RIDGES_TESTING_TEST_MESHES_H

#include "AnalyticSurface.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace ridges
{
namespace testing
{

struct Mesh
{
  std::vector<double> points;          // 3 per point
  std::vector<std::int32_t> triangles; // 3 per triangle, counter-clockwise seen from outside

  std::size_t PointCount() const { return this->points.size() / 3; }
  std::size_t TriangleCount() const { return this->triangles.size() / 3; }
  Eigen::Vector3d Point(std::size_t i) const
  {
    return { this->points[3 * i], this->points[3 * i + 1], this->points[3 * i + 2] };
  }
  void SetPoint(std::size_t i, const Eigen::Vector3d& point);
  void AddPoint(const Eigen::Vector3d& point);
  void AddTriangle(std::int32_t i, std::int32_t j, std::int32_t k);
};

// --- Builders

// The unit icosphere with each edge of the icosahedron cut in frequency: 10 frequency^2 + 2 points.
// Rotated, no point lies on a coordinate plane (where the ellipsoid has its ridges) in practice.
Mesh Icosphere(int frequency, bool rotated = true);
// The icosphere scaled, so the points lie on the ellipsoid.
Mesh EllipsoidMesh(int frequency, double a, double b, double c, bool rotated = true);
// The icosphere projected along rays from center, on a surface star-shaped about it.
Mesh StarShapedMesh(int frequency, const AnalyticSurface& surface, const Eigen::Vector3d& center);
// nu cells around the z axis, nv around the tube; 2 nu nv triangles.
Mesh TorusMesh(double R, double r, int nu, int nv);
// An open patch of the cylinder around z: nu cells over [0, angle], angle < 2 pi, nv over height.
Mesh CylinderPatch(double r, double angle, double height, int nu, int nv);
// The graph z = f(x, y) over [-halfSize, halfSize]^2, n by n cells. Inner points are moved at
// random in x and y by at most jitter (below 0.25) cell sizes, and diagonals are then the shorter
// ones; with no jitter the grid is regular. Upward orientation.
using HeightField = std::function<double(double, double)>;
Mesh GraphPatch(
  const HeightField& f, double halfSize, int n, double jitter = 0.0, std::uint64_t seed = 1);

// Any closed surface inside the box -halfSize to halfSize. With h = the longest half-side / n,
// edges are of about 1.4 h, and angles above about 15 degrees, which Relax improves. Throws
// std::runtime_error if n is too small for a manifold; MakeDoubleTorus() needs 45.
Mesh ClosedMesh(const AnalyticSurface& surface, const Eigen::Vector3d& halfSize, int n);

// A triangle mesh in the OFF format; without points if the file cannot be read.
Mesh ReadOff(const std::string& path);

// --- Changes

// Renumbers points and triangles and rotates the points within each triangle. newToOld, if given,
// receives for each new point its old number.
Mesh Permute(const Mesh& mesh, std::uint64_t seed, std::vector<std::int32_t>* newToOld = nullptr);
// s R p + t; orientation is reversed with det R < 0, so that it stays outward.
Mesh Transform(
  const Mesh& mesh, const Eigen::Matrix3d& R, const Eigen::Vector3d& t, double s = 1.0);
// A proper rotation without any special angle.
Eigen::Matrix3d GenericRotation();
// Reverses all triangles.
Mesh Flip(const Mesh& mesh);
// The points, moved by an offset, and triangles of another mesh behind those of the first.
void Append(Mesh& mesh, const Mesh& other, const Eigen::Vector3d& offset = Eigen::Vector3d::Zero());
// Moves points along the normals of the mesh by a Gaussian of the given standard deviation.
Mesh AddNormalNoise(const Mesh& mesh, double standardDeviation, std::uint64_t seed);
// Each iteration moves points half way to the mean of their neighbours in the tangent plane, and
// projects them back to the surface. Border points stay. Points leave sharp rims: few iterations.
Mesh Relax(const Mesh& mesh, const AnalyticSurface& surface, int iterations);

// --- Measures

struct MeshTopology
{
  int points = 0; // those used by triangles
  int edges = 0;
  int triangles = 0;
  int borderEdges = 0;
  // Each edge in one triangle, or in two with opposite directions; triangles have distinct points.
  bool oriented = true;
  int EulerCharacteristic() const { return this->points - this->edges + this->triangles; }
};
MeshTopology Topology(const Mesh& mesh);
int EulerCharacteristic(const Mesh& mesh);
double MeanEdgeLength(const Mesh& mesh);
// The smallest angle of all triangles, in radians.
double SmallestAngle(const Mesh& mesh);
// Positive if the triangles of a closed mesh are outward.
double SignedVolume(const Mesh& mesh);
// Area-weighted, unit.
std::vector<Eigen::Vector3d> PointNormals(const Mesh& mesh);

} // namespace testing
} // namespace ridges

#endif
