// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Salience/FieldDerivatives.h"

#include "Base/SymmetricTensor.h"

#include <Eigen/Geometry>

#include <cmath>

namespace ridges
{
namespace
{

/// The frame of a point as the axes that a neighbour's position and form are given in.
class TangentPlane
{
public:
  TangentPlane(const TriangleMesh& mesh, const MongeField& field, Id p)
    : Mesh_(mesh)
    , Field_(field)
    , Origin_(mesh.Point(p))
    , D1_(field.D1(p))
    , D2_(field.D2(p))
    , Normal_(D1_.cross(D2_))
  {
  }

  Eigen::Vector2d Position(Id q) const
  {
    const Eigen::Vector3d offset = this->Mesh_.Point(q) - this->Origin_;
    return { offset.dot(this->D1_), offset.dot(this->D2_) };
  }

  /// d1 of q after the smallest turn that takes its normal to that of the plane.
  Eigen::Vector2d Direction(Id q) const
  {
    const Eigen::Vector3d d1 = this->Field_.D1(q);
    const Eigen::Vector3d normal = d1.cross(this->Field_.D2(q));
    const double denominator = 1.0 + normal.dot(this->Normal_);
    const double part = denominator > 0.0 ? d1.dot(this->Normal_) / denominator : 0.0;
    const Eigen::Vector3d turned = d1 - part * (normal + this->Normal_);
    const Eigen::Vector2d direction(turned.dot(this->D1_), turned.dot(this->D2_));
    const double length = direction.norm();
    return length > 0.0 ? Eigen::Vector2d(direction / length) : Eigen::Vector2d(1.0, 0.0);
  }

private:
  const TriangleMesh& Mesh_;
  const MongeField& Field_;
  Eigen::Vector3d Origin_;
  Eigen::Vector3d D1_;
  Eigen::Vector3d D2_;
  Eigen::Vector3d Normal_;
};

/// The gradient at p, in its frame, of values over the points around it: along the axes 1 and 2.
/// valueAt(q) is that of a neighbour less that of p.
template <std::size_t Size, typename ValueAt>
std::array<std::array<double, Size>, 2> Gradient(
  const OneRings& rings, const TangentPlane& plane, Id p, const ValueAt& valueAt)
{
  std::array<std::array<double, Size>, 2> gradient{};
  const Span<Id> ring = rings.Around(p);
  const Id count = ring.size();
  if (!rings.IsFan(p) || count < 2)
  {
    return gradient;
  }
  const bool closed = rings.IsClosed(p);
  // Twice the gradient of a triangle times its area takes each corner's value times the opposite
  // side, turned by a right angle. Where a fan ends, p itself is the next corner.
  Eigen::Vector2d before = Eigen::Vector2d::Zero();
  Eigen::Vector2d here = plane.Position(ring[0]);
  const Eigen::Vector2d first = here;
  if (closed)
  {
    before = plane.Position(ring[count - 1]);
  }
  double area = 0.0;
  for (Id i = 0; i < count; ++i)
  {
    Eigen::Vector2d next = Eigen::Vector2d::Zero();
    if (i + 1 < count)
    {
      next = plane.Position(ring[i + 1]);
    }
    else if (closed)
    {
      next = first;
    }
    area += here[0] * next[1] - here[1] * next[0];
    const Eigen::Vector2d side = next - before;
    const std::array<double, Size> value = valueAt(ring[i]);
    for (std::size_t j = 0; j < Size; ++j)
    {
      gradient[0][j] += value[j] * side[1];
      gradient[1][j] -= value[j] * side[0];
    }
    before = here;
    here = next;
  }
  for (auto& along : gradient)
  {
    for (double& value : along)
    {
      value = area > 0.0 ? value / area : 0.0;
    }
  }
  return gradient;
}

} // namespace

std::array<double, 4> FieldDerivatives::ThirdOrder(Id p) const
{
  const MongeField& field = this->Field_;
  const TangentPlane plane(this->Rings_.Mesh(), field, p);
  const auto valueAt = [&field, &plane, p](Id q) -> SymmetricTensor<2>
  {
    const Eigen::Vector2d d1 = plane.Direction(q);
    const double gap = field.k1[q] - field.k2[q];
    const double minimum = field.k2[q];
    return { minimum + gap * d1[0] * d1[0] - field.k1[p], gap * d1[0] * d1[1],
      minimum + gap * d1[1] * d1[1] - field.k2[p] };
  };
  const auto along = Gradient<3>(this->Rings_, plane, p, valueAt);
  return { along[0][0], (along[1][0] + 2.0 * along[0][1]) / 3.0,
    (along[0][2] + 2.0 * along[1][1]) / 3.0, along[1][2] };
}

std::array<double, 5> FieldDerivatives::FourthOrder(Id p) const
{
  const MongeField& field = this->Field_;
  const TangentPlane plane(this->Rings_.Mesh(), field, p);
  const double* own = field.ThirdOrder(p);
  const auto valueAt = [&field, &plane, own](Id q)
  {
    // The old axes in the new ones are d1 and d2; InBasis wants the new ones in the old.
    const Eigen::Vector2d d1 = plane.Direction(q);
    const double* b = field.ThirdOrder(q);
    SymmetricTensor<3> value = InBasis(SymmetricTensor<3>{ b[0], b[1], b[2], b[3] },
      Eigen::Vector2d(d1[0], -d1[1]), Eigen::Vector2d(d1[1], d1[0]));
    for (int i = 0; i < 4; ++i)
    {
      value[i] -= own[i];
    }
    return value;
  };
  const auto along = Gradient<4>(this->Rings_, plane, p, valueAt);
  const double k1 = field.k1[p];
  const double k2 = field.k2[p];
  // A Monge patch is not flat: its coefficients are the covariant derivatives and these products.
  return { along[0][0] + 3.0 * k1 * k1 * k1, (along[1][0] + 3.0 * along[0][1]) / 4.0,
    0.5 * (along[1][1] + along[0][2] + k1 * k2 * (k1 + k2)),
    (along[0][3] + 3.0 * along[1][2]) / 4.0, along[1][3] + 3.0 * k2 * k2 * k2 };
}

} // namespace ridges
