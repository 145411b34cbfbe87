// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fixtures/TestFields.h"
#include "ParametricMesh.h"

#include "Mesh/CoordinateRounding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace ridges;
using namespace ridges::testing;

namespace
{

CoordinateRounding RoundingOf(const std::vector<double>& coordinates)
{
  CoordinateRounding rounding;
  for (const double x : coordinates)
  {
    rounding.Include(x);
  }
  return rounding;
}

} // namespace

TEST(CoordinateRounding, IsThatOfTheCoarsestTypeThatHoldsAllCoordinates)
{
  const MeshedSurface exact(Icosphere(3));
  const MeshedSurface rounded(RoundToSingle(Icosphere(3)));
  const CoordinateRounding ofExact = FindCoordinateRounding(exact.Triangles());
  const CoordinateRounding ofRounded = FindCoordinateRounding(rounded.Triangles());
  EXPECT_EQ(ofExact.OfPrecision(), 0.5 * std::numeric_limits<double>::epsilon());
  EXPECT_EQ(ofRounded.OfPrecision(), 0.5 * std::numeric_limits<float>::epsilon());
  EXPECT_EQ(ofExact.digits, CoordinateRounding::NotDecimal);
  EXPECT_EQ(ofRounded.digits, CoordinateRounding::NotDecimal);
  EXPECT_EQ(ofExact.OfDigits(1.0), 0.0);
}

TEST(CoordinateRounding, FindsDigitsOfTextInBothPrecisions)
{
  for (const int digits : { 5, 6, 7, 8, 9 })
  {
    const Mesh written = RoundToDigits(EllipsoidMesh(3, 271.8, 1.0, 0.6), digits);
    const CoordinateRounding inDouble = RoundingOf(written.points);
    const CoordinateRounding inSingle = RoundingOf(RoundToSingle(written).points);
    EXPECT_EQ(inDouble.digits, digits);
    // Single precision itself has hardly more than seven.
    EXPECT_EQ(inSingle.digits, digits <= 6 ? digits : CoordinateRounding::NotDecimal);
    EXPECT_TRUE(inSingle.isSingle);
  }
}

TEST(CoordinateRounding, OfDigitsIsThatOfAStepAtTheCoordinate)
{
  const CoordinateRounding rounding = RoundingOf({ 0.0, 123.456, -2.83277e-16 });
  EXPECT_EQ(rounding.digits, 6);
  EXPECT_NEAR(rounding.OfDigits(-123.0), 1e-3 / std::sqrt(12.0), 1e-9);
  EXPECT_NEAR(rounding.OfDigits(1000.0), 1e-2 / std::sqrt(12.0), 1e-8);
  EXPECT_NEAR(rounding.OfDigits(0.999), 1e-6 / std::sqrt(12.0), 1e-12);
  EXPECT_EQ(rounding.OfDigits(0.0), 0.0);
}

TEST(CoordinateRounding, FewDigitsCountAsMeant)
{
  EXPECT_EQ(RoundingOf({ 17.25, 3.0, 511.5 }).OfDigits(100.0), 0.0);
  EXPECT_EQ(RoundingOf({}).OfDigits(1.0), 0.0);
}

TEST(CoordinateRounding, OfPartsIsThatOfAllTogether)
{
  // The least of the roundings of parts would be wrong: one is single, the other of few digits.
  const std::vector<double> single{ static_cast<float>(0.1234567), 3.0 };
  const std::vector<double> decimal{ 0.123456 };
  std::vector<double> all = single;
  all.insert(all.end(), decimal.begin(), decimal.end());
  const CoordinateRounding together = RoundingOf(single).Include(RoundingOf(decimal));
  EXPECT_EQ(together.isSingle, RoundingOf(all).isSingle);
  EXPECT_EQ(together.digits, RoundingOf(all).digits);
  EXPECT_FALSE(together.isSingle);
}
