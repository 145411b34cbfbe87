// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Certification/CertifiedSurface.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace ridges;
using ridges::testing::CertifiedSurface;

namespace
{

constexpr const char* Bumpy = "x^2 + 1.3*y^2 + 1.6*z^2 + 0.3*sin(2*x*y) + 0.2*exp(z - x) - 1";

/// Of a box around a point of the surface, at some places of the box.
template <typename Body>
void ForPlaces(const LocalFrame& frame, const IntervalVector& box, const Body& body)
{
  for (const double u : { 0.0, 0.31, 1.0 })
  {
    for (const double v : { 0.0, 0.77, 1.0 })
    {
      for (const double w : { 0.0, 0.5, 1.0 })
      {
        const std::array<double, 3> share{ u, v, w };
        Eigen::Vector3d x;
        for (int i = 0; i < 3; ++i)
        {
          x[i] = boost::numeric::median(frame.origin[i]);
          for (int axis = 0; axis < 3; ++axis)
          {
            const Interval& side = box[axis];
            x[i] +=
              frame.axes(i, axis) * (side.lower() + share[axis] * (side.upper() - side.lower()));
          }
        }
        body(x);
      }
    }
  }
}

} // namespace

// The derivative along the first axis, of every order, at points of the box.
TEST(SurfaceBounds, ContainDerivativesInTheBox)
{
  const CertifiedSurface surface(Bumpy, FormulaFunction::Kind::Implicit);
  const Eigen::Vector3d x(0.5, 0.3, 0.2);
  const LocalFrame frame{ { Interval(x[0]), Interval(x[1]), Interval(x[2]) }, surface.FrameAt(x) };
  const IntervalVector box{ Interval(-0.02, 0.03), Interval(-0.03, 0.01), Interval(-0.01, 0.01) };
  for (const SurfaceBounds* bounds : { static_cast<const SurfaceBounds*>(&surface.proof),
         static_cast<const SurfaceBounds*>(&surface.samples) })
  {
    const JetBounds jets = bounds->In(frame, box);
    ForPlaces(frame, box,
      [&surface, &frame, &jets](const Eigen::Vector3d& place)
      {
        using Jet = Taylor3<4>;
        std::array<Jet, 3> along;
        for (int i = 0; i < 3; ++i)
        {
          along[i] = Jet::Linear(place[i], frame.axes(i, 0), frame.axes(i, 1), frame.axes(i, 2));
        }
        const Jet exact = surface.function.Evaluate(along);
        for (int i = 0; i <= 4; ++i)
        {
          for (int j = 0; i + j <= 4; ++j)
          {
            for (int k = 0; i + j + k <= 4; ++k)
            {
              const double error = 1e-12 * (1.0 + std::abs(exact(i, j, k)));
              EXPECT_LE(jets.inBox(i, j, k).lower(), exact(i, j, k) + error);
              EXPECT_GE(jets.inBox(i, j, k).upper(), exact(i, j, k) - error);
            }
          }
        }
      });
  }
}

// By Taylor's formula the bounds on order k leave out what order 4 changes over the box: its size
// to the power 5 - k.
TEST(SurfaceBounds, ShrinkWithTheBoxByTheirOrder)
{
  const CertifiedSurface surface(Bumpy, FormulaFunction::Kind::Implicit);
  const Eigen::Vector3d x(0.5, 0.3, 0.2);
  const LocalFrame frame{ { Interval(x[0]), Interval(x[1]), Interval(x[2]) }, surface.FrameAt(x) };
  const auto width = [&surface, &frame](double size, int order)
  {
    const Interval side(-size, size);
    const Interval found = surface.proof.In(frame, { side, side, side }).inBox(order, 0, 0);
    return found.upper() - found.lower();
  };
  for (const int order : { 2, 3, 4 })
  {
    EXPECT_LT(width(0.005, order), 0.6 * width(0.01, order)) << order;
  }
}

// What a part is said to have, each of its points has.
TEST(SurfacePiece, SignsHoldInTheWholePart)
{
  const CertifiedSurface surface(
    "0.3*x^2+y^2+0.2*x^3-0.3*x*y^2+0.4*x^2*y^2+0.3*x^3*y", FormulaFunction::Kind::Graph);
  const MappedTriangle whole = surface.Mapped(
    { surface.Over(-0.25, -0.2), surface.Over(-0.1, -0.22), surface.Over(-0.2, -0.05) });
  const Eigen::Vector3d weights(0.2, 0.5, 0.3);
  int signs = 0;
  for (const double size : { 1.0, 0.3, 0.1, 0.03 })
  {
    Part part{ {}, 3 };
    for (int i = 0; i < 3; ++i)
    {
      part.corner[i] = (1.0 - size) * weights + size * Eigen::Vector3d::Unit(i);
    }
    const PartBounds bounds = BoundPart(surface.proof, whole, part, 0.0);
    if (!bounds.hasGap || !bounds.isNarrow)
    {
      continue;
    }
    for (int i = 0; i < 3; ++i)
    {
      const Eigen::Vector3d at = 0.9 * part.corner[i] + 0.1 * part.Center();
      const Eigen::Vector3d normal = whole.Normal(at);
      const Eigen::Vector3d flat = whole.Position(at);
      const Eigen::Vector3d x = flat + HeightAlong(surface.proof, flat, normal, 0.0) * normal;
      for (int color = 0; color < 2; ++color)
      {
        const Interval& value = bounds.extremality[color].value;
        const double b = ExtremalityAt(surface.proof, x, color, bounds.frame.col(0));
        signs += HasSign(value) ? 1 : 0;
        EXPECT_TRUE(!IsPositive(value) || b > 0.0);
        EXPECT_TRUE(!IsNegative(value) || b < 0.0);
      }
    }
  }
  EXPECT_GT(signs, 6); // else nothing was tested
}
