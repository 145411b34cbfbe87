// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_SalientSelection_h
#define ridges_SalientSelection_h

#include "Ridges/RidgeTrace.h"
#include "Salience/FoldAngle.h"

#include <optional>
#include <vector>

namespace ridges
{

/// Which parts of ridges are salient. Angles are in radians, lengths in the unit of the points.
struct SalientRule
{
  double angle = 0.0;      ///< What a line has somewhere.
  double weakAngle = 0.0;  ///< What a line has everywhere, but in gaps.
  double longestGap = 0.0; ///< Of what is bridged along a ridge.
  double leastMass = 0.0;  ///< Integral of the fold angle along a line.
  double floor = 0.0;      ///< The height of folds that noise has.
  bool crestOnly = true;   ///< Whether all but crest lines is left out.
};

/// A part of a ridge.
struct SalientLine
{
  Id ridge = 0;
  std::vector<Id> vertices; ///< Of the ridge's trace, in order; a closed line repeats the first.
  bool closed = false;
  double mass = 0.0;
  double angle = 0.0;      ///< The largest.
  double confidence = 0.0; ///< Share of the length that is elliptic and above the floor.
  /// Before the first and behind the last vertex, where the line was lengthened to a corner.
  std::optional<RidgeVertex> startCorner;
  std::optional<RidgeVertex> endCorner;
};

/**
 * The salient parts of ridges of one colour: hysteresis along whole ridges. Pieces that are
 * elliptic with the weak angle at both ends are joined, gaps bridged, and what is left is kept if
 * it has the angle somewhere and enough mass. In the order of ridges, and along them.
 */
std::vector<SalientLine> SelectSalient(const std::vector<RidgeTrace>& ridges,
  const std::vector<RidgeFolds>& folds, const SalientRule& rule);

} // namespace ridges

#endif
