// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// The ellipsoid with semi-axes 1, 0.8, 0.6, meshed and fitted at several sizes, and its ridges as
// the filter for ridge extraction makes them.

#ifndef RIDGES_TESTING_ELLIPSOID_FIXTURE_H
#define RIDGES_TESTING_ELLIPSOID_FIXTURE_H

#include "EllipsoidRidges.h"
#include "Fixtures/TestFields.h"

#include "Ridges/RidgeAssembly.h"
#include "Umbilics/UmbilicForm.h"

#include <algorithm>
#include <map>
#include <memory>

namespace ridges
{
namespace testing
{

constexpr double EllipsoidAxes[3] = { 1.0, 0.8, 0.6 };

struct FittedEllipsoid
{
  explicit FittedEllipsoid(int frequency)
    : surface(MeshSurface(
        EllipsoidSurface({ EllipsoidAxes[0], EllipsoidAxes[1], EllipsoidAxes[2] }), frequency))
    , field(FitField(surface.Triangles()))
    , meanEdge(surface.Triangles().MeanEdgeLength())
  {
  }
  const TriangleMesh& Triangles() const { return this->surface.Triangles(); }

  // Made when first asked for. 10 frequency^2 + 2 points: 32, 45, 63 and 89 give 10, 20, 40 and
  // 80 thousand.
  static const FittedEllipsoid& OfFrequency(int frequency)
  {
    static std::map<int, std::unique_ptr<FittedEllipsoid>> made;
    std::unique_ptr<FittedEllipsoid>& slot = made[frequency];
    if (!slot)
    {
      slot = std::make_unique<FittedEllipsoid>(frequency);
    }
    return *slot;
  }

  MeshedSurface surface;
  FieldArrays field;
  double meanEdge;
};

inline std::vector<RidgeSegment> MarchMesh(
  const TriangleMesh& mesh, const MongeField& field, Color color, TypeRule rule)
{
  RidgeCrossings crossings(mesh, field, color, CrossingRule::Form);
  crossings.Build();
  std::vector<RidgeSegment> segments;
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    MarchTriangle(crossings, rule, t, segments);
  }
  return segments;
}

// The ridges of those segments.
inline std::vector<Ridge> AssembleMesh(const TriangleMesh& mesh, const MongeField& field,
  Color color, const std::vector<RidgeSegment>& segments)
{
  RidgeCrossings crossings(mesh, field, color, CrossingRule::Form);
  crossings.Build();
  return AssembleRidges(crossings, segments);
}

// The points of the nodes of a ridge.
inline std::vector<RidgePoint> PointsOf(
  const TriangleMesh& mesh, const MongeField& field, Color color, const Ridge& ridge)
{
  std::vector<RidgePoint> points(ridge.nodes.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (!Ridge::IsUmbilic(ridge.nodes[i]))
    {
      points[i] = RidgePointOnEdge(mesh, field, color, CrossingRule::Form, ridge.nodes[i]);
    }
  }
  const auto placeUmbilic = [&](std::size_t i, std::size_t next)
  {
    if (Ridge::IsUmbilic(ridge.nodes[i]))
    {
      const Id triangle = Ridge::TriangleOfUmbilic(ridge.nodes[i]);
      points[i] = RidgePointAtUmbilic(
        mesh, field, triangle, UmbilicInTriangle(mesh, field, triangle), points[next]);
    }
  };
  placeUmbilic(0, 1);
  placeUmbilic(points.size() - 1, points.size() - 2);
  return points;
}

// Distance to the nearest of the four umbilics.
inline double DistanceToUmbilics(const Eigen::Vector3d& point)
{
  double least = 10.0;
  for (const Eigen::Vector3d& umbilic :
    EllipsoidUmbilics(EllipsoidAxes[0], EllipsoidAxes[1], EllipsoidAxes[2]))
  {
    least = std::min(least, (point - umbilic).norm());
  }
  return least;
}

} // namespace testing
} // namespace ridges

#endif
