// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ridges/RidgeType.h"

#include "Monge/AcuteRule.h"

#include <Eigen/Geometry>

namespace ridges
{

RidgeType TypeOf(Color color, bool elliptic)
{
  if (color == Color::Blue)
  {
    return elliptic ? RidgeType::MaximumElliptic : RidgeType::MaximumHyperbolic;
  }
  return elliptic ? RidgeType::MinimumElliptic : RidgeType::MinimumHyperbolic;
}

bool IsElliptic(RidgeType type)
{
  return type == RidgeType::MaximumElliptic || type == RidgeType::MinimumElliptic;
}

bool IsEllipticByThirdOrder(const TriangleMesh& mesh, const MongeField& field, Color color,
  Id triangle, int apex, const Eigen::Vector3d& r1, const Eigen::Vector3d& r2)
{
  const Triangle& corners = mesh.Corners(triangle);
  const Eigen::Vector3d normal = mesh.AreaNormal(triangle);
  int rising = 0;
  for (int i = 0; i < 3; ++i)
  {
    const Id v = corners[(apex + i) % 3];
    const Eigen::Vector3d direction = field.Direction(color, v);
    const double towards = direction.cross(r2 - r1).dot(normal);
    const bool sameSide = (towards >= 0.0) == (i == 0);
    rising += ExtremalitySign(field.Extremality(color, v)) * (sameSide ? 1 : -1);
  }
  // A ridge towards which k1 rises is a maximum of it; an elliptic red ridge is a minimum of k2.
  return color == Color::Blue ? rising > 0 : rising < 0;
}

} // namespace ridges
