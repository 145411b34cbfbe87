// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_PatchCurves_h
#define ridges_PatchCurves_h

#include "Ridges/Patch/PatchPaths.h"
#include "Ridges/Patch/RefinedPatch.h"
#include "Ridges/RidgeCrossings.h"

#include <map>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ridges
{

/// A ridge inside a patch, from a side of its contour or the umbilic to another side or the
/// umbilic.
struct PatchCurve
{
  static constexpr int Umbilic = -1;

  int from = Umbilic;
  int to = Umbilic;
  std::vector<EdgeCrossing> path; ///< Between both.
};

/**
 * Follows the ridges of one colour through the small triangles of a patch. What crosses one edge
 * of the contour twice, which the mesh does not show, is taken to turn back there. So each crossing
 * of the contour that the mesh shows is an end of one curve, as many others as the cubic form says
 * are at the umbilic, and no two curves cross.
 *
 * Next to an umbilic two ridges may be so near to each other that an error of the interpolation
 * joins them, and leaves a short ridge from the umbilic to itself and one that passes by. Where
 * these are nearer to each other than half an edge, both are led to the umbilic instead.
 */
class PatchCurves
{
public:
  PatchCurves(const RidgeCrossings& crossings, const PatchContour& contour,
    const RefinedPatch& refined, Id umbilic);

  /// False if the interpolated form does not look like one umbilic with as many ridges.
  bool Find(int ridgeCount, std::vector<PatchCurve>& curves);

private:
  struct Side
  {
    std::array<int, 2> corners{ -1, -1 };
    std::array<int, 2> triangles{ -1, -1 };
  };

  bool March();
  bool LookAtHole(int ridgeCount);
  bool LookAtContour();
  /// A way across a side: out of one of its two triangles.
  struct Step
  {
    int side;
    int triangle; ///< 0 or 1.

    bool operator<(const Step& other) const
    {
      return std::tie(this->side, this->triangle) < std::tie(other.side, other.triangle);
    }
  };
  struct Trail
  {
    PatchCurve curve;
    std::vector<int> sides;
  };

  Trail Follow(int start) const;
  int NextIn(int triangle, int side) const;
  Eigen::Vector3d MiddleOf(int side) const;
  bool Append(const Trail& trail, std::vector<PatchCurve>& curves);

  void UniteNearLoops();
  bool IsNear(const Trail& loop) const;
  void Unite(const Trail& loop, const std::vector<std::uint8_t>& isFromHole);
  std::vector<std::uint8_t> Flood(int corner) const;
  int TriangleAlong(int side, int from) const;
  bool LeadOverBorder(const Trail& loop, std::vector<EdgeCrossing>& path) const;
  std::pair<int, int> RaysOf(const Trail& loop) const;

  const RidgeCrossings& Crossings_;
  const PatchContour& Contour_;
  const RefinedPatch& Refined_;
  Id Umbilic_;
  double Reach_ = 0.0;                      ///< Half the longest side of the umbilic's triangle.
  std::vector<Side> Sides_;                 ///< Those that are crossed.
  std::vector<std::array<int, 3>> SidesOf_; ///< Of each triangle, -1 where not crossed.
  std::unordered_map<std::uint64_t, int> NumberOf_;
  std::vector<int> OnHole_;       ///< Places around the hole, by side, or -1.
  std::vector<int> OnContour_;    ///< Sides of the contour, by side, or -1.
  std::vector<int> TurnsTo_;      ///< By side: another on the same edge, or -1.
  std::vector<int> AroundHole_;   ///< Sides there, in order.
  std::map<Step, Step> Switches_; ///< From a triangle to a side into a triangle beyond another.
  std::vector<std::uint8_t> IsDone_;
};

} // namespace ridges

#endif
