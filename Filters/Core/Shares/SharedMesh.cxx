// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shares/SharedMesh.h"

#include <algorithm>
#include <array>

namespace ridges
{
namespace
{

void Pack(Bytes& bytes, const MeshPatch& patch)
{
  ridges::Pack(bytes, patch.points);
  ridges::Pack(bytes, patch.triangles);
  ridges::Pack(bytes, patch.counts);
  ridges::Pack(bytes, patch.around);
}

MeshPatch TakePatch(const Bytes& bytes)
{
  Unpacker unpacker(bytes);
  MeshPatch patch;
  patch.points = unpacker.Take<MeshPatch::Corner>();
  patch.triangles = unpacker.Take<MeshPatch::Cell>();
  patch.counts = unpacker.Take<Id>();
  patch.around = unpacker.Take<Id>();
  return patch;
}

/// Collects triangles of some points, each point once.
class PatchBuilder
{
public:
  template <typename Corner>
  Id Add(std::int64_t number, const Triangle& corners, const Corner& cornerOf)
  {
    MeshPatch::Cell cell{ number, {} };
    for (int i = 0; i < 3; ++i)
    {
      const auto next = static_cast<Id>(this->patch.points.size());
      const auto [entry, isNew] = this->Points_.try_emplace(corners[i], next);
      if (isNew)
      {
        this->patch.points.push_back(cornerOf(corners[i]));
      }
      cell.corners[i] = entry->second;
    }
    this->patch.triangles.push_back(cell);
    return static_cast<Id>(this->patch.triangles.size()) - 1;
  }

  MeshPatch patch;

private:
  std::unordered_map<Id, Id> Points_;
};

} // namespace

std::string SharedMesh::Share(Ranks& ranks, const MeshPiece& piece)
{
  this->Rank_ = ranks.Rank();
  const std::string faults = this->Points_.Share(ranks, piece);
  if (!faults.empty())
  {
    return faults;
  }
  this->Positions_ = this->Points_.Owned();
  this->SendTriangles(ranks, piece);
  this->RankCoincident(ranks);
  return {};
}

/// Each triangle of the piece goes to the owners of its corners.
void SharedMesh::SendTriangles(Ranks& ranks, const MeshPiece& piece)
{
  std::int64_t first = 0;
  this->NumberOfTriangles_ = 0;
  const auto counts = GatherAllOne<std::int64_t>(ranks, piece.triangles.size());
  for (int rank = 0; rank < ranks.Size(); ++rank)
  {
    first += rank < ranks.Rank() ? counts[rank] : 0;
    this->NumberOfTriangles_ += counts[rank];
  }
  const std::vector<std::int64_t>& numbers = this->Points_.NumbersOfPiece();
  const auto cornerOf = [&piece, &numbers](Id p)
  {
    const double* x = piece.points + 3 * static_cast<std::size_t>(p);
    return MeshPatch::Corner{ numbers[p], { x[0], x[1], x[2] } };
  };
  std::vector<PatchBuilder> builders(ranks.Size());
  for (Id t = 0; t < piece.triangles.size(); ++t)
  {
    std::array<int, 3> owners;
    std::transform(piece.triangles[t].begin(), piece.triangles[t].end(), owners.begin(),
      [this, &numbers](Id p) { return this->Points_.OwnerOf(numbers[p]); });
    std::sort(owners.begin(), owners.end());
    const auto last = std::unique(owners.begin(), owners.end());
    std::for_each(owners.begin(), last,
      [&](int owner) { builders[owner].Add(first + t, piece.triangles[t], cornerOf); });
  }
  std::vector<Bytes> messages(ranks.Size());
  for (int rank = 0; rank < ranks.Size(); ++rank)
  {
    Pack(messages[rank], builders[rank].patch);
    builders[rank] = {};
  }
  for (const Bytes& message : ranks.Exchange(std::move(messages)))
  {
    this->Take(TakePatch(message));
  }
  this->Around_ = TriangleMesh(this->Points_.Owned().data(),
    static_cast<Id>(this->Positions_.size() / 3), this->Triangles_, TriangleMesh::Edges::NotBuilt);
}

/// Who lies at one place is ordered by what lies around: that takes the coincident points of all
/// ranks, but nothing else of the mesh.
void SharedMesh::RankCoincident(Ranks& ranks)
{
  this->RanksAtPlace_.clear();
  const std::vector<Id>& coincident = this->Points_.Coincident();
  if (!IsAnywhere(ranks, !coincident.empty()))
  {
    return;
  }
  MeshPatch own = this->PatchAround(coincident);
  // Isolated ones are in no triangle.
  for (const Id p : coincident)
  {
    const double* x = this->Positions_.data() + 3 * static_cast<std::size_t>(p);
    own.points.push_back({ this->NumberOf(p), { x[0], x[1], x[2] } });
  }
  Bytes message;
  Pack(message, own);
  std::unordered_map<std::int64_t, Id> pointOf;
  std::unordered_map<std::int64_t, Id> triangleOf;
  std::vector<double> positions;
  std::vector<Triangle> triangles;
  for (const Bytes& bytes : ranks.GatherAll(std::move(message)))
  {
    const MeshPatch patch = TakePatch(bytes);
    for (const MeshPatch::Corner& corner : patch.points)
    {
      if (pointOf.try_emplace(corner.number, static_cast<Id>(positions.size() / 3)).second)
      {
        positions.insert(positions.end(), corner.x.begin(), corner.x.end());
      }
    }
    for (const MeshPatch::Cell& cell : patch.triangles)
    {
      if (triangleOf.try_emplace(cell.number, static_cast<Id>(triangles.size())).second)
      {
        Triangle corners;
        std::transform(cell.corners.begin(), cell.corners.end(), corners.begin(),
          [&pointOf, &patch](Id p) { return pointOf.at(patch.points[p].number); });
        triangles.push_back(corners);
      }
    }
  }
  const TriangleMesh mesh(positions.data(), static_cast<Id>(positions.size() / 3), triangles,
    TriangleMesh::Edges::NotBuilt);
  for (const auto& [number, p] : pointOf)
  {
    const std::uint64_t rank = mesh.RankAtPlace(p);
    if (rank != 0)
    {
      this->RanksAtPlace_.emplace_back(number, rank);
    }
  }
  std::sort(this->RanksAtPlace_.begin(), this->RanksAtPlace_.end());
}

MeshPatch SharedMesh::PatchAround(const std::vector<Id>& owned) const
{
  PatchBuilder builder;
  std::unordered_map<Id, Id> added;
  const auto cornerOf = [this](Id p)
  {
    const double* x = this->Positions_.data() + 3 * static_cast<std::size_t>(p);
    return MeshPatch::Corner{ this->NumberOf(p), { x[0], x[1], x[2] } };
  };
  for (const Id p : owned)
  {
    const Span<Id> around = this->Around_.TrianglesAround(p);
    builder.patch.counts.push_back(around.size());
    for (const Id t : around)
    {
      const auto [entry, isNew] = added.try_emplace(t, 0);
      if (isNew)
      {
        entry->second = builder.Add(this->TriangleNumbers_[t], this->Triangles_[t], cornerOf);
      }
      builder.patch.around.push_back(entry->second);
    }
  }
  return std::move(builder.patch);
}

Id SharedMesh::LocalOf(std::int64_t number) const
{
  const std::int64_t first = this->Points_.First(this->Rank_);
  if (number >= first && number < first + this->NumberOfOwned())
  {
    return static_cast<Id>(number - first);
  }
  const auto found = this->Others_.find(number);
  return found == this->Others_.end() ? -1 : found->second;
}

std::int64_t SharedMesh::NumberOf(Id local) const
{
  return local < this->NumberOfOwned() ? this->Points_.First(this->Rank_) + local
                                       : this->NumbersOfOthers_[local - this->NumberOfOwned()];
}

Id SharedMesh::AddPoint(const MeshPatch::Corner& corner)
{
  const Id known = this->LocalOf(corner.number);
  if (known >= 0)
  {
    return known;
  }
  const auto local = static_cast<Id>(this->Positions_.size() / 3);
  this->Positions_.insert(this->Positions_.end(), corner.x.begin(), corner.x.end());
  this->NumbersOfOthers_.push_back(corner.number);
  this->Others_.emplace(corner.number, local);
  this->RowOf_.emplace_back(-1, 0);
  return local;
}

/// Which triangles those of the patch are here.
std::vector<Id> SharedMesh::Take(const MeshPatch& patch)
{
  std::vector<Id> points;
  points.reserve(patch.points.size());
  for (const MeshPatch::Corner& corner : patch.points)
  {
    points.push_back(this->AddPoint(corner));
  }
  std::vector<Id> triangles;
  triangles.reserve(patch.triangles.size());
  for (const MeshPatch::Cell& cell : patch.triangles)
  {
    const Triangle corners = { points[cell.corners[0]], points[cell.corners[1]],
      points[cell.corners[2]] };
    const auto next = static_cast<Id>(this->Triangles_.size());
    const bool isInside = std::all_of(
      corners.begin(), corners.end(), [this](Id p) { return p < this->NumberOfOwned(); });
    const auto known = isInside ? std::pair(this->TriangleOf_.end(), true)
                                : this->TriangleOf_.try_emplace(cell.number, next);
    if (known.second)
    {
      this->Triangles_.push_back(corners);
      this->TriangleNumbers_.push_back(cell.number);
    }
    triangles.push_back(known.second ? next : known.first->second);
  }
  return triangles;
}

/// For the triangles around these points of others.
void SharedMesh::Ask(Ranks& ranks, const std::vector<Id>& points)
{
  if (!IsAnywhere(ranks, !points.empty()))
  {
    return;
  }
  std::vector<std::vector<std::int64_t>> wanted(ranks.Size());
  std::vector<std::vector<Id>> asked(ranks.Size());
  for (const Id p : points)
  {
    const std::int64_t number = this->NumberOf(p);
    const int owner = this->Points_.OwnerOf(number);
    wanted[owner].push_back(number);
    asked[owner].push_back(p);
  }
  std::vector<Bytes> replies(ranks.Size());
  const auto requests = ExchangeValues(ranks, wanted);
  for (int rank = 0; rank < ranks.Size(); ++rank)
  {
    std::vector<Id> owned;
    owned.reserve(requests[rank].size());
    for (const std::int64_t number : requests[rank])
    {
      owned.push_back(static_cast<Id>(number - this->Points_.First(this->Rank_)));
    }
    Pack(replies[rank], this->PatchAround(owned));
  }
  const std::vector<Bytes> received = ranks.Exchange(std::move(replies));
  for (int rank = 0; rank < ranks.Size(); ++rank)
  {
    const MeshPatch patch = TakePatch(received[rank]);
    const std::vector<Id> triangles = this->Take(patch);
    std::size_t at = 0;
    for (std::size_t i = 0; i < asked[rank].size(); ++i)
    {
      this->RowOf_[asked[rank][i] - this->NumberOfOwned()] = {
        static_cast<std::int64_t>(this->Rows_.size()), patch.counts[i]
      };
      for (Id k = 0; k < patch.counts[i]; ++k)
      {
        this->Rows_.push_back(triangles[patch.around[at++]]);
      }
    }
  }
}

Span<Id> SharedMesh::TrianglesAround(Id local) const
{
  if (local < this->NumberOfOwned())
  {
    return this->Around_.TrianglesAround(local);
  }
  const auto [begin, count] = this->RowOf_[local - this->NumberOfOwned()];
  const Id* first = this->Rows_.data() + begin;
  return { first, first + count };
}

MeshShare::MeshShare(Ranks& ranks, SharedMesh& shared, std::vector<Id> points, int rings,
  const RangeLoop& loop, Id shares)
  : Points_(std::move(points))
  , NumberOfInner_(static_cast<Id>(Points_.size()))
  , Owners_(shared.Points())
{
  const std::vector<Id> triangles = this->Spread(ranks, shared, rings);
  std::unordered_map<Id, Id> ownId;
  ownId.reserve(this->Points_.size());
  const std::size_t count = this->Points_.size();
  this->Positions_.reserve(3 * count);
  this->Numbers_.reserve(count);
  std::vector<std::pair<Id, std::uint64_t>> ranksAtPlace;
  for (std::size_t p = 0; p < count; ++p)
  {
    const Id local = this->Points_[p];
    ownId.emplace(local, static_cast<Id>(p));
    const double* x = shared.Positions_.data() + 3 * static_cast<std::size_t>(local);
    this->Positions_.insert(this->Positions_.end(), x, x + 3);
    const std::int64_t number = shared.NumberOf(local);
    this->Numbers_.push_back(number);
    const auto rank = std::lower_bound(shared.RanksAtPlace_.begin(), shared.RanksAtPlace_.end(),
      std::pair(number, std::uint64_t(0)));
    if (rank != shared.RanksAtPlace_.end() && rank->first == number)
    {
      ranksAtPlace.emplace_back(static_cast<Id>(p), rank->second);
    }
  }
  Buffer<Triangle> corners(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const Triangle& local = shared.Triangles_[triangles[t]];
    corners[t] = { ownId.at(local[0]), ownId.at(local[1]), ownId.at(local[2]) };
  }
  this->Mesh_ = TriangleMesh(this->Positions_.data(), static_cast<Id>(count), std::move(corners),
    TriangleMesh::Edges::NotBuilt, loop, shares);
  this->Mesh_.SetRanksAtPlace(std::move(ranksAtPlace));
}

/// Ring after ring: appends the points of each, and gives the triangles around all but the last.
std::vector<Id> MeshShare::Spread(Ranks& ranks, SharedMesh& shared, int rings)
{
  std::vector<std::uint8_t> isPoint;
  std::vector<std::uint8_t> isTriangle;
  std::vector<Id> triangles;
  isPoint.resize(shared.Positions_.size() / 3, 0);
  for (const Id p : this->Points_)
  {
    isPoint[p] = 1;
  }
  std::size_t begin = 0;
  for (int ring = 0; ring <= rings; ++ring)
  {
    const std::size_t end = this->Points_.size();
    std::vector<Id> missing;
    for (std::size_t i = begin; i < end; ++i)
    {
      if (!shared.IsComplete(this->Points_[i]))
      {
        missing.push_back(this->Points_[i]);
      }
    }
    shared.Ask(ranks, missing);
    isPoint.resize(shared.Positions_.size() / 3, 0);
    isTriangle.resize(shared.Triangles_.size(), 0);
    for (std::size_t i = begin; i < end; ++i)
    {
      for (const Id t : shared.TrianglesAround(this->Points_[i]))
      {
        if (isTriangle[t] != 0)
        {
          continue;
        }
        isTriangle[t] = 1;
        triangles.push_back(t);
        for (const Id p : shared.Triangles_[t])
        {
          if (isPoint[p] == 0)
          {
            isPoint[p] = 1;
            this->Points_.push_back(p);
          }
        }
      }
    }
    begin = end;
  }
  return triangles;
}

} // namespace ridges
