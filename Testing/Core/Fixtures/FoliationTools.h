// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// Surfaces with their curvature lines, for the tests of these.

#ifndef RIDGES_TESTING_FOLIATION_TOOLS_H
#define RIDGES_TESTING_FOLIATION_TOOLS_H

#include "EllipsoidRidges.h"
#include "Fixtures/TestFields.h"

#include "Foliation/PrincipalFoliation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ridges
{
namespace testing
{

inline FoliationRule RuleFor(Color color, double separation)
{
  FoliationRule rule;
  rule.color = color;
  rule.separation = separation;
  rule.leastDistance = 0.5 * separation;
  rule.minimumLength = 2.0 * separation;
  rule.maximumLength = std::numeric_limits<double>::infinity();
  rule.step = 0.2 * separation;
  rule.closingDistance = 0.1 * separation;
  return rule;
}

inline std::vector<CurvatureLine> LinesOf(const TriangleMesh& mesh, const FieldArrays& field,
  const FoliationRule& rule, const std::vector<std::uint8_t>& closed = {})
{
  PrincipalFoliation foliation(mesh, field.View(), rule, closed);
  EXPECT_TRUE(foliation.Trace());
  return foliation.Lines();
}

/// What is true of any lines.
inline void CheckLines(const std::vector<CurvatureLine>& lines, const FoliationRule& rule)
{
  for (const CurvatureLine& line : lines)
  {
    ASSERT_GE(line.points.size(), 2u);
    ASSERT_EQ(line.points.size(), line.curvatures.size());
    double length = 0.0;
    const std::size_t segments = line.points.size() - (line.closed ? 0 : 1);
    for (std::size_t i = 0; i < segments; ++i)
    {
      const double step = (line.points[(i + 1) % line.points.size()] - line.points[i]).norm();
      ASSERT_TRUE(std::isfinite(step) && std::isfinite(line.curvatures[i]));
      ASSERT_LE(step, 1.5 * rule.step + rule.closingDistance);
      length += step;
    }
    EXPECT_NEAR(line.length, length, 1e-10 * length);
    EXPECT_GE(line.length, rule.minimumLength * (1.0 - 1e-12));
    EXPECT_LE(line.length, rule.maximumLength + 3.0 * rule.step);
  }
}

struct TorusLines
{
  explicit TorusLines(int n)
    : surface(TorusMesh(2.0, 0.7, 3 * n, n))
    , field(ExactField(surface.Triangles(), MakeTorus(2.0, 0.7)))
    , edge(surface.Triangles().MeanEdgeLength())
  {
  }
  static double AroundTube(const Eigen::Vector3d& x)
  {
    return std::atan2(x[2], x.head<2>().norm() - 2.0);
  }

  MeshedSurface surface;
  FieldArrays field;
  double edge;
};

struct EllipsoidLines
{
  explicit EllipsoidLines(int frequency)
    : surface(EllipsoidMesh(frequency, 1.0, 0.8, 0.6))
    , field(ExactField(surface.Triangles(), MakeEllipsoid(1.0, 0.8, 0.6)))
  {
  }
  MeshedSurface surface;
  FieldArrays field;
};

inline double DistanceToUmbilics(const Eigen::Vector3d& x)
{
  double least = 10.0;
  for (const Eigen::Vector3d& umbilic : EllipsoidUmbilics(1.0, 0.8, 0.6))
  {
    least = std::min(least, (x - umbilic).norm());
  }
  return least;
}

} // namespace testing
} // namespace ridges

#endif
