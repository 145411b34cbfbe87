// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Umbilics/PairCancellation.h"

#include "Mesh/PositionOrder.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>
#include <tuple>
#include <utility>

// All umbilics grow at the same speed, triangle by triangle, over the triangles that paths may pass
// through. Each triangle goes to the umbilic with the shortest path to it. Where two opposite ones
// meet, halfway along the path between them, no shorter path is left, and they cancel each other.
// The triangles of both are free again, and the umbilics around grow into them.
//
// This finds the shortest path between opposite umbilics each time. Paths between those that are
// left are never shorter than the one before. And no point of the shortest path is nearer to a
// third umbilic than to both its ends: otherwise there would be a shorter path.
//
// Umbilics that have grown by the same number of triangles are handled together, in the order of
// the mesh as far as possible. A search in the order of lengths would jump about in memory.

namespace ridges
{
namespace
{

constexpr Id None = -1;

/// What is known of a triangle that paths may pass through.
struct Node
{
  double length = 0.0; ///< Of the path from the umbilic that has the triangle.
  Id steps = 0;        ///< The same in triangles; without an owner, the front it is in, if any.
  Id owner = None;     ///< That umbilic.
  Id previous = None;  ///< The triangle before this one on the path.
  std::array<Id, 3> across = { None, None, None }; ///< Neighbours that paths may pass through.
};

/// Neighbouring triangles of two opposite umbilics, that of the one that comes first at first.
struct Meeting
{
  double length; ///< Of the path from one umbilic to the other.
  Id triangle;
  Id beside;
};

class Growth
{
public:
  Growth(const TriangleMesh& mesh, const std::vector<IndexCharge>& charges,
    const std::vector<std::uint8_t>& isWeak, const RangeLoop& loop);

  /// False if the monitor stopped it.
  bool Run(const Monitor& monitor);

  bool IsActive(Id charge) const { return this->IsActive_[charge] != 0; }

  /// The triangles of all paths that touch each other are a region.
  void CollectRegions(Cancellation& result);

private:
  bool IsPositive(Id charge) const { return this->Charges_[charge].halfTurns > 0; }
  bool AreOpposite(Id a, Id b) const { return this->IsPositive(a) != this->IsPositive(b); }
  Eigen::Map<const Eigen::Vector3d> CentroidOf(Id triangle) const
  {
    return Eigen::Map<const Eigen::Vector3d>(this->Centroids_[triangle].data());
  }
  double Step(Id a, Id b) const { return (this->CentroidOf(a) - this->CentroidOf(b)).norm(); }
  /// Of the path across two neighbouring triangles, that of the umbilic that comes first at first.
  double PathLength(Id triangle, Id beside) const
  {
    return this->Nodes_[triangle].length + this->Step(triangle, beside) +
      this->Nodes_[beside].length;
  }

  void GrowTo(std::size_t steps);
  void AddToFront(Id triangle, std::size_t steps);
  bool Settle(Id triangle, Id steps);
  void LookAround(Id triangle);
  bool CancelMeetings(std::size_t steps);
  bool IsStill(const Meeting& meeting, std::size_t steps) const;
  bool Precedes(const Meeting& a, const Meeting& b) const;
  void Free(Id charge);
  void AddPath(Id from, Id path);
  Id RootOf(Id path);

  const TriangleMesh& Mesh_;
  const std::vector<IndexCharge>& Charges_;
  std::vector<std::uint8_t> IsActive_; ///< Whether an umbilic may be cancelled and is not yet.
  std::array<Id, 2> Left_ = { 0, 0 };  ///< Active ones, negative and positive.
  Buffer<Node> Nodes_;
  Buffer<std::array<double, 3>> Centroids_; ///< Of the triangles that paths may pass through.
  std::vector<Id>
    PathOf_; ///< Of each triangle a path along which umbilics were cancelled, or None.
  std::vector<std::vector<Id>> Front_;         ///< By steps: triangles that may be that far.
  std::vector<std::vector<Meeting>> Meetings_; ///< By steps of the whole path.
  std::size_t FirstFront_ = 1;                 ///< None before this one is left.
  std::vector<Id> Parents_;                    ///< Of paths: those that touch have one root.
  std::vector<Id> OnPaths_;                    ///< All triangles that a path passes through.
  std::vector<Id> Scratch_;
};

Growth::Growth(const TriangleMesh& mesh, const std::vector<IndexCharge>& charges,
  const std::vector<std::uint8_t>& isWeak, const RangeLoop& loop)
  : Mesh_(mesh)
  , Charges_(charges)
  , IsActive_(charges.size())
  , Nodes_(isWeak.size())
  , Centroids_(isWeak.size())
  , PathOf_(isWeak.size(), None)
{
  std::vector<std::uint8_t> isOpen(isWeak);
  for (const IndexCharge& charge : charges)
  {
    isOpen[charge.triangle] = std::abs(charge.halfTurns) == 1 ? 1 : 0;
  }
  loop(mesh.NumberOfTriangles(),
    [this, &isOpen](Id begin, Id end)
    {
      for (Id t = begin; t < end; ++t)
      {
        if (isOpen[t])
        {
          const Eigen::Vector3d center = this->Mesh_.Centroid(t);
          this->Centroids_[t] = { center[0], center[1], center[2] };
        }
        Node node;
        for (int side = 0; isOpen[t] && side < 3; ++side)
        {
          const Id next = this->Mesh_.Neighbor(t, side);
          node.across[side] = next >= 0 && isOpen[next] ? next : None;
        }
        this->Nodes_[t] = node;
      }
    });
  for (Id i = 0; i < static_cast<Id>(charges.size()); ++i)
  {
    const bool active = std::abs(charges[i].halfTurns) == 1;
    this->IsActive_[i] = active ? 1 : 0;
    if (active)
    {
      this->Nodes_[charges[i].triangle].owner = i;
      ++this->Left_[this->IsPositive(i) ? 1 : 0];
    }
  }
}

bool Growth::Run(const Monitor& monitor)
{
  const double all = this->Left_[0] + this->Left_[1];
  this->Front_.resize(2);
  this->Meetings_.resize(2);
  for (Id t = 0; t < this->Mesh_.NumberOfTriangles(); ++t)
  {
    if (this->Nodes_[t].owner != None)
    {
      this->LookAround(t);
    }
  }
  // Paths of so many steps meet in triangles that are half as far at most.
  for (std::size_t steps = 1;
       steps < this->Meetings_.size() || this->FirstFront_ < this->Front_.size(); ++steps)
  {
    this->GrowTo(steps / 2);
    while (steps < this->Meetings_.size() && this->CancelMeetings(steps))
    {
      this->GrowTo(steps / 2);
    }
    if (this->Left_[0] == 0 || this->Left_[1] == 0)
    {
      return true;
    }
    // Nobody knows how many will be left.
    if (!monitor(1.0 - (this->Left_[0] + this->Left_[1]) / all))
    {
      return false;
    }
  }
  return true;
}

void Growth::GrowTo(std::size_t steps)
{
  const std::size_t end = std::min(steps + 1, this->Front_.size());
  for (; this->FirstFront_ < end; ++this->FirstFront_)
  {
    const std::vector<Id> front = std::move(this->Front_[this->FirstFront_]);
    this->Front_[this->FirstFront_].clear();
    for (const Id t : front)
    {
      if (this->Settle(t, static_cast<Id>(this->FirstFront_)))
      {
        this->LookAround(t);
      }
    }
  }
}

void Growth::AddToFront(Id triangle, std::size_t steps)
{
  Node& node = this->Nodes_[triangle];
  if (node.steps == static_cast<Id>(steps))
  {
    return;
  }
  node.steps = static_cast<Id>(steps);
  if (this->Front_.size() <= steps)
  {
    this->Front_.resize(steps + 1);
  }
  this->Front_[steps].push_back(triangle);
  this->FirstFront_ = std::min(this->FirstFront_, steps);
}

/// Gives a triangle to the umbilic with the shortest of all paths that arrive in so many steps.
bool Growth::Settle(Id triangle, Id steps)
{
  Node& node = this->Nodes_[triangle];
  if (node.owner != None)
  {
    return false;
  }
  for (const Id previous : node.across)
  {
    if (previous == None)
    {
      continue;
    }
    const Node& before = this->Nodes_[previous];
    if (before.owner == None || before.steps != steps - 1 || !this->IsActive(before.owner))
    {
      continue;
    }
    const double length = before.length + this->Step(triangle, previous);
    const auto offered = std::tie(length, before.owner);
    const auto taken = std::tie(node.length, node.owner);
    if (node.owner == None || offered < taken ||
      (offered == taken && ComesBefore(this->Mesh_, previous, node.previous)))
    {
      node.length = length;
      node.owner = before.owner;
      node.previous = previous;
    }
  }
  const bool isSettled = node.owner != None;
  if (isSettled || node.steps == steps)
  {
    node.steps = isSettled ? steps : 0;
  }
  return isSettled;
}

/// What is next to a triangle that was settled: more to grow into, and opposite umbilics.
void Growth::LookAround(Id triangle)
{
  const Node& node = this->Nodes_[triangle];
  for (const Id next : node.across)
  {
    if (next == None)
    {
      continue;
    }
    const Node& other = this->Nodes_[next];
    // Neighbours that are umbilics both look at each other: once is enough.
    const bool isKnown = node.steps + other.steps == 0 && node.owner > other.owner;
    if (other.owner == None)
    {
      this->AddToFront(next, node.steps + 1);
    }
    else if (!isKnown && this->AreOpposite(node.owner, other.owner))
    {
      const std::size_t steps = static_cast<std::size_t>(node.steps) + other.steps + 1;
      if (this->Meetings_.size() <= steps)
      {
        this->Meetings_.resize(steps + 1);
      }
      const Id ofFirst = node.owner < other.owner ? triangle : next;
      const Id ofSecond = ofFirst == triangle ? next : triangle;
      this->Meetings_[steps].push_back({ this->PathLength(ofFirst, ofSecond), ofFirst, ofSecond });
    }
  }
}

bool Growth::Precedes(const Meeting& a, const Meeting& b) const
{
  const auto x = std::tie(a.length, this->Nodes_[a.triangle].owner, this->Nodes_[a.beside].owner);
  const auto y = std::tie(b.length, this->Nodes_[b.triangle].owner, this->Nodes_[b.beside].owner);
  if (x != y)
  {
    return x < y;
  }
  return a.triangle != b.triangle
    ? ComesBefore(this->Mesh_, a.triangle, b.triangle)
    : a.beside != b.beside && ComesBefore(this->Mesh_, a.beside, b.beside);
}

/// Whether both triangles belong to umbilics that meet in this path, and not to others by now.
bool Growth::IsStill(const Meeting& meeting, std::size_t steps) const
{
  const Node& a = this->Nodes_[meeting.triangle];
  const Node& b = this->Nodes_[meeting.beside];
  return a.owner != None && b.owner != None && a.owner < b.owner && this->IsActive(a.owner) &&
    this->IsActive(b.owner) && this->AreOpposite(a.owner, b.owner) &&
    static_cast<std::size_t>(a.steps) + b.steps + 1 == steps &&
    this->PathLength(meeting.triangle, meeting.beside) == meeting.length;
}

/// Cancels those that meet after so many steps, the shortest path first. False if there are none.
bool Growth::CancelMeetings(std::size_t steps)
{
  std::vector<Meeting> meetings = std::move(this->Meetings_[steps]);
  this->Meetings_[steps].clear();
  const auto isOver = [this, steps](const Meeting& meeting)
  { return !this->IsStill(meeting, steps); };
  meetings.erase(std::remove_if(meetings.begin(), meetings.end(), isOver), meetings.end());
  std::sort(meetings.begin(), meetings.end(),
    [this](const Meeting& a, const Meeting& b) { return this->Precedes(a, b); });
  std::vector<Id> cancelled;
  for (const Meeting& meeting : meetings)
  {
    const Id first = this->Nodes_[meeting.triangle].owner;
    const Id second = this->Nodes_[meeting.beside].owner;
    if (!this->IsActive(first) || !this->IsActive(second))
    {
      continue;
    }
    this->IsActive_[first] = 0;
    this->IsActive_[second] = 0;
    cancelled.insert(cancelled.end(), { first, second });
    const Id path = static_cast<Id>(this->Parents_.size());
    this->Parents_.push_back(path);
    this->AddPath(meeting.triangle, path);
    this->AddPath(meeting.beside, path);
    --this->Left_[0];
    --this->Left_[1];
  }
  for (const Id charge : cancelled)
  {
    this->Free(charge);
  }
  return !cancelled.empty();
}

/// Takes from an umbilic all its triangles, into which others may grow now.
void Growth::Free(Id charge)
{
  const Id start = this->Charges_[charge].triangle;
  this->Nodes_[start].owner = None;
  this->Nodes_[start].steps = 0;
  this->Scratch_.assign(1, start);
  while (!this->Scratch_.empty())
  {
    const Id t = this->Scratch_.back();
    this->Scratch_.pop_back();
    for (const Id next : this->Nodes_[t].across)
    {
      if (next == None || this->Nodes_[next].owner == None)
      {
        continue;
      }
      Node& other = this->Nodes_[next];
      if (other.owner == charge)
      {
        other.owner = None;
        other.steps = 0;
        this->Scratch_.push_back(next);
      }
      else if (this->IsActive(other.owner))
      {
        this->AddToFront(t, other.steps + 1);
      }
    }
  }
}

void Growth::AddPath(Id from, Id path)
{
  for (Id t = from; t != None; t = this->Nodes_[t].previous)
  {
    Id& pathOf = this->PathOf_[t];
    if (pathOf == None)
    {
      pathOf = path;
      this->OnPaths_.push_back(t);
    }
    else
    {
      this->Parents_[this->RootOf(pathOf)] = this->RootOf(path);
    }
  }
}

Id Growth::RootOf(Id path)
{
  while (this->Parents_[path] != path)
  {
    this->Parents_[path] = this->Parents_[this->Parents_[path]];
    path = this->Parents_[path];
  }
  return path;
}

// By the first umbilic of each.
void Growth::CollectRegions(Cancellation& result)
{
  if (this->OnPaths_.empty())
  {
    return;
  }
  std::vector<Id> regionOfPath(this->Parents_.size(), Cancellation::NoRegion);
  Id count = 0;
  for (const IndexCharge& charge : this->Charges_)
  {
    const Id path = this->PathOf_[charge.triangle];
    if (path != None)
    {
      Id& region = regionOfPath[this->RootOf(path)];
      region = region == Cancellation::NoRegion ? count++ : region;
    }
  }
  // From now on of each triangle its region.
  static_assert(None == Cancellation::NoRegion, "the rest is in no region");
  result.regionOf = std::move(this->PathOf_);
  std::vector<std::size_t> ends(count, 0);
  for (const Id t : this->OnPaths_)
  {
    Id& region = result.regionOf[t];
    region = regionOfPath[this->RootOf(region)];
    ++ends[region];
  }
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<Id> triangles(this->OnPaths_.size());
  std::vector<std::size_t> places(ends);
  for (const Id t : this->OnPaths_)
  {
    triangles[--places[result.regionOf[t]]] = t;
  }
  result.regions = TriangleGroups(std::move(triangles), std::move(ends));
}

} // namespace

Cancellation CancelPairs(const TriangleMesh& mesh, std::vector<IndexCharge> charges,
  const std::vector<std::uint8_t>& isWeak, const RangeLoop& loop, const Monitor& monitor)
{
  SortByPosition(mesh, charges);
  Cancellation result;
  const auto isThere = [&charges](int halfTurns)
  {
    return std::any_of(charges.begin(), charges.end(),
      [halfTurns](const IndexCharge& charge) { return charge.halfTurns == halfTurns; });
  };
  if (!isThere(1) || !isThere(-1))
  {
    result.kept = std::move(charges);
    return result;
  }
  Growth growth(mesh, charges, isWeak, loop);
  if (!growth.Run(monitor))
  {
    return {};
  }
  growth.CollectRegions(result);
  for (Id i = 0; i < static_cast<Id>(charges.size()); ++i)
  {
    if (std::abs(charges[i].halfTurns) != 1 || growth.IsActive(i))
    {
      result.kept.push_back(charges[i]);
    }
  }
  return result;
}

} // namespace ridges
