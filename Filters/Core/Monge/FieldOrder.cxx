// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Monge/FieldOrder.h"

#include <array>
#include <cmath>
#include <utility>

namespace ridges
{

bool ComesBefore(const TriangleMesh& mesh, const MongeField& field, Id p, Id q)
{
  if (p == q || PointComesBefore(mesh, p, q))
  {
    return p != q;
  }
  if (PointComesBefore(mesh, q, p))
  {
    return false;
  }
  // The signs of the extremalities are those of the directions, which mean nothing.
  const auto valuesOf = [&field](Id i)
  {
    return std::array<double, 4>{ field.k1[i], field.k2[i],
      std::abs(field.Extremality(Color::Blue, i)), std::abs(field.Extremality(Color::Red, i)) };
  };
  return valuesOf(p) < valuesOf(q);
}

OrderedEdge EndsInOrder(const TriangleMesh& mesh, const MongeField& field, Id edge)
{
  OrderedEdge ends(mesh, edge);
  if (mesh.Point(ends.p) == mesh.Point(ends.q) && ComesBefore(mesh, field, ends.q, ends.p))
  {
    std::swap(ends.p, ends.q);
    ends.swaps = !ends.swaps;
  }
  return ends;
}

} // namespace ridges
