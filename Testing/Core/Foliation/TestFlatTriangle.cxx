// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Fixtures/TestFields.h"

#include "Foliation/FlatTriangle.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <random>

namespace
{

using namespace ridges;
using namespace ridges::testing;

const Eigen::Vector2d None = Eigen::Vector2d::Zero();

/// One triangle in a generic plane, with frames in that plane.
struct OneTriangle
{
  static Mesh MakeMesh()
  {
    Mesh mesh;
    const Eigen::Matrix3d R = GenericRotation();
    mesh.AddPoint(R * Eigen::Vector3d(0.0, 0.0, 0.5));
    mesh.AddPoint(R * Eigen::Vector3d(1.0, 0.1, 0.5));
    mesh.AddPoint(R * Eigen::Vector3d(0.3, 0.9, 0.5));
    mesh.AddTriangle(0, 1, 2);
    return mesh;
  }

  OneTriangle()
    : surface(MakeMesh())
    , field(3)
  {
  }

  /// d1 at an angle from the first edge, in radians.
  void SetFrame(Id p, double angle, double k1, double k2)
  {
    const Eigen::Matrix3d R = GenericRotation();
    MongeForm form;
    form.d1 = R * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0);
    form.d2 = R * Eigen::Vector3d(-std::sin(angle), std::cos(angle), 0.0);
    form.n = R * Eigen::Vector3d::UnitZ();
    form.k1 = k1;
    form.k2 = k2;
    this->field.Set(p, form);
  }
  FlatTriangle Face() const { return { this->surface.Triangles(), this->field.View(), 0 }; }

  Eigen::Vector3d InSpace(const FlatTriangle& face, const Eigen::Vector2d& direction) const
  {
    return face.ToSpace(direction) - face.ToSpace(None);
  }

  MeshedSurface surface;
  FieldArrays field;
};

} // namespace

//------------------------------------------------------------------------------
TEST(FlatTriangle, GivesBackTheFramesOfItsCorners)
{
  OneTriangle one;
  const double angles[3] = { 0.3, 0.8, -0.2 };
  for (Id p = 0; p < 3; ++p)
  {
    one.SetFrame(p, angles[p], 2.0 + p, -1.0 - 0.5 * p);
  }
  const FlatTriangle face = one.Face();
  ASSERT_FALSE(face.IsDegenerate());
  for (Id p = 0; p < 3; ++p)
  {
    const Eigen::Vector2d corner = face.ToFlat(one.surface.Triangles().Point(p));
    EXPECT_LT((face.ToSpace(corner) - one.surface.Triangles().Point(p)).norm(), 1e-15);
    for (const Color color : { Color::Blue, Color::Red })
    {
      const Eigen::Vector3d direction = one.InSpace(face, face.Direction(color, corner, None));
      EXPECT_NEAR(direction.norm(), 1.0, 1e-15);
      EXPECT_NEAR(std::abs(direction.dot(one.field.View().Direction(color, p))), 1.0, 1e-14);
    }
    EXPECT_NEAR(face.Curvature(Color::Blue, corner), 2.0 + p, 1e-14);
    EXPECT_NEAR(face.Curvature(Color::Red, corner), -1.0 - 0.5 * p, 1e-14);
    EXPECT_NEAR(face.Gap(corner), 3.0 + 1.5 * p, 1e-14);
  }
}

// A linear field of forms is met everywhere: here a cubic's Hessian without its trace, (x, -y) at
// twice the angle, which has its umbilic inside.
TEST(FlatTriangle, IsExactForLinearForms)
{
  OneTriangle one;
  const Eigen::Matrix3d R = GenericRotation();
  const Eigen::Vector2d umbilic(0.4, 0.3);
  const auto angleAt = [&](const Eigen::Vector2d& x)
  { return 0.5 * std::atan2(-(x - umbilic)[1], (x - umbilic)[0]); };
  const auto inPlane = [&](const Eigen::Vector3d& x) -> Eigen::Vector2d
  { return (R.transpose() * x).head<2>(); };
  for (Id p = 0; p < 3; ++p)
  {
    const Eigen::Vector2d x = inPlane(one.surface.Triangles().Point(p));
    one.SetFrame(p, angleAt(x), 1.0 + (x - umbilic).norm(), 1.0 - (x - umbilic).norm());
  }
  const FlatTriangle face = one.Face();
  std::mt19937_64 generator(1);
  for (int i = 0; i < 100; ++i)
  {
    const Eigen::Vector2d flat(Symmetric(generator), Symmetric(generator));
    const Eigen::Vector2d x = inPlane(face.ToSpace(flat));
    const Eigen::Vector2d blue =
      inPlane(one.InSpace(face, face.Direction(Color::Blue, flat, None)));
    EXPECT_NEAR(
      std::abs(blue.dot(Eigen::Vector2d(std::cos(angleAt(x)), std::sin(angleAt(x))))), 1.0, 1e-12);
    EXPECT_NEAR(face.Gap(flat), 2.0 * (x - umbilic).norm(), 1e-13);
    const Eigen::Vector2d red = inPlane(one.InSpace(face, face.Direction(Color::Red, flat, None)));
    EXPECT_NEAR(red.dot(blue), 0.0, 1e-14);
  }
  const Eigen::Vector2d atUmbilic = face.ToFlat(R * Eigen::Vector3d(umbilic[0], umbilic[1], 0.5));
  EXPECT_LT(face.Gap(atUmbilic), 1e-15);
}

TEST(FlatTriangle, HasNoDirectionWhereAllCurvaturesAreEqual)
{
  OneTriangle one;
  for (Id p = 0; p < 3; ++p)
  {
    one.SetFrame(p, 1.0 * p, 3.0, 3.0);
  }
  const FlatTriangle face = one.Face();
  EXPECT_EQ(face.Direction(Color::Blue, face.Centroid(), Eigen::Vector2d::UnitX()), None);
  EXPECT_EQ(face.Gap(face.Centroid()), 0.0);
  EXPECT_NEAR(face.Curvature(Color::Red, face.Centroid()), 3.0, 1e-15);
}

TEST(FlatTriangle, DirectionsAreOnTheSideAskedFor)
{
  OneTriangle one;
  for (Id p = 0; p < 3; ++p)
  {
    one.SetFrame(p, 0.2 * p, 1.0, 0.0);
  }
  const FlatTriangle face = one.Face();
  const Eigen::Vector2d there(0.6, -0.8);
  const Eigen::Vector2d direction = face.Direction(Color::Blue, face.Centroid(), there);
  EXPECT_GE(direction.dot(there), 0.0);
  EXPECT_EQ(face.Direction(Color::Blue, face.Centroid(), -there), -direction);
}

// Around an edge both triangles see the same line, up to the turn about the edge.
TEST(FlatTriangle, DirectionsOfNeighborsFoldIntoEachOther)
{
  const MeshedSurface surface(EllipsoidMesh(20, 1.0, 0.8, 0.6));
  const TriangleMesh& mesh = surface.Triangles();
  const FieldArrays field = ExactField(mesh, MakeEllipsoid(1.0, 0.8, 0.6));
  const double edge = surface.Triangles().MeanEdgeLength();
  double greatest = 0.0;
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const FlatTriangle face(mesh, field.View(), t);
    if (face.Gap(face.Centroid()) < 0.3)
    {
      continue;
    }
    for (int i = 0; i < 3; ++i)
    {
      const FlatTriangle::Side& side = face.SideAt(i);
      ASSERT_GE(side.neighbor, 0);
      const FlatTriangle other(mesh, field.View(), side.neighbor);
      const FlatTriangle::Side& same = other.SideAt(other.SideOf(side.edge));
      ASSERT_EQ(same.edge, side.edge);
      ASSERT_EQ(same.neighbor, t);
      const Eigen::Vector2d here = side.start + 0.5 * side.length * side.along;
      const Eigen::Vector2d there = same.start + 0.5 * same.length * same.along;
      EXPECT_LT((face.ToSpace(here) - other.ToSpace(there)).norm(), 1e-15);
      const Eigen::Vector2d a = face.Direction(Color::Blue, here, None);
      const Eigen::Vector2d b = other.Direction(Color::Blue, there, None);
      // The cross product of (along, outward) here and (along, inward) there.
      greatest = std::max(greatest,
        std::abs(a.dot(side.along) * b.dot(same.inward) + a.dot(side.inward) * b.dot(same.along)));
    }
  }
  // The solid angle between the planes and tangent planes: k^2 edge^2 / 2 with k up to 2.8.
  EXPECT_LT(greatest, 4.0 * edge * edge);
  EXPECT_GT(greatest, 0.0);
}

TEST(FlatTriangle, IsTheSameToTheBitHoweverItIsNumberedAndSigned)
{
  const Mesh mesh = EllipsoidMesh(4, 1.0, 0.8, 0.6);
  const MeshedSurface surface(mesh);
  FieldArrays field = ExactField(surface.Triangles(), MakeEllipsoid(1.0, 0.8, 0.6));
  Mesh turned = mesh;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
  {
    turned.triangles[i] = mesh.triangles[i + 2];
    turned.triangles[i + 1] = mesh.triangles[i];
    turned.triangles[i + 2] = mesh.triangles[i + 1];
  }
  const MeshedSurface other(turned);
  FieldArrays flipped = field;
  for (Id p = 0; p < surface.Triangles().NumberOfPoints(); p += 2)
  {
    flipped.Turn(p);
  }
  for (Id t = 0; t < surface.Triangles().NumberOfTriangles(); ++t)
  {
    const FlatTriangle a(surface.Triangles(), field.View(), t);
    const FlatTriangle b(other.Triangles(), flipped.View(), t);
    EXPECT_EQ(a.Centroid(), b.Centroid());
    EXPECT_EQ(a.ToSpace(a.Centroid()), b.ToSpace(b.Centroid()));
    EXPECT_EQ(
      a.Direction(Color::Red, a.Centroid(), None), b.Direction(Color::Red, b.Centroid(), None));
    EXPECT_EQ(a.Curvature(Color::Blue, a.Centroid()), b.Curvature(Color::Blue, b.Centroid()));
  }
}

TEST(FlatTriangle, WithoutAreaIsDegenerate)
{
  Mesh mesh;
  for (const double x : { 0.0, 1.0, 3.0 })
  {
    mesh.AddPoint({ x, 0.0, 0.0 });
  }
  mesh.AddPoint({ 0.0, 0.0, 0.0 });
  mesh.AddTriangle(0, 1, 2);
  mesh.AddTriangle(0, 1, 3);
  const MeshedSurface surface(mesh);
  const FieldArrays field(4);
  EXPECT_TRUE(FlatTriangle(surface.Triangles(), field.View(), 0).IsDegenerate());
  EXPECT_TRUE(FlatTriangle(surface.Triangles(), field.View(), 1).IsDegenerate());
}
