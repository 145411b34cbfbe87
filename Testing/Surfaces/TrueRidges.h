// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The ridges of an analytic surface as polylines whose vertices lie on the exact ridges.

#ifndef RIDGES_TESTING_TRUE_RIDGES_H
#define RIDGES_TESTING_TRUE_RIDGES_H

#include "ClosedSurfaces.h"
#include "ExactUmbilics.h"
#include "TestMeshes.h"

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

namespace ridges
{
namespace testing
{

// A whole ridge of one colour: a loop, which repeats its first point at its end, or a curve between
// two umbilics.
struct TrueRidge
{
  bool maximum = true;
  bool closed = false;
  std::array<int, 2> umbilics{ -1, -1 }; // at its ends, -1 for a loop or where it is not known
  std::vector<Eigen::Vector3d> points;
  std::vector<double> P; // exact, of the ridge's colour; at an umbilic that of the next point
};

// By the types 1 to 4 of ridges; turning points by linear interpolation of P.
std::array<double, 5> LengthsByType(const std::vector<TrueRidge>& ridges);

// The parts of a ridge between its turning points. A loop without any is one.
int NumberOfArcs(const TrueRidge& ridge);

// All ridges, by marching the triangles of a fine mesh with exact Monge forms at its points, each
// crossing then moved onto the exact ridge. Right if the mesh tells neighbouring ridges apart.
std::vector<TrueRidge> FindRidges(
  const AnalyticSurface& surface, const Mesh& fineMesh, const std::vector<ExactUmbilic>& umbilics);

// What speaks against the result of FindRidges, a line each: an umbilic that not as many ridges
// meet as its cubic form says, a ridge with a loose end. None on a mesh that is fine enough.
std::vector<std::string> DoubtsAbout(
  const std::vector<TrueRidge>& ridges, const std::vector<ExactUmbilic>& umbilics);

// Each triangle cut in four, the new points on the surface.
Mesh Subdivide(const Mesh& mesh, const AnalyticSurface& surface);

} // namespace testing
} // namespace ridges

#endif
