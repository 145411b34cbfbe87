// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Umbilics/UmbilicGathering.h"

#include "Mesh/PointTree.h"
#include "Umbilics/PatchChoice.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace ridges
{

UmbilicGathering::UmbilicGathering(const TriangleMesh& mesh, const MongeField& field,
  const std::vector<IndexCharge>& charges, const std::vector<std::uint8_t>& isWeak,
  const std::uint8_t* usable, const RangeLoop& loop, const Monitor& monitor)
  : Mesh_(mesh)
  , Field_(field)
  , Usable_(usable)
  , HalfTurns_(mesh.NumberOfTriangles(), 0)
{
  std::vector<IndexCharge> unusable;
  std::vector<IndexCharge> measured;
  for (const IndexCharge& charge : charges)
  {
    this->HalfTurns_[charge.triangle] = charge.halfTurns;
    (AreUsable(mesh.Corners(charge.triangle), usable) ? measured : unusable).push_back(charge);
  }
  this->Cancellation_ = CancelPairs(mesh, std::move(measured), isWeak, loop, monitor);
  std::vector<IndexCharge>& kept = this->Cancellation_.kept;
  kept.insert(kept.end(), unusable.begin(), unusable.end());
}

// Patches within half the distance between their first centroids cannot share a triangle.
std::vector<double> UmbilicGathering::HalfWaysToNext(const RangeLoop& loop) const
{
  const std::vector<IndexCharge>& kept = this->Cancellation_.kept;
  std::vector<Eigen::Vector3d> centers;
  centers.reserve(kept.size());
  for (const IndexCharge& charge : kept)
  {
    centers.push_back(this->Mesh_.Centroid(charge.triangle));
  }
  const PointTree tree(centers);
  std::vector<double> halfWays(kept.size(), 0.0);
  loop(static_cast<Id>(kept.size()),
    [&tree, &halfWays](Id begin, Id end)
    {
      for (Id i = begin; i < end; ++i)
      {
        halfWays[i] = 0.5 * tree.DistanceToNearestOther(i);
      }
    });
  return halfWays;
}

std::vector<Umbilic> UmbilicGathering::Umbilics(double patchSize, const RangeLoop& loop)
{
  const std::vector<IndexCharge>& kept = this->Cancellation_.kept;
  const std::vector<double> halfWays = this->HalfWaysToNext(loop);
  const PatchSurroundings surroundings{ this->Mesh_, this->Field_, this->Usable_,
    this->Cancellation_, this->HalfTurns_ };
  std::vector<Umbilic> found(kept.size());
  // Some at a time with the same scratch memory.
  constexpr Id share = 64;
  const Id count = static_cast<Id>(kept.size());
  loop((count + share - 1) / share,
    [&surroundings, &halfWays, &found, patchSize, count, this](Id begin, Id end)
    {
      PatchChoice choice(surroundings);
      for (Id i = share * begin; i < std::min(share * end, count); ++i)
      {
        found[i] = this->MakeUmbilicWithPatch(
          this->Cancellation_.kept[i], choice, patchSize, halfWays[i] * (1.0 - 1e-12));
      }
    });

  std::vector<Umbilic> umbilics;
  umbilics.reserve(found.size());
  this->IsSwallowed_.assign(this->Cancellation_.regions.size(), 0);
  for (std::size_t i = 0; i < kept.size(); ++i)
  {
    this->MarkSwallowed(found[i].patch);
    umbilics.push_back(std::move(found[i]));
    if (std::abs(kept[i].halfTurns) > 1)
    {
      // Several that cannot be told apart: the first has the patch.
      Umbilic alike = umbilics.back();
      alike.patch.clear();
      alike.touchesBorder = false;
      umbilics.insert(umbilics.end(), std::abs(kept[i].halfTurns) - 1, alike);
    }
  }
  return umbilics;
}

Umbilic UmbilicGathering::MakeUmbilicWithPatch(
  const IndexCharge& charge, PatchChoice& choice, double patchSize, double limit) const
{
  const double index = charge.halfTurns > 0 ? 0.5 : -0.5;
  Umbilic umbilic = MakeUmbilic(this->Mesh_, this->Field_, charge.triangle, index, {});
  umbilic.patch = choice.Choose(charge, umbilic.ridgeCount, patchSize, limit);
  umbilic.touchesBorder = TouchesBorder(this->Mesh_, umbilic.patch);
  return umbilic;
}

void UmbilicGathering::MarkSwallowed(const std::vector<Id>& patch)
{
  for (const Id t : patch)
  {
    const Id region = this->Cancellation_.RegionOf(t);
    if (region != Cancellation::NoRegion)
    {
      this->IsSwallowed_[region] = 1;
    }
  }
}

TriangleGroups UmbilicGathering::CancelledRegions() const
{
  TriangleGroups outside;
  for (std::size_t i = 0; i < this->Cancellation_.regions.size(); ++i)
  {
    if (this->IsSwallowed_.empty() || !this->IsSwallowed_[i])
    {
      outside.Add(this->Cancellation_.regions[i]);
    }
  }
  return outside;
}

} // namespace ridges
