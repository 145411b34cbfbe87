// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_Interval_h
#define ridges_Interval_h

#include <boost/numeric/interval.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ridges
{

// Boost gives the names.
// NOLINTBEGIN(readability-identifier-naming)

/**
 * How the ends of intervals are rounded: computed to nearest and moved outward by more than the
 * error. The rounding mode of the processor stays as it is, which compilers take for granted.
 * Elementary functions of the C library are taken to be right to 4 units in the last place.
 */
struct OutwardRounding
{
  static double Out(double value, double ulps, double direction)
  {
    constexpr double tiny = 1e-300; // covers what is lost to underflow
    const double bound = value +
      direction * (std::abs(value) * (ulps * std::numeric_limits<double>::epsilon()) + tiny);
    return std::isnan(bound) ? Overflowed(value, direction) : bound;
  }

  static double Down(double value) { return Out(value, 1.0, -1.0); }
  static double Up(double value) { return Out(value, 1.0, 1.0); }
  static double FarDown(double value) { return Out(value, 4.0, -1.0); }
  static double FarUp(double value) { return Out(value, 4.0, 1.0); }

  void init() {}
  template <typename U>
  double conv_down(const U& v)
  {
    return static_cast<double>(v);
  }
  template <typename U>
  double conv_up(const U& v)
  {
    return static_cast<double>(v);
  }
  double opp_down(double x) { return -x; }
  double opp_up(double x) { return -x; }
  double add_down(double x, double y) { return Down(x + y); }
  double add_up(double x, double y) { return Up(x + y); }
  double sub_down(double x, double y) { return Down(x - y); }
  double sub_up(double x, double y) { return Up(x - y); }
  double mul_down(double x, double y) { return Down(x * y); }
  double mul_up(double x, double y) { return Up(x * y); }
  double div_down(double x, double y) { return Down(x / y); }
  double div_up(double x, double y) { return Up(x / y); }
  double sqrt_down(double x) { return std::max(0.0, Down(std::sqrt(x))); }
  double sqrt_up(double x) { return Up(std::sqrt(x)); }
  double median(double x, double y) { return x + 0.5 * (y - x); }
  double int_down(double x) { return std::floor(x); }
  double int_up(double x) { return std::ceil(x); }
  double exp_down(double x) { return std::max(0.0, FarDown(std::exp(x))); }
  double exp_up(double x) { return FarUp(std::exp(x)); }
  double log_down(double x) { return FarDown(std::log(x)); }
  double log_up(double x) { return FarUp(std::log(x)); }
  double cos_down(double x) { return FarDown(std::cos(x)); }
  double cos_up(double x) { return FarUp(std::cos(x)); }
  double tan_down(double x) { return FarDown(std::tan(x)); }
  double tan_up(double x) { return FarUp(std::tan(x)); }
  double asin_down(double x) { return FarDown(std::asin(x)); }
  double asin_up(double x) { return FarUp(std::asin(x)); }
  double acos_down(double x) { return FarDown(std::acos(x)); }
  double acos_up(double x) { return FarUp(std::acos(x)); }
  double atan_down(double x) { return FarDown(std::atan(x)); }
  double atan_up(double x) { return FarUp(std::atan(x)); }
  double sinh_down(double x) { return FarDown(std::sinh(x)); }
  double sinh_up(double x) { return FarUp(std::sinh(x)); }
  double cosh_down(double x) { return FarDown(std::cosh(x)); }
  double cosh_up(double x) { return FarUp(std::cosh(x)); }
  double tanh_down(double x) { return FarDown(std::tanh(x)); }
  double tanh_up(double x) { return FarUp(std::tanh(x)); }

private:
  /// Nothing is known of a value that is not a number; of one that is too large, on which side.
  static double Overflowed(double value, double direction)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const bool isInward = std::isinf(value) && value * direction < 0.0;
    return isInward ? -direction * std::numeric_limits<double>::max() : direction * infinity;
  }
};

/// What is undefined, as the logarithm of a negative number, may be anything.
struct WholeIfUndefined
{
  static double pos_inf() { return std::numeric_limits<double>::infinity(); }
  static double neg_inf() { return -std::numeric_limits<double>::infinity(); }
  static double nan() { return std::numeric_limits<double>::quiet_NaN(); }
  static bool is_nan(double x) { return std::isnan(x); }
  static double empty_lower() { return neg_inf(); }
  static double empty_upper() { return pos_inf(); }
  static bool is_empty(double lower, double upper) { return !(lower <= upper); }
};

// NOLINTEND(readability-identifier-naming)

/// An interval that contains all values that an expression can take.
using Interval = boost::numeric::interval<double,
  boost::numeric::interval_lib::policies<
    boost::numeric::interval_lib::save_state_nothing<OutwardRounding>, WholeIfUndefined>>;

inline bool IsPositive(const Interval& a)
{
  return a.lower() > 0.0;
}
inline bool IsNegative(const Interval& a)
{
  return a.upper() < 0.0;
}
/// 0 if it may vanish.
inline int SignOf(const Interval& a)
{
  return IsPositive(a) ? 1 : IsNegative(a) ? -1 : 0;
}

inline bool HasSign(const Interval& a)
{
  return SignOf(a) != 0;
}
/// Largest absolute value.
inline double Magnitude(const Interval& a)
{
  return std::max(std::abs(a.lower()), std::abs(a.upper()));
}
inline Interval Around(double center, double radius)
{
  return { center - radius, center + radius };
}

inline Interval pow(const Interval& a, double exponent)
{
  return exp(Interval(exponent) * log(a));
}

inline Interval cbrt(const Interval& a)
{
  return { OutwardRounding::FarDown(std::cbrt(a.lower())),
    OutwardRounding::FarUp(std::cbrt(a.upper())) };
}

} // namespace ridges

#endif
