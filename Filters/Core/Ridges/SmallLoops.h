// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_SmallLoops_h
#define ridges_SmallLoops_h

#include "Fit/FitErrors.h"
#include "Ridges/RidgeAssembly.h"

namespace ridges
{

/**
 * Finds ridges that noise in b alone may have made: loops around a few points at which b0 (b3) is
 * not significantly different from 0. Had it the other sign there the loop would not exist.
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
  bool IsInsignificant(Id point) const;
  bool IsInsignificantBehind(Id start, Id outside, const std::vector<Id>& fence) const;

  const RidgeCrossings& Crossings_;
  FitErrorSource Errors_;
  double Significance_;
};

} // namespace ridges

#endif
