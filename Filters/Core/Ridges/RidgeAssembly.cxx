// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ridges/RidgeAssembly.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace ridges
{
namespace
{

constexpr Id None = -1;

/// Walks from segment to segment across the edges where exactly two meet.
class Walker
{
public:
  Walker(const RidgeCrossings& crossings, const std::vector<RidgeSegment>& segments)
    : Crossings_(crossings)
    , Segments_(segments)
    , At_(crossings.Size(), { None, None })
    , Visited_(segments.size(), 0)
  {
    for (std::size_t s = 0; s < segments.size(); ++s)
    {
      for (const Id edge : { segments[s].edge0, segments[s].edge1 })
      {
        if (edge != RidgeSegment::ToUmbilic && crossings.Mesh().EdgeAt(edge).t1 >= 0)
        {
          auto& pair = this->At_[crossings.NumberOf(edge)];
          pair[pair[0] == None ? 0 : 1] = static_cast<Id>(s);
        }
      }
    }
  }

  bool IsVisited(Id segment) const { return this->Visited_[segment] != 0; }

  /// The segment that continues across the edge, or None.
  Id Across(Id segment, Id edge) const
  {
    if (edge == RidgeSegment::ToUmbilic || this->Crossings_.Mesh().EdgeAt(edge).t1 < 0)
    {
      return None;
    }
    const auto& pair = this->At_[this->Crossings_.NumberOf(edge)];
    return pair[0] == segment ? pair[1] : pair[0];
  }

  /// The ridge that starts in the segment at its end `from`.
  Ridge Walk(Id segment, Id from)
  {
    // Of unknown length, so that they are put together in memory that is there.
    this->Nodes_.assign(1, this->NodeOf(segment, from));
    this->Walked_.clear();
    while (segment != None && !this->Visited_[segment])
    {
      this->Visited_[segment] = 1;
      const RidgeSegment& s = this->Segments_[segment];
      const Id to = s.edge0 == from ? s.edge1 : s.edge0;
      this->Walked_.push_back(segment);
      this->Nodes_.push_back(this->NodeOf(segment, to));
      segment = this->Across(segment, to);
      from = to;
    }
    return { this->Nodes_, this->Walked_, segment != None };
  }

private:
  Id NodeOf(Id segment, Id edge) const
  {
    return edge == RidgeSegment::ToUmbilic ? Ridge::AtUmbilic(this->Segments_[segment].triangle)
                                           : edge;
  }

  const RidgeCrossings& Crossings_;
  const std::vector<RidgeSegment>& Segments_;
  std::vector<std::array<Id, 2>> At_; ///< Segments at each crossing.
  std::vector<std::uint8_t> Visited_;
  std::vector<Id> Nodes_;
  std::vector<Id> Walked_;
};

} // namespace

std::vector<Ridge> AssembleRidges(
  const RidgeCrossings& crossings, const std::vector<RidgeSegment>& segments)
{
  Walker walker(crossings, segments);
  const Id count = static_cast<Id>(segments.size());
  std::vector<Ridge> ridges;
  for (Id s = 0; s < count; ++s)
  {
    for (const Id edge : { segments[s].edge0, segments[s].edge1 })
    {
      if (!walker.IsVisited(s) && walker.Across(s, edge) == None)
      {
        ridges.push_back(walker.Walk(s, edge));
      }
    }
  }
  // What is left has no end.
  for (Id s = 0; s < count; ++s)
  {
    if (!walker.IsVisited(s))
    {
      ridges.push_back(walker.Walk(s, segments[s].edge0));
    }
  }
  return ridges;
}

void LeaveOut(std::vector<Ridge>& ridges, const std::vector<std::uint8_t>& isLeftOut)
{
  std::vector<Ridge> kept;
  for (std::size_t i = 0; i < ridges.size(); ++i)
  {
    if (!isLeftOut[i])
    {
      kept.push_back(std::move(ridges[i]));
    }
  }
  ridges = std::move(kept);
}

} // namespace ridges
