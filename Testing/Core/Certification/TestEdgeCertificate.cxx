// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Certification/CertifiedSurface.h"
#include "Certification/EdgeCertificate.h"
#include "Certification/TriangleCertificate.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace ridges;
using ridges::testing::CertifiedSurface;

namespace
{

const double Pi = std::acos(-1.0);

/// A trough along x with waves: k2 is across the waves everywhere, and by symmetry it has extrema
/// along its curvature lines at x = 0, pi/6, pi/3, ..., which are the red ridges.
const CertifiedSurface& Waves()
{
  static const CertifiedSurface surface("0.05*cos(6*x)+2*y^2", FormulaFunction::Kind::Graph);
  return surface;
}

/// With an umbilic of index 1/2 at the origin.
const CertifiedSurface& Lemon()
{
  static const CertifiedSurface surface(
    "0.5*(x^2+y^2)+x^3/6+x*y^2/3", FormulaFunction::Kind::Graph);
  return surface;
}

EdgeCertificate CertifyOver(const CertifiedSurface& surface, const SurfaceBounds& bounds,
  const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
  const Eigen::Vector3d p = surface.Over(from[0], from[1]);
  const Eigen::Vector3d q = surface.Over(to[0], to[1]);
  return CertifyEdge(
    bounds, surface.Mapped({ p, q, q }), { surface.FrameAt(p).col(0), surface.FrameAt(q).col(0) });
}

} // namespace

TEST(EdgeCertificate, FindsTheCrossingWhereTheRidgeIs)
{
  for (const SurfaceBounds* bounds : { static_cast<const SurfaceBounds*>(&Waves().proof),
         static_cast<const SurfaceBounds*>(&Waves().samples) })
  {
    const EdgeCertificate edge = CertifyOver(Waves(), *bounds, { 0.45, 0.1 }, { 0.62, 0.13 });
    EXPECT_EQ(edge.failed, 0);
    EXPECT_EQ(edge.crossings[0], 0);
    ASSERT_EQ(edge.crossings[1], 1);
    // Round-off of b divided by its slope.
    EXPECT_NEAR(edge.position[1][0], Pi / 6.0, 1e-12);
    EXPECT_NEAR(edge.orientation, 1, 1);
  }
}

// The sign of b is the same at both ends: the acute rule sees no ridge here.
TEST(EdgeCertificate, CountsTwoRidgesOnOneEdge)
{
  for (const SurfaceBounds* bounds : { static_cast<const SurfaceBounds*>(&Waves().proof),
         static_cast<const SurfaceBounds*>(&Waves().samples) })
  {
    const EdgeCertificate edge = CertifyOver(Waves(), *bounds, { -0.1, 0.1 }, { 0.65, 0.13 });
    EXPECT_EQ(edge.crossings[1], 2);
    EXPECT_NE(edge.failed & OneCrossing, 0);
    const EdgeCertificate longer = CertifyOver(Waves(), *bounds, { -0.1, 0.1 }, { 1.15, 0.13 });
    EXPECT_EQ(longer.crossings[1], 3);
    EXPECT_NE(longer.failed & OneCrossing, 0);
  }
}

TEST(EdgeCertificate, DoesNotDecideWhereARidgeGoesThroughAVertex)
{
  const EdgeCertificate edge = CertifyOver(Waves(), Waves().proof, { 0.0, 0.1 }, { 0.1, 0.12 });
  EXPECT_NE(edge.failed & NoRidgeThroughVertex, 0);
  EXPECT_NE(edge.failed & OneCrossing, 0); // nor how many cross it
  EXPECT_EQ(edge.crossings[1], -1);
}

TEST(EdgeCertificate, DoesNotDecideAlongARidge)
{
  const EdgeCertificate edge = CertifyOver(Waves(), Waves().proof, { 0.0, 0.1 }, { 0.0, 0.2 });
  EXPECT_NE(edge.failed & (TransversalCrossings | NoRidgeThroughVertex), 0);
}

// Its ends are mirror images about the plane of the umbilic, and moved until it goes through.
TEST(EdgeCertificate, DoesNotDecideThroughAnUmbilic)
{
  const CertifiedSurface surface("x^2+y^2/0.64+z^2/0.36-1", FormulaFunction::Kind::Implicit);
  const double umbilic = 0.75; // a sqrt((a² - b²) / (a² - c²))
  const auto end = [](double angle, double side)
  {
    return Eigen::Vector3d(
      0.99 * std::cos(angle), side * std::sqrt(1.0 - 0.9801) * 0.8, 0.6 * 0.99 * std::sin(angle));
  };
  const auto edgeAt = [&surface, &end](double angle) {
    return surface.Mapped({ end(angle, -1.0), end(angle, 1.0), end(angle, 1.0) });
  };
  double low = 0.5;
  double high = 1.0;
  for (int step = 0; step < 60; ++step)
  {
    const double angle = 0.5 * (low + high);
    const MappedTriangle whole = edgeAt(angle);
    const Eigen::Vector3d half(0.5, 0.5, 0.0);
    const Eigen::Vector3d x = whole.Position(half) +
      HeightAlong(surface.proof, whole.Position(half), whole.Normal(half), 0.0) *
        whole.Normal(half);
    (x[0] > umbilic ? low : high) = angle;
  }
  const MappedTriangle whole = edgeAt(low);
  const EdgeCertificate edge = CertifyEdge(surface.proof, whole,
    { surface.FrameAt(whole.point[0]).col(0), surface.FrameAt(whole.point[1]).col(0) });
  EXPECT_NE(edge.failed & NoUmbilicOnEdge, 0);
  EXPECT_EQ(edge.crossings[0], -1);
}

// Along a long edge past two umbilics d1 makes more than a quarter of a turn: there the acute rule
// is wrong, and continuity is not.
TEST(EdgeCertificate, TurnsByContinuity)
{
  const CertifiedSurface surface("x^2+y^2/0.81+z^2/0.09-1", FormulaFunction::Kind::Implicit);
  int wrong = 0;
  for (const double y : { -0.4, -0.3, -0.2, -0.1, -0.05, 0.05, 0.1, 0.2, 0.3, 0.4 })
  {
    const auto top = [y](double x)
    { return Eigen::Vector3d(x, y, 0.3 * std::sqrt(1.0 - x * x - y * y / 0.81)); };
    const Eigen::Vector3d p = top(0.7);
    const Eigen::Vector3d q = top(-0.75);
    const MappedTriangle whole = surface.Mapped({ p, q, q });
    const Eigen::Vector3d first = surface.FrameAt(p).col(0);
    const Eigen::Vector3d last = surface.FrameAt(q).col(0);
    const EdgeCertificate edge = CertifyEdge(surface.proof, whole, { first, last });
    if (edge.orientation == 0)
    {
      continue;
    }
    // Followed in small steps, each of them acute.
    Eigen::Vector3d d1 = first;
    for (int step = 1; step <= 1000; ++step)
    {
      const Eigen::Vector3d weights(1.0 - step / 1000.0, step / 1000.0, 0.0);
      const Eigen::Vector3d normal = whole.Normal(weights);
      const Eigen::Vector3d flat = whole.Position(weights);
      const Eigen::Vector3d x = flat + HeightAlong(surface.proof, flat, normal, 0.0) * normal;
      const Eigen::Vector3d next = surface.FrameAt(x).col(0);
      d1 = next.dot(d1) < 0.0 ? Eigen::Vector3d(-next) : next;
    }
    EXPECT_EQ(edge.orientation, last.dot(d1) < 0.0 ? -1 : 1) << y;
    const bool isAcuteWrong = first.dot(d1) < 0.0;
    EXPECT_EQ((edge.failed & CorrectOrientation) != 0, isAcuteWrong) << y;
    wrong += isAcuteWrong ? 1 : 0;
  }
  EXPECT_GT(wrong, 0); // else nothing was tested
}

TEST(TriangleCertificate, HoldsWhereARidgeOnlyCrosses)
{
  const MappedTriangle whole =
    Waves().Mapped({ Waves().Over(0.45, 0.1), Waves().Over(0.62, 0.12), Waves().Over(0.5, 0.25) });
  EXPECT_EQ(CertifyTriangle(Waves().proof, whole).failed, 0);
  EXPECT_EQ(CertifyTriangle(Waves().samples, whole).failed, 0);
}

TEST(TriangleCertificate, FailsAroundAnUmbilic)
{
  const MappedTriangle whole = Lemon().Mapped(
    { Lemon().Over(-0.1, -0.05), Lemon().Over(0.1, -0.07), Lemon().Over(0.01, 0.12) });
  EXPECT_NE(CertifyTriangle(Lemon().proof, whole).failed & OneUmbilic, 0);
  EXPECT_NE(CertifyTriangle(Lemon().samples, whole).failed & OneUmbilic, 0);
}

// k1 along circles of radius 1/2 is constant, but for b0 = x² + y² - 0.0004 + ... of what is added:
// a closed blue ridge.
TEST(TriangleCertificate, FailsAroundAClosedRidge)
{
  const CertifiedSurface loop(
    "0.5-sqrt(0.25-x^2)-0.5*y^2+x^5/60+x^3*y^2/6-0.0004*x^3/6", FormulaFunction::Kind::Graph);
  const std::array<Eigen::Vector3d, 3> corners{ loop.Over(-0.1, -0.06), loop.Over(0.1, -0.06),
    loop.Over(0.0, 0.11) };
  const MappedTriangle whole = loop.Mapped(corners);
  const Eigen::Vector3d d1 = loop.FrameAt(corners[0]).col(0);
  const double inside = ExtremalityAt(loop.proof, loop.Over(0.0, 0.0), 0, d1);
  const double outside = ExtremalityAt(loop.proof, loop.Over(0.05, 0.0), 0, d1);
  ASSERT_LT(inside * outside, 0.0);
  EXPECT_NE(CertifyTriangle(loop.proof, whole).failed & NoRidgeInTriangle, 0);
  EXPECT_NE(CertifyTriangle(loop.samples, whole).failed & NoRidgeInTriangle, 0);
}
