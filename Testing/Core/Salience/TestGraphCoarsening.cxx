// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Fixtures/MeshWithRings.h"
#include "Salience/GraphCoarsening.h"
#include "Salience/GraphInterpolation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

namespace
{

using namespace ridges;
using namespace ridges::testing;

Coarsening CoarsenAll(const RingGraph& graph)
{
  const std::vector<std::uint8_t> joins(graph.NumberOfCells(), 1);
  return Coarsen(
    graph, joins, [](Id) { return std::uint64_t{ 0 }; }, TriangleMesh::InOneRange);
}

} // namespace

TEST(GraphCoarsening, EachCellIsInOneCoarseCell)
{
  const MeshWithRings made(AddNormalNoise(Icosphere(8), 0.02, 1));
  const RingGraph graph = made.Graph(true);
  const Coarsening coarsening = CoarsenAll(graph);
  std::vector<int> times(graph.NumberOfCells(), 0);
  double area = 0.0;
  for (Id cell = 0; cell < coarsening.graph.NumberOfCells(); ++cell)
  {
    area += coarsening.graph.areas[cell];
    const Span<Id> members = coarsening.Members(cell);
    for (const Id member : members)
    {
      ++times[member];
      EXPECT_EQ(coarsening.coarse[member], cell);
      // The first is the chosen one, and the others are its neighbours.
      const Span<Id> ring = graph.Around(members[0]);
      EXPECT_TRUE(
        member == members[0] || std::find(ring.begin(), ring.end(), member) != ring.end());
    }
  }
  EXPECT_EQ(*std::min_element(times.begin(), times.end()), 1);
  EXPECT_EQ(*std::max_element(times.begin(), times.end()), 1);
  double whole = 0.0;
  for (const double part : graph.areas)
  {
    whole += part;
  }
  EXPECT_NEAR(area, whole, 1e-12 * whole);
  const double ratio = 1.0 * graph.NumberOfCells() / coarsening.graph.NumberOfCells();
  EXPECT_GT(ratio, 3.5);
  EXPECT_LT(ratio, 5.5);
}

TEST(GraphCoarsening, NeighborsAreMutual)
{
  const MeshWithRings made(Icosphere(6));
  const Coarsening coarsening = CoarsenAll(made.Graph(true));
  for (Id cell = 0; cell < coarsening.graph.NumberOfCells(); ++cell)
  {
    const Span<Id> ring = coarsening.graph.Around(cell);
    EXPECT_GE(ring.size(), 3);
    EXPECT_EQ(std::set<Id>(ring.begin(), ring.end()).size(), static_cast<std::size_t>(ring.size()));
    for (const Id other : ring)
    {
      const Span<Id> back = coarsening.graph.Around(other);
      EXPECT_NE(other, cell);
      EXPECT_NE(std::find(back.begin(), back.end(), cell), back.end());
    }
  }
}

TEST(GraphCoarsening, CellsThatDoNotJoinStay)
{
  const MeshWithRings made(Icosphere(5));
  const RingGraph graph = made.Graph(true);
  std::vector<std::uint8_t> joins(graph.NumberOfCells());
  for (Id cell = 0; cell < graph.NumberOfCells(); ++cell)
  {
    joins[cell] = graph.positions[cell].z() > 0.0 ? 1 : 0;
  }
  const Coarsening coarsening = Coarsen(
    graph, joins, [](Id) { return std::uint64_t{ 0 }; }, TriangleMesh::InOneRange);
  for (Id cell = 0; cell < graph.NumberOfCells(); ++cell)
  {
    if (joins[cell] == 0)
    {
      const Id coarse = coarsening.coarse[cell];
      ASSERT_EQ(coarsening.Members(coarse).size(), 1);
      EXPECT_EQ(coarsening.graph.positions[coarse], graph.positions[cell]);
      EXPECT_EQ(coarsening.variances[coarse], 0.0);
    }
  }
}

// The same cells join, whatever their numbers are.
TEST(GraphCoarsening, DoesNotDependOnTheNumbering)
{
  const Mesh mesh = AddNormalNoise(Icosphere(8), 0.02, 1);
  std::vector<std::int32_t> newToOld;
  const MeshWithRings made(mesh);
  const MeshWithRings permuted(Permute(mesh, 5, &newToOld));
  const Coarsening one = CoarsenAll(made.Graph(true));
  const Coarsening other = CoarsenAll(permuted.Graph(true));
  ASSERT_EQ(other.graph.NumberOfCells(), one.graph.NumberOfCells());
  for (Id cell = 0; cell < other.graph.NumberOfCells(); ++cell)
  {
    const Span<Id> members = other.Members(cell);
    const Id same = one.coarse[newToOld[members[0]]];
    const Span<Id> expected = one.Members(same);
    ASSERT_EQ(members.size(), expected.size());
    for (Id i = 0; i < members.size(); ++i)
    {
      EXPECT_EQ(newToOld[members[i]], expected[i]);
    }
    EXPECT_EQ(other.graph.positions[cell], one.graph.positions[same]);
    EXPECT_EQ(other.graph.areas[cell], one.graph.areas[same]);
    EXPECT_EQ(other.graph.Variance(cell), one.graph.Variance(same));
  }
}

// From coarse cells of a flat mesh, away from the border, where others would be beyond. Where a
// place has hardly any cells at one side of it, corrections are cut.
TEST(GraphCoarsening, InterpolationKeepsWhatIsLinear)
{
  const MeshWithRings made(Grid(40));
  const RingGraph graph = made.Graph(true);
  const Coarsening coarsening = CoarsenAll(graph);
  int cut = 0;
  int inside = 0;
  for (Id cell = 0; cell < graph.NumberOfCells(); ++cell)
  {
    const Eigen::Vector3d& x = graph.positions[cell];
    if (x.cwiseAbs().maxCoeff() > 14.0)
    {
      continue;
    }
    double weights = 0.0;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    const GraphInterpolation parts(
      coarsening.graph, coarsening.coarse[cell], x, graph.normals[cell]);
    for (const GraphInterpolation::Part& part : parts)
    {
      const double weight = part.factor * coarsening.graph.areas[part.cell];
      weights += weight;
      mean += weight * coarsening.graph.positions[part.cell];
    }
    const double error = (mean / weights - x).norm();
    EXPECT_LT(error, 0.01);
    cut += error > 1e-9 ? 1 : 0;
    ++inside;
    EXPECT_GT(parts.Variance(), 0.0);
    EXPECT_LT(parts.Variance(), 3.0);
  }
  EXPECT_LT(cut, 0.01 * inside);
}
