// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// Where in its triangle an umbilic lies.

#include "Fixtures/TestFields.h"

#include "Umbilics/DirectionIndex.h"
#include "Umbilics/UmbilicForm.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using namespace ridges;
using namespace ridges::testing;
using Eigen::Vector3d;

// The sheet z = 0.8 sqrt(1 + x^2 + (y / 0.7)^2) of a hyperboloid, with umbilics at x = 0.
constexpr double UmbilicY = 0.470266353;

double Height(double x, double y)
{
  return 0.8 * std::sqrt(1.0 + x * x + y * y / 0.49);
}

AnalyticSurface Hyperboloid()
{
  return AnalyticSurface(
    [](auto x, auto y, auto z) { return z * z - 0.64 * (1.0 + x * x + y * y * (1.0 / 0.49)); });
}

} // namespace

//------------------------------------------------------------------------------
// The mesh has the line x = 0, so that the umbilics lie on an edge: whether inside of a triangle or
// not is a matter of round-off. Along it the form is interpolated to second order.
TEST(UmbilicPosition, AnUmbilicOnAnEdgeIsFoundThere)
{
  for (const int n : { 40, 80, 160 })
  {
    const MeshedSurface surface(GraphPatch(Height, 2.0, n));
    const TriangleMesh& mesh = surface.Triangles();
    const FieldArrays field = ExactField(mesh, Hyperboloid());
    const double edge = 4.0 / n;
    const DirectionIndex index(mesh, field.View(), nullptr);
    int found = 0;
    for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
    {
      if (index.HalfTurns(t) != 0)
      {
        ++found;
        const Vector3d umbilic = UmbilicInTriangle(mesh, field.View(), t);
        EXPECT_NEAR(umbilic.x(), 0.0, 2e-3 * edge) << n;
        EXPECT_NEAR(std::abs(umbilic.y()), UmbilicY, edge * edge) << n;
      }
    }
    EXPECT_EQ(found, 2) << n;
  }
}

//------------------------------------------------------------------------------
// Forms in the plane, as a length of k1 - k2 and an angle of d1, at the corners of a triangle.
TEST(UmbilicPosition, WeightsAreThoseOfTheLeastForm)
{
  Mesh triangle;
  triangle.AddPoint(Vector3d(0.0, 0.0, 0.0));
  triangle.AddPoint(Vector3d(1.0, 0.0, 0.0));
  triangle.AddPoint(Vector3d(0.0, 1.0, 0.0));
  triangle.AddTriangle(0, 1, 2);
  const MeshedSurface surface(triangle);
  const auto weightsOf = [&](const std::array<Eigen::Vector2d, 3>& forms)
  {
    FieldArrays field(3);
    for (Id p = 0; p < 3; ++p)
    {
      const double angle = 0.5 * std::atan2(forms[p][1], forms[p][0]);
      MongeForm form;
      form.n = Vector3d::UnitZ();
      form.d1 = Vector3d(std::cos(angle), std::sin(angle), 0.0);
      form.d2 = form.n.cross(form.d1);
      form.k1 = forms[p].norm();
      form.k2 = 0.0;
      field.Set(p, form);
    }
    // From corner 0 on, which comes first by position, then 1 and 2 in the sense of the triangle.
    const Triangle corners = CornersInOrder(surface.Triangles(), field.View(), 0);
    const Vector3d weights = UmbilicWeights(surface.Triangles(), field.View(), 0);
    Vector3d byPoint;
    for (int i = 0; i < 3; ++i)
    {
      byPoint[corners[i]] = weights[i];
    }
    return byPoint;
  };
  // A thousandth is kept away from the sides.
  const auto expectWeights = [](const Vector3d& found, const Vector3d& expected)
  {
    EXPECT_LT((found - expected).norm(), 3e-3) << found.transpose();
    EXPECT_GE(found.minCoeff(), 0.999e-3);
    EXPECT_NEAR(found.sum(), 1.0, 1e-14);
  };
  using V = Eigen::Vector2d;
  // Zero inside, on a side, at a corner; beyond a side; beyond a corner; the same everywhere; none.
  expectWeights(weightsOf({ V(1, 0), V(-1, 1), V(-1, -3) }), Vector3d(0.5, 0.375, 0.125));
  expectWeights(weightsOf({ V(1, 1), V(-3, -3), V(2, -7) }), Vector3d(0.75, 0.25, 0.0));
  expectWeights(weightsOf({ V(0, 0), V(1, 2), V(3, 1) }), Vector3d(1.0, 0.0, 0.0));
  expectWeights(weightsOf({ V(1, 1), V(-1, 1), V(0, 5) }), Vector3d(0.5, 0.5, 0.0));
  expectWeights(weightsOf({ V(1, 1), V(3, 1), V(1, 4) }), Vector3d(1.0, 0.0, 0.0));
  expectWeights(weightsOf({ V(1, 1), V(1, 1), V(1, 1) }), Vector3d::Constant(1.0 / 3.0));
  expectWeights(weightsOf({ V(0, 0), V(0, 0), V(0, 0) }), Vector3d::Constant(1.0 / 3.0));
}
