// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_PatchRidges_h
#define ridges_PatchRidges_h

#include "Ridges/MarchingTriangles.h"
#include "Ridges/Patch/PatchContour.h"

namespace ridges
{

struct PatchCurve;

/// A patch around an umbilic, or a region where umbilics have cancelled each other.
struct RidgePatch
{
  static constexpr Id NoUmbilic = -1;

  std::vector<Id> triangles;
  Id umbilic = NoUmbilic; ///< The triangle of the umbilic.
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  int ridgeCount = 0; ///< Of each colour at the umbilic: 1 or 3.
};

/**
 * Draws the ridges of one colour inside a patch (section 6.3), where what marching finds does not
 * do: where it holds more singular triangles than that of its umbilic, or where at that one other
 * ridges meet than have to.
 *
 * The crossings of the contour are all that is kept. Of neighbours among them, the nearest pair
 * first, as many pairs are joined along the contour as leave those that have to meet at the
 * umbilic; pairs that marching joins go before others. The rest runs straight to the umbilic. Thus
 * no ridge ends in a patch but at its umbilic, none crosses another, and none is lost.
 *
 * On a contour with fewer crossings than ridges have to meet, those there are run to the umbilic.
 */
class PatchRidges
{
public:
  explicit PatchRidges(const RidgeCrossings& crossings)
    : Crossings_(crossings)
  {
  }

  /// Appends the pieces, and what they pass through, by which marching has to be replaced in the
  /// patch, and sets the flags of its triangles; or leaves all as it is where marching will do.
  void Draw(const RidgePatch& patch, std::vector<RidgeSegment>& segments,
    std::vector<RidgePath>& paths, std::vector<std::uint8_t>& isReplaced) const;

private:
  struct Crossing
  {
    std::size_t side; ///< Of the contour.
    Id partner = -1;  ///< The crossing that marching joins it to.
    bool toUmbilic = false;
  };
  struct Pair
  {
    std::size_t first; ///< Sides of the contour, in the order of the walk.
    std::size_t last;
  };
  struct Joints
  {
    std::vector<Pair> pairs;
    std::vector<std::size_t> toUmbilic; ///< Sides of the contour.
  };

  std::vector<Crossing> FindCrossings(const PatchContour& contour, Id umbilic) const;
  bool IsDrawnByMarching(const RidgePatch& patch, const std::vector<Crossing>& crossings) const;
  Joints Join(const RidgePatch& patch, const PatchContour& contour,
    const std::vector<Crossing>& crossings) const;
  bool FindCurves(
    const RidgePatch& patch, const PatchContour& contour, std::vector<PatchCurve>& curves) const;
  std::vector<PatchCurve> MakeCurves(const RidgePatch& patch, const PatchContour& contour,
    const std::vector<Crossing>& crossings) const;
  void Append(const RidgePatch& patch, const PatchContour& contour, const PatchCurve& curve,
    std::vector<RidgeSegment>& segments, std::vector<RidgePath>& paths) const;
  bool IsSingular(Id triangle) const;

  const RidgeCrossings& Crossings_;
};

} // namespace ridges

#endif
