// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Closed surfaces of several kinds, each a family of which a seed draws one. All but the ellipsoid
// are generic: without any symmetry.

#ifndef RIDGES_TESTING_CLOSED_SURFACES_H
#define RIDGES_TESTING_CLOSED_SURFACES_H

#include "AnalyticSurface.h"

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace ridges
{
namespace testing
{

struct ClosedSurface
{
  std::string name;
  AnalyticSurface surface;
  Eigen::Vector3d halfSize; // of a box around the origin that it lies in
  int eulerCharacteristic;  // for the seed of GenericClosedSurfaces(): others may close a hole
};

// x^2 + y^2 + z^2 = 1 + a cubic and quartic polynomial: nearly round, with many umbilics.
ClosedSurface PerturbedSphere(std::uint64_t seed);
// A torus with three bulges, which have umbilics of both signs.
ClosedSurface BulgedTorus(std::uint64_t seed);
// Genus 2: two bent tori grown together, with three bulges.
ClosedSurface BulgedDoubleTorus(std::uint64_t seed);
// Star-shaped about the origin: the radius is a polynomial of the direction.
ClosedSurface Blob(std::uint64_t seed);
// A level of a sum of five Gaussians.
ClosedSurface Metaballs(std::uint64_t seed);

// By name: "ellipsoid", "blend", "sphere", "torus", "double torus", "blob", "metaballs", the last
// five with the seed of GenericClosedSurfaces(), or with another if ":seed" follows. Throws
// std::invalid_argument for any other name.
ClosedSurface ClosedSurfaceByName(const std::string& name);

// One of each of the five families, with seeds chosen so that the umbilics lie well apart from each
// other and from the borders between their types, and that finer and finer meshes show the same
// ridges.
std::vector<ClosedSurface> GenericClosedSurfaces();

} // namespace testing
} // namespace ridges

#endif
