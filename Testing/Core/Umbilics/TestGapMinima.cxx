// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// Minima of k1 - k2 with an index: on made-up fields and on surfaces whose umbilics are known.

#include "Fixtures/EllipsoidFixture.h"

#include "Monge/AcuteRule.h"
#include "Umbilics/GapMinima.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

namespace
{

using namespace ridges;
using namespace ridges::testing;
using Eigen::Vector3d;

const double Pi = std::acos(-1.0);

// The index along a circle in the plane z = 0 of the directions that turn `index` times, each with
// a random sign.
double IndexOfTurningField(double index, int count, bool clockwise)
{
  std::mt19937_64 generator(61);
  FieldArrays arrays(count);
  std::vector<Id> contour;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * Pi * i / count;
    MongeForm form;
    form.n = Vector3d::UnitZ();
    form.d1 = Vector3d(std::cos(index * angle + 0.3), std::sin(index * angle + 0.3), 0.0);
    form.d2 = form.n.cross(form.d1);
    arrays.Set(i, form);
    if (Uniform(generator) < 0.5)
    {
      arrays.Turn(i);
    }
    contour.push_back(i);
  }
  if (clockwise)
  {
    std::reverse(contour.begin(), contour.end());
  }
  return ContourIndex(arrays.View(), contour, Vector3d(0.1, -0.2, 1.0));
}

std::vector<Umbilic> Detect(const TriangleMesh& mesh, const MongeField& field, double patchSize)
{
  GapMinima minima(mesh, field, patchSize);
  std::vector<Id> smallestAround;
  smallestAround.reserve(mesh.NumberOfPoints());
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    smallestAround.push_back(SmallestGapAround(mesh, field, p));
  }
  std::vector<Id> candidates;
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    if (MinimizesGapInOneRing(mesh, smallestAround, t) && minima.Minimizes(t))
    {
      candidates.push_back(t);
    }
  }
  return minima.Select(candidates);
}

} // namespace

//------------------------------------------------------------------------------
TEST(GapMinima, ContourIndexCountsHalfTurns)
{
  for (const int count : { 12, 50 }) // Less than a quarter turn per step.
  {
    for (const double index : { 0.5, -0.5, 0.0, 1.0, -1.0, 1.5 })
    {
      EXPECT_EQ(IndexOfTurningField(index, count, false), index) << count << " points";
      EXPECT_EQ(IndexOfTurningField(index, count, true), -index) << count << " points";
    }
  }
}

//------------------------------------------------------------------------------
TEST(GapMinima, FindsThoseOfTheEllipsoid)
{
  const auto exact = EllipsoidUmbilics(EllipsoidAxes[0], EllipsoidAxes[1], EllipsoidAxes[2]);
  for (const int frequency : { 32, 63 })
  {
    const FittedEllipsoid& ellipsoid = FittedEllipsoid::OfFrequency(frequency);
    for (const double patchSize : { 2.0, 3.0, 4.0 })
    {
      const auto umbilics = Detect(ellipsoid.Triangles(), ellipsoid.field.View(), patchSize);
      ASSERT_EQ(umbilics.size(), 4u) << "frequency " << frequency << " size " << patchSize;
      double sum = 0.0;
      for (const Umbilic& umbilic : umbilics)
      {
        EXPECT_EQ(umbilic.index, 0.5);
        EXPECT_EQ(umbilic.ridgeCount, 1);
        EXPECT_EQ(umbilic.thirdOrderIndex, 1);
        EXPECT_FALSE(IsRegular(ellipsoid.Triangles(), ellipsoid.field.View(), umbilic.triangle));
        // Linear interpolation in the triangle: a fraction of an edge.
        const double distance = DistanceToUmbilics(umbilic.position);
        EXPECT_LT(distance, ellipsoid.meanEdge);
        sum += distance;
      }
      std::cout << "ellipsoid, frequency " << frequency << ", patch size " << patchSize
                << ": umbilics off by " << sum / 4.0 / ellipsoid.meanEdge
                << " mean edges on average\n";
      // Each of the four is found once.
      for (const Vector3d& expected : exact)
      {
        EXPECT_EQ(
          std::count_if(umbilics.begin(), umbilics.end(),
            [&](const Umbilic& u) { return (u.position - expected).norm() < ellipsoid.meanEdge; }),
          1);
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(GapMinima, FindsThoseOfTheBlend)
{
  const MeshedSurface surface(MeshSurface(BlendSurface(), 63));
  const FieldArrays field = FitField(surface.Triangles());
  for (const double patchSize : { 2.0, 3.0, 4.0 })
  {
    const auto umbilics = Detect(surface.Triangles(), field.View(), patchSize);
    int positive = 0;
    int negative = 0;
    for (const Umbilic& umbilic : umbilics)
    {
      ++(umbilic.index > 0.0 ? positive : negative);
      EXPECT_EQ(umbilic.thirdOrderIndex, umbilic.index > 0.0 ? 1 : -1);
      EXPECT_TRUE(umbilic.ridgeCount == 1 || umbilic.index < 0.0);
    }
    EXPECT_EQ(positive, 6) << "size " << patchSize;
    EXPECT_EQ(negative, 2) << "size " << patchSize;
  }
}

//------------------------------------------------------------------------------
TEST(GapMinima, PatchesDoNotOverlapOnNoise)
{
  const MeshedSurface surface(Icosphere(16));
  const TriangleMesh& mesh = surface.Triangles();
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
  {
    const FieldArrays field = RandomField(mesh, seed);
    const auto umbilics = Detect(mesh, field.View(), 2.0);
    EXPECT_GT(umbilics.size(), 3u);
    std::vector<int> taken(mesh.NumberOfTriangles(), 0);
    for (const Umbilic& umbilic : umbilics)
    {
      EXPECT_EQ(std::abs(umbilic.index), 0.5);
      EXPECT_EQ(std::count(umbilic.patch.begin(), umbilic.patch.end(), umbilic.triangle), 1);
      for (const Id t : umbilic.patch)
      {
        EXPECT_EQ(taken[t]++, 0);
      }
    }
  }
}

//------------------------------------------------------------------------------
// Where gaps are equal, as around an axis of symmetry, one triangle of a fan stands for all.
TEST(GapMinima, OfEqualGapsAroundAPointOneIsSmallest)
{
  const int count = 100;
  Mesh fan;
  fan.AddPoint(Vector3d::Zero());
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * Pi * i / count;
    fan.AddPoint(Vector3d(std::cos(angle), std::sin(angle), 0.0));
  }
  for (int i = 0; i < count; ++i)
  {
    fan.AddTriangle(0, 1 + i, 1 + (i + 1) % count);
  }
  const MeshedSurface surface(fan);
  const TriangleMesh& mesh = surface.Triangles();
  FieldArrays field(mesh.NumberOfPoints());
  MongeForm form;
  form.k1 = 1.0;
  form.n = Vector3d::UnitZ();
  form.d1 = Vector3d::UnitX();
  form.d2 = Vector3d::UnitY();
  std::vector<Id> smallestAround;
  smallestAround.reserve(mesh.NumberOfPoints());
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    field.Set(p, form);
  }
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    smallestAround.push_back(SmallestGapAround(mesh, field.View(), p));
  }
  int found = 0;
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    found += MinimizesGapInOneRing(mesh, smallestAround, t) ? 1 : 0;
  }
  EXPECT_EQ(found, 1);
}
