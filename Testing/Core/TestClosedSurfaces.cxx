// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The generic closed surfaces, their meshes, and their umbilics.

#include "ClosedSurfaces.h"
#include "EllipsoidRidges.h"
#include "EvenMesh.h"
#include "ExactUmbilics.h"
#include "SurfaceSampling.h"
#include "TestMeshes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

using namespace ridges::testing;
using Eigen::Vector3d;

//------------------------------------------------------------------------------
// Whether all triangles hang together by their points.
bool IsConnected(const Mesh& mesh)
{
  std::vector<std::size_t> parents(mesh.PointCount());
  for (std::size_t i = 0; i < parents.size(); ++i)
  {
    parents[i] = i;
  }
  const auto root = [&](std::size_t i)
  {
    while (parents[i] != i)
    {
      i = parents[i] = parents[parents[i]];
    }
    return i;
  };
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    parents[root(mesh.triangles[i])] = root(mesh.triangles[i - i % 3]);
  }
  std::set<std::size_t> roots;
  for (std::size_t i = 0; i < parents.size(); ++i)
  {
    roots.insert(root(i));
  }
  return roots.size() == 1;
}

//------------------------------------------------------------------------------
struct Expected
{
  std::string name;
  int eulerCharacteristic;
  int positive;  // umbilics of index +1/2
  int negative;  // of index -1/2
  int withThree; // where three ridges of each colour meet
  int monstars;
  double edgesApart; // closest two, in edges of the mesh of 10k points, at least
};

//------------------------------------------------------------------------------
class ClosedSurfaces : public testing::TestWithParam<Expected>
{
};

//------------------------------------------------------------------------------
void ExpectEvenMesh(const ClosedSurface& closed, const Mesh& mesh, double points)
{
  EXPECT_NEAR(static_cast<double>(mesh.PointCount()) / points, 1.0, 0.08);
  const MeshTopology topology = Topology(mesh);
  EXPECT_TRUE(topology.oriented);
  EXPECT_EQ(topology.borderEdges, 0);
  EXPECT_EQ(topology.EulerCharacteristic(), closed.eulerCharacteristic);
  EXPECT_TRUE(IsConnected(mesh));
  EXPECT_GT(SignedVolume(mesh), 0.0);
  EXPECT_GT(SmallestAngle(mesh), 20.0 / 180.0 * EIGEN_PI);
  const std::vector<Vector3d> normals = PointNormals(mesh);
  for (std::size_t i = 0; i < mesh.PointCount(); ++i)
  {
    const Vector3d gradient = closed.surface.Gradient(mesh.Point(i));
    // Round-off of positions up to 3.
    EXPECT_LT(std::abs(closed.surface.Value(mesh.Point(i))), 1e-14 * (1.0 + gradient.norm()));
    EXPECT_GT(normals[i].dot(gradient.normalized()), 0.95);
  }
}

} // namespace

//------------------------------------------------------------------------------
TEST_P(ClosedSurfaces, HaveEvenMeshesAndTheseUmbilics)
{
  const Expected& expected = this->GetParam();
  const ClosedSurface closed = ClosedSurfaceByName(expected.name);
  EXPECT_EQ(closed.eulerCharacteristic, expected.eulerCharacteristic);
  const Mesh mesh = EvenMesh(closed.surface, closed.halfSize, 10000);
  ExpectEvenMesh(closed, mesh, 10000.0);
  const std::vector<ExactUmbilic> umbilics = FindUmbilics(closed.surface, mesh);
  int positive = 0;
  int withThree = 0;
  int monstars = 0;
  for (const ExactUmbilic& umbilic : umbilics)
  {
    const ExactMonge monge = closed.surface.Monge(umbilic.position);
    const double scale = LocalLength(monge);
    EXPECT_LT((monge.k1 - monge.k2) * scale, 1e-9);
    EXPECT_LT(std::abs(closed.surface.Value(umbilic.position)), 1e-14 * (1.0 + 1.0 / scale));

    // Turns counted on a circle, and what the third order says (sections 8.2 and 3).
    EXPECT_EQ(umbilic.index, umbilic.indexMargin > 0.0 ? 0.5 : -0.5);
    EXPECT_EQ(umbilic.index < 0.0, umbilic.kind == UmbilicKind::Star);
    if (umbilic.ridgeCount == 3)
    {
      EXPECT_EQ(umbilic.index, -0.5);
    }
    positive += umbilic.index > 0.0 ? 1 : 0;
    withThree += umbilic.ridgeCount == 3 ? 1 : 0;
    monstars += umbilic.kind == UmbilicKind::Monstar ? 1 : 0;
  }
  EXPECT_EQ(IndexSum(umbilics), expected.eulerCharacteristic);
  EXPECT_EQ(positive, expected.positive);
  EXPECT_EQ(static_cast<int>(umbilics.size()) - positive, expected.negative);
  EXPECT_EQ(withThree, expected.withThree);
  EXPECT_EQ(monstars, expected.monstars);
  EXPECT_GT(ClosestDistance(umbilics), expected.edgesApart * MeanEdgeLength(mesh));

  // Another mesh starts the search elsewhere.
  const std::vector<ExactUmbilic> again =
    FindUmbilics(closed.surface, EvenMesh(closed.surface, closed.halfSize, 5000));
  ASSERT_EQ(again.size(), umbilics.size());
  for (std::size_t i = 0; i < again.size(); ++i)
  {
    EXPECT_LT((again[i].position - umbilics[i].position).norm(), 1e-9);
    EXPECT_EQ(again[i].index, umbilics[i].index);
    EXPECT_EQ(again[i].ridgeCount, umbilics[i].ridgeCount);
    EXPECT_EQ(again[i].kind, umbilics[i].kind);
  }
}

INSTANTIATE_TEST_SUITE_P(OfEachKind, ClosedSurfaces,
  testing::Values(Expected{ "blend", 2, 6, 2, 0, 0, 11.0 },
    Expected{ "sphere", 2, 8, 4, 3, 1, 7.0 }, Expected{ "torus", 0, 2, 2, 0, 0, 4.4 },
    Expected{ "double torus", -2, 7, 11, 8, 1, 5.8 }, Expected{ "blob", 2, 8, 4, 0, 1, 8.0 },
    Expected{ "metaballs", 2, 5, 1, 1, 0, 14.0 }),
  [](const testing::TestParamInfo<Expected>& surface)
  {
    std::string name = surface.param.name;
    name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
    return name;
  });

//------------------------------------------------------------------------------
// Poincare and Hopf hold for the seeds that were not chosen, too, whatever their genus.
TEST(ExactUmbilics, AddUpToTheEulerCharacteristic)
{
  for (const char* name : { "sphere:4", "torus:4", "double torus:4", "blob:4" })
  {
    const ClosedSurface closed = ClosedSurfaceByName(name);
    const Mesh mesh = EvenMesh(closed.surface, closed.halfSize, 5000);
    EXPECT_EQ(IndexSum(FindUmbilics(closed.surface, mesh)), EulerCharacteristic(mesh)) << name;
  }
}

//------------------------------------------------------------------------------
TEST(ExactUmbilics, OfTheEllipsoidAreThoseOfTheClosedForm)
{
  const std::vector<Vector3d> axes = { { 1.0, 0.8, 0.6 }, { 1.0, 0.5, 0.4 }, { 1.0, 0.9, 0.3 } };
  for (const Vector3d& semiAxes : axes)
  {
    const AnalyticSurface surface = MakeEllipsoid(semiAxes[0], semiAxes[1], semiAxes[2]);
    const Mesh mesh = EllipsoidMesh(25, semiAxes[0], semiAxes[1], semiAxes[2]);
    const std::vector<ExactUmbilic> umbilics = FindUmbilics(surface, mesh);
    ASSERT_EQ(umbilics.size(), 4u);
    for (const Vector3d& expected : EllipsoidUmbilics(semiAxes[0], semiAxes[1], semiAxes[2]))
    {
      double nearest = std::numeric_limits<double>::max();
      for (const ExactUmbilic& umbilic : umbilics)
      {
        nearest = std::min(nearest, (umbilic.position - expected).norm());
        EXPECT_EQ(umbilic.index, 0.5);
        EXPECT_EQ(umbilic.ridgeCount, 1);
        EXPECT_EQ(umbilic.kind, UmbilicKind::Lemon);
      }
      EXPECT_LT(nearest, 1e-10); // where k1 = k2 to round-off
    }
  }
}

//------------------------------------------------------------------------------
// k1 - k2 has no zero on a torus of revolution, and its directions never turn.
TEST(ExactUmbilics, DoNotExistOnTheTorus)
{
  EXPECT_TRUE(FindUmbilics(MakeTorus(1.0, 0.4), TorusMesh(1.0, 0.4, 60, 30)).empty());
}

//------------------------------------------------------------------------------
TEST(ClosedSurfaceByName, RefusesUnknownNames)
{
  EXPECT_THROW(ClosedSurfaceByName("cube"), std::invalid_argument);
  EXPECT_EQ(GenericClosedSurfaces().size(), 5u);
}
