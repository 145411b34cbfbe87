// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Ridge points found on surfaces themselves.

#include "EllipsoidRidges.h"
#include "ExactRidges.h"
#include "SurfaceSampling.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace
{

using namespace ridges::testing;
using Eigen::Vector2d;
using Eigen::Vector3d;

} // namespace

//------------------------------------------------------------------------------
// Against differences along curvature lines, whose own turning is that of the frame.
TEST(ExtremalityGradient, IsTheDerivativeOfTheExtremality)
{
  for (const NamedSurface& item : GenericSurfaces())
  {
    for (const Vector3d& point : RandomPoints(item, 20))
    {
      const ExactMonge monge = item.surface.Monge(point);
      const double length = LocalLength(monge);
      const double h = 1e-3 * length;
      for (const bool maximum : { true, false })
      {
        const Vector2d gradient = ExtremalityGradient(monge, maximum);
        for (int axis = 0; axis < 2; ++axis)
        {
          const Vector3d direction = axis == 0 ? monge.d1 : monge.d2;
          const auto extremality = [&](double s)
          {
            const ExactMonge there =
              item.surface.Monge(OnCurvatureLine(item.surface, point, direction, axis == 0, s));
            const double sign = there.d1.dot(monge.d1) < 0.0 ? -1.0 : 1.0;
            return sign * (maximum ? there.b[0] : there.b[3]);
          };
          // Fourth-order differences, of a quantity that changes over the length; 1 / (k1 - k2) up
          // to ten lengths.
          EXPECT_NEAR(gradient[axis] * std::pow(length, 3),
            FirstDerivative(extremality, h) * std::pow(length, 3), 1e-5)
            << item.name << " maximum " << maximum << " axis " << axis;
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(NearestRidgePoint, IsInTheSymmetryPlanesOfTheEllipsoid)
{
  const std::array<double, 3> axes = { 1.0, 0.8, 0.6 };
  const AnalyticSurface surface = MakeEllipsoid(axes[0], axes[1], axes[2]);
  for (const EllipsoidRidgePiece& piece : EllipsoidRidgeIntegrals(axes[0], axes[1], axes[2]))
  {
    for (const double fraction : { 0.1, 0.3, 0.5, 0.7, 0.9 })
    {
      const double t = piece.begin + fraction * (piece.end - piece.begin);
      const Vector3d onRidge = EllipsoidRidgePoint(axes[0], axes[1], axes[2], piece.plane, t);
      for (const double offset : { -0.02, 0.01 })
      {
        const Vector3d start = surface.Project(onRidge + offset * Vector3d::Unit(piece.plane));
        const bool maximum = piece.type <= MaximumHyperbolic;
        const ExactRidgePoint nearest = NearestRidgePoint(surface, maximum, start, 0.1);
        ASSERT_TRUE(nearest.found);
        // Newton stops at steps of a millionth of the reach, which the next one squares.
        EXPECT_LT(std::abs(nearest.monge.origin[piece.plane]), 1e-8);
        EXPECT_NEAR(nearest.Distance(start), std::abs(offset), 0.1 * std::abs(offset));
        EXPECT_EQ(nearest.IsElliptic(maximum),
          piece.type == MaximumElliptic || piece.type == MinimumElliptic);
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(NearestRidgePoint, IsNotFoundBeyondTheReach)
{
  const AnalyticSurface surface = MakeEllipsoid(1.0, 0.8, 0.6);
  const Vector3d amid = surface.Project(Vector3d(0.5, 0.45, 0.4));
  EXPECT_FALSE(NearestRidgePoint(surface, true, amid, 0.05).found);
  EXPECT_FALSE(NearestRidgePoint(surface, false, amid, 0.05).found);
}
