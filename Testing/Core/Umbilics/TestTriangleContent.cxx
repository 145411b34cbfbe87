// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// What corners tell of triangles, against those that have an index, are weak, or are crossed.

#include "Fixtures/EllipsoidFixture.h"

#include "Monge/AcuteRule.h"
#include "Monge/TamePoint.h"
#include "Umbilics/DirectionIndex.h"
#include "Umbilics/TriangleContent.h"

#include <gtest/gtest.h>

#include <vector>

using namespace ridges;
using namespace ridges::testing;

namespace
{

/// Triangles whose content is wrong; how many there are of each is added.
int CountWrong(const TriangleMesh& mesh, const MongeField& field, const FitErrorSource& errors,
  std::array<int, 3>& counts)
{
  constexpr double significance = 3.0;
  const TriangleContents contents(field, errors, significance, mesh.NumberOfPoints());
  const DirectionIndex index(mesh, field, nullptr);
  std::vector<double> gapErrors;
  std::vector<std::uint8_t> isTame;
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    gapErrors.push_back(GapError(mesh, errors, p));
    isTame.push_back(IsGentle(field, errors, p) || IsTame(mesh, field, p) ? 1 : 0);
  }
  int wrong = 0;
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const Triangle& c = mesh.Corners(t);
    const TriangleContent content = contents.At(c);
    ++counts[static_cast<std::size_t>(content)];
    bool isCrossed = false;
    for (int i = 0; i < 3; ++i)
    {
      isCrossed = isCrossed || IsCrossed(field, Color::Blue, c[i], c[(i + 1) % 3]) ||
        IsCrossed(field, Color::Red, c[i], c[(i + 1) % 3]);
    }
    const bool isUmbilic = (index.MayTurn(t, isTame) && index.HalfTurns(t) != 0) ||
      IsWeak(mesh, field, gapErrors.data(), significance, t);
    wrong += isUmbilic && content != TriangleContent::Umbilic ? 1 : 0;
    wrong += isCrossed && content == TriangleContent::Nothing ? 1 : 0;
  }
  return wrong;
}

} // namespace

// Of a clean mesh a small part, and less of a finer one.
TEST(TriangleContent, LeavesLittleOfACleanMesh)
{
  std::vector<double> shares;
  for (const int frequency : { 32, 63 })
  {
    const FittedEllipsoid& ellipsoid = FittedEllipsoid::OfFrequency(frequency);
    const Id points = ellipsoid.Triangles().NumberOfPoints();
    // Rounding is below these, and the radius is that of two rings.
    const std::vector<double> residual(points, 1e-9);
    const std::vector<double> scale(points, 2.0 * ellipsoid.meanEdge);
    FitErrorSource errors;
    errors.fitResidual = residual.data();
    errors.fitScale = scale.data();
    std::array<int, 3> counts{};
    EXPECT_EQ(CountWrong(ellipsoid.Triangles(), ellipsoid.field.View(), errors, counts), 0);
    EXPECT_GE(counts[2], 4);
    shares.push_back(
      1.0 - counts[0] / static_cast<double>(ellipsoid.Triangles().NumberOfTriangles()));
  }
  EXPECT_LT(shares[0], 0.08);
  EXPECT_LT(shares[1], 0.6 * shares[0]);
}

TEST(TriangleContent, MissesNothingInNoise)
{
  const FittedEllipsoid& ellipsoid = FittedEllipsoid::OfFrequency(32);
  const TriangleMesh& mesh = ellipsoid.Triangles();
  const Id points = mesh.NumberOfPoints();
  const std::vector<double> scale(points, 2.0 * ellipsoid.meanEdge);
  for (const double height : { 1e-6, 1e-4, 1e-2 })
  {
    const std::vector<double> residual(points, height);
    FitErrorSource errors;
    errors.fitResidual = residual.data();
    errors.fitScale = scale.data();
    std::array<int, 3> counts{};
    EXPECT_EQ(CountWrong(mesh, ellipsoid.field.View(), errors, counts), 0) << height;
    EXPECT_EQ(CountWrong(mesh, RandomField(mesh, 3).View(), errors, counts), 0) << height;
  }
  // Standard errors, instead of residuals.
  const std::vector<double> curvatureErrors(points, 0.02);
  const std::vector<double> residual(points, 1e-9);
  FitErrorSource errors;
  errors.fitResidual = residual.data();
  errors.fitScale = scale.data();
  errors.maximumCurvatureError = curvatureErrors.data();
  errors.minimumCurvatureError = curvatureErrors.data();
  std::array<int, 3> counts{};
  EXPECT_EQ(CountWrong(mesh, ellipsoid.field.View(), errors, counts), 0);
  EXPECT_GT(counts[0], mesh.NumberOfTriangles() / 2);
}
