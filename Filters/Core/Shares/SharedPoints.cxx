// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shares/SharedPoints.h"

#include "Base/RankGathering.h"
#include "Mesh/PositionHash.h"
#include "Shares/PositionBisection.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace ridges
{
namespace
{

/// A point of a piece on its way to its owner.
struct Arrival
{
  std::array<double, 3> x;
  std::int64_t globalId; ///< -1 if unknown.
  std::int64_t isUsed;   ///< Whether any triangle has it.
};

/// 0 and -0 are one place.
std::array<double, 3> PlaceOf(const std::array<double, 3>& x)
{
  return { x[0] + 0.0, x[1] + 0.0, x[2] + 0.0 };
}

/// Who has used points at a place. Ranks arrive one after the other.
struct Place
{
  std::array<double, 3> x;
  int ranks = 0;
  int lastRank = -1;
  Id ofLastRank = 0;
  Id mostOfARank = 0;

  bool IsOnePoint() const { return this->mostOfARank <= 1; }
};

/// Numbers places as they come: by their bits, so that not even what is not a number matters.
class PlaceTable
{
public:
  explicit PlaceTable(std::size_t count)
  {
    std::size_t size = 16;
    while (size < 2 * count)
    {
      size *= 2;
    }
    this->Table_.assign(size, -1);
  }

  /// The number of a place, which is added if it is new.
  Id Find(const std::array<double, 3>& x, std::vector<Place>& places)
  {
    const std::size_t mask = this->Table_.size() - 1;
    std::size_t at = static_cast<std::size_t>(PositionHash({ x[0], x[1], x[2] })) & mask;
    while (this->Table_[at] >= 0 && BitsOf(places[this->Table_[at]].x) != BitsOf(x))
    {
      at = (at + 1) & mask;
    }
    if (this->Table_[at] < 0)
    {
      this->Table_[at] = static_cast<Id>(places.size());
      places.push_back({ x });
    }
    return this->Table_[at];
  }

private:
  static std::array<std::uint64_t, 3> BitsOf(const std::array<double, 3>& x)
  {
    std::array<std::uint64_t, 3> bits;
    std::memcpy(bits.data(), x.data(), sizeof bits);
    return bits;
  }

  std::vector<Id> Table_;
};

/// Of all points of all pieces, about as many per rank; each rank gives its part.
std::vector<Eigen::Vector3d> SampleOf(Ranks& ranks, const MeshPiece& piece)
{
  // So that ranks own as many to a percent or so, if they are few; many need not be that even.
  constexpr std::int64_t leastPerRank = 512;
  constexpr std::int64_t least = 1 << 15;
  const std::int64_t wanted = std::max(least, leastPerRank * ranks.Size());
  const std::int64_t all = SumOverRanks(ranks, piece.numberOfPoints);
  const std::int64_t step = std::max<std::int64_t>(1, all / wanted);
  std::vector<std::array<double, 3>> own;
  for (std::int64_t p = step / 2; p < piece.numberOfPoints; p += step)
  {
    const double* x = piece.points + 3 * p;
    own.push_back({ x[0], x[1], x[2] });
  }
  std::vector<Eigen::Vector3d> sample;
  for (const auto& part : GatherAllValues(ranks, own))
  {
    for (const std::array<double, 3>& x : part)
    {
      sample.emplace_back(x[0], x[1], x[2]);
    }
  }
  return sample;
}

} // namespace

std::string TextOfAmbiguousPlaces(Id count, const std::array<double, 3>& x, const char* help)
{
  char place[120];
  std::snprintf(place, sizeof place, "(%.9g, %.9g, %.9g)", x[0], x[1], x[2]);
  return std::to_string(count) +
    " places have several points in one piece and points of another piece, too, as at " + place +
    ": which are the same cannot be known (" + help + ")";
}

/// What came to this rank.
struct SharedPoints::Arrivals
{
  std::vector<std::vector<Arrival>> points; ///< By rank.
  std::vector<std::vector<Id>> placeOf;
  std::vector<Place> places;
  std::set<std::pair<Id, int>> usedBy; ///< At places with unused points: by which ranks.

  explicit Arrivals(std::vector<std::vector<Arrival>> received)
    : points(std::move(received))
  {
    this->FindPlaces();
    this->FindUsers();
  }

  std::string Faults() const
  {
    Id ambiguous = 0;
    std::array<double, 3> example{};
    std::set<Id> seen;
    for (std::size_t rank = 0; rank < this->points.size(); ++rank)
    {
      for (std::size_t i = 0; i < this->points[rank].size(); ++i)
      {
        const Id at = this->placeOf[rank][i];
        const Place& place = this->places[at];
        if (!place.IsOnePoint() && place.ranks > 1 && this->points[rank][i].isUsed != 0 &&
          this->points[rank][i].globalId < 0 && seen.insert(at).second)
        {
          example = ++ambiguous == 1 ? place.x : example;
        }
      }
    }
    return ambiguous > 0
      ? TextOfAmbiguousPlaces(ambiguous, example,
          "if they are all one, merge coincident points in each piece; if not, give the points "
          "global ids")
      : "";
  }

private:
  void FindPlaces()
  {
    std::size_t count = 0;
    for (const std::vector<Arrival>& from : this->points)
    {
      count += from.size();
    }
    PlaceTable table(count);
    this->places.reserve(count);
    this->placeOf.resize(this->points.size());
    for (std::size_t rank = 0; rank < this->points.size(); ++rank)
    {
      this->placeOf[rank].reserve(this->points[rank].size());
      for (const Arrival& arrival : this->points[rank])
      {
        const Id at = table.Find(PlaceOf(arrival.x), this->places);
        this->placeOf[rank].push_back(at);
        if (arrival.isUsed != 0)
        {
          Place& place = this->places[at];
          const bool isSameRank = place.lastRank == static_cast<int>(rank);
          place.ranks += isSameRank ? 0 : 1;
          place.ofLastRank = isSameRank ? place.ofLastRank + 1 : 1;
          place.lastRank = static_cast<int>(rank);
          place.mostOfARank = std::max(place.mostOfARank, place.ofLastRank);
        }
      }
    }
  }

  void FindUsers()
  {
    std::set<Id> withUnused;
    const auto forAll = [this](int isUsed, const auto& visit)
    {
      for (std::size_t rank = 0; rank < this->points.size(); ++rank)
      {
        for (std::size_t i = 0; i < this->points[rank].size(); ++i)
        {
          if ((this->points[rank][i].isUsed != 0) == (isUsed != 0))
          {
            visit(this->placeOf[rank][i], static_cast<int>(rank));
          }
        }
      }
    };
    forAll(0, [&withUnused](Id place, int) { withUnused.insert(place); });
    if (!withUnused.empty())
    {
      forAll(1,
        [this, &withUnused](Id place, int rank)
        {
          if (withUnused.count(place) > 0)
          {
            this->usedBy.emplace(place, rank);
          }
        });
    }
  }
};

std::string SharedPoints::Share(Ranks& ranks, const MeshPiece& piece)
{
  const PositionBisection parts(SampleOf(ranks, piece), ranks.Size());
  std::vector<std::uint8_t> isUsed(piece.numberOfPoints, 0);
  for (const Triangle& corners : piece.triangles)
  {
    for (const Id p : corners)
    {
      isUsed[p] = 1;
    }
  }
  std::vector<std::vector<Arrival>> sent(ranks.Size());
  this->SentTo_.assign(ranks.Size(), {});
  for (Id p = 0; p < piece.numberOfPoints; ++p)
  {
    const double* x = piece.points + 3 * static_cast<std::size_t>(p);
    const int owner = parts.PartOf({ x[0] + 0.0, x[1] + 0.0, x[2] + 0.0 });
    sent[owner].push_back(
      { { x[0], x[1], x[2] }, piece.globalIds ? piece.globalIds[p] : -1, isUsed[p] });
    this->SentTo_[owner].push_back(p);
  }
  const Arrivals arrivals(ExchangeValues(ranks, std::move(sent)));
  std::string faults = TextOfRanks(ranks, arrivals.Faults());
  if (!faults.empty())
  {
    return faults;
  }
  this->Number(ranks, arrivals, this->ReceivedFrom_);
  return {};
}

std::vector<std::int64_t> SharedPoints::NumbersOfPiece(Ranks& ranks) const
{
  std::vector<std::int64_t> numbers(this->NumberOfOwned());
  std::iota(numbers.begin(), numbers.end(), this->First_[ranks.Rank()]);
  return this->ToPiece(ranks, numbers.data(), 1);
}

Id SharedPoints::NumberOfPoints() const
{
  Id count = 0;
  for (const std::vector<Id>& sent : this->SentTo_)
  {
    count += static_cast<Id>(sent.size());
  }
  return count;
}

namespace
{

/// Decides which arrivals are one point, one after the other: a key per point.
class PointKeys
{
public:
  enum class Kind
  {
    Only, ///< Of all ranks, at the place.
    OfRank,
    WithId,
    Isolated
  };
  struct Key
  {
    Kind kind;
    std::int64_t which;
  };

  /// `hasUsed`: whether the same rank has a point at the place that triangles use.
  Key Next(Id at, const Place& place, int rank, const Arrival& arrival, bool hasUsed)
  {
    if (arrival.isUsed == 0)
    {
      // The first of a rank that has no other there is what others have there.
      const Id before = this->Isolated_[{ at, rank }]++ + (hasUsed ? 1 : 0);
      return { before == 0 ? Kind::Only : Kind::Isolated, before };
    }
    if (place.IsOnePoint())
    {
      return { Kind::Only, 0 };
    }
    return place.ranks == 1 ? Key{ Kind::OfRank, this->OfRank_++ }
                            : Key{ Kind::WithId, arrival.globalId };
  }

private:
  std::map<std::pair<Id, int>, Id> Isolated_;
  std::int64_t OfRank_ = 0;
};

} // namespace

/// In the order of arrival, so that points that follow each other in pieces do so here.
void SharedPoints::Number(
  Ranks& ranks, const Arrivals& arrivals, std::vector<std::vector<Id>>& pointOf)
{
  using Kind = PointKeys::Kind;
  PointKeys keys;
  std::vector<Id> only(arrivals.places.size(), -1);
  std::map<std::tuple<Id, Kind, std::int64_t>, Id> others;
  std::vector<Id> pointsAt(arrivals.places.size(), 0);
  std::vector<Id> placeOfPoint;
  this->Owned_.clear();
  this->Owned_.reserve(3 * arrivals.places.size());
  placeOfPoint.reserve(arrivals.places.size());
  pointOf.assign(arrivals.points.size(), {});
  for (std::size_t rank = 0; rank < arrivals.points.size(); ++rank)
  {
    const auto from = static_cast<int>(rank);
    pointOf[rank].reserve(arrivals.points[rank].size());
    for (std::size_t i = 0; i < arrivals.points[rank].size(); ++i)
    {
      const Arrival& arrival = arrivals.points[rank][i];
      const Id at = arrivals.placeOf[rank][i];
      const PointKeys::Key key = keys.Next(at, arrivals.places[at], from, arrival,
        !arrivals.usedBy.empty() && arrivals.usedBy.count({ at, from }) > 0);
      Id& point = key.kind == Kind::Only
        ? only[at]
        : others.try_emplace({ at, key.kind, key.which }, -1).first->second;
      if (point < 0)
      {
        point = this->NumberOfOwned();
        this->Owned_.insert(this->Owned_.end(), arrival.x.begin(), arrival.x.end());
        placeOfPoint.push_back(at);
        ++pointsAt[at];
      }
      pointOf[rank].push_back(point);
    }
  }

  this->Coincident_.clear();
  for (Id p = 0; p < this->NumberOfOwned(); ++p)
  {
    if (pointsAt[placeOfPoint[p]] > 1)
    {
      this->Coincident_.push_back(p);
    }
  }
  this->First_ = { 0 };
  for (const Id count : GatherAllOne(ranks, this->NumberOfOwned()))
  {
    this->First_.push_back(this->First_.back() + count);
  }
}

void SharedPoints::TakeWhole(std::vector<double> positions, std::vector<Id> coincident)
{
  this->Owned_ = std::move(positions);
  this->Coincident_ = std::move(coincident);
  this->First_ = { 0, this->NumberOfOwned() };
  this->SentTo_.assign(1, {});
  this->ReceivedFrom_.assign(1, {});
}

int SharedPoints::OwnerOf(std::int64_t number) const
{
  return static_cast<int>(
    std::upper_bound(this->First_.begin(), this->First_.end(), number) - this->First_.begin() - 1);
}

} // namespace ridges
