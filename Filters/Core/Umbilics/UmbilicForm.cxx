// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Umbilics/UmbilicForm.h"

#include "Mesh/PositionOrder.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

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

} // namespace

Triangle CornersInOrder(const TriangleMesh& mesh, Id triangle)
{
  Triangle corners = mesh.Corners(triangle);
  const auto first = std::min_element(corners.begin(), corners.end(),
    [&mesh](Id p, Id q) { return ComesBefore(mesh.Point(p), mesh.Point(q)); });
  std::rotate(corners.begin(), first, corners.end());
  return corners;
}

Eigen::Matrix<double, 2, 3> TracelessForms(
  const TriangleMesh& mesh, const MongeField& field, const Triangle& corners)
{
  const Eigen::Vector3d normal = (mesh.Point(corners[1]) - mesh.Point(corners[0]))
                                   .cross(mesh.Point(corners[2]) - mesh.Point(corners[0]));
  const Eigen::Vector3d e1 = (mesh.Point(corners[1]) - mesh.Point(corners[0])).normalized();
  const Eigen::Vector3d e2 = normal.cross(e1).normalized();
  Eigen::Matrix<double, 2, 3> forms;
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
  Eigen::Vector3d centroid = Eigen::Vector3d::Constant(1.0 / 3.0);
  const auto forms = TracelessForms(mesh, field, CornersInOrder(mesh, triangle));
  const double magnitude = forms.cwiseAbs().maxCoeff();
  if (!(magnitude > 0.0) || !std::isfinite(magnitude))
  {
    return centroid;
  }
  Eigen::Matrix3d system;
  system << forms / magnitude, Eigen::RowVector3d::Ones();
  const Eigen::FullPivLU<Eigen::Matrix3d> solver(system);
  const Eigen::Vector3d weights = solver.solve(Eigen::Vector3d(0.0, 0.0, 1.0));
  const bool inside = solver.isInvertible() && weights.minCoeff() >= 0.0;
  return inside ? weights : centroid;
}

Eigen::Vector3d UmbilicInTriangle(const TriangleMesh& mesh, const MongeField& field, Id triangle)
{
  const Triangle corners = CornersInOrder(mesh, triangle);
  const Eigen::Vector3d weights = UmbilicWeights(mesh, field, triangle);
  return weights[0] * mesh.Point(corners[0]) + weights[1] * mesh.Point(corners[1]) +
    weights[2] * mesh.Point(corners[2]);
}

SymmetricTensor<3> CubicFormAt(
  const TriangleMesh& mesh, const MongeField& field, Id triangle, const Eigen::Vector3d& weights)
{
  const Triangle corners = CornersInOrder(mesh, triangle);
  const Eigen::Vector3d normal = (mesh.Point(corners[1]) - mesh.Point(corners[0]))
                                   .cross(mesh.Point(corners[2]) - mesh.Point(corners[0]))
                                   .normalized();
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
