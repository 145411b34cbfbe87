// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Umbilics/UmbilicForm.h"

#include "Monge/FieldOrder.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ridges
{
namespace
{

/// The sign of the discriminant of a binary cubic form: positive with three real roots.
bool HasThreeRoots(const SymmetricTensor<3>& f)
{
  const double minusDiscriminant = f[0] * f[0] * f[3] * f[3] - 6.0 * f[0] * f[1] * f[2] * f[3] +
    4.0 * f[0] * f[2] * f[2] * f[2] + 4.0 * f[1] * f[1] * f[1] * f[3] -
    3.0 * f[1] * f[1] * f[2] * f[2];
  return minusDiscriminant < 0.0;
}

using Forms = Eigen::Matrix<double, 2, 3>;

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

/// Where on the sides of a triangle the form is least; the mean of such places, if several are
/// alike.
Eigen::Vector3d WeightsOfLeastOnSides(const Forms& forms)
{
  double least = std::numeric_limits<double>::infinity();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const Eigen::Vector2d along = forms.col(j) - forms.col(i);
    const double squared = along.squaredNorm();
    const double t = squared > 0.0 ? std::clamp(-forms.col(i).dot(along) / squared, 0.0, 1.0) : 0.5;
    const double value = (forms.col(i) + t * along).squaredNorm();
    if (value < least)
    {
      least = value;
      sum.setZero();
    }
    if (value == least)
    {
      sum[i] += 1.0 - t;
      sum[j] += t;
    }
  }
  return sum / sum.sum();
}

/// The weights at which the form, linear between the corners, is least: 0, if it is that inside.
/// All of them positive, as ridges are drawn around the point in the triangle.
Eigen::Vector3d WeightsOfLeast(const Forms& forms)
{
  const Eigen::Vector3d areas(Cross(forms.col(1), forms.col(2)), Cross(forms.col(2), forms.col(0)),
    Cross(forms.col(0), forms.col(1)));
  const double area = areas.sum();
  Eigen::Vector3d weights = areas / area;
  if (area == 0.0 || !(weights.minCoeff() >= 0.0))
  {
    weights = WeightsOfLeastOnSides(forms);
  }
  constexpr double least = 1e-3;
  const Eigen::Vector3d centroid = Eigen::Vector3d::Constant(1.0 / 3.0);
  const double missing = std::max(0.0, least - weights.minCoeff());
  return weights + missing / (missing + centroid[0] - least) * (centroid - weights);
}

/// The normal of the triangle's plane; where it has no area, about that of the surface.
Eigen::Vector3d NormalOf(const TriangleMesh& mesh, const MongeField& field, const Triangle& corners)
{
  const Eigen::Vector3d ofPlane = (mesh.Point(corners[1]) - mesh.Point(corners[0]))
                                    .cross(mesh.Point(corners[2]) - mesh.Point(corners[0]));
  if (ofPlane.squaredNorm() > 0.0)
  {
    return ofPlane.normalized();
  }
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (const Id p : corners)
  {
    normal += field.D1(p).cross(field.D2(p));
  }
  return normal.squaredNorm() > 0.0 ? normal.normalized() : Eigen::Vector3d(0.0, 0.0, 1.0);
}

} // namespace

Triangle CornersInOrder(const TriangleMesh& mesh, const MongeField& field, Id triangle)
{
  Triangle corners = mesh.Corners(triangle);
  const auto first = std::min_element(corners.begin(), corners.end(),
    [&mesh, &field](Id p, Id q) { return ComesBefore(mesh, field, p, q); });
  std::rotate(corners.begin(), first, corners.end());
  return corners;
}

Eigen::Matrix<double, 2, 3> TracelessForms(
  const TriangleMesh& mesh, const MongeField& field, const Triangle& corners)
{
  const Eigen::Vector3d normal = NormalOf(mesh, field, corners);
  const Eigen::Vector3d edge = mesh.Point(corners[1]) - mesh.Point(corners[0]);
  const bool hasPlane = normal.cross(edge).squaredNorm() > 0.0;
  const Eigen::Vector3d e1 = hasPlane ? edge.normalized() : normal.unitOrthogonal();
  const Eigen::Vector3d e2 = normal.cross(e1).normalized();
  Forms forms;
  for (int i = 0; i < 3; ++i)
  {
    const Id v = corners[i];
    const double x1 = field.D1(v).dot(e1);
    const double y1 = field.D1(v).dot(e2);
    const double x2 = field.D2(v).dot(e1);
    const double y2 = field.D2(v).dot(e2);
    // From both directions, so that it is the same seen from the other side of the surface.
    const double half = 0.5 * (field.k1[v] - field.k2[v]);
    forms.col(i) << half * (x1 * x1 - y1 * y1 - x2 * x2 + y2 * y2),
      2.0 * half * (x1 * y1 - x2 * y2);
  }
  return forms;
}

Eigen::Vector3d UmbilicWeights(const TriangleMesh& mesh, const MongeField& field, Id triangle)
{
  const auto forms = TracelessForms(mesh, field, CornersInOrder(mesh, field, triangle));
  const double magnitude = forms.cwiseAbs().maxCoeff();
  if (!(magnitude > 0.0) || !std::isfinite(magnitude))
  {
    return Eigen::Vector3d::Constant(1.0 / 3.0);
  }
  return WeightsOfLeast(forms / magnitude);
}

Eigen::Vector3d UmbilicInTriangle(const TriangleMesh& mesh, const MongeField& field, Id triangle)
{
  const Triangle corners = CornersInOrder(mesh, field, triangle);
  const Eigen::Vector3d weights = UmbilicWeights(mesh, field, triangle);
  return weights[0] * mesh.Point(corners[0]) + weights[1] * mesh.Point(corners[1]) +
    weights[2] * mesh.Point(corners[2]);
}

SymmetricTensor<3> CubicFormAt(
  const TriangleMesh& mesh, const MongeField& field, Id triangle, const Eigen::Vector3d& weights)
{
  const Triangle corners = CornersInOrder(mesh, field, triangle);
  const Eigen::Vector3d normal = NormalOf(mesh, field, corners);
  const Eigen::Vector3d e1 = normal.unitOrthogonal();
  const Eigen::Vector3d e2 = normal.cross(e1);
  SymmetricTensor<3> mean{};
  for (int i = 0; i < 3; ++i)
  {
    const Id p = corners[i];
    const double angle = std::atan2(field.D1(p).dot(e2), field.D1(p).dot(e1));
    const Eigen::Vector2d e1InPrincipal(std::cos(angle), -std::sin(angle));
    const Eigen::Vector2d e2InPrincipal(std::sin(angle), std::cos(angle));
    const double* b = field.ThirdOrder(p);
    const auto form =
      InBasis(SymmetricTensor<3>{ b[0], b[1], b[2], b[3] }, e1InPrincipal, e2InPrincipal);
    for (std::size_t j = 0; j < mean.size(); ++j)
    {
      mean[j] += weights[i] * form[j];
    }
  }
  return mean;
}

int RidgeCountOf(const SymmetricTensor<3>& f)
{
  return HasThreeRoots(f) ? 3 : 1;
}

int ThirdOrderIndexOf(const SymmetricTensor<3>& f)
{
  const double s = (f[0] - f[2]) * f[2] - f[1] * (f[1] - f[3]);
  return s > 0.0 ? 1 : (s < 0.0 ? -1 : 0);
}

UmbilicPattern PatternOf(const SymmetricTensor<3>& f, double index)
{
  if (index < 0.0)
  {
    return UmbilicPattern::Star;
  }
  // A third of the derivative along the circle, as a form again.
  const SymmetricTensor<3> turned = { f[1], (2.0 * f[2] - f[0]) / 3.0, (f[3] - 2.0 * f[1]) / 3.0,
    -f[2] };
  return HasThreeRoots(turned) ? UmbilicPattern::Monstar : UmbilicPattern::Lemon;
}

} // namespace ridges
