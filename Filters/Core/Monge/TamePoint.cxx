// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Monge/TamePoint.h"

#include <Eigen/Geometry>

namespace ridges
{

bool IsTame(const TriangleMesh& mesh, const MongeField& field, Id point)
{
  const Eigen::Vector3d n = field.D1(point).cross(field.D2(point));
  int sides = 0;
  for (const Id t : mesh.TrianglesAround(point))
  {
    const Eigen::Vector3d normal = mesh.AreaNormal(t);
    const double along = n.dot(normal);
    if (!(along * along > 0.25 * normal.squaredNorm()))
    {
      return false;
    }
    sides |= along > 0.0 ? 1 : 2;
  }
  return sides != 3;
}

} // namespace ridges
