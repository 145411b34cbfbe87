// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// The smallest enclosing sphere against its defining property and against brute force.

#include "Fixtures/TestFields.h"

#include "Mesh/EnclosingSphere.h"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace
{

using namespace ridges;
using namespace ridges::testing;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

// Some operations of round-off on coordinates of the size of the radius.
const double RoundOff = 1e-12;

Matrix3Xd RandomCloud(int count, std::uint64_t seed)
{
  std::mt19937_64 generator(seed);
  Matrix3Xd points(3, count);
  for (int i = 0; i < count; ++i)
  {
    points.col(i) = InBall(generator);
  }
  return points;
}

double FarthestFrom(const Vector3d& center, const Matrix3Xd& points)
{
  return (points.colwise() - center).colwise().norm().maxCoeff();
}

// A sphere around points is the smallest if its centre is in the convex hull of the points that it
// touches: equivalently, no move of the centre brings all of these nearer. Looked for by descent:
// the move that is tried goes towards the mean of the farthest points.
void CheckSmallest(const Sphere& sphere, const Matrix3Xd& points, std::uint64_t seed)
{
  ASSERT_LE(FarthestFrom(sphere.center, points), sphere.radius * (1.0 + RoundOff));
  ASSERT_GE(FarthestFrom(sphere.center, points), sphere.radius * (1.0 - RoundOff));
  std::mt19937_64 generator(seed);
  for (const double step : { 1e-1, 1e-2, 1e-3, 1e-4 })
  {
    for (int i = 0; i < 300; ++i)
    {
      const Vector3d moved = sphere.center + step * sphere.radius * InBall(generator).normalized();
      ASSERT_GE(FarthestFrom(moved, points), sphere.radius * (1.0 - RoundOff));
    }
  }
}

// The smallest sphere over all sets of up to four points whose circumscribed sphere, with its
// centre in their affine hull, encloses all.
double BruteForceRadius(const Matrix3Xd& points)
{
  const int n = static_cast<int>(points.cols());
  double best = std::numeric_limits<double>::max();
  for (int set = 1; set < (1 << n); ++set)
  {
    std::vector<int> chosen;
    for (int i = 0; i < n; ++i)
    {
      if (set & (1 << i))
      {
        chosen.push_back(i);
      }
    }
    if (chosen.size() > 4)
    {
      continue;
    }
    // 2 (p_i - p_0) . x = |p_i - p_0|^2 with x of least norm.
    const Eigen::Index rows = static_cast<Eigen::Index>(chosen.size()) - 1;
    Eigen::MatrixXd system(rows, 3);
    Eigen::VectorXd squares(rows);
    for (Eigen::Index i = 0; i < rows; ++i)
    {
      const Vector3d edge = points.col(chosen[i + 1]) - points.col(chosen[0]);
      system.row(i) = 2.0 * edge.transpose();
      squares[i] = edge.squaredNorm();
    }
    Vector3d offset = Vector3d::Zero();
    if (rows > 0)
    {
      offset = system.completeOrthogonalDecomposition().solve(squares);
    }
    if (FarthestFrom(points.col(chosen[0]) + offset, points) <= offset.norm() * (1.0 + RoundOff))
    {
      best = std::min(best, offset.norm());
    }
  }
  return best;
}

} // namespace

//------------------------------------------------------------------------------
TEST(EnclosingSphere, OfTinyCloudsIsThatOfAllSubsets)
{
  for (std::uint64_t seed = 1; seed <= 200; ++seed)
  {
    const int count = 2 + static_cast<int>(seed % 7);
    const Matrix3Xd points = RandomCloud(count, seed);
    const Sphere sphere = SmallestEnclosingSphere(points);
    EXPECT_NEAR(sphere.radius, BruteForceRadius(points), RoundOff) << "seed " << seed;
    EXPECT_NEAR(FarthestFrom(sphere.center, points), sphere.radius, RoundOff);
  }
}

//------------------------------------------------------------------------------
TEST(EnclosingSphere, OfRandomCloudsIsTheSmallest)
{
  for (const int count : { 5, 20, 100, 1000 })
  {
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
    {
      const Matrix3Xd points = RandomCloud(count, seed);
      CheckSmallest(SmallestEnclosingSphere(points), points, seed);
    }
  }
}

//------------------------------------------------------------------------------
TEST(EnclosingSphere, OfPointsInAPlaneOrOnALineIsTheSmallest)
{
  Matrix3Xd plane = RandomCloud(50, 31);
  plane.row(2).setZero();
  Matrix3Xd line = plane;
  line.row(1).setZero();
  for (const Matrix3Xd& points : { plane, line })
  {
    const Matrix3Xd turned = (GenericRotation() * points).colwise() + Vector3d(1, 2, 3);
    CheckSmallest(SmallestEnclosingSphere(turned), turned, 1);
  }
  const double span = line.row(0).maxCoeff() - line.row(0).minCoeff();
  EXPECT_NEAR(SmallestEnclosingSphere(line).radius, 0.5 * span, RoundOff);
}

//------------------------------------------------------------------------------
TEST(EnclosingSphere, OfCubeCornersAndDuplicatesIsTheCircumscribedSphere)
{
  Matrix3Xd points(3, 24);
  for (int i = 0; i < 24; ++i)
  {
    points.col(i) << (i & 1 ? 1.0 : -1.0), (i & 2 ? 1.0 : -1.0), (i & 4 ? 1.0 : -1.0);
  }
  const Sphere sphere = SmallestEnclosingSphere(points);
  EXPECT_NEAR(sphere.radius, std::sqrt(3.0), RoundOff);
  EXPECT_LT(sphere.center.norm(), RoundOff);
}

//------------------------------------------------------------------------------
TEST(EnclosingSphere, OfFewPointsIsObvious)
{
  EXPECT_EQ(SmallestEnclosingSphere(Matrix3Xd(3, 0)).radius, 0.0);
  const Matrix3Xd same = Vector3d(1, 2, 3).replicate(1, 5);
  EXPECT_EQ(SmallestEnclosingSphere(same).radius, 0.0);
  EXPECT_EQ(SmallestEnclosingSphere(same).center, Vector3d(1, 2, 3));
  Matrix3Xd obtuse(3, 3); // Two of the three points determine the sphere.
  obtuse << 0, 10, 5, 0, 0, 1, 0, 0, 0;
  EXPECT_NEAR(SmallestEnclosingSphere(obtuse).radius, 5.0, RoundOff);
}

//------------------------------------------------------------------------------
TEST(EnclosingSphere, OfMeshesIsThatOfTheirSurfaceAndDoesNotTurn)
{
  const auto pointsOf = [](const Mesh& mesh)
  {
    return Matrix3Xd(Eigen::Map<const Matrix3Xd>(
      mesh.points.data(), 3, static_cast<Eigen::Index>(mesh.PointCount())));
  };
  // All points are on the unit sphere: most sets of four of them determine it.
  const Sphere unit = SmallestEnclosingSphere(pointsOf(Icosphere(20)));
  EXPECT_NEAR(unit.radius, 1.0, RoundOff);
  EXPECT_LT(unit.center.norm(), RoundOff);

  // The poles of this mesh are corners of the icosahedron only by chance: within an edge of them,
  // at an edge of 0.035, the distance to the centre falls by half its square at most.
  const Matrix3Xd ellipsoid = pointsOf(EllipsoidMesh(32, 1.0, 0.8, 0.6));
  const Sphere sphere = SmallestEnclosingSphere(ellipsoid);
  CheckSmallest(sphere, ellipsoid, 2);
  EXPECT_NEAR(sphere.radius, 1.0, 0.5 * 0.04 * 0.04);
  EXPECT_LE(sphere.radius, 1.0 + RoundOff);

  const Matrix3Xd turned = (7.0 * GenericRotation() * ellipsoid).colwise() + Vector3d(1, -2, 3);
  EXPECT_NEAR(SmallestEnclosingSphere(turned).radius / 7.0, sphere.radius, RoundOff);
}

TEST(EnclosingSphere, OfAMeshLeavesOutPointsOfNoTriangle)
{
  Mesh mesh = Icosphere(3);
  mesh.AddPoint({ 100.0, 0.0, 0.0 });
  mesh.AddPoint({ std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0 });
  EXPECT_NEAR(SmallestEnclosingSphere(MeshedSurface(mesh).Triangles()).radius, 1.0, RoundOff);
  EXPECT_EQ(SmallestEnclosingSphere(TriangleMesh()).radius, 0.0);
}

//------------------------------------------------------------------------------
TEST(EnclosingSphere, OfAMeshIsThatOfThePointsOfItsTriangles)
{
  std::vector<Mesh> meshes = { Icosphere(1), Icosphere(6), EllipsoidMesh(8, 1.4, 1.0, 0.6),
    EllipsoidMesh(8, 9.0, 0.2, 0.1), TorusMesh(2.0, 0.7, 21, 11),
    CylinderPatch(1.0, 2.0, 1.0, 12, 7), CylinderPatch(1.0, 0.1, 30.0, 5, 40),
    AddNormalNoise(Icosphere(6), 0.1, 2) };
  for (const Mesh& mesh : meshes)
  {
    const Matrix3Xd points = Eigen::Map<const Matrix3Xd>(
      mesh.points.data(), 3, static_cast<Eigen::Index>(mesh.PointCount()));
    const Sphere expected = SmallestEnclosingSphere(points);
    Mesh withOther = mesh;
    withOther.AddPoint(Vector3d(100.0, 0.0, 0.0));
    const MeshedSurface surface(withOther);
    const Sphere sphere = SmallestEnclosingSphere(surface.Triangles());
    EXPECT_NEAR(sphere.radius, expected.radius, RoundOff * expected.radius);
    EXPECT_LT((sphere.center - expected.center).norm(), 1e-6 * expected.radius);
  }
  EXPECT_EQ(SmallestEnclosingSphere(TriangleMesh()).radius, 0.0);
}
