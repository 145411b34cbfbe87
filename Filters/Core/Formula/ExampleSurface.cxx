// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Formula/ExampleSurface.h"

#include "Formula/TrianglesOfPoints.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>

namespace ridges
{
namespace
{

constexpr int SmoothingSteps = 60;
constexpr int NewtonSteps = 50;

/// The icosahedron's corners and its faces, outward.
Eigen::Matrix<double, 3, 12> IcosahedronPoints()
{
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  Eigen::Matrix<double, 3, 12> points;
  // clang-format off
  points << -1,  1, -1,  1,  0,  0,  0,  0,  g,  g, -g, -g,
             g,  g, -g, -g, -1,  1, -1,  1,  0,  0,  0,  0,
             0,  0,  0,  0,  g,  g, -g, -g, -1,  1, -1,  1;
  // clang-format on
  return points.colwise().normalized();
}

constexpr std::array<Triangle, 20> IcosahedronFaces = { { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 },
  { 0, 7, 10 }, { 0, 10, 11 }, { 1, 5, 9 }, { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 },
  { 3, 9, 4 }, { 3, 4, 2 }, { 3, 2, 6 }, { 3, 6, 8 }, { 3, 8, 9 }, { 4, 9, 5 }, { 2, 4, 11 },
  { 6, 2, 10 }, { 8, 6, 7 }, { 9, 8, 1 } } };

/// Numbers the points of a subdivided icosahedron: shared corners and edges only once.
class GeodesicNumbering
{
public:
  explicit GeodesicNumbering(int frequency)
    : Frequency_(frequency)
    , FirstInside_(12 + 30 * (frequency - 1))
  {
    for (auto& row : this->EdgeIds_)
    {
      row.fill(-1);
    }
  }

  /// The point at i steps from corner 0 to 1 and j steps from corner 0 to 2 of the face.
  Id operator()(int face, int i, int j)
  {
    const int n = this->Frequency_;
    const Triangle& c = IcosahedronFaces[face];
    if (i + j == 0 || i == n || j == n)
    {
      return i == n ? c[1] : (j == n ? c[2] : c[0]);
    }
    if (j == 0)
    {
      return this->OnEdge(c[0], c[1], i);
    }
    if (i == 0)
    {
      return this->OnEdge(c[0], c[2], j);
    }
    if (i + j == n)
    {
      return this->OnEdge(c[1], c[2], j);
    }
    const int insideFace = (n - 1) * (n - 2) / 2;
    const int before = (j - 1) * (n - 1) - j * (j - 1) / 2;
    return this->FirstInside_ + face * insideFace + before + i - 1;
  }

private:
  Id OnEdge(Id a, Id b, int step)
  {
    const bool forward = a < b;
    Id& edge = this->EdgeIds_[forward ? a : b][forward ? b : a];
    if (edge < 0)
    {
      edge = this->NextEdge_++;
    }
    return 12 + edge * (this->Frequency_ - 1) + (forward ? step : this->Frequency_ - step) - 1;
  }

  int Frequency_;
  Id FirstInside_;
  Id NextEdge_ = 0;
  std::array<std::array<Id, 12>, 12> EdgeIds_{};
};

/// Where the ray from the inner point meets the surface: bisection, as f may be far from linear.
Eigen::Vector3d CastRay(const ImplicitSurface& surface, const Eigen::Vector3d& direction)
{
  const Eigen::Vector3d center = surface.Center();
  Eigen::Vector3d gradient;
  double inside = 0.0;
  double outside = 1e-3;
  while (surface.Evaluate(center + outside * direction, gradient) < 0.0)
  {
    inside = outside;
    outside *= 1.5;
  }
  for (int step = 0; step < NewtonSteps; ++step)
  {
    const double middle = 0.5 * (inside + outside);
    const bool within = surface.Evaluate(center + middle * direction, gradient) < 0.0;
    (within ? inside : outside) = middle;
  }
  return surface.Project(center + outside * direction);
}

/// The point of the surface nearest to one that is not far from it.
Eigen::Vector3d Nearest(const ImplicitSurface& surface, const Eigen::Vector3d& target)
{
  const Eigen::Vector3d projected = surface.Project(target);
  // On a coarse mesh the mean may be too far from the surface for Newton's method.
  const bool near = (projected - target).norm() < 0.1 * (target - surface.Center()).norm();
  return near ? projected : CastRay(surface, (target - surface.Center()).normalized());
}

static_assert(MeshSurfaceLoops == 1 + 2 * SmoothingSteps, "one to cast, two for each step");

} // namespace

Eigen::Vector3d ImplicitSurface::Project(Eigen::Vector3d x) const
{
  Eigen::Vector3d gradient;
  for (int step = 0; step < NewtonSteps; ++step)
  {
    const double value = this->Evaluate(x, gradient);
    const Eigen::Vector3d move = gradient * (value / gradient.squaredNorm());
    x -= move;
    if (move.norm() <= 1e-15 * x.norm())
    {
      break;
    }
  }
  return x;
}

EllipsoidSurface::EllipsoidSurface(const Eigen::Vector3d& semiAxes)
  : InverseSquares_(semiAxes.cwiseAbs2().cwiseInverse())
{
}

double EllipsoidSurface::Evaluate(const Eigen::Vector3d& x, Eigen::Vector3d& gradient) const
{
  gradient = 2.0 * this->InverseSquares_.cwiseProduct(x);
  return 0.5 * gradient.dot(x) - 1.0;
}

double BlendSurface::Evaluate(const Eigen::Vector3d& x, Eigen::Vector3d& gradient) const
{
  static const EllipsoidSurface a({ 0.15, 0.25, 0.35 });
  static const EllipsoidSurface b({ 0.1, 0.2, 0.3 });
  const Eigen::Vector3d centerOfB(0.25, 0.1, 0.1);
  Eigen::Vector3d gradientA;
  Eigen::Vector3d gradientB;
  const double ofA = std::exp(-0.7 * a.Evaluate(x, gradientA));
  const double ofB = std::exp(-0.7 * b.Evaluate(x - centerOfB, gradientB));
  gradient = 0.7 * (ofA * gradientA + ofB * gradientB);
  return 1.0 - ofA - ofB;
}

PointsAndTriangles GeodesicSphere(int frequency)
{
  const int n = frequency;
  const Eigen::Matrix3d turn = (Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()) *
    Eigen::AngleAxisd(1.1, Eigen::Vector3d::UnitX()) *
    Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ()))
                                 .toRotationMatrix();
  const Eigen::Matrix<double, 3, 12> corners = turn * IcosahedronPoints();
  GeodesicNumbering numbering(n);

  PointsAndTriangles mesh;
  mesh.points.resize(3, 10 * static_cast<Eigen::Index>(n) * n + 2);
  mesh.triangles.reserve(20 * static_cast<std::size_t>(n) * n);
  for (int face = 0; face < static_cast<int>(IcosahedronFaces.size()); ++face)
  {
    const Triangle& c = IcosahedronFaces[face];
    for (int j = 0; j <= n; ++j)
    {
      for (int i = 0; i + j <= n; ++i)
      {
        const Id p = numbering(face, i, j);
        mesh.points.col(p) =
          ((n - i - j) * corners.col(c[0]) + i * corners.col(c[1]) + j * corners.col(c[2]))
            .normalized();
        if (i + j < n)
        {
          mesh.triangles.push_back({ p, numbering(face, i + 1, j), numbering(face, i, j + 1) });
        }
        if (i + j < n - 1)
        {
          mesh.triangles.push_back({ numbering(face, i + 1, j), numbering(face, i + 1, j + 1),
            numbering(face, i, j + 1) });
        }
      }
    }
  }
  return mesh;
}

PointsAndTriangles MeshSurface(
  const ImplicitSurface& surface, int frequency, const StoppableLoop& loop)
{
  PointsAndTriangles result = GeodesicSphere(frequency);
  Eigen::Matrix3Xd& points = result.points;
  const auto count = static_cast<Id>(points.cols());
  const TrianglesOfPoints around(count, result.triangles);
  Eigen::Matrix3Xd targets(3, points.cols());
  const auto cast = [&surface, &points](Id begin, Id end)
  {
    for (Id p = begin; p < end; ++p)
    {
      points.col(p) = CastRay(surface, points.col(p));
    }
  };
  const auto aim = [&around, &points, &targets](Id begin, Id end)
  {
    for (Id p = begin; p < end; ++p)
    {
      targets.col(p) = around.MeanCentroid(p, [&points](Id corner) { return points.col(corner); });
    }
  };
  const auto move = [&surface, &points, &targets](Id begin, Id end)
  {
    for (Id p = begin; p < end; ++p)
    {
      points.col(p) = Nearest(surface, targets.col(p));
    }
  };
  bool goesOn = loop(count, cast);
  for (int step = 0; goesOn && step < SmoothingSteps; ++step)
  {
    goesOn = loop(count, aim) && loop(count, move);
  }
  return goesOn ? result : PointsAndTriangles();
}

PointsAndTriangles MeshEllipsoid(const Eigen::Vector3d& semiAxes, int frequency)
{
  PointsAndTriangles result = GeodesicSphere(frequency);
  result.points = semiAxes.asDiagonal() * result.points;
  return result;
}

} // namespace ridges
