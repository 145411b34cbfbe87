// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_MeanSquare_h
#define ridges_MeanSquare_h

#include "Mesh/TriangleMesh.h"

#include <algorithm>
#include <cmath>

namespace ridges
{

/// The mean of square(q) over the corners of the triangles around a point: of the point and its
/// neighbours, the point counting a third. 0 without triangles; not finite if a square is not.
template <typename Square>
double MeanSquareAround(const TriangleMesh& mesh, Id point, const Square& square)
{
  double largest = 0.0;
  for (const Id t : mesh.TrianglesAround(point))
  {
    for (const Id q : mesh.Corners(t))
    {
      largest = std::max(largest, square(q));
    }
  }
  // Each is rounded to one grain, far below what matters: these sums are exact in any order, so
  // that the numbering does not show even in the last digit.
  constexpr double grainsInLargest = 1 << 20;
  const double grain = largest * grainsInLargest;
  if (!std::isfinite(grain))
  {
    return grain;
  }
  double sum = 0.0;
  int count = 0;
  for (const Id t : mesh.TrianglesAround(point))
  {
    for (const Id q : mesh.Corners(t))
    {
      sum += (square(q) + grain) - grain;
      ++count;
    }
  }
  return count > 0 ? sum / count : 0.0;
}

} // namespace ridges

#endif
