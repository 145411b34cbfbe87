// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Salience/SalientSelection.h"

#include <gtest/gtest.h>

#include <numeric>

namespace
{

using namespace ridges;

/// A ridge with its vertices at distance 1 from each other, and folds of these angles: elliptic,
/// but hyperbolic where an angle is negative.
struct TestRidge
{
  TestRidge(const std::vector<double>& angles, bool closed)
  {
    this->trace.closed = closed;
    for (std::size_t i = 0; i < angles.size(); ++i)
    {
      RidgeVertex vertex;
      vertex.edge = static_cast<Id>(i);
      vertex.point = RidgePoint();
      vertex.point.position = { static_cast<double>(i), 0.0, 0.0 };
      vertex.point.color = Color::Blue;
      vertex.point.crestMargin = 1.0;
      this->trace.vertices.push_back(vertex);
      Fold fold;
      fold.angle = std::max(0.0, angles[i]);
      fold.height = fold.angle;
      this->folds.push_back(fold);
    }
    for (std::size_t i = 0; i + 1 < angles.size(); ++i)
    {
      const bool elliptic = angles[i] >= 0.0 && angles[i + 1] >= 0.0;
      this->trace.types.push_back(TypeOf(Color::Blue, elliptic));
    }
    if (closed)
    {
      // A square of side n / 4 would do as well; only lengths count, and the last is 1.
      this->trace.vertices.push_back(this->trace.vertices.front());
      this->folds.push_back(this->folds.front());
      this->trace.types.push_back(TypeOf(Color::Blue, angles.back() >= 0.0 && angles[0] >= 0.0));
      const double turn = 2.0 * EIGEN_PI / static_cast<double>(angles.size());
      const double radius = 0.5 / std::sin(0.5 * turn);
      for (std::size_t i = 0; i < this->trace.vertices.size(); ++i)
      {
        const double angle = turn * static_cast<double>(i % angles.size());
        this->trace.vertices[i].point.position = { radius * std::cos(angle),
          radius * std::sin(angle), 0.0 };
      }
    }
  }

  std::vector<SalientLine> Select(const SalientRule& rule) const
  {
    return SelectSalient({ this->trace }, { this->folds }, rule);
  }

  RidgeTrace trace;
  RidgeFolds folds;
};

SalientRule Rule(double gap = 0.0, double mass = 0.0)
{
  SalientRule rule;
  rule.angle = 2.0;
  rule.weakAngle = 1.0;
  rule.longestGap = gap;
  rule.leastMass = mass;
  rule.floor = 0.1;
  return rule;
}

std::vector<Id> Range(Id first, Id last)
{
  std::vector<Id> ids(last - first + 1);
  std::iota(ids.begin(), ids.end(), first);
  return ids;
}

} // namespace

TEST(SalientSelection, KeepsWeakPartsBesideStrongOnes)
{
  const TestRidge ridge({ 0.5, 1.0, 2.5, 1.5, 0.2, 0.2, 1.5, 1.5 }, false);
  const auto lines = ridge.Select(Rule());
  ASSERT_EQ(lines.size(), 1u); // the second part is strong nowhere
  EXPECT_EQ(lines[0].vertices, Range(1, 3));
  EXPECT_FALSE(lines[0].closed);
  EXPECT_DOUBLE_EQ(lines[0].angle, 2.5);
  EXPECT_DOUBLE_EQ(lines[0].mass, 0.5 * (1.0 + 2.5) + 0.5 * (2.5 + 1.5));
  EXPECT_DOUBLE_EQ(lines[0].confidence, 1.0);
}

TEST(SalientSelection, BridgesGapsUpToTheLongest)
{
  const TestRidge ridge({ 3.0, 3.0, -1.0, 3.0, 3.0, 0.0, 0.0, 0.0, 3.0, 3.0 }, false);
  const auto lines = ridge.Select(Rule(2.0));
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].vertices, Range(0, 4));
  EXPECT_DOUBLE_EQ(lines[0].confidence, 0.5); // the gap has two of four pieces
  EXPECT_EQ(lines[1].vertices, Range(8, 9));
  EXPECT_EQ(ridge.Select(Rule(1.9)).size(), 3u);
  EXPECT_EQ(ridge.Select(Rule(4.0)).size(), 1u);
}

TEST(SalientSelection, LeavesOutLinesOfLittleMass)
{
  const TestRidge ridge({ 3.0, 3.0, 0.0, 3.0, 3.0, 3.0 }, false);
  const auto lines = ridge.Select(Rule(0.0, 4.0));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].vertices, Range(3, 5));
}

TEST(SalientSelection, KeepsLoopsWhole)
{
  const TestRidge all({ 3.0, 3.0, 3.0, 3.0, 3.0 }, true);
  auto lines = all.Select(Rule());
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].closed);
  EXPECT_EQ(lines[0].vertices, (std::vector<Id>{ 0, 1, 2, 3, 4, 0 }));
  EXPECT_NEAR(lines[0].mass, 15.0, 1e-12);

  // A short gap is bridged, wherever the loop starts; a long one opens it.
  const TestRidge gap({ 3.0, 0.0, 3.0, 3.0, 3.0 }, true);
  lines = gap.Select(Rule(2.5));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].closed);
  lines = gap.Select(Rule(1.5));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_FALSE(lines[0].closed);
  EXPECT_EQ(lines[0].vertices, (std::vector<Id>{ 2, 3, 4, 0 }));
}

TEST(SalientSelection, LinesOfALoopGoOverItsStart)
{
  const TestRidge ridge({ 3.0, 3.0, 0.0, 0.0, 3.0, 3.0, 0.0, 0.0, 3.0, 3.0 }, true);
  const auto lines = ridge.Select(Rule());
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].vertices, (std::vector<Id>{ 4, 5 }));
  EXPECT_EQ(lines[1].vertices, (std::vector<Id>{ 8, 9, 0, 1 }));
}

TEST(SalientSelection, KeepsCrestsOnlyIfAskedTo)
{
  TestRidge ridge({ 3.0, 3.0, 3.0, 3.0, 3.0 }, false);
  ridge.trace.vertices[3].point.crestMargin = -2.0;
  ridge.trace.vertices[4].point.crestMargin = -2.0;
  SalientRule rule = Rule();
  ASSERT_EQ(ridge.Select(rule).size(), 1u);
  EXPECT_EQ(ridge.Select(rule)[0].vertices, Range(0, 2));
  rule.crestOnly = false;
  EXPECT_EQ(ridge.Select(rule)[0].vertices, Range(0, 4));
}

TEST(SalientSelection, NothingComesOfNothing)
{
  EXPECT_TRUE(SelectSalient({}, {}, Rule()).empty());
  EXPECT_TRUE(TestRidge({ 0.0, 0.0, 0.0 }, true).Select(Rule()).empty());
  EXPECT_TRUE(TestRidge({ -1.0, -1.0, -1.0 }, false).Select(Rule()).empty());
}
