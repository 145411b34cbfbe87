// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fit/FitErrors.h"

#include "Mesh/MeanSquare.h"
#include "Mesh/PositionOrder.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ridges
{
namespace
{

/// See FromResiduals. The estimate of n is too rough for n - 15 to be taken for less.
constexpr double Factor = 140.0;
constexpr double LeastFreedom = 9.0;

/// Of b0, over that of the third-order tensor.
constexpr double ErrorOfExtremality = 0.6;

/// Of k1 - k2, from the number of points of a fit and what it magnifies noise by in the tensor.
/// That tells the degree: each of 4, 6 and 8 has its coefficients and its factors, over the root of
/// the points that are more than these. As their number is an estimate, it is taken for a fifth
/// more than the coefficients at least.
double ErrorOfGap(double gain, double points)
{
  struct Degree
  {
    double coefficients;
    double ofTensor;
    double ofGap;
  };
  constexpr std::array<Degree, 3> degrees{ { { 15.0, 130.0, 59.0 }, { 28.0, 730.0, 154.0 },
    { 45.0, 2400.0, 330.0 } } };
  const auto freedom = [points](const Degree& degree)
  { return std::max(0.2 * degree.coefficients, points - degree.coefficients); };
  // Of two degrees in a row the higher one if the gain is above the geometric mean of theirs.
  const double squaredGain = gain * gain;
  std::size_t i = 0;
  for (; i + 1 < degrees.size(); ++i)
  {
    const double factors = degrees[i].ofTensor * degrees[i + 1].ofTensor;
    if (!(squaredGain * squaredGain * freedom(degrees[i]) * freedom(degrees[i + 1]) >
          factors * factors))
    {
      break;
    }
  }
  return degrees[i].ofGap / std::sqrt(freedom(degrees[i]));
}

/// The same to the last digit whatever the order of the three.
double SumBySize(double a, double b, double c)
{
  const double lower = std::min(a, b);
  const double upper = std::max(a, b);
  return std::min(lower, c) + std::max(lower, std::min(upper, c)) + std::max(upper, c);
}

/// About how many points a fit at this point was to, from the area that its scale covers.
double EstimatePoints(const TriangleMesh& mesh, double scale, Id point)
{
  double areas = 0.0;
  for (const Id t : mesh.TrianglesAround(point))
  {
    areas += 0.5 * AreaNormalInOrder(mesh, t).norm();
  }
  // Two rings of an even mesh, 19 points, reach to 2 edges, or 14.5 times the area for a point.
  constexpr double perDisk = 19.0 / 14.5;
  constexpr double pi = 3.14159265358979323846;
  return areas > 0.0 ? perDisk * pi * scale * scale / (areas / 3.0) : 0.0;
}

/**
 * A standard error from residual / scale^order, for a value of the unit 1 / length^order.
 *
 * With n points and 15 coefficients the noise is the residual times sqrt(n / (n - 15)), and its
 * effect on a coefficient falls like one over sqrt(n). The factor left is one that, on even meshes
 * and scans, and for 18 to 200 points, comes within a factor of two of the median of the standard
 * errors of k1 - k2 and of b0 by JetErrors.h. Where it is known by what a fit magnifies noise,
 * which depends on its degree, that is used instead.
 */
template <int Order>
double FromResiduals(const TriangleMesh& mesh, const FitErrorSource& source, Id point)
{
  if (!source.fitResidual || !source.fitScale || !(source.fitScale[point] > 0.0))
  {
    return 0.0;
  }
  static_assert(Order == 1 || Order == 2, "in units of 1 / length or 1 / length^2");
  const auto unit = [&source](Id p)
  {
    const double inverse = 1.0 / source.fitScale[p];
    return Order == 1 ? inverse : inverse * inverse;
  };
  const auto square = [&source, &unit](Id p)
  {
    if (!(source.fitScale[p] > 0.0))
    {
      return 0.0;
    }
    const double rounding = Order == 1 ? source.rounding / source.fitScale[p] : 0.0;
    const double squaredUnit = unit(p) * unit(p);
    const double residual = source.fitResidual[p];
    return (residual * residual + rounding * rounding) * squaredUnit;
  };
  const double meanSquare = MeanSquareAround(mesh, point, square);
  if (!std::isfinite(meanSquare))
  {
    return meanSquare;
  }
  constexpr double coefficients = 15.0;
  const double points = EstimatePoints(mesh, source.fitScale[point], point);
  double factor = Factor / std::sqrt(std::max(LeastFreedom, points - coefficients));
  if (source.noiseGain && source.noiseGain[point] > 0.0)
  {
    // With few points more than coefficients residuals say too little to trust a lower estimate.
    const double gain = source.noiseGain[point];
    const double byGain = Order == 1 ? ErrorOfGap(gain, points) : ErrorOfExtremality * gain;
    factor = points < 2.0 * coefficients ? std::max(factor, byGain) : byGain;
  }
  // Below this all is rounding: the surface is a polynomial to ten digits over the fitted radius.
  constexpr double rounding = 1e-10;
  return std::max(rounding * unit(point), factor * std::sqrt(meanSquare));
}

} // namespace

double GapError(const TriangleMesh& mesh, const FitErrorSource& source, Id point)
{
  if (source.maximumCurvatureError && source.minimumCurvatureError)
  {
    return std::hypot(source.maximumCurvatureError[point], source.minimumCurvatureError[point]);
  }
  return FromResiduals<1>(mesh, source, point);
}

double ExtremalityError(
  const TriangleMesh& mesh, const FitErrorSource& source, Color color, Id point)
{
  if (source.thirdOrderError)
  {
    return source
      .thirdOrderError[4 * static_cast<std::size_t>(point) + (color == Color::Blue ? 0 : 3)];
  }
  return FromResiduals<2>(mesh, source, point);
}

bool IsGentle(const MongeField& field, const FitErrorSource& source, Id point)
{
  if (!source.fitResidual || !source.fitScale || !(source.fitScale[point] > 0.0))
  {
    return false;
  }
  // Slopes at the radius from the second order, and from the third; and the heights left over.
  constexpr double mostSlope = 0.4;
  constexpr double mostResidual = 0.01;
  const double scale = source.fitScale[point];
  const double second = std::max(std::abs(field.k1[point]), std::abs(field.k2[point]));
  const double* b = field.ThirdOrder(point);
  const double third =
    std::max(std::max(std::abs(b[0]), std::abs(b[1])), std::max(std::abs(b[2]), std::abs(b[3])));
  return source.fitResidual[point] < mostResidual && second * scale < mostSlope &&
    third * scale * scale < mostSlope;
}

bool MayBeWeak(const MongeField& field, const FitErrorSource& source, double significance, Id point)
{
  if (source.maximumCurvatureError || !source.fitResidual || !source.fitScale)
  {
    return true;
  }
  // LeastFreedom under the root
  const double mostError = source.noiseGain && source.noiseGain[point] > 0.0
    ? ErrorOfGap(source.noiseGain[point], 0.0)
    : Factor / 3.0;
  constexpr double mostOfNeighbors = 4.0;
  const double scale = source.fitScale[point];
  const double gap = field.k1[point] - field.k2[point];
  constexpr double rounding = 1e-10;
  return !(gap * scale > significance *
      (mostError * (mostOfNeighbors * source.fitResidual[point] + source.rounding / scale) +
        rounding));
}

namespace
{

bool IsWeakAt(const MongeField& field, const std::array<double, 3>& errors, double significance,
  const Triangle& c)
{
  const double gap = SumBySize(field.k1[c[0]] - field.k2[c[0]], field.k1[c[1]] - field.k2[c[1]],
    field.k1[c[2]] - field.k2[c[2]]);
  const double error = SumBySize(errors[0], errors[1], errors[2]);
  return error > 0.0 && gap <= significance * error;
}

} // namespace

bool IsWeak(const TriangleMesh& mesh, const MongeField& field, const double* gapErrors,
  double significance, Id triangle)
{
  const Triangle& c = mesh.Corners(triangle);
  return IsWeakAt(field, { gapErrors[c[0]], gapErrors[c[1]], gapErrors[c[2]] }, significance, c);
}

bool IsWeakByStandardErrors(
  const MongeField& field, const FitErrorSource& source, double significance, const Triangle& c)
{
  std::array<double, 3> errors;
  std::transform(c.begin(), c.end(), errors.begin(),
    [&source](Id p)
    { return std::hypot(source.maximumCurvatureError[p], source.minimumCurvatureError[p]); });
  return IsWeakAt(field, errors, significance, c);
}

} // namespace ridges
