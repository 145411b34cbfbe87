// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ridges/ZoneDoubt.h"

#include "Ridges/RidgeZones.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ridges
{
namespace
{

using Verdict = ExtremalityErrors::Verdict;

} // namespace

bool ZoneDoubt::IsOutside(const Ridge& ridge)
{
  // Mostly one of a few places shows it.
  constexpr std::size_t most = 64;
  const std::size_t step = ridge.nodes.size() / most + 1;
  Id point = -1;
  for (std::size_t i = 0; i < ridge.nodes.size(); i += step)
  {
    if (!Ridge::IsUmbilic(ridge.nodes[i]))
    {
      point = this->Mesh_.EdgeAt(ridge.nodes[i]).v0;
      if (this->IsNearOthers(point))
      {
        return true;
      }
    }
  }
  return point >= 0 && this->IsInNone(point);
}

bool ZoneDoubt::IsNearOthers(Id p)
{
  if (const bool* known = this->IsNear_.Find(p))
  {
    return *known;
  }
  const bool isNear = this->LooksNearOthers(p);
  this->IsNear_[p] = isNear;
  return isNear;
}

/// Whether a point within the margin can be in no zone.
bool ZoneDoubt::LooksNearOthers(Id p)
{
  std::vector<Id> reached{ p };
  std::size_t begin = 0;
  for (int ring = 0; ring <= RidgeZones::Margin; ++ring)
  {
    const std::size_t end = reached.size();
    for (std::size_t i = begin; i < end; ++i)
    {
      if (this->VerdictOf_(reached[i]) == Verdict::Significant)
      {
        return true;
      }
    }
    for (std::size_t i = begin; i < end && ring < RidgeZones::Margin; ++i)
    {
      this->Mesh_.LookAt(reached[i]);
      for (const Id t : this->Mesh_.TrianglesAround(reached[i]))
      {
        for (const Id q : this->Mesh_.Corners(t))
        {
          if (std::find(reached.begin(), reached.end(), q) == reached.end())
          {
            reached.push_back(q);
          }
        }
      }
    }
    begin = end;
  }
  return false;
}

bool ZoneDoubt::IsInNone(Id p)
{
  if (const bool* known = this->IsInNone_.Find(p))
  {
    return *known;
  }
  return this->GrowsIntoNone(p);
}

/// The region of a point, as RidgeZones has it.
bool ZoneDoubt::GrowsIntoNone(Id first)
{
  std::vector<Id> region{ first };
  IdTable<bool> isReached;
  isReached[first] = true;
  std::size_t roundOff = 0;
  std::size_t insignificant = 0;
  bool isAllOfItsPart = true;
  bool dependsOnOthers = false;
  // With so many, its share of the mesh decides, which is not known here.
  const auto isKnown = [&roundOff, &insignificant]
  { return roundOff + insignificant < RidgeZones::LeastPoints; };
  for (std::size_t i = 0; i < region.size() && isKnown(); ++i)
  {
    const Verdict verdict = this->VerdictOf_(region[i]);
    roundOff += verdict == Verdict::RoundOff ? 1 : 0;
    insignificant += verdict == Verdict::Insignificant ? 1 : 0;
    if (verdict == Verdict::Faint || verdict == Verdict::Unresolved)
    {
      dependsOnOthers = true; // that they are connected to, which are not looked at here
      break;
    }
    this->Mesh_.LookAt(region[i]);
    for (const Id t : this->Mesh_.TrianglesAround(region[i]))
    {
      for (const Id q : this->Mesh_.Corners(t))
      {
        if (isReached.Contains(q))
        {
          continue;
        }
        isReached[q] = true;
        if (this->IsNearOthers(q))
        {
          isAllOfItsPart = false;
        }
        else
        {
          region.push_back(q);
        }
      }
    }
  }
  const bool isRoundOff = insignificant == 0 && roundOff >= RidgeZones::LeastRoundOff;
  const bool isSmall = region.size() < RidgeZones::LeastPoints &&
    roundOff + insignificant < RidgeZones::LeastPointsOfWhole;
  const bool isNone = !dependsOnOthers && isKnown() && !isRoundOff && (isSmall || !isAllOfItsPart);
  for (const Id p : region)
  {
    this->IsInNone_[p] = isNone;
  }
  return isNone;
}

} // namespace ridges
