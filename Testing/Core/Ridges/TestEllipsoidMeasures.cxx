// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// Length, strength and sharpness of the ridges of the ellipsoid against quadrature over the exact
// ridges, with the sharpness of hyperbolic ridges cut off at 1% of the model size.

#include "Fixtures/EllipsoidFixture.h"

#include "Monge/AcuteRule.h"
#include "Ridges/RidgeMeasures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace
{

using namespace ridges;
using namespace ridges::testing;

const double CutOff = 0.01;
const char* const TypeNames[5] = { "", "blue elliptic", "blue hyperbolic", "red elliptic",
  "red hyperbolic" };
const char* const MeasureNames[3] = { "length", "strength", "sharpness" };

struct Errors
{
  RidgeType type;
  std::array<double, 3> relative; // Of length, strength, sharpness.
  int count;                      // Ridges of the type: of these the worst.
};

Errors Compare(const EllipsoidRidgePiece& piece, int frequency)
{
  const FittedEllipsoid& ellipsoid = FittedEllipsoid::OfFrequency(frequency);
  const TriangleMesh& mesh = ellipsoid.Triangles();
  const MongeField field = ellipsoid.field.View();
  const auto type = static_cast<RidgeType>(piece.type);
  const Color color = piece.type <= MaximumHyperbolic ? Color::Blue : Color::Red;
  const auto exactUmbilics =
    EllipsoidUmbilics(EllipsoidAxes[0], EllipsoidAxes[1], EllipsoidAxes[2]);

  const auto segments = MarchMesh(mesh, field, color, TypeRule::FourthOrder);
  std::vector<Eigen::Vector3d> umbilics;
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    if (!IsRegular(mesh, field, t))
    {
      umbilics.push_back(UmbilicInTriangle(mesh, field, t));
    }
  }
  EXPECT_EQ(umbilics.size(), exactUmbilics.size());
  const UmbilicCutOff cutOff(umbilics, CutOff * EllipsoidAxes[0]);

  Errors errors{ type, { 0.0, 0.0, 0.0 }, 0 };
  for (const Ridge& ridge : AssembleMesh(mesh, field, color, segments))
  {
    if (segments[ridge.segments[ridge.segments.size() / 2]].type != type)
    {
      continue;
    }
    ++errors.count;
    const RidgeMeasures found = MeasureRidge(PointsOf(mesh, field, color, ridge), type, cutOff);
    const double modelSize = EllipsoidAxes[0];
    const double relative[3] = { found.length / piece.length - 1.0,
      found.strength / piece.strength - 1.0,
      found.rawSharpness * modelSize * modelSize / piece.sharpness - 1.0 };
    for (int i = 0; i < 3; ++i)
    {
      if (std::abs(relative[i]) > std::abs(errors.relative[i]))
      {
        errors.relative[i] = relative[i];
      }
    }
  }
  return errors;
}

} // namespace

//------------------------------------------------------------------------------
TEST(EllipsoidMeasures, ConvergeToTheExactIntegrals)
{
  // One piece of each type: the two hyperbolic ones of a colour are mirror images.
  std::vector<EllipsoidRidgePiece> pieces =
    EllipsoidRidgeIntegrals(EllipsoidAxes[0], EllipsoidAxes[1], EllipsoidAxes[2], CutOff);
  ASSERT_EQ(pieces.size(), 6u);
  std::sort(pieces.begin(), pieces.end(),
    [](const EllipsoidRidgePiece& p, const EllipsoidRidgePiece& q) { return p.type < q.type; });

  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    if (i > 0 && pieces[i].type == pieces[i - 1].type)
    {
      continue;
    }
    std::array<Errors, 4> bySize{};
    const int frequencies[4] = { 32, 45, 63, 89 };
    for (int size = 0; size < 4; ++size)
    {
      bySize[size] = Compare(pieces[i], frequencies[size]);
      EXPECT_EQ(bySize[size].count, pieces[i].closed ? 1 : 2);
    }
    for (int measure = 0; measure < 3; ++measure)
    {
      std::printf("%-16s%-10s relative errors at 10k, 20k, 40k, 80k:", TypeNames[pieces[i].type],
        MeasureNames[measure]);
      for (const Errors& errors : bySize)
      {
        std::printf(" %+.2e", errors.relative[measure]);
      }
      std::printf("\n");
      const auto error = [&](int size) { return std::abs(bySize[size].relative[measure]); };
      EXPECT_LT(error(2), 0.02) << TypeNames[pieces[i].type] << " " << MeasureNames[measure];
      // Converges: twice the points, or thrice, make a smaller error, unless it is tiny already.
      EXPECT_LT(error(3), std::max(0.75 * error(0), 1e-4))
        << TypeNames[pieces[i].type] << " " << MeasureNames[measure];
    }
  }
}
