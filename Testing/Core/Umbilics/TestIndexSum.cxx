// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// The indices of triangles sum to the Euler characteristic on closed meshes of any shape: with
// triangles without area, points where the surface touches itself, and very many triangles around a
// point. Integers, no tolerance.

#include "Fixtures/TestFields.h"
#include "RandomClosedMesh.h"

#include "Umbilics/DirectionIndex.h"
#include "Umbilics/IndexCharge.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{

using namespace ridges;
using namespace ridges::testing;
using Eigen::Vector3d;

// Frames with the normal of the mesh, or any where that has none; d1 is any.
FieldArrays RandomFrames(const TriangleMesh& mesh, std::uint64_t seed)
{
  std::mt19937_64 generator(seed);
  FieldArrays field(mesh.NumberOfPoints());
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    const Vector3d normal = mesh.PointNormal(p).stableNormalized();
    MongeForm form;
    form.n = normal.squaredNorm() > 0.5 ? normal : InBall(generator).normalized();
    form.d1 = form.n.cross(InBall(generator)).normalized();
    form.d2 = form.n.cross(form.d1);
    field.Set(p, form);
  }
  return field;
}

int SumOfHalfTurns(const TriangleMesh& mesh, const FieldArrays& field)
{
  const DirectionIndex index(mesh, field.View(), nullptr);
  int sum = 0;
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    sum += index.HalfTurns(t);
  }
  return sum;
}

// A closed fan of so many triangles over another one: the apexes have that valence.
Mesh DoubleCone(int count, double height)
{
  Mesh mesh;
  mesh.AddPoint(Vector3d(0.0, 0.0, height));
  mesh.AddPoint(Vector3d(0.0, 0.0, -height));
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * std::acos(-1.0) * i / count;
    mesh.AddPoint(Vector3d(std::cos(angle), std::sin(angle), 0.0));
  }
  for (int i = 0; i < count; ++i)
  {
    mesh.AddTriangle(0, 2 + i, 2 + (i + 1) % count);
    mesh.AddTriangle(1, 2 + (i + 1) % count, 2 + i);
  }
  return mesh;
}

} // namespace

//------------------------------------------------------------------------------
TEST(IndexSum, IsTheEulerCharacteristicOfAnyClosedMesh)
{
  double most = 0.0;
  int pinched = 0;
  for (std::uint64_t seed = 1; seed <= 250; ++seed)
  {
    SCOPED_TRACE(seed);
    const RandomClosedMesh random = MakeRandomClosedMesh(seed);
    const MeshedSurface surface(random.mesh);
    const TriangleMesh& mesh = surface.Triangles();
    ASSERT_EQ(mesh.EulerCharacteristic(), random.eulerCharacteristic);
    ASSERT_EQ(SumOfHalfTurns(mesh, RandomField(mesh, seed)), 2 * random.eulerCharacteristic);
    ASSERT_EQ(SumOfHalfTurns(mesh, RandomFrames(mesh, seed)), 2 * random.eulerCharacteristic);
    most = std::max(most, ShareWithoutArea(random.mesh));
    pinched += Topology(random.mesh).EulerCharacteristic() < random.eulerCharacteristic ? 1 : 0;
  }
  EXPECT_GT(most, 0.4);
  EXPECT_GT(pinched, 20);
}

//------------------------------------------------------------------------------
TEST(IndexSum, IsTwoWhereAFanIsInOnePlace)
{
  // A point and its neighbours in one place: all angles of its triangles are 0.
  Mesh mesh = Icosphere(2);
  for (std::size_t t = 0; t < mesh.TriangleCount(); ++t)
  {
    const std::int32_t* corners = mesh.triangles.data() + 3 * t;
    if (std::find(corners, corners + 3, 0) != corners + 3)
    {
      for (int i = 0; i < 3; ++i)
      {
        mesh.SetPoint(corners[i], mesh.Point(0));
      }
    }
  }
  const MeshedSurface surface(mesh);
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    EXPECT_EQ(SumOfHalfTurns(surface.Triangles(), RandomFrames(surface.Triangles(), seed)), 4);
  }
  // All of it in one place.
  for (std::size_t p = 0; p < mesh.PointCount(); ++p)
  {
    mesh.SetPoint(p, Vector3d(1.0, 2.0, 3.0));
  }
  const MeshedSurface point(mesh);
  EXPECT_EQ(SumOfHalfTurns(point.Triangles(), RandomFrames(point.Triangles(), 1)), 4);
}

//------------------------------------------------------------------------------
TEST(IndexSum, DoesNotDependOnTheSizeOfTheMesh)
{
  const Mesh sphere = Icosphere(4);
  for (const double size : { 1e-300, 1e-200, 1e-100, 1e100, 1e150 })
  {
    const MeshedSurface surface(
      Transform(sphere, Eigen::Matrix3d::Identity(), Vector3d::Zero(), size));
    EXPECT_EQ(SumOfHalfTurns(surface.Triangles(), RandomField(surface.Triangles(), 3)), 4) << size;
  }
}

//------------------------------------------------------------------------------
// Each triangle looks at all others around its corners, so that without keeping what is known of
// the points of many triangles this would take hours.
TEST(IndexSum, IsTwoOnADoubleConeOfManyTriangles)
{
  for (const double height : { 0.0, 1e-9, 0.3 })
  {
    const MeshedSurface surface(DoubleCone(20000, height));
    EXPECT_EQ(SumOfHalfTurns(surface.Triangles(), RandomFrames(surface.Triangles(), 5)), 4);
  }
}
