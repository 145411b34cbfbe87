// SPDX-License-Identifier: BSD-3-Clause
#include "FitErrors.h"

#include <algorithm>
#include <cmath>

namespace ridges
{
namespace
{

/// A standard error for each unit of residual / scale^order, that is for values of the unit
/// 1 / length^order.
template <int Order>
double FromResiduals(
  const TriangleMesh& mesh, const FitErrorSource& source, double perResidual, Id point)
{
  if (!source.fitResidual || !source.fitScale || !(source.fitScale[point] > 0.0))
  {
    return 0.0;
  }
  const auto unit = [&source](Id p) { return std::pow(source.fitScale[p], -Order); };
  double sum = 0.0;
  int count = 0;
  for (const Id t : mesh.TrianglesAround(point))
  {
    for (const Id p : mesh.Corners(t))
    {
      const double ratio = source.fitScale[p] > 0.0 ? source.fitResidual[p] * unit(p) : 0.0;
      sum += ratio * ratio;
      ++count;
    }
  }
  // Below this all is rounding: the surface is a polynomial to ten digits over the fitted radius.
  constexpr double rounding = 1e-10;
  const double average = count > 0 ? std::sqrt(sum / count) : 0.0;
  return std::max(rounding * unit(point), perResidual * average);
}

} // namespace

double GapError(const TriangleMesh& mesh, const FitErrorSource& source, Id point)
{
  if (source.maximumCurvatureError && source.minimumCurvatureError)
  {
    return std::hypot(source.maximumCurvatureError[point], source.minimumCurvatureError[point]);
  }
  // The median over fits of degree 4 to 18 points, even or from scans, is 40 to 53.
  return FromResiduals<1>(mesh, source, 45.0, point);
}

double ExtremalityError(
  const TriangleMesh& mesh, const FitErrorSource& source, Color color, Id point)
{
  if (source.thirdOrderError)
  {
    return source
      .thirdOrderError[4 * static_cast<std::size_t>(point) + (color == Color::Blue ? 0 : 3)];
  }
  // The median over such fits is 25 on even meshes and 40 to 100 on scans.
  return FromResiduals<2>(mesh, source, 40.0, point);
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
