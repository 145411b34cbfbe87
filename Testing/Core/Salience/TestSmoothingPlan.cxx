// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Fixtures/MeshWithRings.h"
#include "Salience/LevelAveraging.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace
{

using namespace ridges;
using namespace ridges::testing;

using Function = std::function<double(const Eigen::Vector3d&)>;

/// The smoothed values of a function at all points.
std::vector<double> Smooth(
  const TriangleMesh& mesh, const SmoothingPlan& plan, const Function& function)
{
  LevelAveraging<9> averaging(plan);
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    averaging.Set(p, { function(mesh.Point(p)) });
  }
  const auto loop = [](Id count, double done, const std::function<void(Id, Id)>& body)
  {
    body(0, count / 2);
    body(count / 2, count);
    return done <= 1.0;
  };
  EXPECT_TRUE(averaging.Run(loop));
  std::vector<double> values;
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    LevelAveraging<9>::Values value;
    EXPECT_TRUE(averaging.Get(p, value));
    values.push_back(value[0]);
  }
  return values;
}

std::size_t NumberOfSweeps(const SmoothingPlan& plan)
{
  std::size_t count = 0;
  for (const SmoothingLevel& level : plan.Levels())
  {
    count += level.sweeps.size();
  }
  return count;
}

} // namespace

// The average of x^2 over a Gaussian around x = 0 is its variance, that of x is 0. The triangles
// are uneven; points in the smallest, at most the twentieth part of all, reach a little less of the
// scale.
TEST(SmoothingPlan, ReachesTheScaleWhateverTheTriangles)
{
  // Plain averages, boxes, two levels and three.
  const std::vector<double> sigmas{ 0.9, 1.5, 4.0, 9.0 };
  const std::vector<std::size_t> levels{ 1, 1, 2, 3 };
  for (std::size_t i = 0; i < sigmas.size(); ++i)
  {
    // The mesh ends farther away than the Gaussian reaches.
    const double sigma = sigmas[i];
    const MeshWithRings made(GraphPatch([](double, double) { return 0.0; }, 36.0, 144, 0.2));
    const TriangleMesh& mesh = made.Triangles();
    const SmoothingPlan plan(made.rings, nullptr, sigma);
    EXPECT_EQ(plan.Levels().size(), levels[i]);
    const std::vector<double> values =
      Smooth(mesh, plan, [](const Eigen::Vector3d& x) { return x[0]; });
    const std::vector<double> squares =
      Smooth(mesh, plan, [](const Eigen::Vector3d& x) { return x[0] * x[0]; });
    double variance = 0.0;
    int inside = 0;
    for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
    {
      const Eigen::Vector3d x = mesh.Point(p);
      if (x.norm() < 4.0)
      {
        variance += squares[p] - values[p] * values[p];
        ++inside;
        EXPECT_NEAR(plan.Sigma(p), sigma, 0.15 * sigma);
        EXPECT_NEAR(values[p], x[0], 0.03 * sigma);
      }
    }
    EXPECT_NEAR(std::sqrt(variance / inside), sigma, 0.03 * sigma) << sigma;
  }
}

TEST(SmoothingPlan, CountsWhatTheFitHasSmoothed)
{
  const MeshWithRings made(Grid(30));
  const std::vector<double> radii(made.Triangles().NumberOfPoints(), 5.0); // 0.4 of it: 2
  const SmoothingPlan alone(made.rings, nullptr, 2.5);
  const SmoothingPlan plan(made.rings, radii.data(), 2.5);
  EXPECT_LT(NumberOfSweeps(plan), NumberOfSweeps(alone));
  EXPECT_NEAR(plan.Sigma(465), 2.5, 0.01);
  // One average is made at least, and reported.
  const SmoothingPlan coarse(made.rings, radii.data(), 0.1);
  EXPECT_EQ(NumberOfSweeps(coarse), 1u);
  EXPECT_GT(coarse.Sigma(465), 2.0);
}

// A wave along x is damped by exp(-sigma^2 w^2 / 2), and what alternates from point to point
// disappears. The mesh ends farther away than the averages reach.
TEST(SmoothingPlan, IsAGaussian)
{
  const int size = 140;
  const MeshWithRings made(Grid(size));
  const TriangleMesh& mesh = made.Triangles();
  for (const double sigma : { 5.0, 9.0 })
  {
    const SmoothingPlan plan(made.rings, nullptr, sigma);
    const std::vector<double> alternating = Smooth(mesh, plan,
      [size](const Eigen::Vector3d& x)
      { return std::lround(x[0] + 0.5 * size) % 2 == 0 ? 1.0 : -1.0; });
    for (const double phase : { 0.5, 1.0, 2.0 })
    {
      const double w = phase / sigma;
      const std::vector<double> wave =
        Smooth(mesh, plan, [w](const Eigen::Vector3d& x) { return std::cos(w * x[0]); });
      double squares = 0.0;
      int inside = 0;
      for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
      {
        const Eigen::Vector3d x = mesh.Point(p);
        if (x.cwiseAbs().maxCoeff() < 10.0)
        {
          const double reached = plan.Sigma(p);
          const double error =
            wave[p] - std::exp(-0.5 * reached * reached * w * w) * std::cos(w * x[0]);
          EXPECT_NEAR(error, 0.0, 0.05);
          EXPECT_NEAR(alternating[p], 0.0, 5e-3);
          squares += error * error;
          ++inside;
        }
      }
      EXPECT_LT(std::sqrt(squares / inside), 0.02);
    }
  }
}

// The work, in sweeps over all points, is bounded however fine the mesh is.
TEST(SmoothingPlan, WorkPerPointDoesNotGrowWithTheScale)
{
  const MeshWithRings made(Grid(100));
  const auto workPerPoint = [&made](double sigma)
  {
    const SmoothingPlan plan(made.rings, nullptr, sigma);
    double work = 0.0;
    for (const SmoothingLevel& level : plan.Levels())
    {
      work += static_cast<double>(level.sweeps.size()) * level.graph.NumberOfCells();
    }
    return work / made.Triangles().NumberOfPoints();
  };
  for (const double sigma : { 3.0, 5.0, 8.0, 13.0, 20.0 })
  {
    EXPECT_LT(workPerPoint(sigma), 37.0) << sigma;
  }
  EXPECT_LT(workPerPoint(20.0), 10.0);
}

// Fine triangles at one side, coarse ones at the other, which need no averages of their own.
TEST(SmoothingPlan, LeavesLargeTrianglesAsTheyAre)
{
  const MeshWithRings made(GradedGrid(120));
  const SmoothingPlan plan(made.rings, nullptr, 9.0);
  ASSERT_GT(plan.Levels().size(), 1u);
  const TriangleMesh& mesh = made.Triangles();
  const SmoothingLevel& finest = plan.Levels().front();
  int alone = 0;
  int joined = 0;
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    const bool isJoined = finest.Members(finest.coarse[plan.CellOf(p)]).size() > 1;
    (isJoined ? joined : alone) += 1;
    // Sizes do not change much from one side of an edge to the other.
    EXPECT_TRUE(isJoined || mesh.Point(p)[0] > -40.0);
  }
  EXPECT_GT(joined, 1000);
  EXPECT_GT(alone, 0);
}
