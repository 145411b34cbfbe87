// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RandomClosedMesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <random>

namespace ridges
{
namespace testing
{

using Eigen::Vector3d;

namespace
{

//------------------------------------------------------------------------------
int Pick(std::mt19937_64& generator, int from, int to)
{
  return from + static_cast<int>(Uniform(generator) * (to - from + 1));
}

//------------------------------------------------------------------------------
Mesh Base(std::mt19937_64& generator, int& characteristic)
{
  const bool sphere = Uniform(generator) < 0.6;
  characteristic += sphere ? 2 : 0;
  return sphere
    ? Icosphere(Pick(generator, 1, 5))
    : TorusMesh(2.0, 0.3 + Uniform(generator), Pick(generator, 3, 14), Pick(generator, 3, 9));
}

//------------------------------------------------------------------------------
// Puts a point into a triangle: it has three triangles, and its neighbours have more.
void Divide(Mesh& mesh, std::size_t triangle, std::mt19937_64& generator)
{
  const auto corner = [&](int i) { return mesh.triangles[3 * triangle + i]; };
  const Vector3d weights(
    0.1 + Uniform(generator), 0.1 + Uniform(generator), 0.1 + Uniform(generator));
  Vector3d point = Vector3d::Zero();
  for (int i = 0; i < 3; ++i)
  {
    point += weights[i] / weights.sum() * mesh.Point(corner(i));
  }
  const std::int32_t a = corner(0);
  const std::int32_t b = corner(1);
  const std::int32_t c = corner(2);
  const auto p = static_cast<std::int32_t>(mesh.PointCount());
  mesh.AddPoint(point);
  mesh.triangles[3 * triangle + 2] = p;
  mesh.AddTriangle(b, c, p);
  mesh.AddTriangle(c, a, p);
}

//------------------------------------------------------------------------------
bool HaveCommonNeighbor(const Mesh& mesh, std::int32_t p, std::int32_t q)
{
  std::vector<std::int32_t> near[2];
  for (std::size_t t = 0; t < mesh.TriangleCount(); ++t)
  {
    const auto* c = mesh.triangles.data() + 3 * t;
    for (int side = 0; side < 2; ++side)
    {
      if (std::find(c, c + 3, side == 0 ? p : q) != c + 3)
      {
        near[side].insert(near[side].end(), c, c + 3);
      }
    }
  }
  return std::any_of(near[0].begin(), near[0].end(),
    [&](std::int32_t r) { return std::find(near[1].begin(), near[1].end(), r) != near[1].end(); });
}

//------------------------------------------------------------------------------
// Makes one point of two that are not near each other: the surface touches itself there.
void Pinch(Mesh& mesh, std::mt19937_64& generator)
{
  const auto count = static_cast<int>(mesh.PointCount());
  const std::int32_t p = Pick(generator, 0, count - 1);
  const std::int32_t q = Pick(generator, 0, count - 1);
  if (!HaveCommonNeighbor(mesh, p, q))
  {
    std::replace(mesh.triangles.begin(), mesh.triangles.end(), q, p);
  }
}

//------------------------------------------------------------------------------
void Round(Mesh& mesh, double step)
{
  for (double& x : mesh.points)
  {
    x = step * std::round(x / step);
  }
}

} // namespace

//------------------------------------------------------------------------------
double ShareWithoutArea(const Mesh& mesh)
{
  std::size_t count = 0;
  for (std::size_t t = 0; t < mesh.TriangleCount(); ++t)
  {
    const auto corner = [&](int i) { return mesh.Point(mesh.triangles[3 * t + i]); };
    const Vector3d a = corner(1) - corner(0);
    const Vector3d b = corner(2) - corner(0);
    count += (a.normalized().cross(b.normalized())).norm() < 1e-12 ? 1 : 0;
  }
  return static_cast<double>(count) / static_cast<double>(mesh.TriangleCount());
}

//------------------------------------------------------------------------------
RandomClosedMesh MakeRandomClosedMesh(std::uint64_t seed)
{
  std::mt19937_64 generator(seed);
  RandomClosedMesh result;
  Mesh& mesh = result.mesh;
  mesh = Base(generator, result.eulerCharacteristic);
  if (Uniform(generator) < 0.3)
  {
    const Mesh other = Base(generator, result.eulerCharacteristic);
    Append(mesh, other, Vector3d(4.0, 0.0, 0.0));
  }
  for (int i = Pick(generator, 0, 60); i > 0; --i)
  {
    Divide(mesh,
      static_cast<std::size_t>(Pick(generator, 0, static_cast<int>(mesh.TriangleCount()) - 1)),
      generator);
  }
  for (int i = Uniform(generator) < 0.3 ? Pick(generator, 1, 3) : 0; i > 0; --i)
  {
    Pinch(mesh, generator);
  }

  Eigen::Matrix3d shape = GenericRotation();
  shape.row(0) *= std::pow(10.0, -2.0 * Uniform(generator));
  const double noise = Uniform(generator) < 0.5 ? 0.0 : 0.2 * Uniform(generator);
  for (std::size_t p = 0; p < mesh.PointCount(); ++p)
  {
    Vector3d shift;
    for (double& x : shift)
    {
      x = noise * (2.0 * Uniform(generator) - 1.0);
    }
    mesh.SetPoint(p, shape * (mesh.Point(p) + shift));
  }
  const double wanted = 0.5 * Uniform(generator);
  double step = 1e-3;
  for (Mesh rounded = mesh; step < 4.0; step *= 1.3)
  {
    rounded = mesh;
    Round(rounded, step);
    if (ShareWithoutArea(rounded) > wanted)
    {
      break;
    }
  }
  Round(mesh, step / 1.3);
  const double size =
    Uniform(generator) < 0.7 ? 1.0 : std::pow(10.0, 300.0 * (Uniform(generator) - 0.5));
  for (double& x : mesh.points)
  {
    x *= size;
  }
  return result;
}

} // namespace testing
} // namespace ridges
