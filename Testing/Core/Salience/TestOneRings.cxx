// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Fixtures/MeshWithRings.h"
#include "Fixtures/TestFields.h"

#include "Salience/OneRings.h"
#include "Salience/RingAveraging.h"
#include "Salience/TensorSmoothing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

using namespace ridges;
using namespace ridges::testing;

/// Two tetrahedra that share a corner, 0: the triangles there are two fans.
Mesh TwoTetrahedra()
{
  Mesh mesh;
  mesh.AddPoint({ 0.0, 0.0, 0.0 });
  for (const double z : { 1.0, -1.0 })
  {
    const auto first = static_cast<std::int32_t>(mesh.PointCount());
    mesh.AddPoint({ 1.0, 0.0, z });
    mesh.AddPoint({ -1.0, 1.0, z });
    mesh.AddPoint({ -1.0, -1.0, z });
    for (int i = 0; i < 3; ++i)
    {
      mesh.AddTriangle(0, first + i, first + (i + 1) % 3);
    }
    mesh.AddTriangle(first, first + 2, first + 1);
  }
  return mesh;
}

template <int Components>
void Average(RingAveraging<Components>& averaging, Id count, int times)
{
  for (int i = 0; i < times; ++i)
  {
    averaging.Step(0, count / 2);
    averaging.Step(count / 2, count);
    averaging.Swap();
  }
}

} // namespace

//------------------------------------------------------------------------------
TEST(OneRings, AreasAddUpToThatOfTheMesh)
{
  for (const Mesh& mesh : { Icosphere(4), Grid(5), TwoTetrahedra() })
  {
    const MeshWithRings made(mesh);
    double area = 0.0;
    for (Id t = 0; t < made.Triangles().NumberOfTriangles(); ++t)
    {
      area += 0.5 * made.Triangles().AreaNormal(t).norm();
    }
    double sum = 0.0;
    for (Id p = 0; p < made.Triangles().NumberOfPoints(); ++p)
    {
      sum += made.rings.Area(p);
    }
    EXPECT_NEAR(sum, area, 1e-12 * area);
  }
}

TEST(OneRings, PointBetweenTwoFansHasAllNeighbors)
{
  const MeshWithRings made(TwoTetrahedra());
  const Span<Id> around = made.rings.Around(0);
  std::vector<Id> found(around.begin(), around.end());
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, (std::vector<Id>{ 1, 2, 3, 4, 5, 6 }));
  EXPECT_FALSE(made.rings.IsFan(0));
  EXPECT_TRUE(made.rings.IsFan(1));
}

// A regular hexagon of side h around its centre, all areas equal: 6/7 of the points at distance h,
// and half of that along either axis.
TEST(OneRings, VarianceOfARegularMeshIsThreeSevenths)
{
  Mesh mesh;
  const double h = 0.3;
  const int n = 8;
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      mesh.AddPoint({ h * (i + 0.5 * j), h * std::sqrt(0.75) * j, 0.0 });
    }
  }
  for (int j = 0; j + 1 < n; ++j)
  {
    for (int i = 0; i + 1 < n; ++i)
    {
      const int p = j * n + i;
      mesh.AddTriangle(p, p + 1, p + n);
      mesh.AddTriangle(p + 1, p + n + 1, p + n);
    }
  }
  const MeshWithRings made(mesh);
  EXPECT_NEAR(made.rings.Variance(3 * n + 3), 3.0 / 7.0 * h * h, 1e-12);
}

//------------------------------------------------------------------------------
TEST(RingAveraging, KeepsConstants)
{
  const MeshWithRings made(AddNormalNoise(Icosphere(5), 0.05, 1));
  const Id count = made.Triangles().NumberOfPoints();
  const RingGraph graph = made.Graph(true);
  RingAveraging<9> averaging(graph);
  for (Id p = 0; p < count; ++p)
  {
    averaging.Set(p, { 1.0, -2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0 });
  }
  for (Id p = 0; p < count; ++p)
  {
    averaging.Prepare(p, p % 3 == 0 ? 0.3 : 1.0);
  }
  Average(averaging, count, 20);
  for (Id p = 0; p < count; ++p)
  {
    RingAveraging<9>::Values values;
    ASSERT_TRUE(averaging.Get(p, values));
    ASSERT_NEAR(values[0], 1.0, 1e-12);
    ASSERT_NEAR(values[1], -2.0, 1e-12);
    ASSERT_NEAR(values[8], 9.0, 1e-12);
  }
}

TEST(RingAveraging, LeavesOutPointsThatDoNotCount)
{
  const MeshWithRings made(Icosphere(3));
  const Id count = made.Triangles().NumberOfPoints();
  const RingGraph graph = made.Graph(true);
  RingAveraging<9> averaging(graph);
  const double none = std::nan("");
  for (Id p = 0; p < count; ++p)
  {
    const bool counts = p != 7;
    averaging.Set(p, { counts ? 1.0 : none }, counts);
  }
  for (Id p = 0; p < count; ++p)
  {
    averaging.Prepare(p, 1.0);
  }
  Average(averaging, count, 3);
  for (Id p = 0; p < count; ++p)
  {
    RingAveraging<9>::Values values;
    EXPECT_EQ(averaging.Get(p, values), p != 7);
    EXPECT_NEAR(values[0], p != 7 ? 1.0 : 0.0, 1e-14);
  }
}

// The triangles are three times as large at one side as at the other. Weighted by area alone each
// average moves a little to that side.
TEST(RingAveraging, DoesNotWanderToLargeTriangles)
{
  const MeshWithRings made(GradedGrid(40));
  const TriangleMesh& mesh = made.Triangles();
  const auto largestDrift = [&made, &mesh](bool hasFactors)
  {
    const RingGraph graph = made.Graph(hasFactors);
    RingAveraging<9> averaging(graph);
    for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
    {
      averaging.Set(p, { mesh.Point(p)[0], mesh.Point(p)[1] });
    }
    for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
    {
      averaging.Prepare(p, 1.0);
    }
    Average(averaging, mesh.NumberOfPoints(), 10);
    double largest = 0.0;
    for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
    {
      // Ten averages do not reach the border from there.
      const Eigen::Vector3d x = mesh.Point(p);
      RingAveraging<9>::Values values;
      averaging.Get(p, values);
      if (std::abs(x[0] + 5.0) < 4.0 && std::abs(x[1]) < 8.0)
      {
        largest = std::max(largest, std::hypot(values[0] - x[0], values[1] - x[1]));
      }
    }
    return largest;
  };
  EXPECT_LT(largestDrift(true), 1e-5);
  EXPECT_GT(largestDrift(false), 0.1);
}

//------------------------------------------------------------------------------
TEST(TensorSmoothing, FormsComeBackFromSpace)
{
  const MeshedSurface surface(Icosphere(2));
  const FieldArrays field = RandomField(surface.Triangles(), 3);
  for (Id p = 0; p < surface.Triangles().NumberOfPoints(); ++p)
  {
    MongeForm form;
    ASSERT_TRUE(SecondOrderFromSpace(SecondOrderToSpace(field.View(), p), form));
    EXPECT_NEAR(form.k1, field.k1[p], 1e-14);
    EXPECT_NEAR(form.k2, field.k2[p], 1e-14);
    EXPECT_NEAR(std::abs(form.d1.dot(field.View().D1(p))), 1.0, 1e-14);

    const ThirdOrderValues values = ThirdOrderToSpace(field.View(), p);
    ASSERT_TRUE(ThirdOrderFromSpace(values, form));
    const double sign = form.d1.dot(field.View().D1(p)) > 0.0 ? 1.0 : -1.0;
    for (int i = 0; i < 4; ++i)
    {
      EXPECT_NEAR(form.b[i], sign * field.b[4 * p + i], 1e-13);
    }
    EXPECT_NEAR(values[19], field.P1[p], 1e-12 * std::abs(field.P1[p]));
    EXPECT_NEAR(values[20], field.P2[p], 1e-12 * std::abs(field.P2[p]));

    ASSERT_TRUE(FourthOrderFromSpace(FourthOrderToSpace(field.View(), p), form));
    for (int i = 0; i < 4; ++i)
    {
      EXPECT_NEAR(form.b[i], sign * field.b[4 * p + i], 1e-13);
    }
    for (int i = 0; i < 5; ++i)
    {
      EXPECT_NEAR(form.c[i], field.c[5 * p + i], 1e-13);
    }
  }
}

//------------------------------------------------------------------------------
// The average of two forms does not depend on the frames that they are given in: a quarter turn
// exchanges k1 and k2 of the negative form, and with them the coefficients.
TEST(TensorSmoothing, TensorsDoNotDependOnTheFrame)
{
  const MeshedSurface surface(Icosphere(2));
  const FieldArrays field = RandomField(surface.Triangles(), 5);
  FieldArrays turned = field;
  for (Id p = 0; p < surface.Triangles().NumberOfPoints(); ++p)
  {
    // x is -y of the turned frame, and y its x.
    for (int i = 0; i < 3; ++i)
    {
      turned.d1[3 * p + i] = field.d2[3 * p + i];
      turned.d2[3 * p + i] = -field.d1[3 * p + i];
    }
    std::swap(turned.k1[p], turned.k2[p]);
    for (int i = 0; i < 4; ++i)
    {
      turned.b[4 * p + i] = (i % 2 == 0 ? 1.0 : -1.0) * field.b[4 * p + 3 - i];
    }
    for (int i = 0; i < 5; ++i)
    {
      turned.c[5 * p + i] = (i % 2 == 0 ? 1.0 : -1.0) * field.c[5 * p + 4 - i];
    }
    const FourthOrderValues expected = FourthOrderToSpace(field.View(), p);
    const FourthOrderValues actual = FourthOrderToSpace(turned.View(), p);
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      EXPECT_NEAR(actual[i], expected[i], 1e-14) << i;
    }
  }
}
