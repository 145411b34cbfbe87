// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Umbilics/IndexCharge.h"

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
  std::sort(charges.begin(), charges.end(),
    [&mesh](const IndexCharge& a, const IndexCharge& b)
    { return ComesBefore(mesh, a.triangle, b.triangle); });
}

void SpreadLargeCharges(const TriangleMesh& mesh, std::vector<IndexCharge>& charges)
{
  // Far away nothing is gained: what turns that fast is a sharp feature of a coarse mesh.
  constexpr std::size_t reach = 1000;
  SortByPosition(mesh, charges);
  std::unordered_map<Id, std::size_t> chargeOf;
  for (std::size_t i = 0; i < charges.size(); ++i)
  {
    chargeOf[charges[i].triangle] = i;
  }
  for (IndexCharge& large : charges)
  {
    std::vector<Id> reached;
    std::unordered_map<Id, bool> isReached;
    if (std::abs(large.halfTurns) > 1)
    {
      reached.push_back(large.triangle);
      isReached[large.triangle] = true;
    }
    for (std::size_t i = 0; i < reached.size() && std::abs(large.halfTurns) > 1; ++i)
    {
      const int sign = large.halfTurns > 0 ? 1 : -1;
      const auto found = chargeOf.find(reached[i]);
      if (found != chargeOf.end() && charges[found->second].halfTurns == -sign)
      {
        charges[found->second].halfTurns = sign;
        large.halfTurns -= 2 * sign;
      }
      for (const NeighborAcross& next : NeighborsByPosition(mesh, reached[i]))
      {
        if (reached.size() < reach && !isReached[next.triangle])
        {
          isReached[next.triangle] = true;
          reached.push_back(next.triangle);
        }
      }
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
