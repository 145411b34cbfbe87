// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Arithmetic on RIDGES_LANES doubles at once. For kernels that are compiled once per instruction
// set: all is in an unnamed namespace and nothing of the standard library is used, so that no code
// for one instruction set can be linked in place of that for another. (xsimd 8.1 and Highway 1.0
// were tried: the same speed and no less code, as compilers have all the operators that kernels
// use.)
#ifndef ridges_LaneVector_h
#define ridges_LaneVector_h

namespace
{

constexpr int Lanes = RIDGES_LANES;

using Vec = double __attribute__((vector_size(Lanes * sizeof(double))));

inline Vec Load(const double* values)
{
  return *reinterpret_cast<const Vec*>(values);
}

inline void Store(double* values, const Vec& v)
{
  *reinterpret_cast<Vec*>(values) = v;
}

inline Vec Broadcast(double x)
{
  return x - Vec{};
}

inline Vec Max(const Vec& a, const Vec& b)
{
  return a > b ? a : b;
}

inline Vec Min(const Vec& a, const Vec& b)
{
  return a < b ? a : b;
}

inline Vec Abs(const Vec& a)
{
  return a < 0.0 ? -a : a;
}

/// a with its sign changed where b is negative.
inline Vec WithSign(const Vec& a, const Vec& b)
{
  return b < 0.0 ? -a : a;
}

inline Vec Sqrt(const Vec& a)
{
  Vec root{};
  for (int lane = 0; lane < Lanes; ++lane)
  {
    root[lane] = __builtin_sqrt(a[lane]);
  }
  return root;
}

using Bits = unsigned long long __attribute__((vector_size(Lanes * sizeof(double))));

/// A positive number with the sign of another.
inline Vec CopySign(const Vec& a, const Vec& b)
{
  constexpr unsigned long long sign = 1ULL << 63;
  return reinterpret_cast<Vec>(reinterpret_cast<Bits>(a) | (reinterpret_cast<Bits>(b) & sign));
}

/// The square root of a positive number to within 4 %, the same in all instruction sets: half the
/// exponent, and a straight line through the roots of what is left.
inline Vec RoughRoot(const Vec& a)
{
  constexpr unsigned long long offset = 0x1ff7a3bea91d9b1bULL;
  return reinterpret_cast<Vec>((reinterpret_cast<Bits>(a) >> 1) + offset);
}

struct Vec3
{
  Vec x, y, z;
};

inline Vec3 Load3(const double* values)
{
  return { Load(values), Load(values + Lanes), Load(values + 2 * Lanes) };
}

inline void Store3(double* values, const Vec3& v)
{
  Store(values, v.x);
  Store(values + Lanes, v.y);
  Store(values + 2 * Lanes, v.z);
}

inline Vec3 operator+(const Vec3& a, const Vec3& b)
{
  return { a.x + b.x, a.y + b.y, a.z + b.z };
}

inline Vec3 operator-(const Vec3& a, const Vec3& b)
{
  return { a.x - b.x, a.y - b.y, a.z - b.z };
}

inline Vec3 operator*(const Vec& s, const Vec3& a)
{
  return { s * a.x, s * a.y, s * a.z };
}

inline Vec Dot(const Vec3& a, const Vec3& b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline Vec3 Cross(const Vec3& a, const Vec3& b)
{
  return { a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
}

/// Per lane a where the condition holds, else b.
template <typename Condition>
inline Vec3 Select(const Condition& condition, const Vec3& a, const Vec3& b)
{
  return { condition ? a.x : b.x, condition ? a.y : b.y, condition ? a.z : b.z };
}

} // namespace

#endif
