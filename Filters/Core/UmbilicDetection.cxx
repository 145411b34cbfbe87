// SPDX-License-Identifier: BSD-3-Clause
#include "UmbilicDetection.h"

#include "RidgePoint.h"

#include <Eigen/Geometry>

#include <algorithm>
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
  double sum = 0.0;
  for (const Id p : mesh.Corners(triangle))
  {
    sum += field.k1[p] - field.k2[p];
  }
  return sum / 3.0;
}

bool MinimizesGapInOneRing(const TriangleMesh& mesh, const MongeField& field, Id triangle)
{
  const double gap = TriangleGap(mesh, field, triangle);
  for (const Id corner : mesh.Corners(triangle))
  {
    for (const Id t : mesh.TrianglesAround(corner))
    {
      if (TriangleGap(mesh, field, t) < gap)
      {
        return false;
      }
    }
  }
  return true;
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

SymmetricTensor<3> TriangleCubicForm(const TriangleMesh& mesh, const MongeField& field, Id triangle)
{
  const PlaneAxes axes(mesh.AreaNormal(triangle));
  SymmetricTensor<3> mean{};
  for (const Id p : mesh.Corners(triangle))
  {
    const double angle = axes.Angle(field.D1(p));
    const Eigen::Vector2d e1InPrincipal(std::cos(angle), -std::sin(angle));
    const Eigen::Vector2d e2InPrincipal(std::sin(angle), std::cos(angle));
    const double* b = field.ThirdOrder(p);
    const auto form =
      InBasis(SymmetricTensor<3>{ b[0], b[1], b[2], b[3] }, e1InPrincipal, e2InPrincipal);
    for (std::size_t j = 0; j < mean.size(); ++j)
    {
      mean[j] += form[j] / 3.0;
    }
  }
  return mean;
}

int RidgeCountOf(const SymmetricTensor<3>& f)
{
  const double minusDiscriminant = f[0] * f[0] * f[3] * f[3] - 6.0 * f[0] * f[1] * f[2] * f[3] +
    4.0 * f[0] * f[2] * f[2] * f[2] + 4.0 * f[1] * f[1] * f[1] * f[3] -
    3.0 * f[1] * f[1] * f[2] * f[2];
  return minusDiscriminant < 0.0 ? 3 : 1;
}

int ThirdOrderIndexOf(const SymmetricTensor<3>& f)
{
  const double s = (f[0] - f[2]) * f[2] - f[1] * (f[1] - f[3]);
  return s > 0.0 ? 1 : (s < 0.0 ? -1 : 0);
}

UmbilicDetector::UmbilicDetector(
  const TriangleMesh& mesh, const MongeField& field, double patchSize)
  : Mesh_(mesh)
  , Field_(field)
  , PatchSize_(patchSize)
  , Patch_(mesh)
{
}

bool UmbilicDetector::Minimizes(Id triangle)
{
  if (!MinimizesGapInOneRing(this->Mesh_, this->Field_, triangle))
  {
    return false;
  }
  const double gap = TriangleGap(this->Mesh_, this->Field_, triangle);
  const Span<Id> patch = this->Patch_.Grow(triangle, this->PatchSize_);
  return std::all_of(patch.begin(), patch.end(),
    [&](Id t) { return TriangleGap(this->Mesh_, this->Field_, t) >= gap; });
}

Id UmbilicDetector::NearestSingularTriangle(Span<Id> patch) const
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

std::vector<Umbilic> UmbilicDetector::Select(std::vector<Id> candidates)
{
  std::sort(candidates.begin(), candidates.end(),
    [this](Id s, Id t)
    {
      const double gapS = TriangleGap(this->Mesh_, this->Field_, s);
      const double gapT = TriangleGap(this->Mesh_, this->Field_, t);
      return gapS != gapT ? gapS < gapT : s < t;
    });

  std::vector<Umbilic> umbilics;
  std::vector<bool> taken(this->Mesh_.NumberOfTriangles(), false);
  for (const Id t : candidates)
  {
    const Span<Id> patch = this->Patch_.Grow(t, this->PatchSize_);
    if (std::any_of(patch.begin(), patch.end(), [&](Id s) { return taken[s]; }))
    {
      continue;
    }
    const double index =
      ContourIndex(this->Field_, this->Patch_.Contour(), this->Mesh_.AreaNormal(t));
    if (std::abs(index) != 0.5)
    {
      continue;
    }
    const Id home = this->NearestSingularTriangle(patch);
    const auto cubicForm = TriangleCubicForm(this->Mesh_, this->Field_, home);
    umbilics.push_back(
      { home, UmbilicInTriangle(this->Mesh_, this->Field_, home), index, RidgeCountOf(cubicForm),
        ThirdOrderIndexOf(cubicForm), std::vector<Id>(patch.begin(), patch.end()) });
    for (const Id s : patch)
    {
      taken[s] = true;
    }
  }
  return umbilics;
}

} // namespace ridges
