// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// The Monge form of a height jet over any plane against that of the implicit surface.

#include "Fixtures/MongeComparison.h"
#include "Fixtures/TestFields.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{

using namespace ridges;
using namespace ridges::testing;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// Some ten operations of round-off on values of size 1, magnified by frames whose height axis is
// tilted by up to 40 degrees, and by up to 1 / 0.1 from principal directions near an umbilic.
const double RoundOff = 1e-12;

// A direct frame whose height axis is `tilt` radians off the normal.
template <typename Generator>
Matrix3d TiltedFrame(const Vector3d& normal, double tilt, Generator& generator)
{
  const Vector3d axis = normal.cross(InBall(generator)).normalized();
  Matrix3d frame;
  frame.col(2) = Eigen::AngleAxisd(tilt, axis) * normal;
  frame.col(0) = frame.col(2).cross(InBall(generator)).normalized();
  frame.col(1) = frame.col(2).cross(frame.col(0));
  return frame;
}

// The jet of the height of the surface f = 0 over a plane through one of its points. Newton's
// method in Taylor arithmetic with a fixed slope: one more degree is exact after every step.
template <typename Formula>
HeightJet ExactHeightJet(const Formula& f, const Vector3d& point, const Matrix3d& frame)
{
  using Jet = Taylor3<4>;
  const auto at = [&](const Jet& w)
  {
    const Jet u = Jet::Linear(0.0, 1.0, 0.0, 0.0);
    const Jet v = Jet::Linear(0.0, 0.0, 1.0, 0.0);
    Jet x[3];
    for (int i = 0; i < 3; ++i)
    {
      x[i] = Jet(point[i]) + frame(i, 0) * u + frame(i, 1) * v + frame(i, 2) * w;
    }
    return f(x[0], x[1], x[2]);
  };
  const double slope = at(Jet::Linear(0.0, 0.0, 0.0, 1.0))(0, 0, 1);
  Jet w;
  for (int step = 0; step < 6; ++step)
  {
    w = w - at(w) / slope;
  }
  const double factorial[5] = { 1.0, 1.0, 2.0, 6.0, 24.0 };
  HeightJet jet;
  for (int i = 0; i <= 4; ++i)
  {
    for (int j = 0; i + j <= 4; ++j)
    {
      jet.derivatives[HeightJet::Index(i, j)] = factorial[i] * factorial[j] * w(i, j, 0);
    }
  }
  return jet;
}

} // namespace

//------------------------------------------------------------------------------
TEST(HeightJet, StandsByDegreeAndGrowingPowerOfTheSecondVariable)
{
  EXPECT_EQ(HeightJet::Size(0), 1);
  EXPECT_EQ(HeightJet::Size(2), 6);
  EXPECT_EQ(HeightJet::Size(4), HeightJet::MaximumSize);
  int next = 0;
  for (int degree = 0; degree <= HeightJet::MaximumDegree; ++degree)
  {
    for (int j = 0; j <= degree; ++j)
    {
      EXPECT_EQ(HeightJet::Index(degree - j, j), next++);
    }
  }
  HeightJet jet;
  jet.derivatives[HeightJet::Index(1, 2)] = 7.0;
  EXPECT_EQ(jet.Derivative(1, 2), 7.0);
  EXPECT_EQ(jet.Tensor(3)[2], 7.0);
}

//------------------------------------------------------------------------------
TEST(MongeForm, OfAJetInItsOwnFrameIsTheJet)
{
  HeightJet jet;
  jet.derivatives = { 0.0, 0.0, 0.0, 2.0, 0.0, -1.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0,
    11.0 };
  const MongeForm form = MongeFormOfHeightJet(jet, Matrix3d::Identity());
  EXPECT_NEAR(form.k1, 2.0, RoundOff);
  EXPECT_NEAR(form.k2, -1.0, RoundOff);
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(form.b[i], 3.0 + i, RoundOff);
  }
  for (int i = 0; i < 5; ++i)
  {
    EXPECT_NEAR(form.c[i], 7.0 + i, RoundOff);
  }
  // Equation (3) by hand: 3 * 16 + 3 * (7 - 3 * 8) and 3 * 25 - 3 * (11 + 3).
  EXPECT_NEAR(form.P1(), -3.0, 100.0 * RoundOff);
  EXPECT_NEAR(form.P2(), 33.0, 100.0 * RoundOff);
}

//------------------------------------------------------------------------------
TEST(MongeForm, OfRandomGraphsIsThatOfTheImplicitSurface)
{
  std::mt19937_64 generator(11);
  for (int trial = 0; trial < 200; ++trial)
  {
    HeightJet jet;
    for (double& derivative : jet.derivatives)
    {
      derivative = Symmetric(generator);
    }
    jet.derivatives[0] = 0.0;
    const ExactMonge exact = GraphSurface(jet).Monge(Vector3d::Zero());
    const Matrix3d frame = TiltedFrame(Vector3d::UnitZ(), 3.0 * Uniform(generator), generator);
    const MongeForm form = MongeFormOfHeightJet(jet, frame);
    // The principal directions, and with them b and c, are the less certain the nearer to an
    // umbilic.
    const double certainty = std::min(1.0, exact.k1 - exact.k2);
    EXPECT_LT(LargestDifference(form, ToMongeForm(exact), frame) * certainty, RoundOff)
      << "trial " << trial << ", slope " << std::hypot(jet.derivatives[1], jet.derivatives[2]);
  }
}

//------------------------------------------------------------------------------
TEST(MongeForm, OfATorusSeenFromATiltedFrameIsExact)
{
  const double R = 2.0;
  const double r = 0.8;
  const auto f = [=](auto x, auto y, auto z)
  {
    const auto q = x * x + y * y + z * z + (R * R - r * r);
    return q * q - 4.0 * R * R * (x * x + y * y);
  };
  const AnalyticSurface surface(f);
  std::mt19937_64 generator(12);
  for (int trial = 0; trial < 50; ++trial)
  {
    const double u = 6.3 * Uniform(generator);
    const double v = 6.3 * Uniform(generator);
    const double h = R + r * std::cos(v);
    const Vector3d point(h * std::cos(u), h * std::sin(u), r * std::sin(v));
    const ExactMonge exact = surface.Monge(point);
    const Matrix3d frame = TiltedFrame(exact.n, 0.7 * Uniform(generator), generator);
    const MongeForm form = MongeFormOfHeightJet(ExactHeightJet(f, point, frame), frame);
    // c reaches 10 here, and derivatives over a plane tilted by 40 degrees 1000.
    EXPECT_LT(LargestDifference(form, ToMongeForm(exact)), 100.0 * RoundOff) << "trial " << trial;
  }
}

//------------------------------------------------------------------------------
TEST(MongeForm, OfASphereSeenFromATiltedFrameIsExact)
{
  const double r = 1.3;
  const auto f = [r](auto x, auto y, auto z) { return x * x + y * y + z * z - r * r; };
  std::mt19937_64 generator(13);
  for (int trial = 0; trial < 50; ++trial)
  {
    const Vector3d normal = InBall(generator).normalized();
    const Matrix3d frame = TiltedFrame(normal, 0.7 * Uniform(generator), generator);
    const MongeForm form = MongeFormOfHeightJet(ExactHeightJet(f, r * normal, frame), frame);
    EXPECT_LT((form.n - normal).norm(), RoundOff);
    EXPECT_NEAR(form.d1.dot(form.d2), 0.0, RoundOff);
    EXPECT_NEAR(form.d1.cross(form.d2).dot(form.n), 1.0, RoundOff);
    // k1 - k2 is a square root's distance to the umbilic: still round-off here, as both of its
    // parts are differences of exact values. c as in the jet of the square root.
    EXPECT_NEAR(form.k1 * r, -1.0, 10.0 * RoundOff);
    EXPECT_NEAR(form.k2 * r, -1.0, 10.0 * RoundOff);
    const double c[5] = { -3.0, 0.0, -1.0, 0.0, -3.0 };
    for (int i = 0; i < 4; ++i)
    {
      EXPECT_NEAR(form.b[i] * r * r, 0.0, 100.0 * RoundOff);
    }
    for (int i = 0; i < 5; ++i)
    {
      EXPECT_NEAR(form.c[i] * std::pow(r, 3), c[i], 100.0 * RoundOff);
    }
  }
}

//------------------------------------------------------------------------------
TEST(MongeForm, FlippedIsTheFormOfTheOtherSide)
{
  std::mt19937_64 generator(14);
  for (int trial = 0; trial < 50; ++trial)
  {
    HeightJet jet;
    HeightJet below; // The same surface as a height over the frame (u, -v, -height).
    for (int i = 0; i <= 4; ++i)
    {
      for (int j = 0; i + j <= 4; ++j)
      {
        const double derivative = i + j > 0 ? Symmetric(generator) : 0.0;
        jet.derivatives[HeightJet::Index(i, j)] = derivative;
        below.derivatives[HeightJet::Index(i, j)] = j % 2 == 0 ? -derivative : derivative;
      }
    }
    const MongeForm above = MongeFormOfHeightJet(jet, Matrix3d::Identity());
    const MongeForm expected =
      MongeFormOfHeightJet(below, Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal());
    const MongeForm flipped = Flipped(above);
    const double certainty = std::min(1.0, above.k1 - above.k2);
    EXPECT_LT(LargestDifference(flipped, expected) * certainty, RoundOff);
    EXPECT_GE(flipped.k1, flipped.k2);
    EXPECT_NEAR(flipped.d1.cross(flipped.d2).dot(flipped.n), 1.0, RoundOff);
    EXPECT_NEAR(flipped.P1(), above.P2(), 100.0 * RoundOff);
    EXPECT_LT(LargestDifference(Flipped(flipped), above), RoundOff);
  }
}
