// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Umbilics/PatchChoice.h"

#include "Monge/AcuteRule.h"

#include <algorithm>

namespace ridges
{

PatchChoice::PatchChoice(const PatchSurroundings& surroundings)
  : Surroundings_(surroundings)
  , Patch_(surroundings.mesh)
{
}

std::vector<Id> PatchChoice::Choose(
  const IndexCharge& charge, int ridgeCount, double size, double limit)
{
  const double radius = size * this->Patch_.OneRingGrade(charge.triangle);
  const double farthest = std::min(2.0 * radius, limit);
  const std::array<int, 2> wanted = { ridgeCount, ridgeCount };
  this->Reset();
  Id matching = 0;
  Id valid = 1;
  this->Patch_.Start(charge.triangle);
  do
  {
    const Span<Id> patch = this->Patch_.Triangles();
    const Id t = patch[patch.size() - 1];
    const bool isWithin = this->Patch_.Threshold() <= radius;
    const bool isUsable =
      AreUsable(this->Surroundings_.mesh.Corners(t), this->Surroundings_.usable);
    if ((!isWithin && matching > 0) || (patch.size() > 1 && !isUsable))
    {
      break;
    }
    this->CountTurns(t);
    this->CountRegion(t);
    this->CountCrossings(t);
    if (this->IsValid(charge))
    {
      matching = this->Crossings_ == wanted ? patch.size() : matching;
      valid = isWithin ? patch.size() : valid;
    }
  } while (this->Patch_.GrowByOne(matching > 0 ? std::min(radius, farthest) : farthest));
  const Id* first = this->Patch_.Triangles().begin();
  return std::vector<Id>(first, first + (matching > 0 ? matching : valid));
}

void PatchChoice::Reset()
{
  this->InsideOfRegion_.Clear();
  this->HalfTurns_ = 0;
  this->PartialRegions_ = 0;
  this->Crossings_ = { 0, 0 };
}

void PatchChoice::CountTurns(Id triangle)
{
  this->HalfTurns_ += this->Surroundings_.halfTurns[triangle];
}

void PatchChoice::CountRegion(Id triangle)
{
  const Cancellation& cancellation = this->Surroundings_.cancellation;
  const Id region = cancellation.RegionOf(triangle);
  if (region != Cancellation::NoRegion)
  {
    const Id inside = ++this->InsideOfRegion_[region];
    this->PartialRegions_ += inside == 1 ? 1 : 0;
    this->PartialRegions_ -= inside == cancellation.regions[region].size() ? 1 : 0;
  }
}

void PatchChoice::CountCrossings(Id triangle)
{
  const TriangleMesh& mesh = this->Surroundings_.mesh;
  const MongeField& field = this->Surroundings_.field;
  const Triangle& corners = mesh.Corners(triangle);
  for (int side = 0; side < 3; ++side)
  {
    // A side that is inside now was on the contour before.
    const Id neighbor = mesh.Neighbor(triangle, side);
    const int change = neighbor >= 0 && this->Patch_.Contains(neighbor) ? -1 : 1;
    const Id p = corners[side];
    const Id q = corners[(side + 1) % 3];
    this->Crossings_[0] += IsCrossed(field, Color::Blue, p, q) ? change : 0;
    this->Crossings_[1] += IsCrossed(field, Color::Red, p, q) ? change : 0;
  }
}

} // namespace ridges
