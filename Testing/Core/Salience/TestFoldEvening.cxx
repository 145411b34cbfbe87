// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Salience/FoldEvening.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using namespace ridges;

/// A ridge along x with vertices at distance 1, all elliptic, with folds of these angles.
struct StraightRidge
{
  explicit StraightRidge(const std::vector<double>& angles)
  {
    for (std::size_t i = 0; i < angles.size(); ++i)
    {
      RidgeVertex vertex;
      vertex.edge = static_cast<Id>(i);
      vertex.point = RidgePoint();
      vertex.point.position = { static_cast<double>(i), 0.0, 0.0 };
      this->trace.vertices.push_back(vertex);
      Fold fold;
      fold.angle = angles[i];
      fold.height = 1.0;
      this->folds.push_back(fold);
    }
    this->trace.types.assign(angles.size() - 1, TypeOf(Color::Blue, true));
  }

  RidgeTrace trace;
  RidgeFolds folds;
};

std::vector<double> Ones(std::size_t count)
{
  return std::vector<double>(count, 1.0);
}

} // namespace

TEST(FoldEvening, LeavesEqualAnglesAsTheyAre)
{
  StraightRidge ridge(Ones(20));
  EvenFolds(ridge.trace, 3.0, 0.0, ridge.folds);
  for (const Fold& fold : ridge.folds)
  {
    EXPECT_NEAR(fold.angle, 1.0, 1e-12);
  }
}

TEST(FoldEvening, SpreadsASinglePointLikeAGaussian)
{
  std::vector<double> angles(21, 0.0);
  angles[10] = 1.0;
  StraightRidge ridge(angles);
  constexpr double sigma = 2.0;
  EvenFolds(ridge.trace, sigma, 0.0, ridge.folds);
  double sum = 1.0; // of the weights: up to 2.5 deviations, five vertices to each side
  for (int i = 1; i <= 5; ++i)
  {
    sum += 2.0 * std::exp(-0.5 * i * i / (sigma * sigma));
  }
  for (int i = -6; i <= 6; ++i)
  {
    const double expected = std::abs(i) <= 5 ? std::exp(-0.5 * i * i / (sigma * sigma)) / sum : 0.0;
    if (std::abs(i) <= 4) // farther out the end of the ridge cuts the weights of some
    {
      EXPECT_NEAR(ridge.folds[10 + i].angle, expected, 1e-12) << i;
    }
  }
}

TEST(FoldEvening, StopsAtHyperbolicPieces)
{
  std::vector<double> angles(20, 1.0);
  std::fill(angles.begin() + 10, angles.end(), 5.0);
  StraightRidge ridge(angles);
  ridge.trace.types[9] = TypeOf(Color::Blue, false);
  EvenFolds(ridge.trace, 3.0, 0.0, ridge.folds);
  EXPECT_NEAR(ridge.folds[9].angle, 1.0, 1e-12);
  EXPECT_NEAR(ridge.folds[10].angle, 5.0, 1e-12);
}

TEST(FoldEvening, DoesNotDependOnTheSenseOfTheRidge)
{
  std::vector<double> angles(20);
  for (std::size_t i = 0; i < angles.size(); ++i)
  {
    angles[i] = std::sin(static_cast<double>(i * i));
  }
  StraightRidge forward(angles);
  StraightRidge backward(std::vector<double>(angles.rbegin(), angles.rend()));
  EvenFolds(forward.trace, 2.0, 0.0, forward.folds);
  EvenFolds(backward.trace, 2.0, 0.0, backward.folds);
  for (std::size_t i = 0; i < angles.size(); ++i)
  {
    EXPECT_DOUBLE_EQ(forward.folds[i].angle, backward.folds[angles.size() - 1 - i].angle);
  }
}

TEST(FoldEvening, GoesAroundLoops)
{
  // The first vertex comes again at the end; lengths of the last piece are those of the others.
  constexpr int count = 24;
  std::vector<double> angles(count + 1, 0.0);
  angles.front() = angles.back() = 1.0;
  StraightRidge ridge(angles);
  ridge.trace.closed = true;
  const double radius = 0.5 / std::sin(EIGEN_PI / count);
  for (int i = 0; i <= count; ++i)
  {
    const double turn = 2.0 * EIGEN_PI * (i % count) / count;
    ridge.trace.vertices[i].point.position = { radius * std::cos(turn), radius * std::sin(turn),
      0.0 };
  }
  EvenFolds(ridge.trace, 2.1, 0.0, ridge.folds); // five vertices to each side
  EXPECT_EQ(ridge.folds.front().angle, ridge.folds.back().angle);
  for (int i = 1; i <= 5; ++i)
  {
    EXPECT_GT(ridge.folds[i].angle, 0.0);
    EXPECT_NEAR(ridge.folds[i].angle, ridge.folds[count - i].angle, 1e-9);
  }
}

TEST(FoldEvening, LeavesOutSlowBends)
{
  StraightRidge ridge(Ones(10));
  for (Fold& fold : ridge.folds)
  {
    fold.foot = 9.5; // the height, 1, is less than 15 % of 10.5
  }
  EvenFolds(ridge.trace, 0.0, 0.15, ridge.folds);
  for (const Fold& fold : ridge.folds)
  {
    EXPECT_EQ(fold.angle, 0.0);
  }
}
