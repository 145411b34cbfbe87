// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// The parity of crossings, on which the extraction of ridges stands: for any mesh and any data.
// Signs and counts: no tolerance.

#include "Fixtures/TestFields.h"

#include "Monge/AcuteRule.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{

using namespace ridges;
using namespace ridges::testing;

std::vector<Mesh> NoiseMeshes()
{
  return { Icosphere(6), TorusMesh(2.0, 0.7, 21, 11), CylinderPatch(1.0, 2.0, 1.0, 13, 9),
    AddNormalNoise(Icosphere(6), 0.3, 1) };
}

int CountCrossings(const TriangleMesh& mesh, const MongeField& field, Color color, Id t)
{
  int count = 0;
  for (int i = 0; i < 3; ++i)
  {
    count += IsCrossed(field, color, mesh.Corners(t)[i], mesh.Corners(t)[(i + 1) % 3]) ? 1 : 0;
  }
  return count;
}

void CheckParity(const TriangleMesh& mesh, const FieldArrays& arrays)
{
  const MongeField field = arrays.View();
  int singular = 0;
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const bool regular = IsRegular(mesh, field, t);
    singular += regular ? 0 : 1;
    for (const Color color : { Color::Blue, Color::Red })
    {
      ASSERT_EQ(CountCrossings(mesh, field, color, t) % 2, regular ? 0 : 1) << "triangle " << t;
    }
  }
  // Noise makes both kinds in plenty, or this would test nothing.
  EXPECT_GT(singular, mesh.NumberOfTriangles() / 10);
  EXPECT_LT(singular, mesh.NumberOfTriangles() * 9 / 10);
}

} // namespace

//------------------------------------------------------------------------------
TEST(AcuteRule, CrossingsAreEvenInRegularAndOddInSingularTriangles)
{
  for (const Mesh& mesh : NoiseMeshes())
  {
    const MeshedSurface surface(mesh);
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
    {
      CheckParity(surface.Triangles(), RandomField(surface.Triangles(), seed));
    }
  }
}

//------------------------------------------------------------------------------
TEST(AcuteRule, ParityHoldsWithZerosAndRightAngles)
{
  for (const Mesh& mesh : NoiseMeshes())
  {
    const MeshedSurface surface(mesh);
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
    {
      FieldArrays arrays = RandomField(surface.Triangles(), seed, 3);
      CheckParity(surface.Triangles(), arrays);
      // Directions along the axes only: a third of the angles are exactly right.
      std::mt19937_64 generator(seed);
      for (Id p = 0; p < surface.Triangles().NumberOfPoints(); ++p)
      {
        const auto axis = static_cast<int>(3.0 * Uniform(generator));
        const double sign = Uniform(generator) < 0.5 ? -1.0 : 1.0;
        for (int i = 0; i < 3; ++i)
        {
          arrays.d1[3 * p + i] = i == axis ? sign : 0.0;
          arrays.d2[3 * p + i] = i == (axis + 1) % 3 ? 1.0 : 0.0;
        }
      }
      CheckParity(surface.Triangles(), arrays);
    }
  }
}

//------------------------------------------------------------------------------
TEST(AcuteRule, CrossingsDoNotDependOnTheSignsOfFrames)
{
  for (const Mesh& mesh : NoiseMeshes())
  {
    const MeshedSurface surface(mesh);
    const TriangleMesh& triangles = surface.Triangles();
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
    {
      const FieldArrays before = RandomField(triangles, seed, 5);
      FieldArrays after = before;
      std::mt19937_64 generator(seed + 100);
      for (Id p = 0; p < triangles.NumberOfPoints(); ++p)
      {
        if (Uniform(generator) < 0.5)
        {
          after.Turn(p);
        }
      }
      Id compared = 0;
      for (Id e = 0; e < triangles.NumberOfEdges(); ++e)
      {
        const Edge& edge = triangles.EdgeAt(e);
        for (const Color color : { Color::Blue, Color::Red })
        {
          const bool isZero = before.View().Extremality(color, edge.v0) == 0.0 ||
            before.View().Extremality(color, edge.v1) == 0.0;
          if (!isZero)
          {
            ++compared;
            ASSERT_EQ(IsCrossed(before.View(), color, edge.v0, edge.v1),
              IsCrossed(after.View(), color, edge.v0, edge.v1));
          }
        }
      }
      EXPECT_GT(compared, triangles.NumberOfEdges());
      CheckParity(triangles, after);
      for (Id t = 0; t < triangles.NumberOfTriangles(); ++t)
      {
        ASSERT_EQ(IsRegular(triangles, before.View(), t), IsRegular(triangles, after.View(), t));
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(AcuteRule, AnEdgeIsCrossedFromBothSidesAlike)
{
  const MeshedSurface surface(TorusMesh(2.0, 0.7, 21, 11));
  const FieldArrays arrays = RandomField(surface.Triangles(), 4, 3);
  for (Id e = 0; e < surface.Triangles().NumberOfEdges(); ++e)
  {
    const Edge& edge = surface.Triangles().EdgeAt(e);
    for (const Color color : { Color::Blue, Color::Red })
    {
      ASSERT_EQ(IsCrossed(arrays.View(), color, edge.v0, edge.v1),
        IsCrossed(arrays.View(), color, edge.v1, edge.v0));
    }
  }
}

//------------------------------------------------------------------------------
TEST(AcuteRule, ZeroCountsAsPositiveWithEitherSign)
{
  EXPECT_EQ(ExtremalitySign(0.0), 1);
  EXPECT_EQ(ExtremalitySign(-0.0), 1);
  EXPECT_EQ(ExtremalitySign(1e-300), 1);
  EXPECT_EQ(ExtremalitySign(-1e-300), -1);
}

//------------------------------------------------------------------------------
TEST(AcuteRule, CrossingParameterIsEquationFour)
{
  const double roundOff = 1e-15;
  // p b(q) + q b(p) over their sum, in absolute values: signs depend on the frames.
  EXPECT_NEAR(CrossingParameter(1.0, -3.0), 0.25, roundOff);
  EXPECT_NEAR(CrossingParameter(-1.0, -3.0), 0.25, roundOff);
  EXPECT_NEAR(CrossingParameter(3e-200, 1e-200), 0.75, roundOff);
  EXPECT_NEAR(CrossingParameter(2e150, -2e150), 0.5, roundOff);
  EXPECT_EQ(CrossingParameter(0.0, -2.0), 0.0);
  EXPECT_EQ(CrossingParameter(2.0, 0.0), 1.0);
  EXPECT_EQ(CrossingParameter(0.0, 0.0), 0.5);
  std::mt19937_64 generator(5);
  for (int i = 0; i < 1000; ++i)
  {
    const double p = Symmetric(generator);
    const double q = Symmetric(generator);
    const double t = CrossingParameter(p, q);
    EXPECT_NEAR(std::abs(p) * (1.0 - t), std::abs(q) * t, roundOff); // The zero of |p|, -|q|.
    EXPECT_NEAR(CrossingParameter(q, p), 1.0 - t, roundOff);
  }
}
