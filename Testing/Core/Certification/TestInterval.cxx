// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Certification/Interval.h"

#include <gtest/gtest.h>

#include <cmath>

using ridges::Interval;

namespace
{

bool Contains(const Interval& a, double x)
{
  return a.lower() <= x && x <= a.upper();
}

} // namespace

TEST(Interval, ContainsSumsThatRoundOff)
{
  // 0.1 added ten times is not 1 in floating point; the exact sum of ten doubles 0.1 is above 1.
  Interval sum(0.0);
  for (int i = 0; i < 10; ++i)
  {
    sum += Interval(0.1);
  }
  EXPECT_LT(sum.lower(), 1.0);
  EXPECT_GT(sum.upper(), 1.0);
  EXPECT_LT(sum.upper() - sum.lower(), 1e-14);
}

TEST(Interval, ContainsAllValuesOfElementaryFunctions)
{
  const Interval a(0.3, 0.4);
  for (const double x : { 0.3, 0.33, 0.37, 0.4 })
  {
    EXPECT_TRUE(Contains(exp(a), std::exp(x)));
    EXPECT_TRUE(Contains(log(a), std::log(x)));
    EXPECT_TRUE(Contains(sqrt(a), std::sqrt(x)));
    EXPECT_TRUE(Contains(cbrt(a), std::cbrt(x)));
    EXPECT_TRUE(Contains(pow(a, 1.7), std::pow(x, 1.7)));
    EXPECT_TRUE(Contains(sin(a), std::sin(x)));
    EXPECT_TRUE(Contains(cos(a), std::cos(x)));
    EXPECT_TRUE(Contains(tan(a), std::tan(x)));
    EXPECT_TRUE(Contains(asin(a), std::asin(x)));
    EXPECT_TRUE(Contains(acos(a), std::acos(x)));
    EXPECT_TRUE(Contains(atan(a), std::atan(x)));
    EXPECT_TRUE(Contains(sinh(a), std::sinh(x)));
    EXPECT_TRUE(Contains(cosh(a), std::cosh(x)));
    EXPECT_TRUE(Contains(tanh(a), std::tanh(x)));
  }
  EXPECT_TRUE(Contains(sin(Interval(1.0, 2.0)), 1.0)); // its maximum, between the ends
  EXPECT_TRUE(Contains(cos(Interval(3.0, 4.0)), -1.0));
}

TEST(Interval, IsWholeWhereNothingIsKnown)
{
  const double huge = 1e308;
  EXPECT_FALSE(HasSign(Interval(1.0) / Interval(-1.0, 1.0)));
  EXPECT_FALSE(HasSign(log(Interval(-2.0, -1.0))));
  EXPECT_FALSE(HasSign(Interval(huge) * Interval(huge) - Interval(huge) * Interval(huge)));
  EXPECT_FALSE(HasSign(Interval::whole() * Interval(0.0)));
}
