// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Umbilics/UmbilicGathering.h"

#include "Monge/AcuteRule.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <utility>

namespace ridges
{

UmbilicGathering::UmbilicGathering(const TriangleMesh& mesh, const MongeField& field,
  const std::vector<IndexCharge>& charges, const std::vector<std::uint8_t>& isWeak,
  const std::uint8_t* usable, const RangeLoop& loop)
  : Mesh_(mesh)
  , Field_(field)
  , Usable_(usable)
  , Patch_(mesh)
{
  std::vector<IndexCharge> unusable;
  std::vector<IndexCharge> measured;
  for (const IndexCharge& charge : charges)
  {
    this->HalfTurns_[charge.triangle] = charge.halfTurns;
    (AreUsable(mesh.Corners(charge.triangle), usable) ? measured : unusable).push_back(charge);
  }
  this->Cancellation_ = CancelPairs(mesh, std::move(measured), isWeak, loop);
  std::vector<IndexCharge>& kept = this->Cancellation_.kept;
  kept.insert(kept.end(), unusable.begin(), unusable.end());
  this->IsSwallowed_.assign(this->Cancellation_.regions.size(), false);
}

// Patches within half the distance between their first centroids cannot share a triangle.
std::vector<double> UmbilicGathering::HalfWaysToNext() const
{
  const std::vector<IndexCharge>& kept = this->Cancellation_.kept;
  std::vector<Eigen::Vector3d> centers;
  centers.reserve(kept.size());
  for (const IndexCharge& charge : kept)
  {
    centers.push_back(this->Mesh_.Centroid(charge.triangle));
  }
  std::vector<std::size_t> order(kept.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&centers](std::size_t i, std::size_t j) { return centers[i][0] < centers[j][0]; });
  std::vector<double> nearest(kept.size(), std::numeric_limits<double>::max());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const Eigen::Vector3d& center = centers[order[i]];
    double& least = nearest[order[i]];
    const auto look = [&](std::size_t j)
    {
      least = std::min(least, (centers[order[j]] - center).norm());
      return std::abs(centers[order[j]][0] - center[0]) < least;
    };
    for (std::size_t j = i; j-- > 0 && look(j);)
    {
    }
    for (std::size_t j = i + 1; j < order.size() && look(j); ++j)
    {
    }
  }
  for (double& distance : nearest)
  {
    distance *= 0.5;
  }
  return nearest;
}

std::vector<Id> UmbilicGathering::ChoosePatch(
  const IndexCharge& charge, int ridgeCount, double radius, double halfWay)
{
  const Span<Id> patch =
    this->Patch_.GrowTo(charge.triangle, std::min(2.0 * radius, halfWay * (1.0 - 1e-12)));
  const std::vector<double>& thresholds = this->Patch_.Thresholds();
  std::unordered_map<Id, Id> orderOf;
  std::unordered_map<Id, Id> insideOfRegion;
  int halfTurns = 0;
  int partialRegions = 0;
  int crossings[2] = { 0, 0 };
  Id matching = 0;
  Id valid = 1;
  for (Id i = 0; i < patch.size(); ++i)
  {
    if (thresholds[i] > radius && matching > 0)
    {
      break;
    }
    const Id t = patch[i];
    if (i > 0 && !AreUsable(this->Mesh_.Corners(t), this->Usable_))
    {
      break;
    }
    orderOf[t] = i;
    const auto turns = this->HalfTurns_.find(t);
    halfTurns += turns != this->HalfTurns_.end() ? turns->second : 0;
    const Id region = this->RegionOf(t);
    if (region != Cancellation::NoRegion)
    {
      const Id inside = ++insideOfRegion[region];
      partialRegions += inside == 1 ? 1 : 0;
      partialRegions -= inside == this->Cancellation_.regions[region].size() ? 1 : 0;
    }
    const Triangle& corners = this->Mesh_.Corners(t);
    for (int side = 0; side < 3; ++side)
    {
      const auto neighbor = orderOf.find(this->Mesh_.Neighbor(t, side));
      const int change = neighbor != orderOf.end() ? -1 : 1;
      const Id p = corners[side];
      const Id q = corners[(side + 1) % 3];
      crossings[0] += IsCrossed(this->Field_, Color::Blue, p, q) ? change : 0;
      crossings[1] += IsCrossed(this->Field_, Color::Red, p, q) ? change : 0;
    }

    const bool isValid = halfTurns == charge.halfTurns && partialRegions == 0;
    if (isValid && crossings[0] == ridgeCount && crossings[1] == ridgeCount)
    {
      matching = i + 1;
    }
    if (isValid && thresholds[i] <= radius)
    {
      valid = i + 1;
    }
  }
  const Id size = matching > 0 ? matching : valid;
  return std::vector<Id>(patch.begin(), patch.begin() + size);
}

std::vector<Umbilic> UmbilicGathering::Umbilics(double patchSize)
{
  const std::vector<double> halfWays = this->HalfWaysToNext();
  std::vector<Umbilic> umbilics;
  this->IsSwallowed_.assign(this->Cancellation_.regions.size(), false);
  for (std::size_t i = 0; i < this->Cancellation_.kept.size(); ++i)
  {
    const IndexCharge& charge = this->Cancellation_.kept[i];
    const double index = charge.halfTurns > 0 ? 0.5 : -0.5;
    Umbilic umbilic = MakeUmbilic(this->Mesh_, this->Field_, charge.triangle, index, {});
    // Where several cannot be told apart the first has the patch.
    const Umbilic alike = umbilic;
    const double radius = patchSize * this->Patch_.OneRingGrade(charge.triangle);
    umbilic.patch = this->ChoosePatch(charge, umbilic.ridgeCount, radius, halfWays[i]);
    umbilic.touchesBorder = TouchesBorder(this->Mesh_, umbilic.patch);
    for (const Id t : umbilic.patch)
    {
      const Id region = this->RegionOf(t);
      if (region != Cancellation::NoRegion)
      {
        this->IsSwallowed_[region] = true;
      }
    }
    umbilics.push_back(std::move(umbilic));
    umbilics.insert(umbilics.end(), std::abs(charge.halfTurns) - 1, alike);
  }
  return umbilics;
}

TriangleGroups UmbilicGathering::CancelledRegions() const
{
  TriangleGroups outside;
  for (std::size_t i = 0; i < this->Cancellation_.regions.size(); ++i)
  {
    if (!this->IsSwallowed_[i])
    {
      outside.Add(this->Cancellation_.regions[i]);
    }
  }
  return outside;
}

} // namespace ridges
