// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_PositionHash_h
#define ridges_PositionHash_h

#include <Eigen/Core>

#include <cstdint>
#include <cstring>

namespace ridges
{

/// Bits of a number that depend on all bits of x: the finaliser of SplitMix64.
inline std::uint64_t MixedBits(std::uint64_t x)
{
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

/// A number that looks random and depends on the coordinates of a point only: to draw samples that
/// do not depend on the numbering.
inline std::uint64_t PositionHash(const Eigen::Vector3d& point)
{
  std::uint64_t hash = 0;
  for (const double x : point)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof(bits));
    hash = MixedBits(hash ^ bits);
  }
  return hash;
}

} // namespace ridges

#endif
