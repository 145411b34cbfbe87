// SPDX-License-Identifier: BSD-3-Clause
#include "Umbilics/PairCancellation.h"

#include "Mesh/PositionOrder.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

namespace ridges
{
namespace
{

constexpr Id None = -1;

/// Where the ways from two umbilics meet: in neighbouring triangles.
struct Meeting
{
  double length; ///< Of the whole way from one umbilic to the other.
  Id charge0;
  Id charge1;
  Id triangle0;
  Id triangle1;
};

/// Shortest ways from all umbilics at once over weak triangles, each triangle for the nearest.
class Ways
{
public:
  Ways(const TriangleMesh& mesh, const std::vector<IndexCharge>& charges,
    const std::vector<std::uint8_t>& isWeak)
    : Mesh_(mesh)
    , Charges_(charges)
    , IsOpen_(isWeak)
    , IsActive_(charges.size(), 0)
    , Nodes_(mesh.NumberOfTriangles())
  {
    for (std::size_t i = 0; i < charges.size(); ++i)
    {
      this->IsActive_[i] = std::abs(charges[i].halfTurns) == 1 ? 1 : 0;
      this->IsOpen_[charges[i].triangle] = this->IsActive_[i];
    }
  }

  bool IsActive(Id charge) const { return this->IsActive_[charge] != 0; }

  /// All meetings of ways from opposite umbilics that are not cancelled yet.
  std::vector<Meeting> Meet();

  /// Cancels the two umbilics. The way along which they meet joins a region with all that it
  /// passes through.
  void Cancel(const Meeting& meeting);

  std::vector<std::vector<Id>> TakeRegions();

private:
  struct Node
  {
    double distance = std::numeric_limits<double>::max();
    Id charge = None;
    Id previous = None;
    Id region = None;
  };
  struct Arrival
  {
    double distance;
    Id charge;
    Id triangle;
    Id previous;
  };

  /// What comes first: by length, and where that is equal, by position.
  bool IsLater(const Arrival& a, const Arrival& b) const;
  bool IsBefore(const Meeting& a, const Meeting& b) const;

  void AddWay(Id from, Id region);

  const TriangleMesh& Mesh_;
  const std::vector<IndexCharge>& Charges_;
  std::vector<std::uint8_t> IsOpen_;
  std::vector<std::uint8_t> IsActive_;
  std::vector<Node> Nodes_;
  std::vector<Id> Reached_;
  std::vector<std::vector<Id>> Regions_;
};

bool Ways::IsLater(const Arrival& a, const Arrival& b) const
{
  const auto x = std::tie(a.distance, a.charge);
  const auto y = std::tie(b.distance, b.charge);
  if (x != y)
  {
    return x > y;
  }
  if (a.triangle != b.triangle)
  {
    return ComesBefore(this->Mesh_, b.triangle, a.triangle);
  }
  return a.previous != b.previous && a.previous != None && b.previous != None &&
    ComesBefore(this->Mesh_, b.previous, a.previous);
}

bool Ways::IsBefore(const Meeting& a, const Meeting& b) const
{
  const auto x = std::tie(a.length, a.charge0, a.charge1);
  const auto y = std::tie(b.length, b.charge0, b.charge1);
  if (x != y)
  {
    return x < y;
  }
  return a.triangle0 != b.triangle0
    ? ComesBefore(this->Mesh_, a.triangle0, b.triangle0)
    : a.triangle1 != b.triangle1 && ComesBefore(this->Mesh_, a.triangle1, b.triangle1);
}

std::vector<Meeting> Ways::Meet()
{
  for (const Id t : this->Reached_)
  {
    this->Nodes_[t].charge = None;
  }
  this->Reached_.clear();

  const auto isLater = [this](const Arrival& a, const Arrival& b) { return this->IsLater(a, b); };
  std::priority_queue<Arrival, std::vector<Arrival>, decltype(isLater)> arrivals(isLater);
  for (Id i = 0; i < static_cast<Id>(this->Charges_.size()); ++i)
  {
    if (this->IsActive(i))
    {
      arrivals.push({ 0.0, i, this->Charges_[i].triangle, None });
    }
  }
  std::vector<Meeting> meetings;
  while (!arrivals.empty())
  {
    const Arrival arrival = arrivals.top();
    arrivals.pop();
    Node& node = this->Nodes_[arrival.triangle];
    if (node.charge != None)
    {
      continue;
    }
    node.distance = arrival.distance;
    node.charge = arrival.charge;
    node.previous = arrival.previous;
    this->Reached_.push_back(arrival.triangle);
    const Eigen::Vector3d center = this->Mesh_.Centroid(arrival.triangle);
    for (int side = 0; side < 3; ++side)
    {
      const Id next = this->Mesh_.Neighbor(arrival.triangle, side);
      if (next < 0 || !this->IsOpen_[next])
      {
        continue;
      }
      const double distance = arrival.distance + (this->Mesh_.Centroid(next) - center).norm();
      const Node& other = this->Nodes_[next];
      if (other.charge == None)
      {
        arrivals.push({ distance, arrival.charge, next, arrival.triangle });
      }
      else if (this->Charges_[other.charge].halfTurns != this->Charges_[arrival.charge].halfTurns)
      {
        meetings.push_back({ distance + other.distance, std::min(arrival.charge, other.charge),
          std::max(arrival.charge, other.charge), arrival.triangle, next });
      }
    }
  }
  std::sort(meetings.begin(), meetings.end(),
    [this](const Meeting& a, const Meeting& b) { return this->IsBefore(a, b); });
  return meetings;
}

void Ways::AddWay(Id from, Id region)
{
  std::vector<Id>& triangles = this->Regions_[region];
  for (Id t = from; t != None; t = this->Nodes_[t].previous)
  {
    const Id old = this->Nodes_[t].region;
    if (old == None)
    {
      this->Nodes_[t].region = region;
      triangles.push_back(t);
    }
    else if (old != region)
    {
      for (const Id s : this->Regions_[old])
      {
        this->Nodes_[s].region = region;
      }
      triangles.insert(triangles.end(), this->Regions_[old].begin(), this->Regions_[old].end());
      this->Regions_[old].clear();
    }
  }
}

void Ways::Cancel(const Meeting& meeting)
{
  const Id region = static_cast<Id>(this->Regions_.size());
  this->Regions_.emplace_back();
  this->AddWay(meeting.triangle0, region);
  this->AddWay(meeting.triangle1, region);
  this->IsActive_[meeting.charge0] = 0;
  this->IsActive_[meeting.charge1] = 0;
}

std::vector<std::vector<Id>> Ways::TakeRegions()
{
  const auto isEmpty = [](const std::vector<Id>& region) { return region.empty(); };
  this->Regions_.erase(
    std::remove_if(this->Regions_.begin(), this->Regions_.end(), isEmpty), this->Regions_.end());
  return std::move(this->Regions_);
}

} // namespace

Cancellation CancelPairs(const TriangleMesh& mesh, std::vector<IndexCharge> charges,
  const std::vector<std::uint8_t>& isWeak)
{
  SortByPosition(mesh, charges);
  Cancellation result;
  const auto isThere = [&charges](int halfTurns)
  {
    return std::any_of(charges.begin(), charges.end(),
      [=](const IndexCharge& charge) { return charge.halfTurns == halfTurns; });
  };
  if (!isThere(1) || !isThere(-1))
  {
    result.kept = std::move(charges);
    return result;
  }
  Ways ways(mesh, charges, isWeak);
  for (bool found = true; found;)
  {
    found = false;
    for (const Meeting& meeting : ways.Meet())
    {
      // Those that meet an umbilic already gone look for another in the next round.
      if (ways.IsActive(meeting.charge0) && ways.IsActive(meeting.charge1))
      {
        ways.Cancel(meeting);
        found = true;
      }
    }
  }
  result.regions = ways.TakeRegions();
  for (Id i = 0; i < static_cast<Id>(charges.size()); ++i)
  {
    if (std::abs(charges[i].halfTurns) != 1 || ways.IsActive(i))
    {
      result.kept.push_back(charges[i]);
    }
  }
  return result;
}

} // namespace ridges
