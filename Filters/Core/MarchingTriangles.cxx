// SPDX-License-Identifier: BSD-3-Clause
#include "MarchingTriangles.h"

#include <array>

namespace ridges
{

void MarchTriangle(const TriangleMesh& mesh, const MongeField& field, Color color,
  const MarchingRules& rules, Id triangle, std::vector<RidgeSegment>& segments)
{
  const Triangle& corners = mesh.Corners(triangle);
  std::array<int, 3> crossed{};
  int count = 0;
  for (int side = 0; side < 3; ++side)
  {
    if (IsCrossed(field, color, corners[side], corners[(side + 1) % 3]))
    {
      crossed[count++] = side;
    }
  }

  if (count == 1 || count == 3)
  {
    for (int i = 0; i < count; ++i)
    {
      segments.push_back({ triangle, mesh.EdgeOf(triangle, crossed[i]), RidgeSegment::ToUmbilic,
        TypeOf(color, false), false });
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
    const RidgePoint r1 = RidgePointOnEdge(mesh, field, color, rules.crossing, edge0);
    const RidgePoint r2 = RidgePointOnEdge(mesh, field, color, rules.crossing, edge1);
    const bool elliptic = rules.type == TypeRule::FourthOrder
      ? r1.P + r2.P < 0.0
      : IsEllipticByThirdOrder(mesh, field, color, triangle, side2, r1.position, r2.position);
    segments.push_back({ triangle, edge0, edge1, TypeOf(color, elliptic),
      elliptic && r1.crestMargin + r2.crestMargin >= 0.0 });
  }
}

} // namespace ridges
