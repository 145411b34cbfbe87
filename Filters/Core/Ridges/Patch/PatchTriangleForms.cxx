// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ridges/Patch/PatchTriangleForms.h"

#include "Umbilics/UmbilicForm.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ridges
{
namespace
{

constexpr double Pi = 3.14159265358979323846;

} // namespace

PatchTriangleForms::PatchTriangleForms(const TriangleMesh& mesh, const MongeField& field, Id t)
  : triangle(t)
  , corners(CornersInOrder(mesh, field, t))
  , second(TracelessForms(mesh, field, this->corners))
{
  const Eigen::Vector3d along = mesh.Point(this->corners[1]) - mesh.Point(this->corners[0]);
  const Eigen::Vector3d other = mesh.Point(this->corners[2]) - mesh.Point(this->corners[0]);
  const Eigen::Vector3d normal = along.cross(other).normalized();
  this->e1 = along.normalized();
  this->e2 = normal.cross(this->e1);
  for (int i = 0; i < 3; ++i)
  {
    const Id p = this->corners[i];
    const double angle = std::atan2(field.D1(p).dot(this->e2), field.D1(p).dot(this->e1));
    const double* b = field.ThirdOrder(p);
    this->third[i] = InBasis(SymmetricTensor<3>{ b[0], b[1], b[2], b[3] },
      Eigen::Vector2d(std::cos(angle), -std::sin(angle)),
      Eigen::Vector2d(std::sin(angle), std::cos(angle)));
  }
}

double PatchTriangleForms::AngleAt(const Eigen::Vector3d& weights) const
{
  const Eigen::Vector2d form = this->second * weights;
  return 0.5 * std::atan2(form[1], form[0]);
}

Eigen::Vector3d PatchTriangleForms::DirectionAt(double angle) const
{
  return std::cos(angle) * this->e1 + std::sin(angle) * this->e2;
}

SymmetricTensor<3> PatchTriangleForms::ThirdOrderAt(const Eigen::Vector3d& weights) const
{
  SymmetricTensor<3> form{};
  for (std::size_t j = 0; j < form.size(); ++j)
  {
    form[j] = weights[0] * this->third[0][j] + weights[1] * this->third[1][j] +
      weights[2] * this->third[2][j];
  }
  return form;
}

double PatchTriangleForms::ExtremalityAt(
  const Eigen::Vector3d& weights, Color color, double angle) const
{
  const SymmetricTensor<3> form = this->ThirdOrderAt(weights);
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  return ContractAll(
    form, color == Color::Blue ? Eigen::Vector2d(cosine, sine) : Eigen::Vector2d(-sine, cosine));
}

double PatchTriangleForms::SpreadAround(const SymmetricTensor<3>& b) const
{
  const auto squaredNorm = [](const SymmetricTensor<3>& f)
  { return f[0] * f[0] + 3.0 * (f[1] * f[1] + f[2] * f[2]) + f[3] * f[3]; };
  double greatest = 0.0;
  for (const SymmetricTensor<3>& corner : this->third)
  {
    greatest = std::max(greatest,
      squaredNorm({ corner[0] - b[0], corner[1] - b[1], corner[2] - b[2], corner[3] - b[3] }));
  }
  const double size = squaredNorm(b);
  return size > 0.0 ? std::sqrt(greatest / size) : std::numeric_limits<double>::infinity();
}

double PatchTriangleForms::DifferenceOfOrders(
  const TriangleMesh& mesh, const SymmetricTensor<3>& b) const
{
  Eigen::Matrix2d sides;
  Eigen::Matrix2d rises;
  for (int i = 0; i < 2; ++i)
  {
    const Eigen::Vector3d side = mesh.Point(this->corners[i + 1]) - mesh.Point(this->corners[0]);
    sides.col(i) << side.dot(this->e1), side.dot(this->e2);
    rises.col(i) = this->second.col(i + 1) - this->second.col(0);
  }
  Eigen::Matrix2d slopes;
  slopes << b[0] - b[2], b[1] - b[3], 2.0 * b[1], 2.0 * b[2];
  const double difference = (rises - slopes * sides).norm();
  const double size = (slopes * sides).norm();
  return size > 0.0 ? difference / size : std::numeric_limits<double>::infinity();
}

Eigen::Vector3d PatchTriangleForms::WayTo(double angle) const
{
  Eigen::Matrix3d equations;
  equations.topRows<2>() = this->second / this->second.cwiseAbs().maxCoeff();
  equations.row(2).setOnes();
  const Eigen::Vector3d way =
    equations.inverse() * Eigen::Vector3d(std::cos(2.0 * angle), std::sin(2.0 * angle), 0.0);
  return way.allFinite() ? way : Eigen::Vector3d::Zero();
}

// In a frame in which the first coefficient is large it is a cubic in the cotangent.
std::vector<double> RootAngles(const SymmetricTensor<3>& form)
{
  double turn = 0.0;
  SymmetricTensor<3> f = form;
  for (int i = 1; i < 6; ++i)
  {
    const double angle = i * Pi / 6.0;
    const Eigen::Vector2d e(std::cos(angle), std::sin(angle));
    const auto turned = InBasis(form, e, Eigen::Vector2d(-e[1], e[0]));
    if (std::abs(turned[0]) > std::abs(f[0]))
    {
      f = turned;
      turn = angle;
    }
  }
  if (!(std::abs(f[0]) > 0.0))
  {
    return {};
  }
  // x^3 + 3 a x^2 + 3 b x + c, and with x - a for x: x^3 + 3 p x + 2 q.
  const double a = f[1] / f[0];
  const double b = f[2] / f[0];
  const double c = f[3] / f[0];
  const double p = b - a * a;
  const double q = 0.5 * (c - 3.0 * a * b) + a * a * a;
  const double discriminant = p * p * p + q * q;
  std::vector<double> cotangents;
  if (discriminant < 0.0)
  {
    const double third = std::acos(std::clamp(-q / std::sqrt(-p * p * p), -1.0, 1.0)) / 3.0;
    for (int k = 0; k < 3; ++k)
    {
      cotangents.push_back(2.0 * std::sqrt(-p) * std::cos(third + 2.0 * Pi * k / 3.0) - a);
    }
  }
  else
  {
    const double root = std::sqrt(discriminant);
    cotangents.push_back(std::cbrt(-q + root) + std::cbrt(-q - root) - a);
  }
  std::vector<double> angles;
  for (const double cotangent : cotangents)
  {
    const double angle = std::fmod(std::atan2(1.0, cotangent) + turn, Pi);
    angles.push_back(angle);
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

} // namespace ridges
