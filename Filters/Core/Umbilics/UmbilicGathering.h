// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_UmbilicGathering_h
#define ridges_UmbilicGathering_h

#include "Umbilics/PairCancellation.h"
#include "Umbilics/Umbilic.h"

#include <vector>

namespace ridges
{

class PatchChoice;

/**
 * The umbilics of a mesh from the indices of its triangles, none of which is lost: what noise has
 * split is cancelled (see PairCancellation.h), what is left are the umbilics, each in a patch (see
 * PatchChoice.h). Patches reach no farther than half way to the next umbilic, so that none
 * overlaps another.
 */
class UmbilicGathering
{
public:
  /// `charges` are all triangles with an index, as SpreadLargeCharges leaves them. `usable` holds
  /// a flag for each point, whether it has directions; null means all have. After the monitor has
  /// stopped the cancellation, nothing else is of use.
  UmbilicGathering(const TriangleMesh& mesh, const MongeField& field,
    const std::vector<IndexCharge>& charges, const std::vector<std::uint8_t>& isWeak,
    const std::uint8_t* usable = nullptr, const RangeLoop& loop = TriangleMesh::InOneRange,
    const Monitor& monitor = NeverStops);

  /// Umbilics in the order of x, then y, then z of their triangles; those that stand for triangles
  /// without directions come last. If the loop leaves out ranges, as when a user aborts, the result
  /// is of no use.
  std::vector<Umbilic> Umbilics(double patchSize, const RangeLoop& loop = TriangleMesh::InOneRange);

  /// Regions where umbilics have cancelled each other, outside all patches of the umbilics.
  TriangleGroups CancelledRegions() const;

private:
  std::vector<double> HalfWaysToNext(const RangeLoop& loop) const;
  Umbilic MakeUmbilicWithPatch(
    const IndexCharge& charge, PatchChoice& choice, double patchSize, double limit) const;
  void MarkSwallowed(const std::vector<Id>& patch);

  const TriangleMesh& Mesh_;
  MongeField Field_;
  const std::uint8_t* Usable_;
  Cancellation Cancellation_;
  std::vector<int> HalfTurns_;            ///< Of each triangle.
  std::vector<std::uint8_t> IsSwallowed_; ///< Whether a region is inside a patch.
};

} // namespace ridges

#endif
