// SPDX-License-Identifier: BSD-3-Clause
#include "GapError.h"

#include <algorithm>
#include <cmath>

namespace ridges
{

double GapError(const TriangleMesh& mesh, const GapErrorSource& source, Id point)
{
  if (source.maximumCurvatureError && source.minimumCurvatureError)
  {
    return std::hypot(source.maximumCurvatureError[point], source.minimumCurvatureError[point]);
  }
  if (!source.fitResidual || !source.fitScale)
  {
    return 0.0;
  }
  // The standard error of k1 - k2 that goes with a residual of one radius, for a curvature of one
  // over the radius: the median over fits of degree 4 to 18 points, even or from scans, is 40 to 53.
  constexpr double perResidual = 45.0;
  double sum = 0.0;
  int count = 0;
  for (const Id t : mesh.TrianglesAround(point))
  {
    for (const Id p : mesh.Corners(t))
    {
      const double ratio =
        source.fitScale[p] > 0.0 ? source.fitResidual[p] / source.fitScale[p] : 0.0;
      sum += ratio * ratio;
      ++count;
    }
  }
  // Below this a curvature is rounding: the surface is flat to ten digits over the fitted radius.
  constexpr double rounding = 1e-10;
  const double floor = source.fitScale[point] > 0.0 ? rounding / source.fitScale[point] : 0.0;
  return count > 0 ? std::max(floor, perResidual * std::sqrt(sum / count)) : floor;
}

bool IsWeak(const TriangleMesh& mesh, const MongeField& field, const double* gapErrors,
  double significance, Id triangle)
{
  double gap = 0.0;
  double error = 0.0;
  for (const Id p : mesh.Corners(triangle))
  {
    gap += field.k1[p] - field.k2[p];
    error += gapErrors[p];
  }
  return error > 0.0 && gap <= significance * error;
}

} // namespace ridges
