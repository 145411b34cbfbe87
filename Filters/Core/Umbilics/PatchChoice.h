// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_PatchChoice_h
#define ridges_PatchChoice_h

#include "Umbilics/PairCancellation.h"
#include "Umbilics/UmbilicPatch.h"

#include <array>

namespace ridges
{

/// What the patches of a mesh have to respect.
struct PatchSurroundings
{
  const TriangleMesh& mesh;
  MongeField field;
  const std::uint8_t* usable; ///< The points that have directions; null means all.
  const Cancellation& cancellation;
  const std::vector<int>& halfTurns; ///< Of each triangle.
};

/**
 * Chooses the patch of an umbilic: a stage of the growth of a disk around its triangle.
 *
 * Valid are the stages with the index of the umbilic that contain each cancelled region as a whole
 * or not at all. Of these the last one up to a radius is chosen at which as many ridges of each
 * colour cross the contour as have to meet at the umbilic; if there is none, the first one up to
 * twice the radius; if there is none either, the last valid one up to the radius.
 *
 * Holds scratch memory of the size of a patch: use one per thread.
 */
class PatchChoice
{
public:
  explicit PatchChoice(const PatchSurroundings& surroundings);

  /// `size` is the radius as a multiple of the greatest distance of a centroid in the one-ring.
  /// The patch does not grow beyond `limit`, in the unit of the points.
  std::vector<Id> Choose(const IndexCharge& charge, int ridgeCount, double size, double limit);

private:
  void Reset();
  void CountTurns(Id triangle);
  void CountRegion(Id triangle);
  void CountCrossings(Id triangle);
  bool IsValid(const IndexCharge& charge) const
  {
    return this->HalfTurns_ == charge.halfTurns && this->PartialRegions_ == 0;
  }

  const PatchSurroundings& Surroundings_;
  UmbilicPatch Patch_;
  IdTable<Id> InsideOfRegion_; ///< How many triangles of a cancelled region are inside.
  int HalfTurns_ = 0;
  int PartialRegions_ = 0;
  std::array<int, 2> Crossings_ = { 0, 0 }; ///< Of the contour by blue and red ridges.
};

} // namespace ridges

#endif
