// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Fixtures/TestFields.h"

#include "Salience/NoiseFloor.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <numeric>

using namespace ridges;
using namespace ridges::testing;

TEST(NoiseFloor, MeasuresTheNoiseOfPoints)
{
  for (const double noise : { 0.001, 0.0002 })
  {
    const MeshedSurface surface(AddNormalNoise(Icosphere(20), noise, 1));
    const OrderedRings rings = RingsOf(surface.Triangles());
    std::vector<Id> sample(surface.Triangles().NumberOfPoints());
    std::iota(sample.begin(), sample.end(), 0);
    std::vector<double> heights;
    NoiseMeter(surface.Triangles(), rings)
      .Measure({ sample.data(), sample.data() + sample.size() }, heights);
    EXPECT_EQ(heights.size(), sample.size());
    // The quantile of 4000 heights scatters by 2 percent.
    EXPECT_NEAR(NoiseMeter::Deviation(heights), noise, 0.08 * noise);
  }
  EXPECT_EQ(NoiseMeter::Deviation({}), 0.0);
}

TEST(NoiseFloor, NoiseIsNormal)
{
  double sum = 0.0;
  double squares = 0.0;
  double fourth = 0.0;
  const int count = 100000;
  for (int i = 0; i < count; ++i)
  {
    const double x = NormalNoise({ 0.001 * i, 1.0, -2.0 });
    sum += x;
    squares += x * x;
    fourth += x * x * x * x;
  }
  // Standard errors: 0.0032, 0.0045 and 0.031.
  EXPECT_NEAR(sum / count, 0.0, 0.015);
  EXPECT_NEAR(squares / count, 1.0, 0.02);
  EXPECT_NEAR(fourth / count, 3.0, 0.15);
}

// Independent errors of deviation e in the two elements of the diagonal, and of e / sqrt(3) off it.
TEST(NoiseFloor, DeviationOfCurvatureIsThatOfTheTensor)
{
  const MeshedSurface surface(Icosphere(30));
  const TriangleMesh& mesh = surface.Triangles();
  FieldArrays clean(mesh.NumberOfPoints());
  std::vector<double> differences;
  const double e = 0.01;
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    const Eigen::Vector3d x = mesh.Point(p);
    MongeForm form;
    form.n = x.normalized();
    form.d1 = form.n.unitOrthogonal();
    form.d2 = form.n.cross(form.d1);
    form.k1 = 2.0;
    form.k2 = -1.0;
    clean.Set(p, form);
    // The eigenvalues of [[2 + a, c], [c, -1 + b]], and the turn of their directions.
    const double a = e * NormalNoise(x);
    const double b = e * NormalNoise(2.0 * x);
    const double c = e * std::sqrt(1.0 / 3.0) * NormalNoise(3.0 * x);
    const double half = 0.5 * (3.0 + a - b);
    const double turn = 0.5 * std::atan2(c, half);
    const Eigen::Vector3d d1 = std::cos(turn) * form.d1 + std::sin(turn) * form.d2;
    form.d1 = d1;
    form.d2 = form.n.cross(d1);
    form.k1 = 0.5 * (1.0 + a + b) + std::hypot(half, c);
    form.k2 = 0.5 * (1.0 + a + b) - std::hypot(half, c);
    differences.push_back(SquaredDifference(clean.View(), p, form));
  }
  EXPECT_NEAR(CurvatureDeviation(mesh, differences), e, 0.06 * e);
}
