// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// Length, strength and sharpness of ridges: closed forms on polylines.

#include "Ridges/RidgeMeasures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{

using namespace ridges;
using Eigen::Vector3d;
using Parts = std::vector<UmbilicCutOff::Part>;

const double RoundOff = 1e-14;

RidgePoint PointAt(double x, double curvature, double P, double gap)
{
  RidgePoint point{};
  point.position = Vector3d(x, 2.0 * x, 2.0 * x) / 3.0; // x is the arc length.
  point.curvature = curvature;
  point.P = P;
  point.gap = gap;
  return point;
}

Vector3d OnAxis(double x)
{
  return { x, 0.0, 0.0 };
}

void ExpectParts(const Parts& found, const Parts& expected)
{
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_NEAR(found[i].begin, expected[i].begin, RoundOff);
    EXPECT_NEAR(found[i].end, expected[i].end, RoundOff);
  }
}

} // namespace

//------------------------------------------------------------------------------
TEST(RidgeMeasures, OfConstantQuantitiesAreProducts)
{
  std::vector<RidgePoint> points;
  for (const double x : { 0.0, 0.5, 0.7, 2.0 })
  {
    points.push_back(PointAt(x, -3.0, -4.0, 0.5));
  }
  const RidgeMeasures measures = MeasureRidge(points, RidgeType::MaximumElliptic, {});
  EXPECT_NEAR(measures.length, 2.0, RoundOff);
  EXPECT_NEAR(measures.strength, 6.0, RoundOff);
  EXPECT_NEAR(measures.rawSharpness, 16.0, 10.0 * RoundOff);
}

//------------------------------------------------------------------------------
TEST(RidgeMeasures, OfFewPointsAreZero)
{
  for (const auto& points :
    { std::vector<RidgePoint>{}, std::vector<RidgePoint>{ PointAt(1.0, 1.0, 1.0, 1.0) } })
  {
    const RidgeMeasures measures = MeasureRidge(points, RidgeType::MinimumElliptic, {});
    EXPECT_EQ(measures.length, 0.0);
    EXPECT_EQ(measures.strength, 0.0);
    EXPECT_EQ(measures.rawSharpness, 0.0);
  }
}

//------------------------------------------------------------------------------
TEST(RidgeMeasures, StrengthOfALineThroughZeroIsThatOfTwoTriangles)
{
  // |k| for k from -1 to 3 over length 2: triangles of areas 1/4 and 9/4.
  const auto strength = [](double from, double to)
  {
    return MeasureRidge(
      { PointAt(0.0, from, 0.0, 1.0), PointAt(2.0, to, 0.0, 1.0) }, RidgeType::MaximumElliptic, {})
      .strength;
  };
  EXPECT_NEAR(strength(-1.0, 3.0), 2.5, RoundOff);
  EXPECT_NEAR(strength(3.0, -1.0), 2.5, RoundOff);
  EXPECT_NEAR(strength(0.0, 3.0), 3.0, RoundOff);
  EXPECT_NEAR(strength(-1.0, -3.0), 4.0, RoundOff);
  EXPECT_EQ(strength(0.0, 0.0), 0.0);
}

//------------------------------------------------------------------------------
TEST(RidgeMeasures, SharpnessOfAQuotientOfLinesIsItsIntegral)
{
  // P = 2 + 3 s and gap = 1 + s over length 1: 3 - log 2. Over one segment the rule of four points
  // has an error below 1e-6 of it; over ten segments round-off.
  const double exact = 3.0 - std::log(2.0);
  const auto sharpness = [](int segments)
  {
    std::vector<RidgePoint> points;
    for (int i = 0; i <= segments; ++i)
    {
      const double s = static_cast<double>(i) / segments;
      points.push_back(PointAt(s, 0.0, -(2.0 + 3.0 * s), 1.0 + s));
    }
    return MeasureRidge(points, RidgeType::MinimumElliptic, {}).rawSharpness;
  };
  EXPECT_NEAR(sharpness(1), exact, 1e-6);
  EXPECT_NEAR(sharpness(10), exact, 1e-13);
}

//------------------------------------------------------------------------------
TEST(RidgeMeasures, SharpnessNearAnUmbilicIsALogarithmFromTheCutOffOn)
{
  // The integrand 5 / x from a cut-off of 0.01 to 1. In steps that grow like x the quotient varies
  // by a factor of 1.5 per segment: the rule of four points has an error of 1e-8 there.
  std::vector<RidgePoint> points = { PointAt(0.0, 0.0, 5.0, 0.0) };
  for (double x = 0.004; x < 1.0; x *= 1.5)
  {
    points.push_back(PointAt(x, 0.0, 5.0, x));
  }
  points.push_back(PointAt(1.0, 0.0, 5.0, 1.0));
  const double exact = 5.0 * std::log(100.0);
  const UmbilicCutOff cutOff({ Vector3d::Zero() }, 0.01);
  EXPECT_NEAR(
    MeasureRidge(points, RidgeType::MaximumHyperbolic, cutOff).rawSharpness, exact, 1e-6 * exact);
  // Length and strength know no cut-off.
  EXPECT_NEAR(MeasureRidge(points, RidgeType::MaximumHyperbolic, cutOff).length, 1.0, RoundOff);

  // Sharpness of an elliptic ridge neither: balls on its way change nothing.
  for (RidgePoint& point : points)
  {
    point.gap = 2.0;
  }
  EXPECT_NEAR(MeasureRidge(points, RidgeType::MaximumElliptic, cutOff).rawSharpness, 2.5, 1e-13);
  EXPECT_NEAR(
    MeasureRidge(points, RidgeType::MaximumHyperbolic, cutOff).rawSharpness, 2.5 * 0.99, 1e-13);
}

//------------------------------------------------------------------------------
TEST(UmbilicCutOff, WithoutBallsLeavesOutNothing)
{
  ExpectParts(UmbilicCutOff().Outside(OnAxis(0), OnAxis(1)), { { 0.0, 1.0 } });
  ExpectParts(UmbilicCutOff({ OnAxis(0.5) }, 0.0).Outside(OnAxis(0), OnAxis(1)), { { 0.0, 1.0 } });
}

//------------------------------------------------------------------------------
TEST(UmbilicCutOff, CutsBallsOutOfASegment)
{
  const UmbilicCutOff inside({ OnAxis(4) }, 1.0);
  ExpectParts(inside.Outside(OnAxis(0), OnAxis(10)), { { 0.0, 0.3 }, { 0.5, 1.0 } });
  ExpectParts(inside.Outside(OnAxis(10), OnAxis(0)), { { 0.0, 0.5 }, { 0.7, 1.0 } });
  ExpectParts(inside.Outside(OnAxis(4), OnAxis(8)), { { 0.25, 1.0 } });
  ExpectParts(inside.Outside(OnAxis(3.5), OnAxis(4.5)), {});
  ExpectParts(inside.Outside(OnAxis(5.5), OnAxis(6.5)), { { 0.0, 1.0 } });
  // Off the segment by 0.6: a chord of 1.6.
  const UmbilicCutOff beside({ Vector3d(4, 0.6, 0) }, 1.0);
  ExpectParts(beside.Outside(OnAxis(0), OnAxis(10)), { { 0.0, 0.32 }, { 0.48, 1.0 } });
}

//------------------------------------------------------------------------------
TEST(UmbilicCutOff, JoinsOverlappingBalls)
{
  const UmbilicCutOff balls({ OnAxis(8), OnAxis(3), OnAxis(4.5), OnAxis(3.2) }, 1.0);
  ExpectParts(balls.Outside(OnAxis(0), OnAxis(10)), { { 0.0, 0.2 }, { 0.55, 0.7 }, { 0.9, 1.0 } });
  const UmbilicCutOff covered({ OnAxis(0), OnAxis(1.5), OnAxis(3) }, 1.0);
  ExpectParts(covered.Outside(OnAxis(0), OnAxis(3)), {});
}

//------------------------------------------------------------------------------
TEST(UmbilicCutOff, IsThatOfSampling)
{
  std::mt19937_64 generator(41);
  const auto random = [&generator]
  { return static_cast<double>(generator() >> 11) * 0x1p-52 - 1.0; };
  int cut = 0;
  for (int trial = 0; trial < 300; ++trial)
  {
    std::vector<Vector3d> centers;
    centers.reserve(6);
    for (int i = 0; i < 6; ++i)
    {
      centers.emplace_back(random(), random(), random());
    }
    const double radius = 0.1 + 0.2 * std::abs(random());
    const Vector3d a(random(), random(), random());
    const Vector3d b(random(), random(), random());
    const Parts parts = UmbilicCutOff(centers, radius).Outside(a, b);
    for (int i = 0; i <= 500; ++i)
    {
      const double s = i / 500.0;
      double distance = 10.0;
      for (const Vector3d& center : centers)
      {
        distance = std::min(distance, ((1.0 - s) * a + s * b - center).norm());
      }
      bool outside = false;
      for (const UmbilicCutOff::Part& part : parts)
      {
        outside |= part.begin <= s && s <= part.end;
      }
      if (std::abs(distance - radius) > 1e-9) // Else either answer is right.
      {
        ASSERT_EQ(outside, distance > radius) << "trial " << trial << " at " << s;
        cut += outside ? 0 : 1;
      }
    }
  }
  EXPECT_GT(cut, 1000);
}
