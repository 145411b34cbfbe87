// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Grids over two parameters, and with them the surfaces all of whose points are ridge points.

#ifndef RIDGES_TESTING_PARAMETRIC_MESH_H
#define RIDGES_TESTING_PARAMETRIC_MESH_H

#include "TestMeshes.h"

#include <functional>
#include <string>
#include <vector>

namespace ridges
{
namespace testing
{

struct ParameterGrid
{
  double uFrom, uTo;
  double vFrom, vTo;
  int nu, nv; // Cells.
  bool isClosedInU, isClosedInV;
  double jitter = 0.0; // Of a cell, below 0.5: parameters are moved by at most so much at random.
};
Mesh ParametricMesh(const std::function<Eigen::Vector3d(double u, double v)>& surface,
  const ParameterGrid& grid, std::uint64_t seed = 1);

// Planes, spheres, cylinders, cones, tori and Dupin cyclides, as regular grids and irregular.
struct NamedMesh
{
  std::string name;
  Mesh mesh;
};
std::vector<NamedMesh> SurfacesWithoutRidges();

// Coordinates rounded to single precision.
Mesh RoundToSingle(const Mesh& mesh);

// Coordinates rounded to significant decimal digits, as files of text have them.
Mesh RoundToDigits(const Mesh& mesh, int digits);

} // namespace testing
} // namespace ridges

#endif
