// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ridges/RidgeZones.h"

#include "Mesh/PositionHash.h"

#include <algorithm>
#include <map>
#include <utility>

namespace ridges
{
namespace
{

using Verdict = ExtremalityErrors::Verdict;

constexpr Id NoRegion = -1;

template <typename Visit>
void ForNeighbors(const TriangleMesh& mesh, Id p, const Visit& visit)
{
  for (const Id t : mesh.TrianglesAround(p))
  {
    for (const Id q : mesh.Corners(t))
    {
      visit(q);
    }
  }
}

} // namespace

RidgeZones::RidgeZones(const TriangleMesh& mesh)
  : Mesh_(mesh)
  , RegionOf_(mesh.NumberOfPoints(), NoRegion)
{
}

bool RidgeZones::Find(const std::vector<Verdict>& verdicts, const Monitor& monitor)
{
  const std::vector<Id> others = this->Others(verdicts);
  if (!monitor(0.3))
  {
    return false;
  }
  std::vector<std::uint8_t> isNear = this->NearOnes(others);
  return monitor(0.6) && this->FindRegions(verdicts, isNear, monitor);
}

/// Outside of what is taken, which afterwards is everything.
bool RidgeZones::FindRegions(
  const std::vector<Verdict>& verdicts, std::vector<std::uint8_t>& isTaken, const Monitor& monitor)
{
  std::vector<Id> sizes; // of the part of the mesh that each point is in
  constexpr std::size_t atATime = 1 << 18;
  std::size_t seen = 0; // points in regions, since the monitor was told
  for (Id first = 0; first < this->Mesh_.NumberOfPoints(); ++first)
  {
    if (seen > atATime)
    {
      seen = 0;
      if (!monitor(0.6 + 0.4 * first / this->Mesh_.NumberOfPoints()))
      {
        return false;
      }
    }
    if (isTaken[first] || this->Mesh_.TrianglesAround(first).size() == 0)
    {
      continue;
    }
    std::vector<Id> region = this->RegionFrom(first, isTaken);
    seen += region.size();
    const auto count = [&region, &verdicts](Verdict verdict)
    {
      return static_cast<std::size_t>(std::count_if(region.begin(), region.end(),
        [&verdicts, verdict](Id p) { return verdicts[p] == verdict; }));
    };
    const std::size_t roundOff = count(Verdict::RoundOff);
    const std::size_t insignificant = count(Verdict::Insignificant) + count(Verdict::Faint);
    const bool isRoundOff = insignificant == 0 && roundOff >= LeastRoundOff;
    bool isZone = isRoundOff;
    bool isWhole = false;
    const bool isLarge = region.size() >= LeastPoints;
    if (!isRoundOff && (isLarge || roundOff + insignificant >= LeastPointsOfWhole))
    {
      if (sizes.empty())
      {
        sizes = this->SizesOfParts();
      }
      const auto size = static_cast<double>(region.size());
      isWhole = size == sizes[first];
      isZone =
        isWhole || (roundOff + insignificant >= LeastPoints && size >= LeastShare * sizes[first]);
    }
    if (isZone)
    {
      for (const Id p : region)
      {
        this->RegionOf_[p] = static_cast<Id>(this->Regions_.size());
      }
      this->Regions_.push_back(std::move(region));
      this->IsRoundOff_.push_back(isRoundOff ? 1 : 0);
      this->IsWhole_.push_back(isWhole ? 1 : 0);
    }
  }
  return monitor(1.0);
}

std::vector<Id> RidgeZones::SizesOfParts() const
{
  std::vector<Id> sizes(this->Mesh_.NumberOfPoints(), 0);
  std::vector<std::uint8_t> isTaken(sizes.size(), 0);
  for (Id first = 0; first < this->Mesh_.NumberOfPoints(); ++first)
  {
    if (!isTaken[first])
    {
      const std::vector<Id> part = this->RegionFrom(first, isTaken);
      for (const Id p : part)
      {
        sizes[p] = static_cast<Id>(part.size());
      }
    }
  }
  return sizes;
}

/// Points that by themselves are no part of a zone.
std::vector<Id> RidgeZones::Others(const std::vector<Verdict>& verdicts) const
{
  std::vector<Id> others;
  std::vector<std::uint8_t> isFound(verdicts.size(), 0);
  const auto take = [&others, &isFound, &verdicts](Verdict wanted, Id p)
  {
    if (!isFound[p] && verdicts[p] == wanted)
    {
      isFound[p] = 1;
      others.push_back(p);
    }
  };
  // From `begin` on, and what is connected to these.
  const auto spread = [this, &others, &take](std::size_t begin, Verdict to)
  {
    for (std::size_t i = begin; i < others.size(); ++i)
    {
      ForNeighbors(this->Mesh_, others[i], [&take, to](Id q) { take(to, q); });
    }
  };
  for (Id p = 0; p < this->Mesh_.NumberOfPoints(); ++p)
  {
    take(Verdict::Significant, p);
  }
  spread(0, Verdict::Faint);
  for (Id p = 0; p < this->Mesh_.NumberOfPoints(); ++p)
  {
    const std::size_t before = others.size();
    take(Verdict::Unresolved, p);
    spread(before, Verdict::Unresolved);
    if (others.size() - before < LeastUnresolved)
    {
      others.resize(before);
    }
  }
  return others;
}

/// Points within the margin of these, by layers of neighbours.
std::vector<std::uint8_t> RidgeZones::NearOnes(std::vector<Id> layer) const
{
  std::vector<std::uint8_t> isNear(this->Mesh_.NumberOfPoints(), 0);
  for (const Id p : layer)
  {
    isNear[p] = 1;
  }
  for (int i = 0; i < Margin; ++i)
  {
    std::vector<Id> next;
    for (const Id p : layer)
    {
      ForNeighbors(this->Mesh_, p,
        [&isNear, &next](Id q)
        {
          if (!isNear[q])
          {
            isNear[q] = 1;
            next.push_back(q);
          }
        });
    }
    layer = std::move(next);
  }
  return isNear;
}

std::vector<Id> RidgeZones::RegionFrom(Id first, std::vector<std::uint8_t>& isTaken) const
{
  std::vector<Id> region{ first };
  isTaken[first] = 1;
  for (std::size_t i = 0; i < region.size(); ++i)
  {
    ForNeighbors(this->Mesh_, region[i],
      [&isTaken, &region](Id q)
      {
        if (!isTaken[q])
        {
          isTaken[q] = 1;
          region.push_back(q);
        }
      });
  }
  return region;
}

void RidgeZones::Remove(std::size_t region)
{
  for (const Id p : this->Regions_[region])
  {
    this->RegionOf_[p] = NoRegion;
  }
  this->Regions_[region].clear();
}

std::vector<Id> RidgeZones::TrianglesOf(std::size_t region) const
{
  const auto isIn = [this, region](Id q) { return this->RegionOf_[q] == static_cast<Id>(region); };
  std::vector<Id> triangles;
  for (const Id p : this->Regions_[region])
  {
    for (const Id t : this->Mesh_.TrianglesAround(p))
    {
      const Triangle& c = this->Mesh_.Corners(t);
      // Once, from the first corner inside.
      if (*std::find_if(c.begin(), c.end(), isIn) == p &&
        std::count_if(c.begin(), c.end(), isIn) > 1)
      {
        triangles.push_back(t);
      }
    }
  }
  return triangles;
}

std::vector<Id> SampleOf(
  const TriangleMesh& mesh, const std::vector<Id>& region, const std::function<bool(Id)>& isDeep)
{
  constexpr std::size_t most = 32;
  constexpr std::size_t least = 24;
  constexpr std::size_t pointsPerSample = 150;
  constexpr std::size_t triesPerSample = 8;
  const std::size_t wanted = std::clamp(region.size() / pointsPerSample, least, most);
  std::vector<std::pair<std::uint64_t, Id>> order;
  order.reserve(region.size());
  for (const Id p : region)
  {
    order.emplace_back(PositionHash(mesh.Point(p)), p);
  }
  const std::size_t tries = std::min(order.size(), triesPerSample * wanted);
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(tries), order.end());
  std::vector<Id> sample;
  for (std::size_t i = 0; i < tries && sample.size() < wanted; ++i)
  {
    if (isDeep(order[i].second))
    {
      sample.push_back(order[i].second);
    }
  }
  return sample;
}

std::vector<std::uint8_t> RidgesInZones(const RidgeZones& zones, const TriangleMesh& mesh,
  const std::vector<Ridge>& ridges, const std::vector<RidgeSegment>& segments,
  const std::vector<RidgePath>& paths)
{
  const auto isInside = [&zones, &mesh](Id e)
  {
    const Edge& edge = mesh.EdgeAt(e);
    return zones.RegionOf(edge.v0) >= 0 && zones.RegionOf(edge.v1) >= 0;
  };
  const auto isWhollyInside = [&isInside, &zones, &mesh, &segments, &paths](const Ridge& ridge)
  {
    const auto isNodeInside = [&isInside, &zones, &mesh](Id node)
    {
      if (!Ridge::IsUmbilic(node))
      {
        return isInside(node);
      }
      const Triangle& c = mesh.Corners(Ridge::TriangleOfUmbilic(node));
      return std::all_of(c.begin(), c.end(), [&zones](Id p) { return zones.RegionOf(p) >= 0; });
    };
    const auto isSegmentInside = [&isInside, &segments, &paths](Id s)
    {
      if (segments[s].path == RidgeSegment::NoPath)
      {
        return true;
      }
      const std::vector<Id>& edges = paths[segments[s].path].edges;
      return std::all_of(edges.begin(), edges.end(), isInside);
    };
    return std::all_of(ridge.nodes.begin(), ridge.nodes.end(), isNodeInside) &&
      std::all_of(ridge.segments.begin(), ridge.segments.end(), isSegmentInside);
  };
  std::vector<std::uint8_t> isLeftOut(ridges.size(), 0);
  std::map<Id, std::vector<std::size_t>> leftOutAt; // by umbilic
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < ridges.size(); ++i)
  {
    isLeftOut[i] = isWhollyInside(ridges[i]) ? 1 : 0;
    if (!isLeftOut[i])
    {
      kept.push_back(i);
      continue;
    }
    for (const Id node : { ridges[i].nodes.front(), ridges[i].nodes.back() })
    {
      if (Ridge::IsUmbilic(node))
      {
        leftOutAt[node].push_back(i);
      }
    }
  }
  // What is kept keeps what it is connected to.
  for (std::size_t i = 0; i < kept.size() && !leftOutAt.empty(); ++i)
  {
    for (const Id node : { ridges[kept[i]].nodes.front(), ridges[kept[i]].nodes.back() })
    {
      const auto at = leftOutAt.find(node);
      for (std::size_t j = 0; at != leftOutAt.end() && j < at->second.size(); ++j)
      {
        const std::size_t other = at->second[j];
        if (isLeftOut[other])
        {
          isLeftOut[other] = 0;
          kept.push_back(other);
        }
      }
    }
  }
  return isLeftOut;
}

} // namespace ridges
