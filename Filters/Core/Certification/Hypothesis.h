// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_Hypothesis_h
#define ridges_Hypothesis_h

#include <array>
#include <cstdint>

namespace ridges
{

/// The hypotheses of RR-5294, sections 5.2.1 and 6.3, and what section 2.2 presumes; as bits of a
/// verdict, where one is set that fails or could not be shown to hold.
enum Hypothesis : std::uint16_t
{
  MeshFollowsSurface = 1 << 0,   ///< 2.2: the projection of the mesh is one-to-one.
  NoRightAngle = 1 << 1,         ///< S1
  NoUmbilicOnEdge = 1 << 2,      ///< S2
  NoRidgeThroughVertex = 1 << 3, ///< S3
  TransversalCrossings = 1 << 4, ///< S4
  OneUmbilic = 1 << 5,           ///< D1
  NoRidgeInTriangle = 1 << 6,    ///< D2
  DisjointPatches = 1 << 7,      ///< 2.2a
  NoRidgeInPatch = 1 << 8,       ///< 2.2b
  OnlyRidgesOfUmbilic = 1 << 9,  ///< 2.2c
  CorrectOrientation = 1 << 10,  ///< 2.2d.i
  OneCrossing = 1 << 11          ///< 2.2d.ii, which implies 3.
};

constexpr int NumberOfHypotheses = 12;

/// No subdivision can help: the surface itself is not generic there.
constexpr std::uint16_t NotGeneric = 1 << 15;

} // namespace ridges

#endif
