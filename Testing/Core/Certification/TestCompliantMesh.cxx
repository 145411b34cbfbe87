// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Certification/CertifiedSurface.h"
#include "Certification/CompliantMesh.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace ridges;
using ridges::testing::CertifiedSurface;

namespace
{

constexpr const char* Ellipsoid = "x^2+y^2/0.64+z^2/0.36-1";

UmbilicCertificate CertifyNear(const CertifiedSurface& surface, Eigen::Vector3d x)
{
  EXPECT_TRUE(FindUmbilic(surface.proof, 0.3, x));
  return CertifyUmbilic(surface.proof, x, 0.3);
}

CompliantMesh Sampled(const CertifiedSurface& surface, const SurfaceBounds& bounds,
  const ridges::testing::Mesh& mesh, bool isReversed = false)
{
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < mesh.PointCount(); ++i)
  {
    points.push_back(mesh.Point(i));
  }
  std::vector<Triangle> triangles;
  for (std::size_t t = 0; t < mesh.TriangleCount(); ++t)
  {
    const std::int32_t* corners = &mesh.triangles[3 * t];
    triangles.push_back(isReversed ? Triangle{ corners[0], corners[2], corners[1] }
                                   : Triangle{ corners[0], corners[1], corners[2] });
  }
  return { surface.exact, bounds, isReversed, points, triangles };
}

/// Until no refinement helps, or so many rounds are over.
MeshCertificate Refined(CompliantMesh& mesh, int rounds)
{
  MeshCertificate found = mesh.Certify(TriangleMesh::InOneRange, NeverStops);
  for (int round = 0; round < rounds && !found.HoldsEverywhere() && mesh.Refine(found); ++round)
  {
    found = mesh.Certify(TriangleMesh::InOneRange, NeverStops);
  }
  return found;
}

/// Each triangle outside patches is crossed twice or not at all, as the theory demands.
void ExpectParity(const TriangleMesh& mesh, const MeshCertificate& found)
{
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    if (found.patchOfTriangle[t] >= 0)
    {
      continue;
    }
    for (int color = 0; color < 2; ++color)
    {
      int crossings = 0;
      for (int side = 0; side < 3; ++side)
      {
        crossings += found.edges[mesh.EdgeOf(t, side)]->crossings[color];
      }
      EXPECT_TRUE(crossings == 0 || crossings == 2) << "triangle " << t;
    }
  }
}

} // namespace

TEST(UmbilicCertificate, IsolatesThoseOfAnEllipsoid)
{
  const CertifiedSurface surface(Ellipsoid, FormulaFunction::Kind::Implicit);
  const UmbilicCertificate found = CertifyNear(surface, { 0.7, 0.05, 0.4 });
  EXPECT_TRUE(found.isIsolated);
  const Eigen::Vector3d exact(0.75, 0.0, 0.6 * std::sqrt(1.0 - 0.75 * 0.75));
  EXPECT_LT((found.position - exact).norm(), 1e-12);
  EXPECT_LT(found.error, 1e-11);
  EXPECT_EQ(found.index, 0.5);
  EXPECT_EQ(found.ridgeCount, (std::array<int, 2>{ 1, 1 }));
  EXPECT_GT(found.radius, 0.05);
}

TEST(UmbilicCertificate, CountsThreeRidgesAtAStar)
{
  const CertifiedSurface star(
    "0.5*(x^2+y^2)+(x^3-3*x*y^2)/6+0.1*x^4+0.05*x*y^3", FormulaFunction::Kind::Graph);
  const UmbilicCertificate found = CertifyNear(star, star.Over(0.02, -0.01));
  EXPECT_TRUE(found.isIsolated);
  EXPECT_LT(found.position.norm(), 1e-12);
  EXPECT_EQ(found.index, -0.5);
  EXPECT_EQ(found.ridgeCount, (std::array<int, 2>{ 3, 3 }));
}

TEST(UmbilicCertificate, DoesNotCertifyThePoleOfASurfaceOfRevolution)
{
  const CertifiedSurface pole("0.5*(x^2+y^2)+(x^2+y^2)^2", FormulaFunction::Kind::Graph);
  const UmbilicCertificate found = CertifyUmbilic(pole.proof, Eigen::Vector3d::Zero(), 0.1);
  EXPECT_FALSE(found.isIsolated);
  EXPECT_EQ(found.radius, 0.0);
}

TEST(CompliantMesh, CertifiesAnEllipsoidFromFortyTwoPoints)
{
  const CertifiedSurface surface(Ellipsoid, FormulaFunction::Kind::Implicit);
  for (const SurfaceBounds* bounds : { static_cast<const SurfaceBounds*>(&surface.proof),
         static_cast<const SurfaceBounds*>(&surface.samples) })
  {
    CompliantMesh mesh =
      Sampled(surface, *bounds, ridges::testing::EllipsoidMesh(2, 1.0, 0.8, 0.6));
    EXPECT_FALSE(mesh.Certify(TriangleMesh::InOneRange, NeverStops).HoldsEverywhere());
    const MeshCertificate found = Refined(mesh, 60);
    ASSERT_TRUE(found.HoldsEverywhere());
    EXPECT_EQ(found.patches.size(), 4U);
    EXPECT_EQ(mesh.Mesh().EulerCharacteristic(), 2);
    EXPECT_EQ(mesh.Mesh().NumberOfNonManifoldEdges(), 0);
    ExpectParity(mesh.Mesh(), found);
    // All ridges are in the coordinate planes.
    int crossings = 0;
    for (const auto& edge : found.edges)
    {
      for (int color = 0; edge && color < 2; ++color)
      {
        if (edge->crossings[color] == 1)
        {
          ++crossings;
          EXPECT_LT(edge->position[color].cwiseAbs().minCoeff(), 1e-11);
        }
      }
    }
    EXPECT_GT(crossings, 20);
  }
}

TEST(CompliantMesh, MovesNothingThatComplies)
{
  const CertifiedSurface surface(Ellipsoid, FormulaFunction::Kind::Implicit);
  CompliantMesh mesh =
    Sampled(surface, surface.proof, ridges::testing::EllipsoidMesh(3, 1.0, 0.8, 0.6));
  const std::vector<double> before = mesh.Points();
  const MeshCertificate found = Refined(mesh, 60);
  ASSERT_TRUE(found.HoldsEverywhere());
  ASSERT_GE(mesh.Points().size(), before.size());
  EXPECT_TRUE(std::equal(before.begin(), before.end(), mesh.Points().begin()));
}

// Vertices on all three coordinate planes, where the ridges are.
TEST(CompliantMesh, MovesVerticesOffRidges)
{
  const CertifiedSurface surface(Ellipsoid, FormulaFunction::Kind::Implicit);
  CompliantMesh mesh =
    Sampled(surface, surface.proof, ridges::testing::EllipsoidMesh(4, 1.0, 0.8, 0.6, false));
  const MeshCertificate first = mesh.Certify(TriangleMesh::InOneRange, NeverStops);
  EXPECT_TRUE(std::any_of(first.edges.begin(), first.edges.end(),
    [](const auto& edge) { return edge && (edge->failed & NoRidgeThroughVertex) != 0; }));
  EXPECT_TRUE(Refined(mesh, 80).HoldsEverywhere());
}

TEST(CompliantMesh, SwapsColorsSeenFromTheOtherSide)
{
  const CertifiedSurface surface(Ellipsoid, FormulaFunction::Kind::Implicit);
  const IntervalBounds reversed(surface.function, true);
  const ridges::testing::Mesh sphere = ridges::testing::EllipsoidMesh(8, 1.0, 0.8, 0.6);
  CompliantMesh outside = Sampled(surface, surface.proof, sphere);
  CompliantMesh inside = Sampled(surface, reversed, sphere, true);
  const auto count = [](const MeshCertificate& found)
  {
    std::array<int, 2> crossings{};
    for (const auto& edge : found.edges)
    {
      crossings[0] += edge ? std::max(0, edge->crossings[0]) : 0;
      crossings[1] += edge ? std::max(0, edge->crossings[1]) : 0;
    }
    return crossings;
  };
  const auto a = count(outside.Certify(TriangleMesh::InOneRange, NeverStops));
  const auto b = count(inside.Certify(TriangleMesh::InOneRange, NeverStops));
  EXPECT_EQ(a[0], b[1]);
  EXPECT_EQ(a[1], b[0]);
  EXPECT_NE(a[0], a[1]);
}

TEST(CompliantMesh, EndsOnSurfacesThatAreNotGeneric)
{
  for (const char* formula : { "x^2+y^2+z^2-1", "x^2+y^2+z^2/0.36-1", "x^2/0.36+y^2+z^2-1" })
  {
    const CertifiedSurface surface(formula, FormulaFunction::Kind::Implicit);
    CompliantMesh mesh =
      Sampled(surface, surface.proof, ridges::testing::EllipsoidMesh(6, 1.0, 1.0, 1.0));
    const MeshCertificate found = Refined(mesh, 3);
    EXPECT_FALSE(found.HoldsEverywhere());
    EXPECT_EQ(mesh.NumberOfPoints(), 362) << formula; // refinement does not help
    for (Id t = 0; t < mesh.Mesh().NumberOfTriangles(); ++t)
    {
      EXPECT_NE(found.FailedAt(mesh.Mesh(), t) & NotGeneric, 0);
    }
  }
}
