// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesPartsToPieces_h
#define vtkRidgesPartsToPieces_h

#include "Core/Base/Ranks.h"
#include "Core/Shares/SharedPoints.h"
#include "vtkRidgesFormArrays.h"

#include <vector>

/**
 * Brings values of points that a rank owns to the pieces that have these points, one part after the
 * other, so that they are never in memory twice; private to the module.
 */
class vtkRidgesPartsToPieces
{
public:
  /// `points` are all that this rank owns, part after part, of which each starts at one of `begins`
  /// and the last ends there. The ranks and shared points have to outlive the object.
  vtkRidgesPartsToPieces(ridges::Ranks& ranks, const ridges::SharedPoints& shared,
    const std::vector<ridges::Id>& points, const std::vector<ridges::Id>& begins);

  /// `part` has the points of the part of this number, ascending, and `values` theirs. Those of
  /// the same part of all ranks go into `piece`, which has a place for each point of this rank's
  /// piece. All ranks have to call this, with the same number.
  void Send(std::size_t number, const std::vector<ridges::Id>& part,
    const vtkRidgesFormArrays& values, vtkRidgesFormArrays& piece) const;

private:
  void SendSlice(std::size_t slice, const std::vector<ridges::Id>& part,
    const vtkRidgesFormArrays& values, vtkRidgesFormArrays& piece) const;

  ridges::Ranks& Ranks;
  const ridges::SharedPoints& Shared;

  // What is wanted by each rank: which of the points that it has sent, slice after slice.
  std::vector<std::vector<ridges::Id>> Wanted;
  std::vector<std::vector<ridges::Id>> WantedBegins; ///< Of slices, of which each part has some.
};

#endif
