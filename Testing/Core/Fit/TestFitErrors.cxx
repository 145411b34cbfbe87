// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Fixtures/TestFields.h"

#include "Fit/FitErrors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{

using namespace ridges;
using namespace ridges::testing;

} // namespace

//------------------------------------------------------------------------------
TEST(GapError, IsThatOfTheTwoCurvaturesTogether)
{
  const MeshedSurface surface(Icosphere(2));
  const TriangleMesh& mesh = surface.Triangles();
  const std::vector<double> error1(mesh.NumberOfPoints(), 3.0);
  const std::vector<double> error2(mesh.NumberOfPoints(), 4.0);
  const std::vector<double> other(mesh.NumberOfPoints(), 17.0);
  FitErrorSource source;
  source.maximumCurvatureError = error1.data();
  source.minimumCurvatureError = error2.data();
  EXPECT_EQ(GapError(mesh, source, 5), 5.0);
  source.fitResidual = other.data();
  source.fitScale = other.data();
  EXPECT_EQ(GapError(mesh, source, 5), 5.0); // Standard errors come first.
}

//------------------------------------------------------------------------------
TEST(GapError, OfResidualsIsTheirMeanSquareAround)
{
  const MeshedSurface surface(Icosphere(4));
  const TriangleMesh& mesh = surface.Triangles();
  std::vector<double> residual(mesh.NumberOfPoints(), 1e-3);
  std::vector<double> scale(mesh.NumberOfPoints(), 0.5);
  FitErrorSource source;
  source.fitResidual = residual.data();
  EXPECT_EQ(GapError(mesh, source, 5), 0.0); // Nothing is known without the scale.
  source.fitScale = scale.data();
  const double even = GapError(mesh, source, 5);
  EXPECT_GT(even, 0.0);
  for (double& value : residual)
  {
    value *= 2.0;
  }
  EXPECT_NEAR(GapError(mesh, source, 5), 2.0 * even, 1e-14); // Round-off.
  for (double& value : scale)
  {
    value *= 4.0;
  }
  // A curvature is one over a length, and a fit over more points is better.
  const double wide = GapError(mesh, source, 5);
  EXPECT_LT(wide, 0.5 * even);

  // One lucky fit says little.
  residual[5] = 0.0;
  EXPECT_GT(GapError(mesh, source, 5), 0.5 * wide);
  EXPECT_LT(GapError(mesh, source, 5), wide);
}

//------------------------------------------------------------------------------
TEST(GapError, OfAnExactFitIsRounding)
{
  const MeshedSurface surface(Icosphere(2));
  const TriangleMesh& mesh = surface.Triangles();
  const std::vector<double> residual(mesh.NumberOfPoints(), 0.0);
  std::vector<double> scale(mesh.NumberOfPoints(), 1e-3);
  FitErrorSource source;
  source.fitResidual = residual.data();
  source.fitScale = scale.data();
  EXPECT_GT(GapError(mesh, source, 3), 0.0);
  EXPECT_LT(GapError(mesh, source, 3), 1e-6 / 1e-3);
  scale.assign(scale.size(), 0.0); // No fit at all.
  EXPECT_EQ(GapError(mesh, source, 3), 0.0);
}

//------------------------------------------------------------------------------
TEST(ExtremalityError, TakesTheComponentOfTheColor)
{
  const MeshedSurface surface(Icosphere(2));
  const TriangleMesh& mesh = surface.Triangles();
  std::vector<double> errors(4 * static_cast<std::size_t>(mesh.NumberOfPoints()));
  for (std::size_t i = 0; i < errors.size(); ++i)
  {
    errors[i] = static_cast<double>(i);
  }
  FitErrorSource source;
  EXPECT_EQ(ExtremalityError(mesh, source, Color::Blue, 7), 0.0);
  source.thirdOrderError = errors.data();
  EXPECT_EQ(ExtremalityError(mesh, source, Color::Blue, 7), 28.0);
  EXPECT_EQ(ExtremalityError(mesh, source, Color::Red, 7), 31.0);
}

//------------------------------------------------------------------------------
TEST(MayBeWeak, MissesNoTriangleThatIsWeakByItsOwnResiduals)
{
  const MeshedSurface surface(Icosphere(4));
  const TriangleMesh& mesh = surface.Triangles();
  FieldArrays field(mesh.NumberOfPoints());
  const std::vector<double> residual(mesh.NumberOfPoints(), 1e-3);
  const std::vector<double> scale(mesh.NumberOfPoints(), 0.5);
  FitErrorSource source;
  source.fitResidual = residual.data();
  source.fitScale = scale.data();
  const double error = GapError(mesh, source, 5);
  field.k1[5] = 3.0 * error;
  EXPECT_TRUE(MayBeWeak(field.View(), source, 3.0, 5));
  field.k1[5] = 1000.0 * error;
  EXPECT_FALSE(MayBeWeak(field.View(), source, 3.0, 5));
  EXPECT_TRUE(MayBeWeak(field.View(), FitErrorSource(), 3.0, 5));
}

//------------------------------------------------------------------------------
TEST(IsGentle, MeasuresSlopesWithinTheFittingRadius)
{
  FieldArrays field(1);
  const double residual = 1e-3;
  const double scale = 0.5;
  FitErrorSource source;
  EXPECT_FALSE(IsGentle(field.View(), source, 0)); // Nothing is known.
  source.fitResidual = &residual;
  source.fitScale = &scale;
  EXPECT_TRUE(IsGentle(field.View(), source, 0));
  field.k2[0] = -0.9; // A slope of 0.45.
  EXPECT_FALSE(IsGentle(field.View(), source, 0));
  field.k2[0] = 0.0;
  field.b[2] = 2.0; // A slope of 0.5.
  EXPECT_FALSE(IsGentle(field.View(), source, 0));
  field.b[2] = 0.0;
  const double noise = 0.1;
  source.fitResidual = &noise;
  EXPECT_FALSE(IsGentle(field.View(), source, 0));
}

//------------------------------------------------------------------------------
TEST(IsWeak, ComparesTheMeanGapWithItsError)
{
  const MeshedSurface surface(Icosphere(2));
  const TriangleMesh& mesh = surface.Triangles();
  FieldArrays field(mesh.NumberOfPoints());
  std::vector<double> errors(mesh.NumberOfPoints(), 0.25);
  const Triangle& corners = mesh.Corners(11);
  for (int i = 0; i < 3; ++i)
  {
    field.k1[corners[i]] = 1.0 + i; // Gaps of 1, 2 and 3: 8 errors on average.
  }
  EXPECT_FALSE(IsWeak(mesh, field.View(), errors.data(), 7.9, 11));
  EXPECT_TRUE(IsWeak(mesh, field.View(), errors.data(), 8.1, 11));
  EXPECT_FALSE(IsWeak(mesh, field.View(), errors.data(), 0.0, 11));
  errors.assign(errors.size(), 0.0); // Nothing is known: directions are believed.
  EXPECT_FALSE(IsWeak(mesh, field.View(), errors.data(), 100.0, 11));
}
