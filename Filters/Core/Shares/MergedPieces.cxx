// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shares/MergedPieces.h"

#include "Mesh/PositionHash.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <utility>

namespace ridges
{
namespace
{

using Place = std::array<double, 3>;

/// Whether two places are one, by their bits: not even what is not a number matters.
bool AreOne(const Place& a, const Place& b)
{
  const auto bitsOf = [](const Place& place)
  {
    std::array<std::uint64_t, 3> bits;
    std::memcpy(bits.data(), place.data(), sizeof bits);
    return bits;
  };
  return bitsOf(a) == bitsOf(b);
}

/// 0 and -0 are one place.
Place PlaceAt(const double* x)
{
  return { x[0] + 0.0, x[1] + 0.0, x[2] + 0.0 };
}

std::vector<std::uint8_t> UsedPoints(const MeshPiece& piece)
{
  std::vector<std::uint8_t> isUsed(piece.numberOfPoints, 0);
  for (const Triangle& corners : piece.triangles)
  {
    for (const Id p : corners)
    {
      isUsed[p] = 1;
    }
  }
  return isUsed;
}

} // namespace

void MergedPieces::Add(const MeshPiece& piece)
{
  const std::vector<std::uint8_t> isUsed = UsedPoints(piece);
  this->MakeRoom(piece);
  const Id first = this->NumberOfPoints();
  std::vector<Id> points(piece.numberOfPoints, -1);
  this->Met_.clear();
  for (Id p = 0; p < piece.numberOfPoints; ++p)
  {
    const double* x = piece.points + 3 * static_cast<std::size_t>(p);
    if (isUsed[p] != 0)
    {
      points[p] = this->Take({ x[0], x[1], x[2] }, first);
    }
    else
    {
      this->Unused_.push_back({ this->NumberOfPieces(), p, { x[0], x[1], x[2] } });
    }
  }
  Id next = this->FirstTriangle_.back();
  for (const Triangle& corners : piece.triangles)
  {
    this->Triangles_[next++] = { points[corners[0]], points[corners[1]], points[corners[2]] };
  }
  this->FirstTriangle_.push_back(next);
  IdRuns runs(points);
  this->IsRepeated_ = this->IsRepeated_ || this->IsTheOneBefore(runs);
  this->PointsOf_.push_back(std::move(runs));
}

/// Whether the triangles of a piece, the last, are those of the piece before.
bool MergedPieces::IsTheOneBefore(const IdRuns& points) const
{
  if (this->PointsOf_.empty() || !(points == this->PointsOf_.back()))
  {
    return false;
  }
  const auto last = [this](int before)
  { return this->Triangles_.begin() + *(this->FirstTriangle_.end() - 1 - before); };
  return last(2) != last(1) && std::equal(last(2), last(1), last(1), last(0));
}

std::string MergedPieces::Finish()
{
  this->TakeUnused();
  this->Table_ = {};
  this->Triangles_.Shorten(this->FirstTriangle_.back());
  std::sort(this->Coincident_.begin(), this->Coincident_.end());
  this->Coincident_.erase(
    std::unique(this->Coincident_.begin(), this->Coincident_.end()), this->Coincident_.end());
  if (this->IsRepeated_)
  {
    return "two pieces that follow each other are the same: what is asked for pieces gives the "
           "whole "
           "mesh each time";
  }
  return this->Ambiguous_.empty()
    ? std::string()
    : TextOfAmbiguousPlaces(static_cast<Id>(this->Ambiguous_.size()),
        this->PlaceOf(*this->Ambiguous_.begin()),
        "if they are all one, merge coincident points in each piece; if not, give the mesh as one "
        "piece");
}

/// At first for as many pieces as will come, should all be of one size: memory that is taken and
/// not written to costs nothing, and what grows step by step leaves holes.
void MergedPieces::MakeRoom(const MeshPiece& piece)
{
  constexpr double spare = 1.1;
  const auto room = [this, &spare](std::size_t before, Id added)
  {
    const auto with = static_cast<double>(before) + static_cast<double>(added);
    const double ofAll = with / (this->NumberOfPieces() + 1.0) * this->Expected_;
    return static_cast<std::size_t>(spare * std::max(ofAll, with)) + 1;
  };
  const auto points = static_cast<std::size_t>(this->NumberOfPoints());
  if (3 * (points + piece.numberOfPoints) > this->Positions_.capacity())
  {
    this->Positions_.reserve(3 * room(points, piece.numberOfPoints));
    this->GrowTable(this->Positions_.capacity() / 3);
  }
  const auto triangles = static_cast<std::size_t>(this->FirstTriangle_.back());
  if (triangles + piece.triangles.size() > this->Triangles_.size())
  {
    Buffer<Triangle> more(room(triangles, piece.triangles.size()));
    std::copy_n(this->Triangles_.begin(), triangles, more.begin());
    this->Triangles_ = std::move(more);
  }
}

/// The point for one of the piece whose new points begin with `firstOfPiece`.
Id MergedPieces::Take(const Place& x, Id firstOfPiece)
{
  const std::size_t slot = this->SlotOf(x);
  const Id known = this->Table_[slot];
  if (known < 0)
  {
    return this->Table_[slot] = this->Append(x);
  }
  if (known >= firstOfPiece)
  {
    this->Several_.insert(known);
    return this->AppendBeside(known, x);
  }
  if (this->Several_.count(known) > 0 || !this->Met_.insert(known).second)
  {
    this->Ambiguous_.insert(known);
  }
  return known;
}

/// Those that no triangle has: what other pieces have there, or points of their own.
void MergedPieces::TakeUnused()
{
  this->GrowTable(static_cast<std::size_t>(this->NumberOfPoints()) + this->Unused_.size());
  for (auto begin = this->Unused_.cbegin(); begin != this->Unused_.cend();)
  {
    const int piece = begin->piece;
    const auto end = std::find_if(
      begin, this->Unused_.cend(), [piece](const Unused& unused) { return unused.piece != piece; });
    this->TakeUnusedOf(piece, begin, end);
    begin = end;
  }
  this->Unused_ = {};
}

void MergedPieces::TakeUnusedOf(
  int piece, std::vector<Unused>::const_iterator begin, std::vector<Unused>::const_iterator end)
{
  std::vector<Id> points = this->PointsOf_[piece].Ids();
  std::vector<Id> sorted = points;
  std::sort(sorted.begin(), sorted.end());
  for (; begin != end; ++begin)
  {
    Id& known = this->Table_[this->SlotOf(begin->x)];
    if (known < 0)
    {
      known = this->Append(begin->x);
      points[begin->point] = known;
    }
    else
    {
      const bool hasIt = std::binary_search(sorted.begin(), sorted.end(), known);
      points[begin->point] = hasIt ? this->AppendBeside(known, begin->x) : known;
    }
  }
  this->PointsOf_[piece] = IdRuns(points);
}

Place MergedPieces::PlaceOf(Id p) const
{
  return PlaceAt(this->Positions_.data() + 3 * static_cast<std::size_t>(p));
}

Id MergedPieces::Append(const Place& x)
{
  const Id p = this->NumberOfPoints();
  this->Positions_.insert(this->Positions_.end(), x.begin(), x.end());
  return p;
}

Id MergedPieces::AppendBeside(Id first, const Place& x)
{
  const Id p = this->Append(x);
  this->Coincident_.push_back(first);
  this->Coincident_.push_back(p);
  return p;
}

/// Where in the table a place is, or belongs.
std::size_t MergedPieces::SlotOf(const Place& x) const
{
  const Place place = PlaceAt(x.data());
  const std::size_t mask = this->Table_.size() - 1;
  std::size_t slot =
    static_cast<std::size_t>(PositionHash({ place[0], place[1], place[2] })) & mask;
  while (this->Table_[slot] >= 0 && !AreOne(this->PlaceOf(this->Table_[slot]), place))
  {
    slot = (slot + 1) & mask;
  }
  return slot;
}

/// So that it can have so many places.
void MergedPieces::GrowTable(std::size_t places)
{
  std::size_t size = 64;
  while (3 * size < 4 * places)
  {
    size *= 2;
  }
  if (size <= this->Table_.size())
  {
    return;
  }
  std::vector<Id> before(size, -1);
  before.swap(this->Table_);
  for (const Id p : before)
  {
    if (p >= 0)
    {
      this->Table_[this->SlotOf(this->PlaceOf(p))] = p;
    }
  }
}

} // namespace ridges
