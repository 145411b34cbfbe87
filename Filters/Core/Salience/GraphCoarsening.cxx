// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Salience/GraphCoarsening.h"

#include "Mesh/PositionHash.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ridges
{
namespace
{

constexpr Id None = -1;

enum class Role : std::uint8_t
{
  Open,
  Chosen,
  Member,
  Single
};

/// The chosen cells: of those that join and have no chosen neighbour yet, again and again all that
/// come before their neighbours. That is the same set in whatever order it is found.
class Choice
{
public:
  Choice(const RingGraph& fine, const std::vector<std::uint8_t>& joins,
    const std::function<std::uint64_t(Id)>& rank)
    : Fine_(fine)
    , Rank_(rank)
    , Roles_(fine.NumberOfCells(), Role::Single)
    , Keys_(fine.NumberOfCells())
  {
    std::vector<Id> open;
    for (Id cell = 0; cell < fine.NumberOfCells(); ++cell)
    {
      this->Keys_[cell] = PositionHash(fine.positions[cell]);
      if (joins[cell] != 0)
      {
        this->Roles_[cell] = Role::Open;
        open.push_back(cell);
      }
    }
    std::vector<Id> left;
    while (!open.empty())
    {
      left.clear();
      for (const Id cell : open)
      {
        if (this->Roles_[cell] == Role::Open && !this->Choose(cell))
        {
          left.push_back(cell);
        }
      }
      open.swap(left);
    }
  }

  const std::vector<Role>& Roles() const { return this->Roles_; }

private:
  bool ComesBefore(Id a, Id b) const
  {
    if (this->Keys_[a] != this->Keys_[b])
    {
      return this->Keys_[a] < this->Keys_[b];
    }
    const std::uint64_t rankOfA = this->Rank_(a);
    const std::uint64_t rankOfB = this->Rank_(b);
    return rankOfA == rankOfB ? a < b : rankOfA < rankOfB;
  }

  /// False if another cell has to be decided on before.
  bool Choose(Id cell)
  {
    for (const Id other : this->Fine_.Around(cell))
    {
      if (this->Roles_[other] == Role::Open && this->ComesBefore(other, cell))
      {
        return false;
      }
    }
    this->Roles_[cell] = Role::Chosen;
    for (const Id other : this->Fine_.Around(cell))
    {
      if (this->Roles_[other] == Role::Open)
      {
        this->Roles_[other] = Role::Member;
      }
    }
    return true;
  }

  const RingGraph& Fine_;
  const std::function<std::uint64_t(Id)>& Rank_;
  std::vector<Role> Roles_;
  std::vector<std::uint64_t> Keys_;
};

Id NearestChosen(const RingGraph& fine, const std::vector<Role>& roles, Id cell)
{
  Id nearest = None;
  double least = std::numeric_limits<double>::infinity();
  for (const Id other : fine.Around(cell))
  {
    if (roles[other] == Role::Chosen)
    {
      const double square = (fine.positions[other] - fine.positions[cell]).squaredNorm();
      if (square < least || nearest == None)
      {
        nearest = other;
        least = square;
      }
    }
  }
  return nearest;
}

/// Numbers the coarse cells in the order of the fine ones and lists what they are made of.
void JoinCells(const RingGraph& fine, const std::vector<Role>& roles, Coarsening& result)
{
  const Id count = fine.NumberOfCells();
  result.coarse.assign(count, None);
  std::vector<Id> centers;
  for (Id cell = 0; cell < count; ++cell)
  {
    if (roles[cell] != Role::Member)
    {
      result.coarse[cell] = static_cast<Id>(centers.size());
      centers.push_back(cell);
    }
  }
  for (Id cell = 0; cell < count; ++cell)
  {
    if (roles[cell] == Role::Member)
    {
      result.coarse[cell] = result.coarse[NearestChosen(fine, roles, cell)];
    }
  }
  result.begins.reserve(centers.size() + 1);
  result.members.reserve(count);
  for (const Id center : centers)
  {
    result.begins.push_back(static_cast<Id>(result.members.size()));
    result.members.push_back(center);
    for (const Id other : fine.Around(center))
    {
      if (roles[other] == Role::Member && result.coarse[other] == result.coarse[center])
      {
        result.members.push_back(other);
      }
    }
  }
  result.begins.push_back(static_cast<Id>(result.members.size()));
}

void MeasureCell(const RingGraph& fine, Id cell, Coarsening& result)
{
  const Span<Id> members = result.Members(cell);
  const Eigen::Vector3d& center = fine.positions[members[0]];
  const Eigen::Vector3d& upwards = fine.normals[members[0]];
  double area = 0.0;
  double square = 0.0;
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  bool hasNormals = true;
  for (const Id member : members)
  {
    const Eigen::Vector3d way = fine.positions[member] - center;
    const Eigen::Vector3d& own = fine.normals[member];
    area += fine.areas[member];
    offset += fine.areas[member] * way;
    square += fine.areas[member] * way.squaredNorm();
    normal += std::copysign(fine.areas[member], own.dot(upwards)) * own;
    hasNormals = hasNormals && own.squaredNorm() > 0.0;
  }
  const double perArea = area > 0.0 ? 1.0 / area : 0.0;
  offset *= perArea;
  result.graph.areas[cell] = area;
  result.graph.positions[cell] = center + offset;
  result.graph.normals[cell].setZero();
  if (hasNormals)
  {
    result.graph.normals[cell] = normal.normalized();
  }
  result.variances[cell] = 0.5 * std::max(0.0, perArea * square - offset.squaredNorm());
}

void MeasureCells(const RingGraph& fine, const RangeLoop& loop, Coarsening& result)
{
  const auto count = static_cast<Id>(result.begins.size() - 1);
  result.graph.areas.resize(count);
  result.graph.positions.resize(count);
  result.graph.normals.resize(count);
  result.variances.resize(count);
  loop(count,
    [&fine, &result](Id begin, Id end)
    {
      for (Id cell = begin; cell < end; ++cell)
      {
        MeasureCell(fine, cell, result);
      }
    });
}

/// Coarse cells are neighbours if any of their parts are.
void FindNeighbors(const RingGraph& fine, Coarsening& result)
{
  const Id count = result.graph.NumberOfCells();
  std::vector<Id> seenFrom(count, None);
  result.graph.begins.reserve(static_cast<std::size_t>(count) + 1);
  for (Id cell = 0; cell < count; ++cell)
  {
    result.graph.begins.push_back(static_cast<Id>(result.graph.neighbors.size()));
    seenFrom[cell] = cell;
    for (const Id member : result.Members(cell))
    {
      for (const Id near : fine.Around(member))
      {
        const Id other = result.coarse[near];
        if (seenFrom[other] != cell)
        {
          seenFrom[other] = cell;
          result.graph.neighbors.push_back(other);
        }
      }
    }
  }
  result.graph.begins.push_back(static_cast<Id>(result.graph.neighbors.size()));
}

} // namespace

Coarsening Coarsen(const RingGraph& fine, const std::vector<std::uint8_t>& joins,
  const std::function<std::uint64_t(Id)>& rank, const RangeLoop& loop)
{
  Coarsening result;
  JoinCells(fine, Choice(fine, joins, rank).Roles(), result);
  MeasureCells(fine, loop, result);
  FindNeighbors(fine, result);
  result.graph.SetFactors(loop);
  result.graph.SetReaches();
  return result;
}

} // namespace ridges
