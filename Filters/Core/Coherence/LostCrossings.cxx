// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Coherence/LostCrossings.h"

#include "Monge/AcuteRule.h"
#include "Ridges/SmallLoops.h"

#include <algorithm>
#include <iterator>
#include <unordered_map>
#include <unordered_set>

namespace ridges
{
namespace
{

/// Puts lost crossings together that a ridge would join outside of regions.
class Gathering
{
public:
  Gathering(const RidgePicture& picture, const std::vector<Id>& lost)
    : Picture_(picture)
    , Lost_(lost.begin(), lost.end())
  {
    for (const Id e : lost)
    {
      for (const Id t : TrianglesAt(*picture.mesh, e))
      {
        if (picture.isUsable[t])
        {
          this->Beside_[this->PlaceOf(t)].push_back(e);
        }
      }
    }
  }

  /// The lost crossings of one ridge, from region to region if it passes some.
  std::vector<Id> Take(Id edge)
  {
    std::vector<Id> gathered{ edge };
    this->Lost_.erase(edge);
    for (std::size_t i = 0; i < gathered.size(); ++i)
    {
      for (const Id t : TrianglesAt(*this->Picture_.mesh, gathered[i]))
      {
        const std::int64_t place = this->PlaceOf(t);
        const auto beside = this->Beside_.find(place);
        const bool looks = place >= 0 && beside != this->Beside_.end();
        for (std::size_t j = 0; looks && j < beside->second.size(); ++j)
        {
          if (this->Lost_.erase(beside->second[j]) > 0)
          {
            gathered.push_back(beside->second[j]);
          }
        }
      }
    }
    return gathered;
  }

  bool IsLeft(Id edge) const { return this->Lost_.count(edge) > 0; }

  bool TouchesRegion(const std::vector<Id>& edges) const
  {
    return std::any_of(edges.begin(), edges.end(),
      [this](Id e)
      {
        const std::vector<Id> triangles = TrianglesAt(*this->Picture_.mesh, e);
        return std::any_of(
          triangles.begin(), triangles.end(), [this](Id t) { return this->PlaceOf(t) < 0; });
      });
  }

  /// Whether crossings go on at both sides: as many enter a triangle, or a region, as leave it.
  bool IsClosed(const std::vector<Id>& edges) const
  {
    for (const Id e : edges)
    {
      if (this->Picture_.IsBorder(e))
      {
        return false;
      }
      for (const Id t : TrianglesAt(*this->Picture_.mesh, e))
      {
        if (this->Picture_.isUsable[t] && this->Beside_.at(this->PlaceOf(t)).size() % 2 != 0)
        {
          return false;
        }
      }
    }
    return true;
  }

private:
  /// A triangle, or a whole region by a negative number.
  std::int64_t PlaceOf(Id t) const
  {
    const std::int64_t region = this->Picture_.RegionOf(t);
    return region >= 0 ? -1 - region : t;
  }

  const RidgePicture& Picture_;
  std::unordered_set<Id> Lost_;
  std::unordered_map<std::int64_t, std::vector<Id>> Beside_;
};

// Whether on one side of the crossings of a loop there are few points.
bool EnclosesFew(const RidgePicture& picture, const std::vector<Id>& crossings)
{
  const TriangleMesh& mesh = *picture.mesh;
  const std::unordered_set<Id> fence(crossings.begin(), crossings.end());
  const Edge& edge = mesh.EdgeAt(crossings.front());
  for (const Id start : { edge.v0, edge.v1 })
  {
    std::vector<Id> points{ start };
    std::unordered_set<Id> reached{ start };
    for (std::size_t i = 0; i < points.size() && points.size() <= SmallLoops::MostPoints; ++i)
    {
      for (const Id t : mesh.TrianglesAround(points[i]))
      {
        for (int side = 0; side < 3; ++side)
        {
          const Id e = mesh.EdgeOf(t, side);
          const Edge& ends = mesh.EdgeAt(e);
          const bool isSpoke = ends.v0 == points[i] || ends.v1 == points[i];
          const Id other = ends.v0 + ends.v1 - points[i];
          if (isSpoke && fence.count(e) == 0 && reached.insert(other).second)
          {
            points.push_back(other);
          }
        }
      }
    }
    if (points.size() <= SmallLoops::MostPoints && reached.count(edge.v0 + edge.v1 - start) == 0)
    {
      return true;
    }
  }
  return false;
}

/// Whether ridges that cross an edge were left out because it is in a zone.
bool IsLeftOutAt(const RidgePicture& picture, Color color, Id edge)
{
  const std::vector<Id> triangles = TrianglesAt(*picture.mesh, edge);
  return std::all_of(triangles.begin(), triangles.end(),
    [&picture, color](Id t) { return picture.IsInZone(color, t); });
}

} // namespace

std::vector<int> CountPassages(
  const RidgePicture& picture, const std::vector<WholeRidge>& ridges, Color color)
{
  std::vector<int> passages(picture.mesh->NumberOfEdges(), 0);
  for (const WholeRidge& ridge : ridges)
  {
    for (const RidgeChain& chain : ridge.chains)
    {
      for (std::size_t i = chain.closed ? 1 : 0; i < chain.points.size(); ++i)
      {
        const Id edge = picture.points[chain.points[i]].edge;
        if (edge >= 0 && ridge.color == color)
        {
          ++passages[edge];
        }
      }
    }
  }
  return passages;
}

LostCrossings FindLostCrossings(
  const RidgePicture& picture, const std::vector<WholeRidge>& ridges, Color color)
{
  const TriangleMesh& mesh = *picture.mesh;
  const std::vector<int> passages = CountPassages(picture, ridges, color);
  LostCrossings result;
  std::vector<Id> notPassed;
  for (Id e = 0; e < mesh.NumberOfEdges(); ++e)
  {
    const Edge& edge = mesh.EdgeAt(e);
    if (IsCrossed(picture.field, color, edge.v0, edge.v1) && picture.IsOutside(e))
    {
      ++result.crossed;
      if (passages[e] == 0)
      {
        notPassed.push_back(e);
      }
    }
  }
  // With those in zones: a loop may be partly in one, and is small as a whole.
  Gathering gathering(picture, notPassed);
  for (const Id e : notPassed)
  {
    if (!gathering.IsLeft(e))
    {
      continue;
    }
    const std::vector<Id> together = gathering.Take(e);
    std::vector<Id> lost;
    std::copy_if(together.begin(), together.end(), std::back_inserter(lost),
      [&picture, color](Id edge) { return !IsLeftOutAt(picture, color, edge); });
    // What a loop encloses that passes a region cannot be told.
    const bool isSmallLoop = !lost.empty() && together.size() <= SmallLoops::MostCrossings &&
      gathering.IsClosed(together) &&
      (gathering.TouchesRegion(together) || EnclosesFew(picture, together));
    result.smallLoops += isSmallLoop ? 1 : 0;
    if (!isSmallLoop)
    {
      result.edges.insert(result.edges.end(), lost.begin(), lost.end());
    }
  }
  std::sort(result.edges.begin(), result.edges.end());
  return result;
}

} // namespace ridges
