// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_Lanes_h
#define ridges_Lanes_h

#include <array>
#include <cmath>

namespace ridges
{

/// Eight doubles that are computed with at once, each for itself: compilers make vector
/// instructions of it, and what is decided once for all eight costs little.
struct Lanes
{
  static constexpr int Count = 8;

  Lanes() = default;
  Lanes(double value) { this->values.fill(value); }

  double& operator[](int lane) { return this->values[lane]; }
  double operator[](int lane) const { return this->values[lane]; }

  Lanes& operator+=(const Lanes& other)
  {
    for (int i = 0; i < Count; ++i)
    {
      this->values[i] += other.values[i];
    }
    return *this;
  }
  Lanes& operator-=(const Lanes& other)
  {
    for (int i = 0; i < Count; ++i)
    {
      this->values[i] -= other.values[i];
    }
    return *this;
  }
  Lanes& operator*=(const Lanes& other)
  {
    for (int i = 0; i < Count; ++i)
    {
      this->values[i] *= other.values[i];
    }
    return *this;
  }
  Lanes& operator/=(const Lanes& other)
  {
    for (int i = 0; i < Count; ++i)
    {
      this->values[i] /= other.values[i];
    }
    return *this;
  }

  friend Lanes operator+(const Lanes& a, const Lanes& b)
  {
    Lanes result = a;
    return result += b;
  }
  friend Lanes operator-(const Lanes& a, const Lanes& b)
  {
    Lanes result = a;
    return result -= b;
  }
  friend Lanes operator*(const Lanes& a, const Lanes& b)
  {
    Lanes result = a;
    return result *= b;
  }
  friend Lanes operator/(const Lanes& a, const Lanes& b)
  {
    Lanes result = a;
    return result /= b;
  }

  /// A function of each of them.
  template <typename Function>
  static Lanes Map(const Lanes& a, const Function& function)
  {
    Lanes result;
    for (int i = 0; i < Count; ++i)
    {
      result.values[i] = function(a.values[i]);
    }
    return result;
  }

  std::array<double, Count> values{};
};

// clang-format off
inline Lanes exp(const Lanes& a) { return Lanes::Map(a, [](double x) { return std::exp(x); }); }
inline Lanes log(const Lanes& a) { return Lanes::Map(a, [](double x) { return std::log(x); }); }
inline Lanes sqrt(const Lanes& a) { return Lanes::Map(a, [](double x) { return std::sqrt(x); }); }
inline Lanes cbrt(const Lanes& a) { return Lanes::Map(a, [](double x) { return std::cbrt(x); }); }
inline Lanes sin(const Lanes& a) { return Lanes::Map(a, [](double x) { return std::sin(x); }); }
inline Lanes cos(const Lanes& a) { return Lanes::Map(a, [](double x) { return std::cos(x); }); }
inline Lanes tan(const Lanes& a) { return Lanes::Map(a, [](double x) { return std::tan(x); }); }
inline Lanes asin(const Lanes& a) { return Lanes::Map(a, [](double x) { return std::asin(x); }); }
inline Lanes acos(const Lanes& a) { return Lanes::Map(a, [](double x) { return std::acos(x); }); }
inline Lanes atan(const Lanes& a) { return Lanes::Map(a, [](double x) { return std::atan(x); }); }
inline Lanes sinh(const Lanes& a) { return Lanes::Map(a, [](double x) { return std::sinh(x); }); }
inline Lanes cosh(const Lanes& a) { return Lanes::Map(a, [](double x) { return std::cosh(x); }); }
inline Lanes tanh(const Lanes& a) { return Lanes::Map(a, [](double x) { return std::tanh(x); }); }
inline Lanes pow(const Lanes& a, double p) { return Lanes::Map(a, [p](double x) { return std::pow(x, p); }); }
// clang-format on

} // namespace ridges

#endif
