// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// The indices of triangles sum to the Euler characteristic whatever the mesh and the directions:
// integers, no tolerance.

#include "Fixtures/TriangleSets.h"

#include "Monge/AcuteRule.h"
#include "Monge/TamePoint.h"
#include "Umbilics/DirectionIndex.h"
#include "Umbilics/IndexCharge.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>

namespace
{

using namespace ridges;
using namespace ridges::testing;
using Eigen::Vector3d;

struct ClosedCase
{
  std::string name;
  Mesh mesh;
};

// Spheres, tori and a surface of genus 2, even, distorted, with points of any valence, tiny.
std::vector<ClosedCase> ClosedMeshes()
{
  const AnalyticSurface doubleTorus = MakeDoubleTorus();
  return { { "icosahedron", Icosphere(1) }, { "sphere", Icosphere(8) },
    { "noisy sphere", AddNormalNoise(Icosphere(8), 0.2, 1) },
    { "sphere of any valence", FlipEdges(Icosphere(8), 2, 3) },
    { "torus", TorusMesh(2.0, 0.7, 21, 11) }, { "coarse torus", TorusMesh(2.0, 1.5, 5, 3) },
    { "torus of any valence", FlipEdges(TorusMesh(2.0, 0.7, 21, 11), 3, 3) },
    { "noisy torus", AddNormalNoise(TorusMesh(2.0, 0.7, 21, 11), 0.2, 4) },
    { "genus 2", ClosedMesh(doubleTorus, DoubleTorusHalfSize(), 45) } };
}

int SumOfHalfTurns(const TriangleMesh& mesh, const DirectionIndex& index)
{
  int sum = 0;
  // Small, so that fans are forgotten and looked at again.
  DirectionFans::Memory memory(16);
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const int halfTurns = index.IsUsable(t) ? index.HalfTurns(t, memory) : 0;
    EXPECT_TRUE(!index.IsUsable(t) || halfTurns == index.HalfTurns(t));
    sum += halfTurns;
  }
  return sum;
}

std::vector<std::uint8_t> TamePoints(const TriangleMesh& mesh, const MongeField& field)
{
  std::vector<std::uint8_t> isTame(mesh.NumberOfPoints(), 0);
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    isTame[p] = IsTame(mesh, field, p) ? 1 : 0;
  }
  return isTame;
}

// Directions in the tangent planes of the mesh, without any order.
FieldArrays RandomTangents(const TriangleMesh& mesh, std::uint64_t seed)
{
  std::mt19937_64 generator(seed);
  FieldArrays field(mesh.NumberOfPoints());
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    MongeForm form;
    form.n = mesh.PointNormal(p).normalized();
    form.d1 = form.n.cross(InBall(generator)).normalized();
    form.d2 = form.n.cross(form.d1);
    field.Set(p, form);
  }
  return field;
}

// Whatever the cheap test passes over has no index.
void CheckMayTurn(const TriangleMesh& mesh, const MongeField& field, int& passed)
{
  const DirectionIndex index(mesh, field, nullptr);
  const std::vector<std::uint8_t> isTame = TamePoints(mesh, field);
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    if (!index.MayTurn(t, isTame))
    {
      ++passed;
      ASSERT_EQ(index.HalfTurns(t), 0) << "triangle " << t;
    }
  }
}

// d1 turns `index` times around a place in the plane, each frame with a random sign.
FieldArrays TurningField(const TriangleMesh& mesh, double index, const Vector3d& center)
{
  std::mt19937_64 generator(5);
  FieldArrays field(mesh.NumberOfPoints());
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    const Vector3d offset = mesh.Point(p) - center;
    const double angle = index * std::atan2(offset[1], offset[0]) + 0.4;
    MongeForm form;
    form.n = Vector3d::UnitZ();
    form.d1 = Vector3d(std::cos(angle), std::sin(angle), 0.0);
    form.d2 = form.n.cross(form.d1);
    field.Set(p, form);
    if (Uniform(generator) < 0.5)
    {
      field.Turn(p);
    }
  }
  return field;
}

} // namespace

//------------------------------------------------------------------------------
TEST(DirectionIndex, SumsToTheEulerCharacteristicForAnyDirections)
{
  for (const ClosedCase& item : ClosedMeshes())
  {
    SCOPED_TRACE(item.name);
    const MeshedSurface surface(item.mesh);
    const TriangleMesh& mesh = surface.Triangles();
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
    {
      for (FieldArrays field : { RandomField(mesh, seed), RandomTangents(mesh, seed) })
      {
        const int before = SumOfHalfTurns(mesh, { mesh, field.View(), nullptr });
        EXPECT_EQ(before, 2 * mesh.EulerCharacteristic());
        std::mt19937_64 generator(seed);
        for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
        {
          if (Uniform(generator) < 0.5)
          {
            field.Turn(p);
          }
        }
        const int after = SumOfHalfTurns(mesh, { mesh, field.View(), nullptr });
        EXPECT_EQ(after, 2 * mesh.EulerCharacteristic());
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(DirectionIndex, SumsToTheEulerCharacteristicWithPointsMissing)
{
  for (const ClosedCase& item : ClosedMeshes())
  {
    SCOPED_TRACE(item.name);
    const MeshedSurface surface(item.mesh);
    const TriangleMesh& mesh = surface.Triangles();
    for (const double share : { 0.02, 0.2, 0.6, 1.0 })
    {
      const FieldArrays field = RandomTangents(mesh, 4);
      std::mt19937_64 generator(6);
      std::vector<std::uint8_t> usable(mesh.NumberOfPoints());
      for (std::uint8_t& flag : usable)
      {
        flag = Uniform(generator) < share ? 0 : 1;
      }
      const DirectionIndex index(mesh, field.View(), usable.data());
      const std::vector<IndexCharge> missing = ChargesOfUnusable(mesh, index);
      EXPECT_EQ(SumOfHalfTurns(mesh, index) + SumOf(missing), 2 * mesh.EulerCharacteristic())
        << share;
      for (const IndexCharge& charge : missing)
      {
        EXPECT_FALSE(index.IsUsable(charge.triangle));
        EXPECT_NE(charge.halfTurns, 0);
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(DirectionIndex, ParityIsThatOfTheAcuteRule)
{
  std::vector<Mesh> meshes = { CylinderPatch(1.0, 2.0, 1.0, 13, 9),
    AddNormalNoise(GraphPatch([](double x, double y) { return x * y; }, 1.0, 12, 0.2), 0.1, 1) };
  for (const ClosedCase& item : ClosedMeshes())
  {
    meshes.push_back(item.mesh);
  }
  for (const Mesh& input : meshes)
  {
    const MeshedSurface surface(input);
    const TriangleMesh& mesh = surface.Triangles();
    const FieldArrays field = RandomTangents(mesh, 7);
    const DirectionIndex index(mesh, field.View(), nullptr);
    for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
    {
      ASSERT_EQ(index.HalfTurns(t) % 2 == 0, IsRegular(mesh, field.View(), t)) << "triangle " << t;
    }
  }
}

//------------------------------------------------------------------------------
TEST(DirectionIndex, CheapTestMissesNothing)
{
  for (const ClosedCase& item : ClosedMeshes())
  {
    SCOPED_TRACE(item.name);
    const MeshedSurface surface(item.mesh);
    const TriangleMesh& mesh = surface.Triangles();
    int passed = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
    {
      const FieldArrays random = RandomField(mesh, seed);
      CheckMayTurn(mesh, random.View(), passed);
      const FieldArrays tangent = RandomTangents(mesh, seed);
      CheckMayTurn(mesh, tangent.View(), passed);
    }
    EXPECT_TRUE(passed > 0 || mesh.NumberOfTriangles() < 1000);
  }
  const MeshedSurface surface(EllipsoidMesh(20, 1.4, 1.0, 0.6));
  const FieldArrays exact = ExactField(surface.Triangles(), MakeEllipsoid(1.4, 1.0, 0.6));
  int passed = 0;
  CheckMayTurn(surface.Triangles(), exact.View(), passed);
  EXPECT_GT(passed, surface.Triangles().NumberOfTriangles() * 9 / 10); // Or it would spare nothing.
}

//------------------------------------------------------------------------------
TEST(DirectionIndex, OfAFieldThatTurnsInThePlane)
{
  const MeshedSurface surface(GraphPatch([](double, double) { return 0.0; }, 1.0, 12, 0.2, 8));
  const TriangleMesh& mesh = surface.Triangles();
  for (const Id triangle : { 100, 143, 200 })
  {
    for (const int halfTurns : { 1, -1 })
    {
      const FieldArrays field = TurningField(mesh, 0.5 * halfTurns, mesh.Centroid(triangle));
      const DirectionIndex index(mesh, field.View(), nullptr);
      std::vector<Id> all;
      for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
      {
        ASSERT_EQ(index.HalfTurns(t), t == triangle ? halfTurns : 0) << "triangle " << t;
        all.push_back(t);
      }
      EXPECT_EQ(index.HalfTurns(all), halfTurns);

      // Nothing changes where the umbilic's own directions are missing: they are asked around.
      std::vector<std::uint8_t> usable(mesh.NumberOfPoints(), 1);
      for (const Id p : mesh.Corners(triangle))
      {
        usable[p] = 0;
      }
      const DirectionIndex without(mesh, field.View(), usable.data());
      const auto charges = ChargesOfUnusable(mesh, without);
      ASSERT_EQ(charges.size(), 1u);
      EXPECT_EQ(charges[0].halfTurns, halfTurns);
    }
  }
}

//------------------------------------------------------------------------------
TEST(DirectionIndex, OfTheEllipsoidIsThatOfItsUmbilics)
{
  const MeshedSurface surface(EllipsoidMesh(24, 1.4, 1.0, 0.6));
  const TriangleMesh& mesh = surface.Triangles();
  const FieldArrays field = ExactField(mesh, MakeEllipsoid(1.4, 1.0, 0.6));
  const DirectionIndex index(mesh, field.View(), nullptr);
  int umbilics = 0;
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const int halfTurns = index.HalfTurns(t);
    EXPECT_TRUE(halfTurns == 0 || halfTurns == 1);
    umbilics += halfTurns;
  }
  EXPECT_EQ(umbilics, 4);
}
