// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Formula/Lanes.h"
#include "Formula/Taylor3Functions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace ridges;

namespace
{

using Jet = Taylor3<4>;

// The greatest coefficient, whatever its degree.
double Greatest(const Jet& jet)
{
  double greatest = 0.0;
  for (const double coefficient : jet.Coefficients())
  {
    greatest = std::max(greatest, std::abs(coefficient));
  }
  return greatest;
}

} // namespace

TEST(Taylor3, ExponentialHasItsSeries)
{
  const Jet x = Jet::Linear(0.0, 1, 0, 0);
  const Jet y = Jet::Linear(0.0, 0, 1, 0);
  const Jet z = Jet::Linear(0.0, 0, 0, 1);
  const double factorial[5] = { 1, 1, 2, 6, 24 };
  const Jet e = exp(x + 2.0 * y - z);
  for (int i = 0; i <= 4; ++i)
  {
    for (int j = 0; i + j <= 4; ++j)
    {
      for (int k = 0; i + j + k <= 4; ++k)
      {
        const double expected =
          std::pow(2.0, j) * (k % 2 ? -1.0 : 1.0) / (factorial[i] * factorial[j] * factorial[k]);
        EXPECT_NEAR(e(i, j, k), expected, 1e-14 * std::abs(expected));
      }
    }
  }
}

// Identities between the functions, at a polynomial with terms of all degrees but the second power
// of x alone. The tolerance is some hundred rounding errors of coefficients up to about 100.
TEST(Taylor3, FunctionsSatisfyTheirIdentities)
{
  const Jet x = Jet::Linear(0.3, 1, 0, 0);
  const Jet y = Jet::Linear(-0.2, 0, 1, 0);
  const Jet z = Jet::Linear(0.1, 0, 0, 1);
  const Jet q = 0.5 + 0.3 * x - 0.4 * y * z + 0.2 * x * y + z * z * z + 0.5 * x * y * y * z;
  const Jet one(1.0);
  const Jet differences[] = {
    sqrt(q) * sqrt(q) - q,
    q / q - one,
    pow(q, 3) - q * q * q,
    pow(q, -0.5) * sqrt(q) - one,
    pow(q, -2) * q * q - one,
    cbrt(q) * cbrt(q) * cbrt(q) - q,
    cbrt(-q) + cbrt(q),
    log(exp(q)) - q,
    exp(log(q)) - q,
    sin(q) * sin(q) + cos(q) * cos(q) - one,
    sin(q + q) - 2.0 * (sin(q) * cos(q)),
    tan(q) - sin(q) / cos(q),
    cosh(q) + sinh(q) - exp(q),
    cosh(q) - sinh(q) - exp(-q),
    tanh(q) - sinh(q) / cosh(q),
    tan(atan(q)) - q,
    sin(asin(q)) - q,
    cos(acos(q)) - q,
  };
  for (std::size_t i = 0; i < std::size(differences); ++i)
  {
    EXPECT_LT(Greatest(differences[i]), 1e-13) << i;
  }
}

// What is known to be 0 is left out of products; the result must not depend on it.
TEST(Taylor3, KnowsItsDegree)
{
  const Jet x = Jet::Linear(0.5, 1, 0, 0);
  EXPECT_EQ(Jet(2.0).Top(), 0);
  EXPECT_EQ((x * x).Top(), 2);
  EXPECT_EQ((x * x * x * x * x).Top(), 4);
  EXPECT_EQ(exp(Jet(2.0)).Top(), 0);
  EXPECT_EQ(exp(x).Top(), 4);
  EXPECT_EQ((x / Jet(2.0)).Top(), 1);
  Jet full = x * x + 1.0;
  full.Set(0, 0, 4, 0.0);
  EXPECT_EQ(full.Top(), 4);
  EXPECT_EQ(Greatest(full * full - (x * x + 1.0) * (x * x + 1.0)), 0.0);
  EXPECT_EQ(Greatest(exp(full) - exp(x * x + 1.0)), 0.0);
}

TEST(Taylor3, EachLaneHasWhatADoubleWouldHave)
{
  using Wide = Taylor3<4, Lanes>;
  Lanes at;
  for (int lane = 0; lane < Lanes::Count; ++lane)
  {
    at[lane] = 0.3 + 0.1 * lane;
  }
  const auto f = [](const auto& x) { return exp(x * x) / sqrt(x + x) - sin(x) * log(x); };
  const Wide wide = f(Wide::Linear(at, 1.0, 0.5, -2.0));
  for (int lane = 0; lane < Lanes::Count; ++lane)
  {
    const Jet single = f(Jet::Linear(at[lane], 1.0, 0.5, -2.0));
    for (int i = 0; i < Jet::Size; ++i)
    {
      EXPECT_EQ(wide.Coefficients()[i][lane], single.Coefficients()[i]);
    }
  }
}
