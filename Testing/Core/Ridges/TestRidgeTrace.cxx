// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// Whole ridges as polylines: runs, turning points, hysteresis and canonical form.

#include "Fixtures/EllipsoidFixture.h"

#include "Ridges/RidgeTrace.h"
#include "Ridges/TypeRuns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using namespace ridges;
using namespace ridges::testing;
using Eigen::Vector3d;

// A polyline on the x axis with P at its points, typed by the fourth order as TraceRidge does.
RidgeTrace TraceWith(const std::vector<RidgeType>& types, double step, bool closed)
{
  RidgeTrace trace;
  trace.closed = closed;
  trace.types = types;
  for (std::size_t i = 0; i <= types.size(); ++i)
  {
    RidgeVertex vertex;
    const double angle = closed ? 2.0 * std::acos(-1.0) * static_cast<double>(i % types.size()) /
        static_cast<double>(types.size())
                                : 0.0;
    vertex.point.position = closed ? Vector3d(std::cos(angle), std::sin(angle), 0.0)
                                   : Vector3d(step * static_cast<double>(i), 0.0, 0.0);
    vertex.point.curvature = 1.0;
    vertex.point.gap = 1.0;
    vertex.point.P = 0.0;
    vertex.point.crestMargin = -1.0;
    vertex.point.parameter = 0.5;
    vertex.edge = static_cast<Id>(i);
    trace.vertices.push_back(vertex);
  }
  return trace;
}

constexpr RidgeType E = RidgeType::MaximumElliptic;
constexpr RidgeType H = RidgeType::MaximumHyperbolic;

// The runs cover the ridge in order, are uniform, and differ from the next; a loop starts where one
// does, unless it is all one.
void CheckRuns(const RidgeTrace& trace)
{
  const auto kind = [&](Id i) { return std::make_pair(trace.types[i], trace.IsCrest(i)); };
  const std::vector<RidgeRun> runs = RunsOf(trace);
  Id next = 0;
  for (std::size_t r = 0; r < runs.size(); ++r)
  {
    ASSERT_EQ(runs[r].first, next);
    ASSERT_GT(runs[r].last, runs[r].first);
    for (Id i = runs[r].first; i < runs[r].last; ++i)
    {
      ASSERT_EQ(kind(i), kind(runs[r].first));
    }
    const std::size_t after = r + 1 < runs.size() ? r + 1 : 0;
    if (runs.size() > 1 && (after > 0 || trace.closed))
    {
      ASSERT_NE(kind(runs[r].first), kind(runs[after].first));
    }
    next = runs[r].last;
  }
  ASSERT_EQ(next, static_cast<Id>(trace.types.size()));
}

std::vector<RidgeTrace> TraceAll(
  const TriangleMesh& mesh, const MongeField& field, Color color, TypeRule rule)
{
  RidgeCrossings crossings(mesh, field, color, CrossingRule::Form);
  crossings.Build();
  const auto segments = MarchMesh(mesh, field, color, rule);
  std::vector<RidgeTrace> traces;
  for (const Ridge& ridge : AssembleRidges(crossings, segments))
  {
    traces.push_back(TraceRidge(ridge, segments, {}, crossings, rule, {}));
  }
  return traces;
}

} // namespace

//------------------------------------------------------------------------------
TEST(RidgeTrace, TurnsWherePVanishes)
{
  const MeshedSurface surface(TorusMesh(2.0, 0.7, 41, 21));
  int turns = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
  {
    const FieldArrays arrays = RandomField(surface.Triangles(), seed);
    for (const RidgeTrace& trace :
      TraceAll(surface.Triangles(), arrays.View(), Color::Blue, TypeRule::FourthOrder))
    {
      ASSERT_EQ(trace.vertices.size(), trace.types.size() + 1);
      for (std::size_t i = 1; i < trace.types.size(); ++i)
      {
        const RidgeVertex& vertex = trace.vertices[i];
        const bool between = vertex.edge == RidgeVertex::None;
        const bool besideUmbilic = trace.vertices[i - 1].umbilic != RidgeVertex::None ||
          trace.vertices[i + 1].umbilic != RidgeVertex::None;
        ASSERT_TRUE(trace.types[i] == trace.types[i - 1] || between || besideUmbilic);
        if (between)
        {
          ++turns;
          const RidgePoint& a = trace.vertices[i - 1].point;
          const RidgePoint& b = trace.vertices[i + 1].point;
          const double t =
            (vertex.point.position - a.position).norm() / (b.position - a.position).norm();
          ASSERT_NEAR((1.0 - t) * a.P + t * b.P, 0.0, 1e-9 * (std::abs(a.P) + std::abs(b.P)));
          ASSERT_NE(trace.types[i], trace.types[i - 1]);
        }
      }
    }
  }
  EXPECT_GT(turns, 100);
}

//------------------------------------------------------------------------------
TEST(RidgeTrace, SplitsIntoUniformRuns)
{
  const MeshedSurface surface(TorusMesh(2.0, 0.7, 41, 21));
  int loops = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
  {
    FieldArrays arrays = RandomField(surface.Triangles(), seed);
    for (std::size_t i = 0; i < arrays.d1.size(); ++i)
    {
      arrays.d1[i] = i % 3 == 0 ? 1.0 : 0.0;
    }
    for (RidgeTrace& trace :
      TraceAll(surface.Triangles(), arrays.View(), Color::Blue, TypeRule::FourthOrder))
    {
      MakeCanonical(surface.Triangles(), trace);
      CheckRuns(trace);
      loops += trace.closed ? 1 : 0;
      // Types change an even number of times around a loop.
      int changes = trace.closed && trace.types.front() != trace.types.back() ? 1 : 0;
      for (std::size_t i = 1; i < trace.types.size(); ++i)
      {
        changes += trace.types[i] != trace.types[i - 1] ? 1 : 0;
      }
      EXPECT_TRUE(!trace.closed || changes % 2 == 0);
    }
  }
  EXPECT_GT(loops, 50);
}

//------------------------------------------------------------------------------
TEST(RidgeTrace, AbsorbsShortRunsShortestFirst)
{
  RidgeTrace trace = TraceWith({ H, E, E, E, H, E, E, H, H, E, E, E, E, H }, 1.0, false);
  AbsorbShortRuns(trace, 1.5);
  EXPECT_EQ(trace.types, (std::vector<RidgeType>{ H, E, E, E, E, E, E, H, H, E, E, E, E, H }));
  AbsorbShortRuns(trace, 2.5);
  EXPECT_EQ(trace.types, (std::vector<RidgeType>{ H, E, E, E, E, E, E, E, E, E, E, E, E, H }));
  AbsorbShortRuns(trace, 100.0); // Leaves one type between the ends.
  EXPECT_EQ(trace.types, std::vector<RidgeType>(14, H));

  RidgeTrace ends = TraceWith({ H, E, E, E }, 1.0, false);
  AbsorbShortRuns(ends, 2.0);
  EXPECT_EQ(ends.types, (std::vector<RidgeType>{ H, E, E, E }));

  // The short run goes over the start of the loop.
  RidgeTrace loop = TraceWith({ H, E, E, E, E, E, E, E, E, E, E, H }, 0.0, true);
  AbsorbShortRuns(loop, 1.2);
  EXPECT_EQ(loop.types, std::vector<RidgeType>(12, E));

  // Once the run at its start is absorbed the loop starts within one.
  RidgeTrace again = TraceWith({ E, H, H, E, E, E, E, E, H, H, H, H }, 0.0, true);
  AbsorbShortRuns(again, 1.9);
  EXPECT_EQ(std::count(again.types.begin(), again.types.end(), E), 5);
}

//------------------------------------------------------------------------------
TEST(RidgeTrace, RemovesTurningPointsThatTurnNoMore)
{
  RidgeTrace trace = TraceWith({ H, H, E, H, H, H }, 1.0, false);
  trace.vertices[2].edge = RidgeVertex::None;
  trace.vertices[3].edge = RidgeVertex::None;
  AbsorbShortRuns(trace, 1.5);
  ASSERT_EQ(trace.types, std::vector<RidgeType>(4, H));
  std::vector<double> x;
  for (const RidgeVertex& vertex : trace.vertices)
  {
    x.push_back(vertex.point.position[0]);
  }
  EXPECT_EQ(x, (std::vector<double>{ 0.0, 1.0, 4.0, 5.0, 6.0 }));
}

//------------------------------------------------------------------------------
TEST(RidgeTrace, CanonicalFormDependsOnPositionsOnly)
{
  const TriangleMesh mesh; // No two vertices are in one place, so that no edge is asked for.
  for (const bool closed : { false, true })
  {
    RidgeTrace trace = TraceWith({ H, E, E, H, E, H, H, E, E, H }, 1.0, closed);
    RidgeTrace expected = trace;
    MakeCanonical(mesh, expected);
    for (std::size_t shift = 0; shift < (closed ? 10u : 1u); ++shift)
    {
      for (const bool reverse : { false, true })
      {
        RidgeTrace other = trace;
        if (closed)
        {
          const auto by = static_cast<std::ptrdiff_t>(shift);
          other.vertices.pop_back();
          std::rotate(other.vertices.begin(), other.vertices.begin() + by, other.vertices.end());
          std::rotate(other.types.begin(), other.types.begin() + by, other.types.end());
          other.vertices.push_back(other.vertices.front());
        }
        if (reverse)
        {
          std::reverse(other.vertices.begin(), other.vertices.end());
          std::reverse(other.types.begin(), other.types.end());
        }
        MakeCanonical(mesh, other);
        EXPECT_EQ(other.types, expected.types);
        EXPECT_FALSE(ComesBefore(mesh, other, expected) || ComesBefore(mesh, expected, other));
      }
    }
    EXPECT_NE(expected.types.front(), closed ? expected.types.back() : E);
  }
}
