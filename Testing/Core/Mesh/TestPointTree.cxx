// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// Against all distances: exact, no tolerance.

#include "AnalyticSurface.h"

#include "Mesh/PointTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace
{

using namespace ridges;
using namespace ridges::testing;
using Eigen::Vector3d;

// Some of them in one place, some on one line.
std::vector<Vector3d> RandomPoints(std::size_t count, std::uint64_t seed)
{
  std::mt19937_64 generator(seed);
  std::vector<Vector3d> points;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double x = Uniform(generator);
    const double y = i % 5 == 0 ? 0.5 : Uniform(generator);
    const double z = i % 10 == 0 ? 0.5 : Uniform(generator);
    points.emplace_back(i % 7 == 0 && i > 0 ? points.back() : Vector3d(x, y, z));
  }
  return points;
}

double LeastDistanceToOther(const std::vector<Vector3d>& points, std::size_t point)
{
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    least = i == point ? least : std::min(least, (points[i] - points[point]).norm());
  }
  return least;
}

} // namespace

TEST(PointTree, FindsTheNearestOtherPoint)
{
  for (const std::size_t count : { 1u, 2u, 3u, 10u, 500u })
  {
    const std::vector<Vector3d> points = RandomPoints(count, count);
    const PointTree tree(points);
    for (std::size_t i = 0; i < count; ++i)
    {
      EXPECT_EQ(tree.DistanceToNearestOther(i), LeastDistanceToOther(points, i));
    }
  }
}

TEST(PointTree, VisitsAllPointsInABall)
{
  const std::vector<Vector3d> points = RandomPoints(300, 1);
  const PointTree tree(points);
  for (const Vector3d& center : RandomPoints(20, 2))
  {
    for (const double radius : { 0.0, 0.1, 0.3, 3.0 })
    {
      const auto isInside = [&center, radius](const Vector3d& x)
      { return (x - center).squaredNorm() <= radius * radius; };
      std::ptrdiff_t visited = 0;
      tree.VisitNear(center, radius,
        [&visited, &isInside](const Vector3d& x)
        {
          EXPECT_TRUE(isInside(x));
          ++visited;
          return true;
        });
      EXPECT_EQ(visited, std::count_if(points.begin(), points.end(), isInside));
    }
  }
}

TEST(PointTree, StopsWhenTheVisitorSaysSo)
{
  const PointTree tree(RandomPoints(100, 1));
  int visited = 0;
  tree.VisitNear(Vector3d::Zero(), 10.0,
    [&visited](const Vector3d&)
    {
      ++visited;
      return visited < 5;
    });
  EXPECT_EQ(visited, 5);
}

TEST(PointTree, OfNoPointsIsEmpty)
{
  PointTree(std::vector<Vector3d>())
    .VisitNear(Vector3d::Zero(), 1.0,
      [](const Vector3d&)
      {
        ADD_FAILURE();
        return true;
      });
}
