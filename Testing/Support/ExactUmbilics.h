// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The umbilics of an analytic surface, found on the surface itself and not on a mesh.

#ifndef RIDGES_TESTING_EXACT_UMBILICS_H
#define RIDGES_TESTING_EXACT_UMBILICS_H

#include "AnalyticSurface.h"
#include "TestMeshes.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace ridges
{
namespace testing
{

enum class UmbilicKind
{
  Lemon,   // index +1/2, one line of curvature of each colour ends there
  Monstar, // index +1/2, three do
  Star     // index -1/2
};

// The cubic form b0 x^3 + 3 b1 x^2 y + 3 b2 x y^2 + b3 y^3 in any orthonormal frame decides it all.
// The three margins are free of units and do not depend on the frame: each divides an invariant of
// degree n of the form by the n-th power of its norm, and is 0 on the border between two types.
struct ExactUmbilic
{
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double curvature = 0.0;
  std::array<double, 4> b{};
  double index = 0.0; // turns of d1 on a small circle around it
  int ridgeCount = 1; // of each colour
  UmbilicKind kind = UmbilicKind::Lemon;
  double indexMargin = 0.0; // S = (b0 - b2) b2 - b1 (b1 - b3), of the sign of the index
  double ridgeMargin = 0.0; // the discriminant: positive where three ridges of each colour meet
  double lineMargin = 0.0;  // that of the directions of curvature lines: negative at a lemon
};

// Sets the ridge count, the kind and the margins of an umbilic whose form and index are known.
void ClassifyByForm(ExactUmbilic& umbilic);

// All umbilics where the mesh, inscribed in the surface, is fine enough to tell them apart, sorted
// by their coordinates. Newton's method starts wherever a corner's exact Monge form predicts an
// umbilic within a few edges, at minima of k1 - k2, and at all triangles around which the exact
// directions turn. Throws std::runtime_error if an index is not +1/2 or -1/2.
std::vector<ExactUmbilic> FindUmbilics(const AnalyticSurface& surface, const Mesh& mesh);

// Newton's method for k1 = k2 from a point of the surface. Whether it has converged to an umbilic.
bool ConvergeToUmbilic(const AnalyticSurface& surface, Eigen::Vector3d& point);

// Turns of d1 along the circle of a radius around a point of the surface, counter-clockwise.
double IndexOnCircle(const AnalyticSurface& surface, const Eigen::Vector3d& center, double radius);

double IndexSum(const std::vector<ExactUmbilic>& umbilics);
double ClosestDistance(const std::vector<ExactUmbilic>& umbilics);

} // namespace testing
} // namespace ridges

#endif
