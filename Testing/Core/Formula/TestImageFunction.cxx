// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Formula/ImageFunction.h"
#include "Formula/ImageNoise.h"
#include "Formula/SmoothedImage.h"
#include "Formula/Taylor3Functions.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

using namespace ridges;

namespace
{

// A quartic and a square of linear forms, and a product of three coordinates.
template <typename T>
T Polynomial(const T& x, const T& y, const T& z)
{
  const T a = 0.3 * x - 0.2 * y + 0.4 * z + 0.1;
  const T b = 0.5 * x + 0.1 * y - 0.3 * z - 0.7;
  return a * a * a * a - 2.0 * b * b + x * y * z + x - 0.5;
}

// The same, smoothed by a Gaussian: a^4 gets 6 s^2 |a|^2 a^2 + 3 s^4 |a|^4, b^2 gets s^2 |b|^2,
// where |a| is the slope of a, and the product of three different coordinates stays.
template <typename T>
T SmoothedPolynomial(const T& x, const T& y, const T& z, double sigma)
{
  const T a = 0.3 * x - 0.2 * y + 0.4 * z + 0.1;
  const double s = sigma * sigma;
  const double ofA = 0.09 + 0.04 + 0.16;
  const double ofB = 0.25 + 0.01 + 0.09;
  return Polynomial(x, y, z) + 6.0 * s * ofA * (a * a) + (3.0 * s * s * ofA * ofA - 2.0 * s * ofB);
}

struct Image
{
  ImageGrid grid;
  std::vector<double> values;

  template <typename Function>
  Image(const ImageGrid& geometry, const Function& function)
    : grid(geometry)
  {
    for (int k = 0; k < grid.size[2]; ++k)
    {
      for (int j = 0; j < grid.size[1]; ++j)
      {
        for (int i = 0; i < grid.size[0]; ++i)
        {
          const Eigen::Vector3d x = this->PointAt({ double(i), double(j), double(k) });
          this->values.push_back(function(x[0], x[1], x[2]));
        }
      }
    }
    this->grid.values = this->values.data();
  }

  Eigen::Vector3d PointAt(const Eigen::Vector3d& index) const
  {
    return this->grid.origin + this->grid.axes * this->grid.spacing.cwiseProduct(index);
  }
};

ImageGrid Oblique()
{
  ImageGrid grid;
  grid.size = { 24, 20, 16 };
  grid.origin = { 0.4, -0.3, 0.2 };
  grid.spacing = { 0.05, 0.08, 0.11 };
  grid.axes = (Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()) *
    Eigen::AngleAxisd(-1.1, Eigen::Vector3d::UnitX()))
                .toRotationMatrix();
  return grid;
}

LaneVector3 Everywhere(const Eigen::Vector3d& x)
{
  return { Lanes(x[0]), Lanes(x[1]), Lanes(x[2]) };
}

} // namespace

// Inside, at the border and beyond a corner; for a Gaussian narrower than the spacing and for a
// wide one. Coefficients of order n have errors of round-off divided by the spacing to the power of
// n.
TEST(ImageFunction, SmoothsPolynomialsExactlyEverywhere)
{
  using Jet = Taylor3<4>;
  const Image image(Oblique(), [](double x, double y, double z) { return Polynomial(x, y, z); });
  const Eigen::Matrix3d frame =
    Eigen::AngleAxisd(0.4, Eigen::Vector3d(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  std::array<LaneVector3, 3> axes;
  for (int axis = 0; axis < 3; ++axis)
  {
    axes[axis] = Everywhere(frame.col(axis));
  }
  for (const double sigma : { 0.05, 0.15 })
  {
    const ImageFunction function(image.grid, sigma, 0.25);
    for (const Eigen::Vector3d& index : { Eigen::Vector3d(11.3, 9.8, 7.1),
           Eigen::Vector3d(0.0, 9.5, 15.0), Eigen::Vector3d(-0.3, -0.2, 15.4) })
    {
      const Eigen::Vector3d x = image.PointAt(index);
      const auto found = function.Full(Everywhere(x), axes);
      std::array<Jet, 3> variables;
      for (int i = 0; i < 3; ++i)
      {
        variables[i] = Jet::Linear(x[i], frame(i, 0), frame(i, 1), frame(i, 2));
      }
      const Jet expected =
        SmoothedPolynomial(variables[0], variables[1], variables[2], sigma) - 0.25;
      for (int d = 0; d <= 4; ++d)
      {
        for (int i = Jet::Offset(d); i < Jet::Offset(d + 1); ++i)
        {
          EXPECT_NEAR(
            found.Coefficients()[i][0], expected.Coefficients()[i], 1e-11 / std::pow(0.05, d))
            << i;
        }
      }
      const auto linear = function.Linear(Everywhere(x));
      const auto gradient = Eigen::Vector3d(
        linear.Coefficients()[1][0], linear.Coefficients()[2][0], linear.Coefficients()[3][0]);
      const Eigen::Vector3d inFrame = frame.transpose() * gradient;
      for (int i = 0; i < 3; ++i)
      {
        EXPECT_NEAR(inFrame[i], expected.Coefficients()[1 + i], 1e-9);
      }
    }
  }
}

// A Gaussian smoothed by a Gaussian is one, wider and lower. Sampling at 0.1 aliases little at this
// width.
TEST(ImageFunction, SmoothsAGaussian)
{
  ImageGrid grid;
  grid.size = { 40, 40, 40 };
  grid.origin = { -2.0, -2.0, -2.0 };
  grid.spacing = { 0.1, 0.1, 0.1 };
  const double width = 0.5;
  const double sigma = 0.15;
  const Image image(grid,
    [width](double x, double y, double z)
    { return std::exp(-0.5 * (x * x + y * y + z * z) / (width * width)); });
  const ImageFunction function(image.grid, sigma, 0.0);
  const double wide = width * width + sigma * sigma;
  const Eigen::Vector3d x(0.33, -0.21, 0.47);
  const auto found = function.Full(
    Everywhere(x), { Everywhere({ 1, 0, 0 }), Everywhere({ 0, 1, 0 }), Everywhere({ 0, 0, 1 }) });
  using Jet = Taylor3<4>;
  const Jet u = Jet::Linear(x[0], 1, 0, 0);
  const Jet v = Jet::Linear(x[1], 0, 1, 0);
  const Jet w = Jet::Linear(x[2], 0, 0, 1);
  const Jet expected =
    std::pow(width * width / wide, 1.5) * exp((-0.5 / wide) * (u * u + v * v + w * w));
  for (int i = 0; i < Jet::Size; ++i)
  {
    EXPECT_NEAR(found.Coefficients()[i][0], expected.Coefficients()[i], 1e-5) << i;
  }
}

// Samples that are smoothed first know the image in between as well as the others.
TEST(SmoothedImage, ChangesNothingButTheCost)
{
  ImageGrid geometry;
  geometry.size = { 76, 76, 76 };
  geometry.spacing = { 0.05, 0.06, 0.05 };
  const Image image(geometry,
    [](double x, double y, double z)
    { return std::sin(9.0 * x + 4.0 * y) + std::cos(7.0 * z - y); });
  const double sigma = 0.2;
  const SmoothedImage smoothed(
    image.grid, sigma, [](Id count, const std::function<void(Id, Id)>& body) { body(0, count); });
  ASSERT_NE(smoothed.Grid().values, image.grid.values);
  const ImageFunction once(image.grid, sigma, 0.1);
  const ImageFunction twice(smoothed.Grid(), sigma, 0.1);
  const std::array<LaneVector3, 3> axes = { Everywhere({ 1, 0, 0 }), Everywhere({ 0, 1, 0 }),
    Everywhere({ 0, 0, 1 }) };
  // Away from the border, where weights are corrected once or twice.
  for (const Eigen::Vector3d& index :
    { Eigen::Vector3d(37.3, 38.0, 36.6), Eigen::Vector3d(39.5, 36.9, 38.0) })
  {
    const auto x = Everywhere(image.PointAt(index));
    const auto expected = once.Full(x, axes);
    const auto found = twice.Full(x, axes);
    for (int d = 0; d <= 4; ++d)
    {
      for (int i = Taylor3<4>::Offset(d); i < Taylor3<4>::Offset(d + 1); ++i)
      {
        EXPECT_NEAR(
          found.Coefficients()[i][0], expected.Coefficients()[i][0], 1e-6 / std::pow(sigma, d))
          << i;
      }
    }
  }
}

// About 1,500 samples are nearest to the places, of which some hundred are independent.
TEST(ImageNoise, IsEstimatedBesideASurface)
{
  ImageGrid geometry;
  geometry.size = { 40, 40, 40 };
  std::mt19937 generator(7);
  std::normal_distribution<double> normal(0.0, 0.3);
  const Image image(geometry,
    [&generator, &normal](double x, double y, double z)
    { return std::tanh(0.5 * (x - 0.3 * y + 0.2 * z - 16.0)) + normal(generator); });
  std::vector<double> places;
  for (int j = 0; j < 200; ++j)
  {
    for (int k = 0; k < 200; ++k)
    {
      const double y = 0.195 * j;
      const double z = 0.195 * k;
      places.insert(places.end(), { 16.0 + 0.3 * y - 0.2 * z, y, z });
    }
  }
  const Span<double> all{ places.data(), places.data() + places.size() };
  EXPECT_NEAR(EstimateImageNoise(image.grid, all), 0.3, 0.05 * 0.3);
  const Image linear(geometry, [](double x, double y, double z) { return x * y - 2.0 * z; });
  EXPECT_NEAR(EstimateImageNoise(linear.grid, all), 0.0, 1e-12);
  EXPECT_EQ(EstimateImageNoise(linear.grid, {}), 0.0);
  const double outside[3] = { -100.0, 0.0, 0.0 };
  EXPECT_EQ(EstimateImageNoise(image.grid, { outside, outside + 3 }), 0.0);
}

TEST(ImageFunction, KnowsItsBorder)
{
  const Image image(Oblique(), [](double x, double, double) { return x; });
  const ImageFunction function(image.grid, 0.1, 0.0);
  EXPECT_FALSE(function.IsAtBorder(image.PointAt({ 12.0, 10.0, 8.0 })));
  EXPECT_TRUE(function.IsAtBorder(image.PointAt({ 5.9, 10.0, 8.0 }))); // 6 samples are 3 sigma
  EXPECT_FALSE(function.IsAtBorder(image.PointAt({ 6.1, 10.0, 8.0 })));
  EXPECT_TRUE(function.IsAtBorder(image.PointAt({ 12.0, 10.0, 15.0 })));
  // Nothing can be said far outside.
  const auto far = function.Linear(Everywhere(image.PointAt({ 100.0, 10.0, 8.0 })));
  EXPECT_TRUE(std::isnan(far.Constant()[0]));
}
