// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ridges/RidgeMeasures.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ridges
{
namespace
{

struct Node
{
  double abscissa; ///< In [0, 1].
  double weight;
};

constexpr std::array<Node, 4> GaussLegendre = { { { 0.069431844202973712, 0.17392742256872693 },
  { 0.33000947820757187, 0.32607257743127307 }, { 0.66999052179242813, 0.32607257743127307 },
  { 0.93056815579702629, 0.17392742256872693 } } };

/// Integral of |P / gap| over a part of a segment, per length of the segment.
double IntegrateSecondDerivative(
  const RidgePoint& a, const RidgePoint& b, const UmbilicCutOff::Part& part)
{
  double sum = 0.0;
  for (const Node& node : GaussLegendre)
  {
    const double s = part.begin + (part.end - part.begin) * node.abscissa;
    const double gap = (1.0 - s) * a.gap + s * b.gap;
    const double P = (1.0 - s) * a.P + s * b.P;
    sum += gap > 0.0 ? node.weight * std::abs(P) / gap : 0.0;
  }
  return sum * (part.end - part.begin);
}

} // namespace

UmbilicCutOff::UmbilicCutOff(const std::vector<Eigen::Vector3d>& umbilics, double radius)
  : Umbilics_(umbilics)
  , Radius_(radius)
{
}

std::vector<UmbilicCutOff::Part> UmbilicCutOff::Outside(
  const Eigen::Vector3d& a, const Eigen::Vector3d& b) const
{
  std::vector<Part> inside;
  const Eigen::Vector3d along = b - a;
  const double squaredLength = along.squaredNorm();
  bool isInside = false;
  // False once nothing of the segment is left: where umbilics are dense one covers it mostly.
  const auto cutOff = [this, &a, &along, squaredLength, &inside, &isInside](
                        const Eigen::Vector3d& umbilic)
  {
    // |a + s along - umbilic| = radius
    const Eigen::Vector3d toA = a - umbilic;
    const double half = toA.dot(along);
    const double rest = toA.squaredNorm() - this->Radius_ * this->Radius_;
    const double discriminant = half * half - squaredLength * rest;
    if (squaredLength > 0.0 && discriminant > 0.0)
    {
      const double root = std::sqrt(discriminant);
      const Part part{ std::max(0.0, (-half - root) / squaredLength),
        std::min(1.0, (-half + root) / squaredLength) };
      if (part.begin < part.end)
      {
        inside.push_back(part);
        isInside = part.begin <= 0.0 && part.end >= 1.0;
      }
    }
    return !isInside;
  };
  const double reach = (this->Radius_ + 0.5 * std::sqrt(squaredLength)) * (1.0 + 1e-12);
  this->Umbilics_.VisitNear(0.5 * (a + b), reach, cutOff);
  if (isInside)
  {
    return {};
  }
  std::sort(
    inside.begin(), inside.end(), [](const Part& s, const Part& t) { return s.begin < t.begin; });

  std::vector<Part> outside;
  double reached = 0.0;
  for (const Part& part : inside)
  {
    if (part.begin > reached)
    {
      outside.push_back({ reached, part.begin });
    }
    reached = std::max(reached, part.end);
  }
  if (reached < 1.0)
  {
    outside.push_back({ reached, 1.0 });
  }
  return outside;
}

RidgeMeasures MeasureRidge(
  const std::vector<RidgePoint>& points, RidgeType type, const UmbilicCutOff& cutOff)
{
  RidgeMeasures measures;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    const RidgePoint& a = points[i];
    const RidgePoint& b = points[i + 1];
    const double length = (b.position - a.position).norm();
    measures.length += length;

    // The curvature may change its sign inside: the integral of the absolute value of a line.
    const double sum = std::abs(a.curvature) + std::abs(b.curvature);
    const bool changes = a.curvature * b.curvature < 0.0;
    const double squares = a.curvature * a.curvature + b.curvature * b.curvature;
    measures.strength += 0.5 * length * (changes ? squares / sum : sum);

    if (IsElliptic(type))
    {
      measures.rawSharpness += length * IntegrateSecondDerivative(a, b, { 0.0, 1.0 });
    }
    else
    {
      for (const UmbilicCutOff::Part& part : cutOff.Outside(a.position, b.position))
      {
        measures.rawSharpness += length * IntegrateSecondDerivative(a, b, part);
      }
    }
  }
  return measures;
}

} // namespace ridges
