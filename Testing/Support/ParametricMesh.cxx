// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ParametricMesh.h"

#include "EvenMesh.h"

#include <Eigen/Geometry>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

namespace ridges
{
namespace testing
{

using Eigen::Vector3d;

namespace
{

const double Pi = std::acos(-1.0);

//------------------------------------------------------------------------------
Vector3d Cyclide(double u, double v)
{
  const double a = 2.0;
  const double b = 1.9;
  const double d = 1.0;
  const double c = std::sqrt(a * a - b * b);
  const double divisor = a - c * std::cos(u) * std::cos(v);
  return Vector3d(d * (c - a * std::cos(u) * std::cos(v)) + b * b * std::cos(u),
           b * std::sin(u) * (a - d * std::cos(v)), b * std::sin(v) * (c * std::cos(u) - d)) /
    divisor;
}

} // namespace

//------------------------------------------------------------------------------
Mesh ParametricMesh(const std::function<Vector3d(double u, double v)>& surface,
  const ParameterGrid& grid, std::uint64_t seed)
{
  std::mt19937_64 generator(seed);
  const int columns = grid.nu + (grid.isClosedInU ? 0 : 1);
  const int rows = grid.nv + (grid.isClosedInV ? 0 : 1);
  Mesh mesh;
  for (int i = 0; i < columns; ++i)
  {
    for (int j = 0; j < rows; ++j)
    {
      // Points of the border stay on it.
      const bool movesInU = grid.isClosedInU || (i > 0 && i < grid.nu);
      const bool movesInV = grid.isClosedInV || (j > 0 && j < grid.nv);
      const double shiftU = grid.jitter * (2.0 * Uniform(generator) - 1.0);
      const double shiftV = grid.jitter * (2.0 * Uniform(generator) - 1.0);
      const double u = (i + (movesInU ? shiftU : 0.0)) / grid.nu;
      const double v = (j + (movesInV ? shiftV : 0.0)) / grid.nv;
      mesh.AddPoint(surface(
        grid.uFrom + u * (grid.uTo - grid.uFrom), grid.vFrom + v * (grid.vTo - grid.vFrom)));
    }
  }
  for (int i = 0; i < grid.nu; ++i)
  {
    for (int j = 0; j < grid.nv; ++j)
    {
      const auto at = [=](int k, int l) { return ((i + k) % columns) * rows + (j + l) % rows; };
      if ((i + j) % 2 == 0)
      {
        mesh.AddTriangle(at(0, 0), at(1, 0), at(1, 1));
        mesh.AddTriangle(at(0, 0), at(1, 1), at(0, 1));
      }
      else
      {
        mesh.AddTriangle(at(0, 0), at(1, 0), at(0, 1));
        mesh.AddTriangle(at(1, 0), at(1, 1), at(0, 1));
      }
    }
  }
  return mesh;
}

//------------------------------------------------------------------------------
std::vector<NamedMesh> SurfacesWithoutRidges()
{
  const Eigen::Matrix3d tilt = GenericRotation();
  const auto plane = [](double u, double v) { return Vector3d(u, v, 0.0); };
  const auto tilted = [tilt](double u, double v) -> Vector3d { return tilt * Vector3d(u, v, 0.0); };
  const auto cylinder = [](double u, double v) { return Vector3d(std::cos(u), std::sin(u), v); };
  const auto cone = [](double u, double v)
  { return Vector3d(v * std::cos(u), v * std::sin(u), 1.2 * v); };
  const auto torus = [](double u, double v)
  {
    const double distance = 2.0 + 0.8 * std::cos(v);
    return Vector3d(distance * std::cos(u), distance * std::sin(u), 0.8 * std::sin(v));
  };
  std::vector<NamedMesh> surfaces = { { "icosphere", Icosphere(10) },
    { "irregular sphere", EvenMesh(MakeSphere(1.0), Vector3d(1.1, 1.1, 1.1), 1000) } };
  for (const double jitter : { 0.0, 0.3 })
  {
    const std::string kind = jitter > 0.0 ? "irregular " : "";
    const ParameterGrid square{ -1.0, 1.0, -1.0, 1.0, 24, 24, false, false, jitter };
    surfaces.push_back({ kind + "plane", ParametricMesh(plane, square) });
    surfaces.push_back({ kind + "tilted plane", ParametricMesh(tilted, square) });
    surfaces.push_back({ kind + "cylinder",
      ParametricMesh(cylinder, { 0.0, 2.0 * Pi, 0.0, 2.0, 60, 19, true, false, jitter }) });
    surfaces.push_back({ kind + "cone",
      ParametricMesh(cone, { 0.0, 2.0 * Pi, 0.5, 1.5, 60, 19, true, false, jitter }) });
    surfaces.push_back({ kind + "torus",
      ParametricMesh(torus, { 0.0, 2.0 * Pi, 0.0, 2.0 * Pi, 60, 30, true, true, jitter }) });
    surfaces.push_back({ kind + "cyclide",
      ParametricMesh(Cyclide, { 0.0, 2.0 * Pi, 0.0, 2.0 * Pi, 80, 40, true, true, jitter }) });
  }
  return surfaces;
}

//------------------------------------------------------------------------------
Mesh RoundToSingle(const Mesh& mesh)
{
  Mesh rounded = mesh;
  for (double& x : rounded.points)
  {
    x = static_cast<double>(static_cast<float>(x));
  }
  return rounded;
}

//------------------------------------------------------------------------------
Mesh RoundToDigits(const Mesh& mesh, int digits)
{
  Mesh rounded = mesh;
  for (double& x : rounded.points)
  {
    char text[64];
    std::snprintf(text, sizeof(text), "%.*g", digits, x);
    x = std::strtod(text, nullptr);
  }
  return rounded;
}

} // namespace testing
} // namespace ridges
