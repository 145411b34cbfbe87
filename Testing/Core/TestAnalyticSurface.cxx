// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The ground truth of the other tests, tested against closed forms and finite differences.

#include "AnalyticSurface.h"
#include "EllipsoidRidges.h"
#include "SurfaceSampling.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace
{

using namespace ridges::testing;
using Eigen::Vector3d;

const double Pi = 3.14159265358979323846;

// Exact forms: round-off only. Relative where the scale of the value is not 1.
const double RoundOff = 1e-12;

} // namespace

//------------------------------------------------------------------------------
TEST(AnalyticSurface, SphereHasTheJetOfTheSquareRoot)
{
  for (const double r : { 0.01, 1.0, 250.0 })
  {
    const AnalyticSurface surface = MakeSphere(r);
    const Vector3d direction = Vector3d(1, -2, 0.5).normalized();
    const ExactMonge monge = surface.Monge(r * direction);
    EXPECT_LT((monge.n - direction).norm(), RoundOff);
    EXPECT_NEAR(monge.k1 * r, -1.0, RoundOff);
    EXPECT_NEAR(monge.k2 * r, -1.0, RoundOff);
    for (const double b : monge.b)
    {
      EXPECT_NEAR(b * r * r, 0.0, RoundOff);
    }
    const double c[5] = { -3, 0, -1, 0, -3 }; // of sqrt(1 - x^2 - y^2)
    for (int i = 0; i < 5; ++i)
    {
      EXPECT_NEAR(monge.c[i] * r * r * r, c[i], RoundOff);
    }
    EXPECT_NEAR(monge.P1 * std::pow(r, 4), 0.0, RoundOff);
    EXPECT_NEAR(monge.P2 * std::pow(r, 4), 0.0, RoundOff);
  }
}

//------------------------------------------------------------------------------
TEST(AnalyticSurface, CylinderIsCurvedOneWay)
{
  const double r = 0.7;
  const ExactMonge monge =
    MakeCylinder(r).Monge(Vector3d(r * std::cos(0.3), r * std::sin(0.3), 5.0));
  EXPECT_NEAR(monge.k1, 0.0, RoundOff);
  EXPECT_NEAR(monge.k2 * r, -1.0, RoundOff);
  EXPECT_NEAR(std::abs(monge.d1.z()), 1.0, RoundOff);
  const double c[5] = { 0, 0, 0, 0, -3 };
  for (int i = 0; i < 5; ++i)
  {
    EXPECT_NEAR(monge.c[i] * r * r * r, c[i], 10 * RoundOff);
  }
  EXPECT_NEAR(monge.P1, 0.0, 10 * RoundOff);
  EXPECT_NEAR(monge.P2, 0.0, 100 * RoundOff); // scale 1/r^4 = 4
}

//------------------------------------------------------------------------------
TEST(AnalyticSurface, TorusMatchesItsClosedForms)
{
  const double R = 1.0;
  const double r = 0.4;
  const AnalyticSurface polynomial = MakeTorus(R, r);
  // The same surface by another formula, through sqrt.
  const AnalyticSurface root(
    [=](auto x, auto y, auto z)
    {
      const auto h = sqrt(x * x + y * y) - R;
      return h * h + z * z - r * r;
    });
  for (const AnalyticSurface& surface : { polynomial, root })
  {
    for (const double angle : { 0.0, 0.4, 1.3, 2.2, 3.1, 4.5, 5.9 })
    {
      const double u = 0.8;
      const double h = R + r * std::cos(angle);
      const Vector3d around(-std::sin(u), std::cos(u), 0);
      const Vector3d along(
        -std::sin(angle) * std::cos(u), -std::sin(angle) * std::sin(u), std::cos(angle));
      const Vector3d point(h * std::cos(u), h * std::sin(u), r * std::sin(angle));
      const ExactMonge monge = surface.Monge(point);

      const double k1 = -std::cos(angle) / h;
      const double side = monge.d2.dot(along);
      EXPECT_NEAR(std::abs(monge.d1.dot(around)), 1.0, RoundOff);
      EXPECT_NEAR(std::abs(side), 1.0, RoundOff);
      EXPECT_NEAR(monge.k1, k1, 10 * RoundOff);
      EXPECT_NEAR(monge.k2, -1 / r, 10 * RoundOff);

      // b1 = dk1 along d2; the other derivatives of k vanish.
      const double b1 = side * R * std::sin(angle) / (r * h * h);
      EXPECT_NEAR(monge.b[0], 0.0, 10 * RoundOff);
      EXPECT_NEAR(monge.b[1], b1, 10 * RoundOff);
      EXPECT_NEAR(monge.b[2], 0.0, 10 * RoundOff);
      EXPECT_NEAR(monge.b[3], 0.0, 10 * RoundOff);

      // k1 and k2 are constant along their lines, so P1 = P2 = 0, which gives c0 and c4.
      EXPECT_NEAR(monge.c[0], 3 * k1 * k1 * k1 - 3 * b1 * b1 / (k1 + 1 / r), 100 * RoundOff);
      EXPECT_NEAR(monge.c[4], -3 / (r * r * r), 100 * RoundOff);
      EXPECT_NEAR(monge.P1, 0.0, 100 * RoundOff);
      EXPECT_NEAR(monge.P2, 0.0, 100 * RoundOff);
    }
  }
}

//------------------------------------------------------------------------------
TEST(AnalyticSurface, EllipsoidHasItsGaussAndMeanCurvature)
{
  const double a = 3.0;
  const double b = 2.0;
  const double c = 0.5;
  const NamedSurface item = { "ellipsoid", MakeEllipsoid(a, b, c), Vector3d::Zero() };
  for (const Vector3d& p : RandomPoints(item, 50))
  {
    const ExactMonge monge = item.surface.Monge(p);
    // The distance from the origin to the tangent plane.
    const double h = 1 / Vector3d(p.x() / (a * a), p.y() / (b * b), p.z() / (c * c)).norm();
    const double abc = a * b * c;
    const double gauss = std::pow(h, 4) / (abc * abc);
    const double mean =
      -std::pow(h, 3) * (a * a + b * b + c * c - p.squaredNorm()) / (2 * abc * abc);
    EXPECT_NEAR(monge.k1 * monge.k2 / gauss, 1.0, 100 * RoundOff);
    EXPECT_NEAR((monge.k1 + monge.k2) / (2 * mean), 1.0, 100 * RoundOff);
    EXPECT_GE(monge.k1, monge.k2);
  }
}

//------------------------------------------------------------------------------
TEST(AnalyticSurface, FrameIsDirectOrthonormalAndOutward)
{
  for (const NamedSurface& item : GenericSurfaces())
  {
    SCOPED_TRACE(item.name);
    for (const Vector3d& p : RandomPoints(item, 20))
    {
      const ExactMonge monge = item.surface.Monge(p);
      Eigen::Matrix3d frame;
      frame << monge.d1, monge.d2, monge.n;
      EXPECT_LT((frame.transpose() * frame - Eigen::Matrix3d::Identity()).norm(), RoundOff);
      EXPECT_NEAR(frame.determinant(), 1.0, RoundOff);
      EXPECT_GT(item.surface.Value(p + 1e-4 * monge.n), 0.0);
      EXPECT_LT(item.surface.Value(p - 1e-4 * monge.n), 0.0);
      EXPECT_GE(monge.k1, monge.k2);
    }
  }
}

//------------------------------------------------------------------------------
TEST(AnalyticSurface, ProjectEndsAtRoundOff)
{
  for (const NamedSurface& item : GenericSurfaces())
  {
    SCOPED_TRACE(item.name);
    for (const Vector3d& p : RandomPoints(item, 20))
    {
      const Vector3d moved = p + 0.01 * Vector3d(0.3, -0.8, 0.5);
      const Vector3d projected = item.surface.Project(moved);
      const double slope = item.surface.Gradient(projected).norm();
      EXPECT_LT(std::abs(item.surface.Value(projected)) / slope, 1e-14); // a distance, size 1
      EXPECT_LT((projected - moved).norm(), 0.011);
    }
  }
  EXPECT_THROW(MakeSphere(1.0).Project(Vector3d::Zero()), std::runtime_error);
}

//------------------------------------------------------------------------------
TEST(AnalyticSurface, MongePolynomialIsOnTheSurfaceToOrderFive)
{
  for (const NamedSurface& item : GenericSurfaces())
  {
    SCOPED_TRACE(item.name);
    for (const Vector3d& p : RandomPoints(item, 20))
    {
      const ExactMonge m = item.surface.Monge(p);
      const double slope = item.surface.Gradient(p).norm();
      const auto error = [&](double radius)
      {
        double worst = 0.0;
        for (int i = 0; i < 12; ++i)
        {
          const double x = radius * std::cos(i * Pi / 6);
          const double y = radius * std::sin(i * Pi / 6);
          const double z = (m.k1 * x * x + m.k2 * y * y) / 2 +
            (m.b[0] * x * x * x + 3 * m.b[1] * x * x * y + 3 * m.b[2] * x * y * y +
              m.b[3] * y * y * y) /
              6 +
            (m.c[0] * x * x * x * x + 4 * m.c[1] * x * x * x * y + 6 * m.c[2] * x * x * y * y +
              4 * m.c[3] * x * y * y * y + m.c[4] * y * y * y * y) /
              24;
          const double value = item.surface.Value(p + x * m.d1 + y * m.d2 + z * m.n);
          worst = std::max(worst, std::abs(value) / slope);
        }
        return worst;
      };
      // Halving the radius divides an error of order 5 (6 where the fifth order is small) by 32
      // (64); a wrong coefficient of order 4 or less gives at most 16. Here at least 24.
      const double radius = 0.02 * LocalLength(m);
      EXPECT_GT(error(radius) / error(0.5 * radius), 24.0);
    }
  }
}

//------------------------------------------------------------------------------
// b0, b1, b2, b3 are the derivatives of k1 along d1, of k1 along d2, of k2 along d1, of k2 along
// d2.
TEST(AnalyticSurface, ThirdOrderIsTheDerivativeOfTheCurvatures)
{
  for (const NamedSurface& item : GenericSurfaces())
  {
    SCOPED_TRACE(item.name);
    for (const Vector3d& p : RandomPoints(item, 20))
    {
      const ExactMonge monge = item.surface.Monge(p);
      const double h = 1e-3 * LocalLength(monge);
      for (int i = 0; i < 4; ++i)
      {
        const Vector3d direction = i % 2 == 0 ? monge.d1 : monge.d2;
        const auto k = [&](double s)
        {
          const ExactMonge near = item.surface.Monge(item.surface.Project(p + s * direction));
          return i < 2 ? near.k1 : near.k2;
        };
        // In units of the local length: truncation (1e-3)^4 times a fifth derivative of up to 1e5;
        // round-off 1e-14 / 1e-3.
        const double length = LocalLength(monge);
        EXPECT_NEAR(FirstDerivative(k, h) * length * length, monge.b[i] * length * length, 1e-7);
      }
    }
  }
}

//------------------------------------------------------------------------------
// Where b vanishes, the second derivative of the curvature along its line is P / (k1 - k2) or
// P / (k2 - k1). The ridge points are found on circles of directions, by bisection of b.
TEST(AnalyticSurface, FourthOrderIsTheSecondDerivativeAtRidgePoints)
{
  int counts[5] = { 0, 0, 0, 0, 0 };
  for (const NamedSurface& item : GenericSurfaces())
  {
    SCOPED_TRACE(item.name);
    for (const bool maximum : { true, false })
    {
      const auto at = [&](double angle)
      {
        const Vector3d direction =
          std::cos(angle) * Vector3d(0.8, 0.5, -0.1) + std::sin(angle) * Vector3d(-0.4, 0.7, 0.3);
        return item.surface.Monge(item.surface.IntersectRay(item.center, direction));
      };
      const auto directionOf = [&](const ExactMonge& m) { return maximum ? m.d1 : m.d2; };
      const int samples = 300;
      for (int i = 0; i < samples; ++i)
      {
        double begin = 2 * Pi * i / samples;
        double end = 2 * Pi * (i + 1) / samples;
        const Vector3d reference = directionOf(at(begin));
        if (std::abs(reference.dot(directionOf(at(end)))) < 0.9)
        {
          continue; // the directions turn too fast, or the ray jumps
        }
        const auto b = [&](double angle)
        {
          const ExactMonge m = at(angle);
          const double value = maximum ? m.b[0] : m.b[3];
          return directionOf(m).dot(reference) < 0.0 ? -value : value;
        };
        const bool positive = b(begin) > 0.0;
        if (positive == (b(end) > 0.0))
        {
          continue;
        }
        for (int step = 0; step < 55; ++step)
        {
          const double middle = 0.5 * (begin + end);
          ((b(middle) > 0.0) == positive ? begin : end) = middle;
        }
        const ExactMonge ridge = at(begin);
        const double length = LocalLength(ridge);
        if ((ridge.k1 - ridge.k2) * length < 0.1 || std::abs(b(begin)) * length * length > 1e-9)
        {
          continue; // near an umbilic, or a jump
        }
        const auto k = [&](double s)
        {
          const ExactMonge near = item.surface.Monge(
            OnCurvatureLine(item.surface, ridge.origin, directionOf(ridge), maximum, s));
          return maximum ? near.k1 : near.k2;
        };
        const double P = maximum ? ridge.P1 : ridge.P2;
        // In units of the local length: truncation (3e-3)^4 times a sixth derivative of up to 1e5;
        // round-off 1e-13 / (3e-3)^2.
        const double h = 3e-3 * length;
        const double unit = length * length * length;
        const double expected = unit * P / (maximum ? ridge.k1 - ridge.k2 : ridge.k2 - ridge.k1);
        EXPECT_NEAR(unit * SecondDerivative(k, h), expected, 1e-5);

        // Section 3: elliptic is a maximum of k1 or a minimum of k2.
        if (std::abs(expected) > 0.01)
        {
          const bool isMaximum = k(h) < k(0) && k(-h) < k(0);
          EXPECT_EQ(P < 0.0, isMaximum == maximum);
          ++counts[maximum ? (P < 0.0 ? MaximumElliptic : MaximumHyperbolic)
                           : (P < 0.0 ? MinimumElliptic : MinimumHyperbolic)];
        }
      }
    }
  }
  for (int type = 1; type <= 4; ++type)
  {
    EXPECT_GT(counts[type], 0) << "no ridge point of type " << type << " was tested";
  }
}

//------------------------------------------------------------------------------
TEST(EllipsoidRidges, UmbilicsAreRoundAndHaveOneRidge)
{
  const double a = 1.0;
  const double b = 0.8;
  const double c = 0.6;
  const AnalyticSurface surface = MakeEllipsoid(a, b, c);
  for (const Vector3d& p : EllipsoidUmbilics(a, b, c))
  {
    EXPECT_NEAR(surface.Value(p), 0.0, 1e-15);
    const ExactMonge m = surface.Monge(p);
    // The section by the plane y = 0 and that across have the same curvature there.
    const double k = -a * c / (b * b * b);
    EXPECT_NEAR(m.k1, k, 10 * RoundOff);
    EXPECT_NEAR(m.k2, k, 10 * RoundOff);
    // One real root of the cubic b0 x^3 + 3 b1 x^2 y + 3 b2 x y^2 + b3 y^3: its discriminant, up to
    // a factor 27, is negative. Index +1/2: the determinant of the derivative of the traceless part
    // of the curvature tensor, (b0 - b2, b1 - b3; b1, b2), is positive.
    const double b0 = m.b[0];
    const double b1 = m.b[1];
    const double b2 = m.b[2];
    const double b3 = m.b[3];
    const double discriminant = 3 * b1 * b1 * b2 * b2 - 4 * b0 * b2 * b2 * b2 -
      4 * b1 * b1 * b1 * b3 + 6 * b0 * b1 * b2 * b3 - b0 * b0 * b3 * b3;
    EXPECT_LT(discriminant, -0.01);
    EXPECT_GT((b0 - b2) * b2 - (b1 - b3) * b1, 0.01);
  }
}

//------------------------------------------------------------------------------
TEST(EllipsoidRidges, CoordinatePlanesAreRidgesOfFigureTwo)
{
  const double a = 1.0;
  const double b = 0.8;
  const double c = 0.6;
  const AnalyticSurface surface = MakeEllipsoid(a, b, c);
  const double umbilic = std::acos(EllipsoidUmbilics(a, b, c)[0].x() / a);
  for (int i = 0; i < 72; ++i)
  {
    const double t = 2 * Pi * (i + 0.5) / 72;
    EXPECT_EQ(EllipsoidRidgeTypeAt(a, b, c, 0, t), MaximumElliptic);
    EXPECT_EQ(EllipsoidRidgeTypeAt(a, b, c, 2, t), MinimumElliptic);
    const bool nearA = std::abs(std::cos(t)) > std::cos(umbilic);
    EXPECT_EQ(EllipsoidRidgeTypeAt(a, b, c, 1, t), nearA ? MaximumHyperbolic : MinimumHyperbolic);

    for (int plane = 0; plane < 3; ++plane)
    {
      const ExactMonge m = surface.Monge(EllipsoidRidgePoint(a, b, c, plane, t));
      const bool maximum = std::abs(m.d1[plane]) > 0.5;
      EXPECT_NEAR(std::abs(maximum ? m.d1[plane] : m.d2[plane]), 1.0, RoundOff);
      EXPECT_NEAR(maximum ? m.b[0] : m.b[3], 0.0, 100 * RoundOff);
    }
  }
}

//------------------------------------------------------------------------------
// At the ends of the axes the curvature lines are the coordinate ellipses, so the second derivative
// of k across a ridge is that of the curvature of an ellipse at a vertex: with semi-axis p at the
// vertex and q across, k = -p/q^2 and k'' = 3 p (p^2 - q^2) / q^6.
TEST(EllipsoidRidges, SecondDerivativesAtTheVertices)
{
  const double axes[3] = { 1.0, 0.8, 0.6 };
  const AnalyticSurface surface = MakeEllipsoid(axes[0], axes[1], axes[2]);
  for (int vertex = 0; vertex < 3; ++vertex)
  {
    const ExactMonge m = surface.Monge(axes[vertex] * Vector3d::Unit(vertex));
    const double p = axes[vertex];
    for (int across = 0; across < 3; ++across)
    {
      if (across != vertex)
      {
        const double q = axes[across];
        const bool maximum = std::abs(m.d1[across]) > 0.5;
        const double expected = 3 * p * (p * p - q * q) / std::pow(q, 6);
        EXPECT_NEAR(maximum ? m.k1 : m.k2, -p / (q * q), 10 * RoundOff);
        EXPECT_NEAR(maximum ? m.P1 / (m.k1 - m.k2) : m.P2 / (m.k2 - m.k1), expected,
          1000 * RoundOff * std::abs(expected));
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(EllipsoidRidges, PiecesHaveTheirClosedFormsAndSymmetry)
{
  const double shapes[3][3] = { { 1.0, 0.8, 0.6 }, { 3.0, 2.0, 1.0 }, { 10.0, 9.5, 6.0 } };
  for (const auto& shape : shapes)
  {
    const double a = shape[0];
    const double b = shape[1];
    const double c = shape[2];
    const std::vector<EllipsoidRidgePiece> pieces = EllipsoidRidgeIntegrals(a, b, c);
    ASSERT_EQ(pieces.size(), 6u); // no turning points
    const int types[6] = { 1, 2, 4, 2, 4, 3 };
    const int planes[6] = { 0, 1, 1, 1, 1, 2 };
    const double tolerance = 1e-9; // relative, of the quadrature
    for (int i = 0; i < 6; ++i)
    {
      const EllipsoidRidgePiece& piece = pieces[i];
      EXPECT_EQ(piece.type, types[i]);
      EXPECT_EQ(piece.plane, planes[i]);
      EXPECT_EQ(piece.closed, piece.plane != 1);
      EXPECT_EQ(piece.endsAtUmbilics, piece.plane == 1);
      // k across the plane times the speed is constant in t: (product of the semi-axes in the
      // plane) / (semi-axis across)^2.
      const double across = shape[piece.plane];
      const double strength = a * b * c / std::pow(across, 3) * (piece.end - piece.begin);
      EXPECT_NEAR(piece.strength / strength, 1.0, tolerance);
      EXPECT_GT(piece.sharpness, 0.0);
    }
    const auto perimeter = [](double p, double q)
    { return 4 * p * std::comp_ellint_2(std::sqrt(1 - q * q / (p * p))); };
    EXPECT_NEAR(pieces[0].length / perimeter(b, c), 1.0, tolerance);
    EXPECT_NEAR(pieces[5].length / perimeter(a, b), 1.0, tolerance);
    EXPECT_NEAR(
      (pieces[1].length + pieces[2].length + pieces[3].length + pieces[4].length) / perimeter(a, c),
      1.0, tolerance);
    for (int i = 1; i <= 2; ++i)
    {
      EXPECT_NEAR(pieces[i].length / pieces[i + 2].length, 1.0, tolerance);
      EXPECT_NEAR(pieces[i].strength / pieces[i + 2].strength, 1.0, tolerance);
      EXPECT_NEAR(pieces[i].sharpness / pieces[i + 2].sharpness, 1.0, tolerance);
    }
  }
}

//------------------------------------------------------------------------------
TEST(EllipsoidRidges, SharpnessIsScaleFreeAndLogarithmicInTheCutoff)
{
  const std::vector<EllipsoidRidgePiece> one = EllipsoidRidgeIntegrals(1.0, 0.8, 0.6);
  const std::vector<EllipsoidRidgePiece> ten = EllipsoidRidgeIntegrals(10.0, 8.0, 6.0);
  const std::vector<EllipsoidRidgePiece> fine = EllipsoidRidgeIntegrals(1.0, 0.8, 0.6, 0.001);
  const std::vector<EllipsoidRidgePiece> finer = EllipsoidRidgeIntegrals(1.0, 0.8, 0.6, 0.0001);
  for (std::size_t i = 0; i < one.size(); ++i)
  {
    EXPECT_NEAR(ten[i].sharpness / one[i].sharpness, 1.0, 1e-9);
    EXPECT_NEAR(ten[i].strength / one[i].strength, 1.0, 1e-9);
    if (one[i].closed)
    {
      EXPECT_DOUBLE_EQ(fine[i].sharpness, one[i].sharpness);
    }
    else
    {
      // A tenth of the cut-off adds the same amount each time, up to terms of its own order.
      const double first = fine[i].sharpness - one[i].sharpness;
      const double second = finer[i].sharpness - fine[i].sharpness;
      EXPECT_NEAR(second / first, 1.0, 0.05);
    }
  }
}
