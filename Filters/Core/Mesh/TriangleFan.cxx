// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/TriangleFan.h"

namespace ridges
{
namespace
{

constexpr FanCorner None = { TriangleMesh::Border, 0 };

/// The triangle on the other side of an edge at this corner, if both have one orientation.
FanCorner Across(const TriangleMesh& mesh, FanCorner at, int side)
{
  const Id neighbor = mesh.Neighbor(at.triangle, side);
  if (neighbor < 0)
  {
    return None;
  }
  // The point at the other end of the side comes before this one there if it comes after it here.
  const Triangle& corners = mesh.Corners(at.triangle);
  const Triangle& others = mesh.Corners(neighbor);
  const int corner = CornerOf(others, corners[at.corner]);
  const int toOtherEnd = side == at.corner ? 1 : 2;
  const bool sameSense =
    others[(corner + 3 - toOtherEnd) % 3] == corners[(at.corner + toOtherEnd) % 3];
  return sameSense ? FanCorner{ neighbor, corner } : None;
}

FanCorner Next(const TriangleMesh& mesh, FanCorner at)
{
  return Across(mesh, at, (at.corner + 2) % 3);
}

FanCorner Previous(const TriangleMesh& mesh, FanCorner at)
{
  return Across(mesh, at, at.corner);
}

} // namespace

FanExtent GatherFan(const TriangleMesh& mesh, FanCorner from, FanCorner* fan)
{
  FanCorner first = from;
  for (FanCorner before = Previous(mesh, first); before.triangle >= 0;
       before = Previous(mesh, first))
  {
    first = before;
    if (first.triangle == from.triangle)
    {
      break;
    }
  }
  FanExtent extent;
  FanCorner at = first;
  do
  {
    fan[extent.size++] = at;
    at = Next(mesh, at);
  } while (at.triangle >= 0 && at.triangle != first.triangle);
  extent.closed = at.triangle >= 0;
  return extent;
}

} // namespace ridges
