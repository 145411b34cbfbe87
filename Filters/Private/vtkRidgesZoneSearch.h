// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesZoneSearch_h
#define vtkRidgesZoneSearch_h

#include "Core/Ridges/RidgeZones.h"
#include "vtkRidgesCompatibility.h"

#include "vtkType.h"

#include <cstdint>
#include <vector>

namespace ridges
{
class OrderedRings;
}

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
VTK_ABI_NAMESPACE_END

class vtkRidgesMongeInput;

/// What vtkRidgeExtraction reports about the zones of a colour.
struct vtkRidgesZones
{
  std::vector<std::vector<ridges::Id>> triangles; ///< Of each zone, by position.
  vtkIdType numberOfRidges = 0;                   ///< That were left out there.
};

/**
 * Finds the ridges of a colour that lie in zones, private to the module: where its extremality is
 * nowhere significant. What it is given has to outlive it.
 */
class vtkRidgesZoneSearch
{
public:
  vtkRidgesZoneSearch(const vtkRidgesMongeInput& monge, ridges::Color color, double significance);

  /**
   * Removes the ridges, and adds the zones that had any. False if the user aborted the filter,
   * whose progress runs from `from` to `to`. On clean meshes some places on each ridge show that
   * there is nothing to remove, and the other points are not looked at.
   */
  bool Run(vtkAlgorithm* filter, double from, double to,
    const std::vector<ridges::RidgeSegment>& segments, const std::vector<ridges::RidgePath>& paths,
    std::vector<ridges::Ridge>& whole, vtkRidgesZones& zones);

private:
  bool IsClear(const ridges::Ridge& ridge);
  bool AreAllClear(const std::vector<ridges::Ridge>& whole);
  bool AreOutside(const std::vector<ridges::Ridge>& whole);
  bool JudgePoints(vtkAlgorithm* filter, double from, double to);
  bool RemoveResolved(vtkAlgorithm* filter, double from, double to, ridges::RidgeZones& zones,
    const std::vector<std::size_t>& regions, bool& isAnyRemoved) const;
  bool ShowsAsAWhole(const ridges::RidgeZones& zones, std::size_t region) const;
  bool ShowsOnLargerScale(
    const ridges::RidgeZones& zones, std::size_t region, const ridges::OrderedRings& rings) const;

  const vtkRidgesMongeInput& Monge;
  ridges::Color Color;
  double Significance;
  std::vector<std::uint8_t> IsFlagged;
  ridges::ExtremalityErrors Errors;
};

#endif
