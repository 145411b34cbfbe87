// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Umbilics/IndexCharge.h"

#include "Mesh/IdTable.h"
#include "Mesh/PositionOrder.h"
#include "Mesh/Regions.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <numeric>
#include <unordered_map>

namespace ridges
{

int SumOf(const std::vector<IndexCharge>& charges)
{
  return std::accumulate(charges.begin(), charges.end(), 0,
    [](int sum, const IndexCharge& charge) { return sum + charge.halfTurns; });
}

void SortByPosition(const TriangleMesh& mesh, std::vector<IndexCharge>& charges)
{
  struct Placed
  {
    double x;
    IndexCharge charge;
  };
  const auto precedes = [&mesh](const Placed& a, const Placed& b)
  { return a.x != b.x ? a.x < b.x : ComesBefore(mesh, a.charge.triangle, b.charge.triangle); };
  std::vector<Placed> placed;
  placed.reserve(charges.size());
  for (const IndexCharge& charge : charges)
  {
    placed.push_back({ mesh.Centroid(charge.triangle)[0], charge });
  }
  if (std::is_sorted(placed.begin(), placed.end(), precedes))
  {
    return;
  }
  std::sort(placed.begin(), placed.end(), precedes);
  std::transform(placed.begin(), placed.end(), charges.begin(),
    [](const Placed& entry) { return entry.charge; });
}

namespace
{

/// Gives the excess of a large charge to the nearest ones of the opposite sign.
void Spread(const TriangleMesh& mesh, std::vector<IndexCharge>& charges,
  const std::unordered_map<Id, std::size_t>& chargeOf, IndexCharge& large)
{
  // Farther away nothing is gained: what turns that fast is a sharp feature of a coarse mesh.
  constexpr std::size_t reach = 1000;
  std::vector<Id> reached{ large.triangle };
  IdTable<bool> isReached;
  isReached[large.triangle] = true;
  for (std::size_t i = 0; i < reached.size() && std::abs(large.halfTurns) > 1; ++i)
  {
    const int sign = large.halfTurns > 0 ? 1 : -1;
    const auto found = chargeOf.find(reached[i]);
    if (found != chargeOf.end() && charges[found->second].halfTurns == -sign)
    {
      charges[found->second].halfTurns = sign;
      large.halfTurns -= 2 * sign;
    }
    for (const Id corner : mesh.Corners(reached[i]))
    {
      mesh.LookAt(corner);
    }
    for (const NeighborAcross& next : NeighborsByPosition(mesh, reached[i]))
    {
      if (reached.size() < reach && !isReached.Contains(next.triangle))
      {
        isReached[next.triangle] = true;
        reached.push_back(next.triangle);
      }
    }
  }
}

} // namespace

void SpreadLargeCharges(const TriangleMesh& mesh, std::vector<IndexCharge>& charges)
{
  SortByPosition(mesh, charges);
  const auto isLarge = [](const IndexCharge& charge) { return std::abs(charge.halfTurns) > 1; };
  if (std::none_of(charges.begin(), charges.end(), isLarge))
  {
    return;
  }
  std::unordered_map<Id, std::size_t> chargeOf;
  for (std::size_t i = 0; i < charges.size(); ++i)
  {
    chargeOf[charges[i].triangle] = i;
  }
  for (IndexCharge& charge : charges)
  {
    if (isLarge(charge))
    {
      Spread(mesh, charges, chargeOf, charge);
    }
  }
  charges.erase(std::remove_if(charges.begin(), charges.end(),
                  [](const IndexCharge& charge) { return charge.halfTurns == 0; }),
    charges.end());
}

std::vector<IndexCharge> ChargesOfUnusable(const TriangleMesh& mesh, const DirectionIndex& index)
{
  std::vector<IndexCharge> charges;
  if (index.AllAreUsable())
  {
    return charges;
  }
  const auto isUnusable = [&index](Id t) { return !index.IsUsable(t); };
  for (const std::vector<Id>& region : RegionsWhere(mesh, isUnusable))
  {
    const int halfTurns = index.HalfTurns(region);
    std::vector<IndexCharge> candidates;
    candidates.reserve(region.size());
    for (const Id t : region)
    {
      candidates.push_back({ t, 0 });
    }
    SortByPosition(mesh, candidates);
    for (int i = 0; i < std::abs(halfTurns); ++i)
    {
      candidates[i % candidates.size()].halfTurns += halfTurns > 0 ? 1 : -1;
    }
    std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(charges),
      [](const IndexCharge& charge) { return charge.halfTurns != 0; });
  }
  return charges;
}

} // namespace ridges
