// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// Fits to points of polynomial graphs, which a fit of their degree has to reproduce.

#include "Fixtures/MongeComparison.h"
#include "Fixtures/TestFields.h"

#include "Fit/JetFit.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace
{

using namespace ridges;
using namespace ridges::testing;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

// Relative round-off of a fit: that of the heights, 1e-16, times a condition number of about 100
// and the 4th power of the inverse radius (here 0.5 to 1, so at most 16), times some safety.
const double FitRoundOff = 1e-9;

double Height(const HeightJet& jet, double x, double y)
{
  const double factorial[5] = { 1.0, 1.0, 2.0, 6.0, 24.0 };
  double z = 0.0;
  for (int i = 0; i <= 4; ++i)
  {
    for (int j = 0; i + j <= 4; ++j)
    {
      z += jet.Derivative(i, j) / (factorial[i] * factorial[j]) * std::pow(x, i) * std::pow(y, j);
    }
  }
  return z;
}

// Terms of degree 5 and more, which the Monge form does not know.
struct HigherTerm
{
  int i;
  int j;
  double coefficient;
};

struct GraphSample
{
  HeightJet jet;
  Matrix3Xd offsets;
};

// The origin and random points of the graph of a random polynomial. A fit takes its heights along
// the direction of least spread, and only over a plane orthogonal to z is the graph a polynomial:
// the linear terms are chosen so that heights are not correlated with x and y, which makes z an
// axis of the spread. The slope at the origin comes from the cubic terms and stays arbitrary.
template <typename Generator>
GraphSample RandomGraph(int degree, int count, Generator& generator)
{
  GraphSample sample;
  std::vector<HigherTerm> higher;
  for (int d = 5; d <= degree; ++d)
  {
    for (int j = 0; j <= d; ++j)
    {
      higher.push_back({ d - j, j, 0.1 * Symmetric(generator) });
    }
  }
  for (int d = 2; d <= std::min(degree, HeightJet::MaximumDegree); ++d)
  {
    for (int j = 0; j <= d; ++j)
    {
      sample.jet.derivatives[HeightJet::Index(d - j, j)] = 0.5 * d * Symmetric(generator);
    }
  }
  sample.offsets.setZero(3, count);
  for (int i = 1; i < count; ++i)
  {
    const Vector3d inBall = 0.8 * InBall(generator);
    sample.offsets.col(i).head<2>() = inBall.head<2>();
    const double x = inBall[0];
    const double y = inBall[1];
    sample.offsets(2, i) = Height(sample.jet, x, y);
    for (const HigherTerm& term : higher)
    {
      sample.offsets(2, i) += term.coefficient * std::pow(x, term.i) * std::pow(y, term.j);
    }
  }
  const Matrix3Xd centered = sample.offsets.colwise() - sample.offsets.rowwise().mean().eval();
  const Eigen::Matrix3d covariance = centered * centered.transpose();
  const Eigen::Vector2d slope =
    covariance.topLeftCorner<2, 2>().inverse() * covariance.topRightCorner<2, 1>();
  sample.offsets.row(2) -= slope.transpose() * sample.offsets.topRows<2>();
  sample.jet.derivatives[HeightJet::Index(1, 0)] = -slope[0];
  sample.jet.derivatives[HeightJet::Index(0, 1)] = -slope[1];
  return sample;
}

MongeForm FormOf(const JetFit& fit)
{
  return MongeFormOfHeightJet(fit.jet, fit.frame);
}

// Scaled by s, curvatures of a surface are divided by s, b by s^2 and c by s^3.
MongeForm Scaled(MongeForm form, double s)
{
  form.k1 /= s;
  form.k2 /= s;
  std::for_each(form.b.begin(), form.b.end(), [s](double& b) { b /= s * s; });
  std::for_each(form.c.begin(), form.c.end(), [s](double& c) { c /= s * s * s; });
  return form;
}

} // namespace

//------------------------------------------------------------------------------
TEST(JetFit, RecoversPolynomialsOfItsDegree)
{
  std::mt19937_64 generator(21);
  JetFitter fitter;
  for (int trial = 0; trial < 200; ++trial)
  {
    const int degree = 2 + trial % 3;
    const int count = 30 + static_cast<int>(31 * Uniform(generator));
    const GraphSample sample = RandomGraph(degree, count, generator);
    const ExactMonge exact = GraphSurface(sample.jet).Monge(Vector3d::Zero());
    for (int fitted = degree; fitted <= 4; ++fitted)
    {
      const JetFit fit = fitter.Fit(sample.offsets, fitted, Vector3d(0.3, 0.2, 1.0));
      ASSERT_EQ(fit.status, FitGood);
      EXPECT_EQ(fit.degree, fitted);
      EXPECT_EQ(fit.rank, HeightJet::Size(fitted));
      EXPECT_LT(fit.conditionNumber, 1e4); // Points in general position: some 10 to 1000.
      EXPECT_LT(fit.residual, 1e-13);      // Round-off in units of the radius.
      EXPECT_NEAR(fit.radius, sample.offsets.colwise().norm().maxCoeff(), 1e-15);
      // Principal directions turn by the error of the fit divided by k1 - k2.
      const double certainty = std::min(1.0, exact.k1 - exact.k2);
      EXPECT_LT(LargestDifference(FormOf(fit), ToMongeForm(exact)) * certainty, FitRoundOff)
        << "trial " << trial << " degree " << degree << " fitted " << fitted;
    }
  }
}

//------------------------------------------------------------------------------
TEST(JetFit, RecoversPolynomialsOfHighDegree)
{
  std::mt19937_64 generator(23);
  JetFitter fitter;
  for (int trial = 0; trial < 40; ++trial)
  {
    const int degree = 5 + trial % 4;
    const GraphSample sample = RandomGraph(degree, 3 * HeightJet::Size(degree), generator);
    const ExactMonge exact = GraphSurface(sample.jet).Monge(Vector3d::Zero());
    for (int fitted = degree; fitted <= JetFitter::MaximumDegree; ++fitted)
    {
      const JetFit fit = fitter.Fit(sample.offsets, fitted, Vector3d(0.3, 0.2, 1.0));
      ASSERT_EQ(fit.status, FitGood);
      EXPECT_EQ(fit.degree, fitted);
      EXPECT_EQ(fit.rank, HeightJet::Size(fitted));
      EXPECT_LT(fit.conditionNumber, 2e3); // Of orthonormal polynomials: some 10 to 100.
      EXPECT_LT(fit.residual, 1e-13);
      const double certainty = std::min(1.0, exact.k1 - exact.k2);
      EXPECT_LT(LargestDifference(FormOf(fit), ToMongeForm(exact)) * certainty, FitRoundOff)
        << "trial " << trial << " degree " << degree << " fitted " << fitted;
    }
  }
}

//------------------------------------------------------------------------------
TEST(JetFit, FollowsRigidMotionsAndScale)
{
  std::mt19937_64 generator(22);
  JetFitter fitter;
  for (const double scale : { 1e-9, 0.01, 1.0, 300.0, 1e12 })
  {
    for (int trial = 0; trial < 20; ++trial)
    {
      const GraphSample sample = RandomGraph(4, 40, generator);
      const ExactMonge exact = GraphSurface(sample.jet).Monge(Vector3d::Zero());
      const Matrix3d turn =
        Eigen::AngleAxisd(3.0 * Uniform(generator), InBall(generator).normalized())
          .toRotationMatrix();
      // A translation has its round-off, 1e-16 of its size: it is to be seen as an offset again.
      const Vector3d center = scale * InBall(generator);
      const Matrix3Xd points = (scale * turn * sample.offsets).colwise() + center;
      const JetFit fit = fitter.Fit(points.colwise() - center, 4, turn * Vector3d::UnitZ());
      ASSERT_EQ(fit.status, FitGood);
      const double certainty = std::min(1.0, exact.k1 - exact.k2);
      EXPECT_LT(
        LargestDifference(Scaled(FormOf(fit), 1.0 / scale), ToMongeForm(exact), turn) * certainty,
        FitRoundOff)
        << "scale " << scale << " trial " << trial;
    }
  }
}

//------------------------------------------------------------------------------
TEST(JetFit, OfDegreeOneIsThePlane)
{
  std::mt19937_64 generator(23);
  const Matrix3d turn = GenericRotation();
  Matrix3Xd offsets = Matrix3Xd::Zero(3, 30);
  for (int i = 1; i < 30; ++i)
  {
    offsets.col(i).head<2>() = InBall(generator).head<2>();
  }
  JetFitter fitter;
  const JetFit fit = fitter.Fit(turn * offsets, 1, turn.col(2));
  EXPECT_EQ(fit.status, FitGood);
  EXPECT_EQ(fit.degree, 1);
  const MongeForm form = FormOf(fit);
  EXPECT_LT((form.n - turn.col(2)).norm(), 1e-14);
  EXPECT_EQ(form.k1, 0.0);
  EXPECT_EQ(form.k2, 0.0);
}

//------------------------------------------------------------------------------
TEST(JetFit, LowersItsDegreeToWhatThePointsAllow)
{
  std::mt19937_64 generator(24);
  JetFitter fitter;
  for (int count = 1; count <= 16; ++count)
  {
    Matrix3Xd offsets = Matrix3Xd::Zero(3, count);
    for (int i = 1; i < count; ++i)
    {
      offsets.col(i) = InBall(generator);
      offsets(2, i) *= 0.1;
    }
    const int degree = count >= 15 ? 4 : count >= 10 ? 3 : count >= 6 ? 2 : count >= 3 ? 1 : 0;
    const JetFit fit = fitter.Fit(offsets, 4, Vector3d::UnitZ());
    EXPECT_EQ(fit.degree, degree) << count << " points";
    EXPECT_EQ((fit.status & FitTooFewPoints) != 0, degree < 4) << count << " points";
    EXPECT_EQ((fit.status & FitInvalid) != 0, degree == 0) << count << " points";
    if (degree > 0)
    {
      // The same as if that degree had been asked for.
      const JetFit same = fitter.Fit(offsets, degree, Vector3d::UnitZ());
      EXPECT_EQ(fit.jet.derivatives, same.jet.derivatives);
      EXPECT_EQ(same.status & FitTooFewPoints, 0);
    }
  }
}

//------------------------------------------------------------------------------
TEST(JetFit, OfPointsOnALineOrAtOnePlaceIsInvalid)
{
  JetFitter fitter;
  Matrix3Xd offsets(3, 20);
  for (int i = 0; i < 20; ++i)
  {
    offsets.col(i) = 0.1 * i * Vector3d(1.0, 2.0, -0.5);
  }
  for (const JetFit& fit : { fitter.Fit(offsets, 4, Vector3d::UnitZ()),
         fitter.Fit(Matrix3Xd::Zero(3, 20), 4, Vector3d::UnitZ()) })
  {
    EXPECT_TRUE(fit.status & FitInvalid);
    EXPECT_EQ(fit.degree, 0);
    for (const double derivative : fit.jet.derivatives)
    {
      EXPECT_EQ(derivative, 0.0);
    }
  }
}

//------------------------------------------------------------------------------
TEST(JetFit, OfNonFinitePointsIsInvalid)
{
  std::mt19937_64 generator(25);
  JetFitter fitter;
  for (const double bad : { std::nan(""), HUGE_VAL })
  {
    Matrix3Xd offsets = RandomGraph(4, 30, generator).offsets;
    offsets(1, 7) = bad;
    EXPECT_TRUE(fitter.Fit(offsets, 4, Vector3d::UnitZ()).status & FitInvalid);
  }
}

//------------------------------------------------------------------------------
TEST(JetFit, OfPointsOnAConicIsIllConditioned)
{
  // 29 points of a circle through the vertex, evenly spread so that z is an axis of their spread:
  // the circle's equation times any polynomial can be added to the height.
  Matrix3Xd offsets = Matrix3Xd::Zero(3, 29);
  for (int i = 1; i < 29; ++i)
  {
    const double angle = 2.0 * i * std::acos(-1.0) / 29.0;
    const double x = std::cos(angle);
    const double y = std::sin(angle);
    offsets.col(i) << x - 1.0, y, 0.1 * x * y;
  }
  JetFitter fitter;
  for (int degree = 2; degree <= 4; ++degree)
  {
    const JetFit fit = fitter.Fit(offsets, degree, Vector3d::UnitZ());
    EXPECT_TRUE(fit.status & FitIllConditioned) << degree;
    EXPECT_LT(fit.rank, HeightJet::Size(degree)) << degree;
    EXPECT_FALSE(fit.status & FitInvalid) << degree;
  }
  EXPECT_EQ(fitter.Fit(offsets, 1, Vector3d::UnitZ()).status, FitGood);
}

//------------------------------------------------------------------------------
TEST(JetFit, CountsRepeatedPointsOnlyOnce)
{
  std::mt19937_64 generator(26);
  JetFitter fitter;
  const GraphSample sample = RandomGraph(4, 20, generator);
  Matrix3Xd twice(3, 40);
  twice << sample.offsets, sample.offsets;
  const JetFit fit = fitter.Fit(twice, 4, Vector3d::UnitZ());
  EXPECT_EQ(fit.status, FitGood);
  const ExactMonge exact = GraphSurface(sample.jet).Monge(Vector3d::Zero());
  const double certainty = std::min(1.0, exact.k1 - exact.k2);
  // 20 points leave only 5 over: a condition number of up to 1e4.
  EXPECT_LT(LargestDifference(FormOf(fit), ToMongeForm(exact)) * certainty, 100.0 * FitRoundOff);

  // Ten places, however often they are taken, do not determine 15 coefficients.
  Matrix3Xd few(3, 40);
  const Matrix3Xd places = sample.offsets.leftCols(10);
  few << places, places, places, places;
  EXPECT_TRUE(fitter.Fit(few, 4, Vector3d::UnitZ()).status & FitIllConditioned);
}

//------------------------------------------------------------------------------
TEST(JetFit, FromTheOtherSideIsTheFlippedForm)
{
  std::mt19937_64 generator(27);
  JetFitter fitter;
  for (int trial = 0; trial < 50; ++trial)
  {
    const GraphSample sample = RandomGraph(4, 40, generator);
    const MongeForm above = FormOf(fitter.Fit(sample.offsets, 4, Vector3d::UnitZ()));
    const MongeForm below = FormOf(fitter.Fit(sample.offsets, 4, -Vector3d::UnitZ()));
    const double certainty = std::min(1.0, above.k1 - above.k2);
    EXPECT_LT(below.n.z(), 0.0);
    EXPECT_LT(LargestDifference(below, Flipped(above)) * certainty, FitRoundOff);
  }
}

//------------------------------------------------------------------------------
TEST(JetFit, WithWeightsRecoversPolynomialsToo)
{
  std::mt19937_64 generator(28);
  JetFitter fitter;
  for (int trial = 0; trial < 50; ++trial)
  {
    const GraphSample sample = RandomGraph(4, 40, generator);
    const ExactMonge exact = GraphSurface(sample.jet).Monge(Vector3d::Zero());
    const JetFit fit = fitter.Fit(sample.offsets, 4, Vector3d::UnitZ(), Weighting::Gaussian);
    EXPECT_EQ(fitter.LastRootWeights().size(), 40);
    // Exp(-2) for the farthest point, 1 for the vertex.
    EXPECT_NEAR(fitter.LastRootWeights().minCoeff(), std::exp(-1.0), 1e-15);
    EXPECT_EQ(fitter.LastRootWeights()[0], 1.0);
    const double certainty = std::min(1.0, exact.k1 - exact.k2);
    EXPECT_LT(LargestDifference(FormOf(fit), ToMongeForm(exact)) * certainty, 10.0 * FitRoundOff);
  }
}

//------------------------------------------------------------------------------
TEST(JetFit, WithWeightsMinimisesTheWeightedSquares)
{
  // The height x^4 over a line of points in which y is free: in degree 2 the weights decide.
  std::mt19937_64 generator(29);
  Matrix3Xd offsets = Matrix3Xd::Zero(3, 60);
  for (int i = 1; i < 60; ++i)
  {
    offsets.col(i).head<2>() = InBall(generator).head<2>();
    offsets(2, i) = 0.1 * std::pow(offsets(0, i), 4);
  }
  JetFitter fitter;
  const JetFit uniform = fitter.Fit(offsets, 2, Vector3d::UnitZ());
  const JetFit gaussian = fitter.Fit(offsets, 2, Vector3d::UnitZ(), Weighting::Gaussian);
  EXPECT_LT(gaussian.residual, uniform.residual);
  const double atUniform = FormOf(uniform).k1;
  const double atGaussian = FormOf(gaussian).k1;
  EXPECT_LT(atGaussian, atUniform); // Nearer to 0, the curvature at the vertex itself.
  EXPECT_GT(atGaussian, 0.0);
}
