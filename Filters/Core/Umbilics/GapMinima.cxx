// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Umbilics/GapMinima.h"

#include "Mesh/PositionOrder.h"
#include "Monge/AcuteRule.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ridges
{
namespace
{

constexpr double Pi = 3.14159265358979323846;

/// Two unit axes of the plane with this normal.
struct PlaneAxes
{
  explicit PlaneAxes(const Eigen::Vector3d& normal)
    : e1(normal.unitOrthogonal())
    , e2(normal.normalized().cross(e1))
  {
  }
  double Angle(const Eigen::Vector3d& v) const { return std::atan2(v.dot(e2), v.dot(e1)); }

  Eigen::Vector3d e1;
  Eigen::Vector3d e2;
};

} // namespace

double TriangleGap(const TriangleMesh& mesh, const MongeField& field, Id triangle)
{
  std::array<double, 3> gaps{};
  for (int i = 0; i < 3; ++i)
  {
    const Id p = mesh.Corners(triangle)[i];
    gaps[i] = field.k1[p] - field.k2[p];
  }
  // By size: the corner that a triangle starts at does not show even in round-off.
  std::sort(gaps.begin(), gaps.end());
  return (gaps[0] + gaps[1] + gaps[2]) / 3.0;
}

Id SmallestGapAround(const TriangleMesh& mesh, const MongeField& field, Id point)
{
  Id smallest = -1;
  double least = 0.0;
  for (const Id t : mesh.TrianglesAround(point))
  {
    const double gap = TriangleGap(mesh, field, t);
    if (smallest < 0 || gap < least || (gap == least && ComesBefore(mesh, t, smallest)))
    {
      smallest = t;
      least = gap;
    }
  }
  return smallest;
}

bool MinimizesGapInOneRing(
  const TriangleMesh& mesh, const std::vector<Id>& smallestAround, Id triangle)
{
  const Triangle& corners = mesh.Corners(triangle);
  return std::all_of(corners.begin(), corners.end(),
    [&smallestAround, triangle](Id p) { return smallestAround[p] == triangle; });
}

double ContourIndex(
  const MongeField& field, const std::vector<Id>& contour, const Eigen::Vector3d& normal)
{
  const PlaneAxes axes(normal);
  double turned = 0.0;
  for (std::size_t i = 0; i < contour.size(); ++i)
  {
    const double from = axes.Angle(field.D1(contour[i]));
    const double to = axes.Angle(field.D1(contour[(i + 1) % contour.size()]));
    // The directions have no sign: the smaller of the two turns, in [-pi/2, pi/2].
    turned += std::remainder(to - from, Pi);
  }
  return 0.5 * std::round(turned / Pi);
}

GapMinima::GapMinima(const TriangleMesh& mesh, const MongeField& field, double patchSize)
  : Mesh_(mesh)
  , Field_(field)
  , PatchSize_(patchSize)
  , Patch_(mesh)
{
}

bool GapMinima::Minimizes(Id triangle)
{
  // Most patches contain a smaller gap near their first triangle.
  const double gap = TriangleGap(this->Mesh_, this->Field_, triangle);
  const double threshold = this->PatchSize_ * this->Patch_.OneRingGrade(triangle);
  this->Patch_.Start(triangle);
  while (this->Patch_.GrowByOne(threshold))
  {
    const Span<Id> patch = this->Patch_.Triangles();
    if (!(TriangleGap(this->Mesh_, this->Field_, patch[patch.size() - 1]) >= gap))
    {
      return false;
    }
  }
  return true;
}

Id GapMinima::NearestSingularTriangle(Span<Id> patch) const
{
  const Eigen::Vector3d center = this->Mesh_.Centroid(patch[0]);
  Id nearest = patch[0];
  double least = std::numeric_limits<double>::max();
  for (const Id t : patch)
  {
    const double distance = (this->Mesh_.Centroid(t) - center).squaredNorm();
    if (distance < least && !IsRegular(this->Mesh_, this->Field_, t))
    {
      least = distance;
      nearest = t;
    }
  }
  return nearest;
}

std::vector<Umbilic> GapMinima::Select(std::vector<Id> candidates, const Monitor& monitor)
{
  std::sort(candidates.begin(), candidates.end(),
    [this](Id s, Id t)
    {
      const double gapS = TriangleGap(this->Mesh_, this->Field_, s);
      const double gapT = TriangleGap(this->Mesh_, this->Field_, t);
      return gapS != gapT ? gapS < gapT : ComesBefore(this->Mesh_, s, t);
    });

  std::vector<Umbilic> umbilics;
  std::vector<bool> taken(this->Mesh_.NumberOfTriangles(), false);
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    constexpr std::size_t between = 1024;
    if (i % between == 0 && !monitor(static_cast<double>(i) / candidates.size()))
    {
      return {};
    }
    const Id t = candidates[i];
    const Span<Id> patch = this->Patch_.Grow(t, this->PatchSize_);
    if (std::any_of(patch.begin(), patch.end(), [&taken](Id s) { return taken[s]; }))
    {
      continue;
    }
    const double index =
      ContourIndex(this->Field_, this->Patch_.Contour(), AreaNormalInOrder(this->Mesh_, t));
    if (std::abs(index) != 0.5)
    {
      continue;
    }
    const Id home = this->NearestSingularTriangle(patch);
    umbilics.push_back(MakeUmbilic(
      this->Mesh_, this->Field_, home, index, std::vector<Id>(patch.begin(), patch.end())));
    for (const Id s : patch)
    {
      taken[s] = true;
    }
  }
  return umbilics;
}

} // namespace ridges
