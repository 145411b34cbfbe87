// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_RidgeZones_h
#define ridges_RidgeZones_h

#include "Base/Monitor.h"
#include "Ridges/ExtremalityErrors.h"
#include "Ridges/RidgeAssembly.h"

#include <functional>
#include <vector>

namespace ridges
{

/**
 * Regions in which every point is a ridge point of a colour, as far as can be known: planes,
 * spheres, cylinders, cones, tori and cyclides (section 7.2). The sign of b0 (b3) is that of its
 * errors there, and so are the ridges.
 *
 * A region is made of points connected by edges, none of them within Margin edges of one where the
 * extremality is significant, or faint and connected to one where it is significant, or of
 * LeastUnresolved connected ones where the surface is not resolved: fewer are flagged by noise.
 * Unless the extremality is round-off wherever it is known, a region needs LeastPoints points at
 * which it is known, and LeastShare of the points of its connected part of the mesh: on noisy
 * surfaces with ridges there are smaller regions by chance. If it is all of that part,
 * LeastPointsOfWhole are enough; or LeastPoints at which it is not known, as where all fits are ill
 * conditioned.
 */
class RidgeZones
{
public:
  static constexpr int Margin = 4;
  static constexpr std::size_t LeastPoints = 200;
  static constexpr std::size_t LeastPointsOfWhole = 20;
  static constexpr double LeastShare = 0.25;
  static constexpr std::size_t LeastUnresolved = 4;

  /// Of points at which the extremality is round-off a few are enough.
  static constexpr std::size_t LeastRoundOff = 8;

  explicit RidgeZones(const TriangleMesh& mesh);

  /// By the verdict on each point. False if the monitor stopped it.
  bool Find(
    const std::vector<ExtremalityErrors::Verdict>& verdicts, const Monitor& monitor = NeverStops);

  /// The points of each region; none of one that was removed.
  const std::vector<std::vector<Id>>& Regions() const { return this->Regions_; }

  /// Whether the extremality is round-off wherever it is known, which is certain on any scale.
  bool IsRoundOff(std::size_t region) const { return this->IsRoundOff_[region] != 0; }

  /// Whether a region is all of its connected part of the mesh; not known where it is round-off.
  bool IsWhole(std::size_t region) const { return this->IsWhole_[region] != 0; }

  /// For a region that is no zone after all.
  void Remove(std::size_t region);

  /// The region of a point, or -1.
  Id RegionOf(Id point) const { return this->RegionOf_[point]; }

  /// The triangles with two corners in a region at least.
  std::vector<Id> TrianglesOf(std::size_t region) const;

private:
  std::vector<Id> Others(const std::vector<ExtremalityErrors::Verdict>& verdicts) const;
  std::vector<std::uint8_t> NearOnes(std::vector<Id> layer) const;
  bool FindRegions(const std::vector<ExtremalityErrors::Verdict>& verdicts,
    std::vector<std::uint8_t>& isTaken, const Monitor& monitor);
  std::vector<Id> SizesOfParts() const;
  std::vector<Id> RegionFrom(Id first, std::vector<std::uint8_t>& isTaken) const;

  const TriangleMesh& Mesh_;
  std::vector<Id> RegionOf_; ///< Per point.
  std::vector<std::vector<Id>> Regions_;
  std::vector<std::uint8_t> IsRoundOff_;
  std::vector<std::uint8_t> IsWhole_;
};

/// Points of a region to look at on larger scales: of those deep enough inside, some that depend on
/// their positions only.
std::vector<Id> SampleOf(
  const TriangleMesh& mesh, const std::vector<Id>& region, const std::function<bool(Id)>& isDeep);

/**
 * Which ridges lie wholly in zones, with both points of each edge they cross, and so do all ridges
 * of their colour that they are connected to through umbilics: 1 for each of these. Thus an umbilic
 * loses all ridges of a colour, or none.
 */
std::vector<std::uint8_t> RidgesInZones(const RidgeZones& zones, const TriangleMesh& mesh,
  const std::vector<Ridge>& ridges, const std::vector<RidgeSegment>& segments,
  const std::vector<RidgePath>& paths);

} // namespace ridges

#endif
