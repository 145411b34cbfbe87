// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_SmallLoops_h
#define ridges_SmallLoops_h

#include "Fit/FitErrors.h"
#include "Ridges/RidgeAssembly.h"

#include <array>
#include <vector>

namespace ridges
{

/**
 * Finds ridges that noise in b alone may have made: loops around a few points at which b0 (b3) is
 * not significantly different from 0. Had it the other sign there the loop would not exist.
 *
 * The edges that a loop crosses an odd number of times divide the points around it into parts, and
 * the loop runs between parts on its one side and parts on its other. It is small if on one of its
 * two sides all parts have few points, and b is insignificant at all of them: within its standard
 * errors and its difference to the derivative of the curvature. Where a loop passes
 * through patches it may cross edges twice, so that there are several parts on each side.
 */
class SmallLoops
{
public:
  /// Loops around more points than this, or of more crossings, are not looked at.
  static constexpr std::size_t MostPoints = 64;
  static constexpr std::size_t MostCrossings = 256;

  /// b has to be within `significance` standard errors of 0.
  SmallLoops(const RidgeCrossings& crossings, const FitErrorSource& errors, double significance);

  bool Contain(const Ridge& ridge, const std::vector<RidgeSegment>& segments,
    const std::vector<RidgePath>& paths) const;

private:
  /// Points that can be reached from each other without crossing the fence: `isSmall` if they are
  /// few, and b is insignificant at all of them. Otherwise not all of them may have been found.
  struct Part
  {
    std::vector<Id> points;
    bool isSmall = true;
    std::size_t done = 0; ///< Points whose neighbours have been looked at.

    bool IsWhole() const { return !this->isSmall || this->done == this->points.size(); }
  };
  using Fence = std::vector<Id>; ///< Edges, sorted.

  bool IsInsignificant(Id point) const;
  double Difference(Id point) const;
  Part FindPart(Id start, const Fence& fence) const;
  void GrowByOne(Part& part, const Fence& fence) const;
  bool Separates(const Part& part, const Fence& fence) const;
  /// `known` are the parts found already.
  bool HasSmallSide(const Fence& fence, const std::array<Part, 2>& known) const;

  const RidgeCrossings& Crossings_;
  FitErrorSource Errors_;
  double Significance_;
};

} // namespace ridges

#endif
