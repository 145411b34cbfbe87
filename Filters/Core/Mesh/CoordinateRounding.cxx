// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/CoordinateRounding.h"

#include "Mesh/TriangleMesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ridges
{
namespace
{

constexpr double DoubleUnit = std::numeric_limits<double>::epsilon();
constexpr double SingleUnit = std::numeric_limits<float>::epsilon();

/// Numbers of single precision are near one of seven digits in any case.
constexpr int MostDigitsOfSingle = 6;

constexpr int LeastDigits = 5;

bool IsSingle(double x)
{
  return static_cast<double>(static_cast<float>(x)) == x;
}

constexpr int MostTabled = 20;

/// 10 to the power of `exponent`, from a table where it is about 0.
double PowerOfTen(int exponent)
{
  static const std::array<double, 2 * MostTabled + 1> powers = []
  {
    std::array<double, 2 * MostTabled + 1> all{};
    int power = -MostTabled;
    for (double& each : all)
    {
      each = std::pow(10.0, power++);
    }
    return all;
  }();
  const int place = exponent + MostTabled;
  return place >= 0 && place <= 2 * MostTabled ? powers[static_cast<std::size_t>(place)]
                                               : std::pow(10.0, exponent);
}

/// The power of ten of the first digit. From that of two, which may be one too low.
int DecimalExponent(double magnitude)
{
  constexpr double log10Of2 = 0.30102999566398120;
  const int exponent = static_cast<int>(std::floor(std::ilogb(magnitude) * log10Of2));
  return magnitude >= PowerOfTen(exponent + 1) ? exponent + 1 : exponent;
}

/// Whether a number of so many digits is as near to it as its type can tell.
bool IsNearNumberOf(int digits, double magnitude, int exponent, double unit)
{
  constexpr double roundings = 2.0; // of the number and of the product
  const double scaled = magnitude * PowerOfTen(digits - 1 - exponent);
  return std::abs(scaled - std::round(scaled)) <= roundings * unit * scaled;
}

/// What has so many digits has more as well, so that the order of coordinates does not matter.
bool HasDigits(int digits, double magnitude, int exponent, bool isSingle)
{
  return IsNearNumberOf(digits, magnitude, exponent, DoubleUnit) ||
    (isSingle &&
      IsNearNumberOf(std::min(digits, MostDigitsOfSingle), magnitude, exponent, SingleUnit));
}

} // namespace

CoordinateRounding& CoordinateRounding::Include(const CoordinateRounding& other)
{
  this->isSingle = this->isSingle && other.isSingle;
  this->digits = std::max(this->digits, other.digits);
  this->largest = std::max(this->largest, other.largest);
  return *this;
}

CoordinateRounding& CoordinateRounding::Include(double coordinate)
{
  const bool isSingleHere = IsSingle(coordinate);
  this->isSingle = this->isSingle && isSingleHere;
  const double magnitude = std::abs(coordinate);
  this->largest = std::max(this->largest, magnitude);
  if (magnitude < std::numeric_limits<double>::min() || this->digits >= NotDecimal)
  {
    return *this;
  }
  const int exponent = DecimalExponent(magnitude);
  while (this->digits < NotDecimal && !HasDigits(this->digits, magnitude, exponent, isSingleHere))
  {
    ++this->digits;
  }
  return *this;
}

double CoordinateRounding::OfPrecision() const
{
  return 0.5 * (this->isSingle ? SingleUnit : DoubleUnit);
}

double CoordinateRounding::OfDigits(double coordinate) const
{
  const double magnitude = std::abs(coordinate);
  if (this->digits < LeastDigits || this->digits >= NotDecimal ||
    magnitude < std::numeric_limits<double>::min())
  {
    return 0.0;
  }
  const double step = PowerOfTen(DecimalExponent(magnitude) + 1 - this->digits);
  return step / std::sqrt(12.0);
}

double CoordinateRounding::Height() const
{
  return this->IsCoarse() ? std::hypot(this->OfPrecision() * this->largest / std::sqrt(3.0),
                              this->OfDigits(this->largest))
                          : 0.0;
}

CoordinateRounding FindCoordinateRounding(const TriangleMesh& mesh)
{
  if (mesh.Part())
  {
    return mesh.Part()->coordinateRounding;
  }
  CoordinateRounding rounding;
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    for (const double x : mesh.Point(p))
    {
      rounding.Include(x);
    }
    if (!rounding.IsCoarse())
    {
      break;
    }
  }
  return rounding;
}

} // namespace ridges
