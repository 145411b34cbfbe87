// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_UmbilicGathering_h
#define ridges_UmbilicGathering_h

#include "Umbilics/PairCancellation.h"
#include "Umbilics/Umbilic.h"
#include "Umbilics/UmbilicPatch.h"

#include <unordered_map>

namespace ridges
{

/**
 * The umbilics of a mesh from the indices of its triangles, none of which is lost: what noise has
 * split is cancelled (see PairCancellation.h), what is left are the umbilics, each in a patch.
 *
 * A patch is a disk grown around its umbilic's triangle up to the size asked for, but not farther
 * than half way to the next umbilic. Of its growth that stage is taken, the last if there are
 * several, at which as many ridges of each colour cross the contour as have to meet at the umbilic;
 * if no stage up to that size will do, the first one up to twice the size; else just the last.
 */
class UmbilicGathering
{
public:
  /// `charges` are all triangles with an index, as SpreadLargeCharges leaves them. `usable` tells
  /// the points that have directions, one flag for each; null means all.
  UmbilicGathering(const TriangleMesh& mesh, const MongeField& field,
    const std::vector<IndexCharge>& charges, const std::vector<std::uint8_t>& isWeak,
    const std::uint8_t* usable = nullptr, const RangeLoop& loop = TriangleMesh::InOneRange);

  /// Umbilics in the order of x, then y, then z of their triangles; those that stand for triangles
  /// without directions come last.
  std::vector<Umbilic> Umbilics(double patchSize);

  /// Regions where umbilics have cancelled each other, outside all patches of the umbilics.
  TriangleGroups CancelledRegions() const;

private:
  /// The region that a triangle is in, or Cancellation::NoRegion.
  Id RegionOf(Id triangle) const
  {
    const std::vector<Id>& regionOf = this->Cancellation_.regionOf;
    return regionOf.empty() ? Cancellation::NoRegion : regionOf[triangle];
  }
  std::vector<double> HalfWaysToNext() const;
  std::vector<Id> ChoosePatch(
    const IndexCharge& charge, int ridgeCount, double radius, double halfWay);

  const TriangleMesh& Mesh_;
  MongeField Field_;
  const std::uint8_t* Usable_;
  Cancellation Cancellation_;
  std::unordered_map<Id, int> HalfTurns_;
  std::vector<bool> IsSwallowed_; ///< Whether a region is inside a patch.
  UmbilicPatch Patch_;
};

} // namespace ridges

#endif
