// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ridges/MarchingTriangles.h"

#include <array>

namespace ridges
{

void MarchTriangle(
  const RidgeCrossings& crossings, TypeRule rule, Id triangle, std::vector<RidgeSegment>& segments)
{
  const TriangleMesh& mesh = crossings.Mesh();
  std::array<int, 3> crossed{};
  int count = 0;
  for (int side = 0; side < 3; ++side)
  {
    if (crossings.IsCrossed(mesh.EdgeOf(triangle, side)))
    {
      crossed[count++] = side;
    }
  }

  if (count == 1 || count == 3)
  {
    for (int i = 0; i < count; ++i)
    {
      segments.push_back({ triangle, mesh.EdgeOf(triangle, crossed[i]), RidgeSegment::ToUmbilic,
        TypeOf(crossings.RidgeColor(), false) });
    }
  }
  else if (count == 2)
  {
    // Sides i and i + 1 share corner i + 1: with it as the apex v1 of section 5.3, the second
    // of the two sides is (v1, v2).
    const bool wraps = crossed[0] == 0 && crossed[1] == 2;
    const int side2 = wraps ? 0 : crossed[1];
    const int side3 = wraps ? 2 : crossed[0];
    const Id edge0 = mesh.EdgeOf(triangle, side2);
    const Id edge1 = mesh.EdgeOf(triangle, side3);
    const RidgePoint& r1 = crossings.PointOn(edge0);
    const RidgePoint& r2 = crossings.PointOn(edge1);
    if (r1.color != r2.color)
    {
      segments.push_back({ triangle, edge0, edge1, RidgeType::Undecided });
      return;
    }
    const bool elliptic = rule == TypeRule::FourthOrder
      ? r1.P + r2.P < 0.0
      : IsEllipticByThirdOrder(
          mesh, crossings.Field(), r1.color, triangle, side2, r1.position, r2.position);
    segments.push_back({ triangle, edge0, edge1, TypeOf(r1.color, elliptic) });
  }
}

} // namespace ridges
