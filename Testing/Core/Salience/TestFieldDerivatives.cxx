// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Fixtures/TestFields.h"

#include "Salience/FieldDerivatives.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace
{

using namespace ridges;
using namespace ridges::testing;

/// The rms of the errors of b and c, over the largest of each, where the derivatives are taken of
/// exact values.
std::array<double, 2> ErrorsOn(const MeshedSurface& surface, const FieldArrays& exact)
{
  const TriangleMesh& mesh = surface.Triangles();
  const OrderedRings ordered = RingsOf(mesh);
  const OneRings rings(mesh, ordered);
  const FieldDerivatives derivatives(rings, exact.View());
  std::array<double, 2> squares{};
  std::array<double, 2> largest{};
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    const auto b = derivatives.ThirdOrder(p);
    const auto c = derivatives.FourthOrder(p);
    for (int i = 0; i < 4; ++i)
    {
      squares[0] += std::pow(b[i] - exact.b[4 * p + i], 2);
      largest[0] = std::max(largest[0], std::abs(exact.b[4 * p + i]));
    }
    for (int i = 0; i < 5; ++i)
    {
      squares[1] += std::pow(c[i] - exact.c[5 * p + i], 2);
      largest[1] = std::max(largest[1], std::abs(exact.c[5 * p + i]));
    }
  }
  const double count = mesh.NumberOfPoints();
  return { std::sqrt(squares[0] / count) / largest[0], std::sqrt(squares[1] / count) / largest[1] };
}

} // namespace

// All coefficients, the umbilics included, on a surface without any symmetry. The gradient over a
// ring is exact for linear functions, and of second order on even meshes.
TEST(FieldDerivatives, ConvergeToTheExactForms)
{
  const AnalyticSurface perturbed = MakePerturbedSphere(0.08, 5);
  std::array<std::array<double, 2>, 2> errors;
  for (const int i : { 0, 1 })
  {
    const MeshedSurface surface(StarShapedMesh(i == 0 ? 10 : 20, perturbed, { 0.0, 0.0, 0.0 }));
    errors[i] = ErrorsOn(surface, ExactField(surface.Triangles(), perturbed));
  }
  EXPECT_LT(errors[1][0], 0.03);
  EXPECT_LT(errors[1][1], 0.03);
  // 4 for second order; the twelve points with five neighbours are of first order.
  EXPECT_GT(errors[0][0] / errors[1][0], 3.0);
  EXPECT_GT(errors[0][1] / errors[1][1], 3.0);
}

// On a cylinder the principal directions turn with the surface, and nothing changes along them.
TEST(FieldDerivatives, AreNoneOnACylinderUpToItsBorder)
{
  const MeshedSurface surface(CylinderPatch(2.0, 2.0, 3.0, 20, 15));
  const TriangleMesh& mesh = surface.Triangles();
  const FieldArrays exact = ExactField(mesh, MakeCylinder(2.0));
  const OrderedRings ordered = RingsOf(mesh);
  const OneRings rings(mesh, ordered);
  const FieldDerivatives derivatives(rings, exact.View());
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    for (const double b : derivatives.ThirdOrder(p))
    {
      EXPECT_NEAR(b, 0.0, 1e-13);
    }
    // The graph of the circle: z = sqrt(r^2 - y^2) - r, whose fourth derivative is -3 / r^3.
    const auto c = derivatives.FourthOrder(p);
    for (int i = 0; i < 4; ++i)
    {
      EXPECT_NEAR(c[i], 0.0, 1e-13);
    }
    EXPECT_NEAR(c[4], -3.0 / 8.0, 1e-13);
  }
}

TEST(FieldDerivatives, AreZeroWhereTrianglesFormNoFan)
{
  Mesh mesh = Icosphere(1);
  // A third triangle at an edge.
  mesh.AddPoint({ 0.0, 0.0, 3.0 });
  mesh.AddTriangle(mesh.triangles[0], mesh.triangles[1], 12);
  const MeshedSurface surface(mesh);
  const FieldArrays field = RandomField(surface.Triangles(), 1);
  const OrderedRings ordered = RingsOf(surface.Triangles());
  const OneRings rings(surface.Triangles(), ordered);
  const FieldDerivatives derivatives(rings, field.View());
  const Id p = mesh.triangles[0];
  ASSERT_FALSE(rings.IsFan(p));
  for (const double b : derivatives.ThirdOrder(p))
  {
    EXPECT_EQ(b, 0.0);
  }
}
