// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shares/SharedMesh.h"

#include "Base/RankGathering.h"

#include <algorithm>
#include <iterator>

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

/// Points, each once.
void SortCorners(std::vector<MeshPatch::Corner>& points)
{
  std::sort(points.begin(), points.end(),
    [](const MeshPatch::Corner& a, const MeshPatch::Corner& b) { return a.number < b.number; });
  points.erase(
    std::unique(points.begin(), points.end(),
      [](const MeshPatch::Corner& a, const MeshPatch::Corner& b) { return a.number == b.number; }),
    points.end());
}

MeshPatch::Corner CornerAt(std::int64_t number, const double* x)
{
  return { number, { x[0], x[1], x[2] } };
}

} // namespace

std::string SharedMesh::Share(Ranks& ranks, const MeshPiece& piece)
{
  this->Rank_ = ranks.Rank();
  std::string faults = this->Points_.Share(ranks, piece);
  if (!faults.empty())
  {
    return faults;
  }
  this->SendTriangles(ranks, piece);
  this->RankCoincident(ranks);
  return {};
}

void SharedMesh::TakeWhole(MergedPieces& pieces, const RangeLoop& loop)
{
  this->Release();
  this->Rank_ = 0;
  this->NumberOfTriangles_ = static_cast<std::int64_t>(pieces.Triangles().size());
  this->Points_.TakeWhole(std::move(pieces.Positions()), std::move(pieces.Coincident()));
  this->Around_ = TriangleMesh(this->Points_.Owned().data(), this->NumberOfOwned(),
    std::move(pieces.Triangles()), TriangleMesh::Edges::NotBuilt, loop);
  this->RanksAtPlace_.clear();
  for (const Id p : this->Points_.Coincident())
  {
    const std::uint64_t rank = this->Around_.RankAtPlace(p);
    if (rank != 0)
    {
      this->RanksAtPlace_.emplace_back(p, rank);
    }
  }
}

/// Each triangle of the piece goes to the owners of its corners; so many at a time, as messages are
/// several times as large as what is made of them.
void SharedMesh::SendTriangles(Ranks& ranks, const MeshPiece& piece)
{
  constexpr std::int64_t atATime = 1 << 17;
  std::int64_t first = 0;
  std::int64_t most = 0;
  this->NumberOfTriangles_ = 0;
  const auto counts = GatherAllOne<std::int64_t>(ranks, piece.triangles.size());
  for (int rank = 0; rank < ranks.Size(); ++rank)
  {
    first += rank < ranks.Rank() ? counts[rank] : 0;
    most = std::max(most, counts[rank]);
    this->NumberOfTriangles_ += counts[rank];
  }
  // Of most surfaces so many, and some beyond.
  const std::size_t expected = 2 * static_cast<std::size_t>(this->NumberOfOwned()) * 17 / 16;
  this->Triangles_.reserve(expected);
  this->TriangleNumbers_.reserve(expected);
  const std::vector<std::int64_t> numbers = this->Points_.NumbersOfPiece(ranks);
  const std::int64_t count = piece.triangles.size();
  for (std::int64_t begin = 0; begin < most; begin += atATime)
  {
    this->SendSome(ranks, piece, numbers, static_cast<Id>(std::min(begin, count)),
      static_cast<Id>(std::min(begin + atATime, count)), first);
  }
  std::vector<Triangle> triangles;
  triangles.swap(this->Triangles_);
  this->Around_ = TriangleMesh(
    this->Points_.Owned().data(), this->NumberOfPoints(), triangles, TriangleMesh::Edges::NotBuilt);
}

/// The triangles from `begin` to `end`; the first of the piece has the number `first`, and its
/// points have `numbers`.
void SharedMesh::SendSome(Ranks& ranks, const MeshPiece& piece,
  const std::vector<std::int64_t>& numbers, Id begin, Id end, std::int64_t first)
{
  std::vector<MeshPatch> patches(ranks.Size());
  for (Id t = begin; t < end; ++t)
  {
    const Triangle& triangle = piece.triangles[t];
    MeshPatch::Cell cell{ first + t, {} };
    std::array<int, 3> owners;
    for (int i = 0; i < 3; ++i)
    {
      cell.corners[i] = numbers[triangle[i]];
      owners[i] = this->Points_.OwnerOf(cell.corners[i]);
    }
    for (int i = 0; i < 3; ++i)
    {
      MeshPatch& patch = patches[owners[i]];
      if (std::find(owners.begin(), owners.begin() + i, owners[i]) == owners.begin() + i)
      {
        patch.triangles.push_back(cell);
      }
      // Each knows where its own points are.
      for (int k = 0; k < 3; ++k)
      {
        if (owners[k] != owners[i])
        {
          patch.points.push_back(
            CornerAt(cell.corners[k], piece.points + 3 * static_cast<std::size_t>(triangle[k])));
        }
      }
    }
  }
  std::vector<Bytes> messages(ranks.Size());
  for (int rank = 0; rank < ranks.Size(); ++rank)
  {
    SortCorners(patches[rank].points);
    Pack(messages[rank], patches[rank]);
    patches[rank] = {};
  }
  messages = ranks.Exchange(std::move(messages));
  for (Bytes& message : messages)
  {
    this->Take(TakePatch(message));
    message = {};
  }
}

void SharedMesh::Release()
{
  this->PositionsOfOthers_ = {};
  this->NumbersOfOthers_ = {};
  this->Others_ = {};
  this->Triangles_ = {};
  this->TriangleNumbers_ = {};
  this->TriangleOf_ = {};
  this->Around_ = {};
  this->RowOf_ = {};
  this->Rows_ = {};
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
    own.points.push_back(CornerAt(this->NumberOf(p), this->Position(p)));
  }
  Bytes message;
  Pack(message, own);
  const std::vector<Bytes> ofAll = ranks.GatherAll(std::move(message));
  std::unordered_map<std::int64_t, Id> pointOf;
  std::unordered_map<std::int64_t, Id> triangleOf;
  std::vector<double> positions;
  std::vector<Triangle> triangles;
  for (const Bytes& bytes : ofAll)
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
          [&pointOf](std::int64_t number) { return pointOf.at(number); });
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
  MeshPatch patch;
  std::unordered_map<Id, Id> added;
  for (const Id p : owned)
  {
    const Span<Id> around = this->Around_.TrianglesAround(p);
    patch.counts.push_back(around.size());
    for (const Id t : around)
    {
      const auto [entry, isNew] = added.try_emplace(t, static_cast<Id>(patch.triangles.size()));
      patch.around.push_back(entry->second);
      if (isNew)
      {
        MeshPatch::Cell cell{ this->TriangleNumbers_[t], {} };
        for (int i = 0; i < 3; ++i)
        {
          const Id corner = this->Around_.Corners(t)[i];
          cell.corners[i] = this->NumberOf(corner);
          patch.points.push_back(CornerAt(cell.corners[i], this->Position(corner)));
        }
        patch.triangles.push_back(cell);
      }
    }
  }
  SortCorners(patch.points);
  return patch;
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
  const Id local = this->NumberOfPoints();
  this->PositionsOfOthers_.insert(this->PositionsOfOthers_.end(), corner.x.begin(), corner.x.end());
  this->NumbersOfOthers_.push_back(corner.number);
  this->Others_.emplace(corner.number, local);
  this->RowOf_.emplace_back(-1, 0);
  return local;
}

/// Which triangles those of the patch are here.
std::vector<Id> SharedMesh::Take(const MeshPatch& patch)
{
  for (const MeshPatch::Corner& corner : patch.points)
  {
    this->AddPoint(corner);
  }
  std::vector<Id> triangles;
  triangles.reserve(patch.triangles.size());
  for (const MeshPatch::Cell& cell : patch.triangles)
  {
    Triangle corners;
    std::transform(cell.corners.begin(), cell.corners.end(), corners.begin(),
      [this](std::int64_t number) { return this->LocalOf(number); });
    const auto next = static_cast<Id>(this->TriangleNumbers_.size());
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
  const auto requests = ExchangeValues(ranks, std::move(wanted));
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
  : NumberOfInner_(static_cast<Id>(points.size()))
  , Owners_(shared.Points())
{
  SparseIds ownId(shared.NumberOfPoints());
  const std::vector<Id> triangles = Spread(ranks, shared, points, ownId, rings);
  this->Positions_.reserve(3 * points.size());
  this->Numbers_.reserve(points.size());
  std::vector<std::pair<Id, std::uint64_t>> ranksAtPlace;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    const double* x = shared.Position(points[p]);
    this->Positions_.insert(this->Positions_.end(), x, x + 3);
    const std::int64_t number = shared.NumberOf(points[p]);
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
    const Triangle& local = shared.Corners(triangles[t]);
    corners[t] = { ownId[local[0]], ownId[local[1]], ownId[local[2]] };
  }
  this->Mesh_ = TriangleMesh(this->Positions_.data(), static_cast<Id>(points.size()),
    std::move(corners), TriangleMesh::Edges::NotBuilt, loop, shares);
  this->Mesh_.SetRanksAtPlace(std::move(ranksAtPlace));
}

std::vector<Id> MeshShare::Owned() const
{
  std::vector<Id> owned;
  owned.reserve(this->Numbers_.size());
  for (const std::int64_t number : this->Numbers_)
  {
    const int owner = this->Owners_.OwnerOf(number);
    owned.push_back(static_cast<Id>(number - this->Owners_.First(owner)));
  }
  return owned;
}

/// Ring after ring: appends the points of each, and gives the triangles around all but the last.
/// `ownId` has the places of the points, or -1.
std::vector<Id> MeshShare::Spread(
  Ranks& ranks, SharedMesh& shared, std::vector<Id>& points, SparseIds& ownId, int rings)
{
  std::vector<bool> isTriangle;
  std::vector<Id> triangles;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    ownId.Set(points[p], static_cast<Id>(p));
  }
  const auto add = [&points, &ownId, &shared, &triangles](Id t)
  {
    triangles.push_back(t);
    for (const Id p : shared.Corners(t))
    {
      if (ownId[p] < 0)
      {
        ownId.Set(p, static_cast<Id>(points.size()));
        points.push_back(p);
      }
    }
  };
  std::size_t begin = 0;
  int ring = 0;
  if (static_cast<Id>(points.size()) == shared.NumberOfOwned())
  {
    // All that are owned: around them are all triangles that were dealt to this rank.
    begin = points.size();
    const Id dealt = shared.Around_.NumberOfTriangles();
    triangles.reserve(dealt);
    isTriangle.resize(dealt, true);
    shared.Ask(ranks, {}); // as other ranks may
    ownId.Grow(shared.NumberOfPoints());
    for (Id t = 0; t < dealt; ++t)
    {
      add(t);
    }
    ++ring;
  }
  for (; ring <= rings; ++ring)
  {
    const std::size_t end = points.size();
    std::vector<Id> missing;
    std::copy_if(points.begin() + static_cast<std::ptrdiff_t>(begin), points.end(),
      std::back_inserter(missing), [&shared](Id p) { return !shared.IsComplete(p); });
    shared.Ask(ranks, missing);
    ownId.Grow(shared.NumberOfPoints());
    isTriangle.resize(shared.NumberOfTrianglesHere(), false);
    for (std::size_t i = begin; i < end; ++i)
    {
      for (const Id t : shared.TrianglesAround(points[i]))
      {
        if (!isTriangle[t])
        {
          isTriangle[t] = true;
          add(t);
        }
      }
    }
    begin = end;
  }
  return triangles;
}

} // namespace ridges
