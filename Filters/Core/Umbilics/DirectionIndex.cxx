// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Umbilics/DirectionIndex.h"

#include "Mesh/PositionOrder.h"
#include "Monge/AcuteRule.h"

#include <Eigen/Geometry>

#include <cmath>

namespace ridges
{
namespace
{

constexpr double Pi = 3.14159265358979323846;

} // namespace

bool DirectionsMayTurn(const MongeField& field, const Triangle& corners)
{
  // Two half turns need 120 degrees on some edge, of which what tame points leave open can be but
  // a part.
  constexpr double cosineOfTurn = 0.5;
  bool singular = false;
  for (int i = 0; i < 3; ++i)
  {
    const double cosine = field.D1(corners[i]).dot(field.D1(corners[(i + 1) % 3]));
    if (!(std::abs(cosine) > cosineOfTurn))
    {
      return true;
    }
    singular = singular != (cosine < 0.0);
  }
  return singular;
}

DirectionIndex::DirectionIndex(
  const TriangleMesh& mesh, const MongeField& field, const std::uint8_t* usable)
  : Mesh_(mesh)
  , Field_(field)
  , Usable_(usable)
  , Fans_(mesh, field)
{
}

bool DirectionIndex::MayTurn(Id triangle, const std::vector<std::uint8_t>& isTame) const
{
  const Triangle& c = this->Mesh_.Corners(triangle);
  return !isTame[c[0]] || !isTame[c[1]] || !isTame[c[2]] || DirectionsMayTurn(this->Field_, c);
}

DirectionIndex::Directions DirectionIndex::DirectionsAt(
  Id triangle, DirectionFans::Memory& memory) const
{
  return { this->Fans_.At({ triangle, 0 }, memory), this->Fans_.At({ triangle, 1 }, memory),
    this->Fans_.At({ triangle, 2 }, memory) };
}

double DirectionIndex::TurnWithin(Id triangle, int side, const Directions& at) const
{
  const Triangle& corners = this->Mesh_.Corners(triangle);
  const int end = (side + 1) % 3;
  if (this->Usable_ && !(this->Usable_[corners[side]] && this->Usable_[corners[end]]))
  {
    return 0.0;
  }
  // Of d1 at q from the edge back to p, and of that at p carried to q.
  const double atQ = at[end].angle - at[end].corner;
  const double carried = at[side].angle + Pi;
  const double flip = AcuteSign(this->Field_, corners[side], corners[end]) > 0 ? 0.0 : Pi;
  return std::remainder(atQ + flip - carried, 2.0 * Pi);
}

// The turn on a side as the triangle that comes first by position has it.
double DirectionIndex::TurnForBoth(Id triangle, int side, DirectionFans::Memory& memory) const
{
  const Id neighbor = this->Mesh_.Neighbor(triangle, side);
  if (neighbor >= 0)
  {
    const Triangle& corners = this->Mesh_.Corners(triangle);
    const Triangle& others = this->Mesh_.Corners(neighbor);
    const int sideThere = CornerOf(others, corners[(side + 1) % 3]);
    const bool neighborIsFirst = ComesBefore(this->Mesh_, neighbor, triangle) ||
      (!ComesBefore(this->Mesh_, triangle, neighbor) && neighbor < triangle);
    if (neighborIsFirst && others[(sideThere + 1) % 3] == corners[side])
    {
      return -this->TurnWithin(neighbor, sideThere, this->DirectionsAt(neighbor, memory));
    }
  }
  return this->TurnWithin(triangle, side, this->DirectionsAt(triangle, memory));
}

// All turns around a triangle.
double DirectionIndex::Turned(Id triangle, DirectionFans::Memory& memory) const
{
  // A turn by half a turn is one in either sense, and round-off decides in which: then one triangle
  // of the edge has to decide for both.
  constexpr double nearlyHalf = Pi - 1e-6;
  const Directions at = this->DirectionsAt(triangle, memory);
  double turned = -Pi;
  for (int side = 0; side < 3; ++side)
  {
    const double turn = this->TurnWithin(triangle, side, at);
    turned += at[side].corner;
    turned += std::abs(turn) < nearlyHalf ? turn : this->TurnForBoth(triangle, side, memory);
  }
  return turned;
}

bool DirectionIndex::IsFoldOnBorder(Id triangle) const
{
  const Triangle& c = this->Mesh_.Corners(triangle);
  return (this->Mesh_.OnBorder(c[0]) || this->Mesh_.OnBorder(c[1]) || this->Mesh_.OnBorder(c[2])) &&
    !DirectionsMayTurn(this->Field_, c);
}

int DirectionIndex::HalfTurns(Id triangle, DirectionFans::Memory& memory) const
{
  const auto halfTurns = static_cast<int>(std::lround(this->Turned(triangle, memory) / Pi));
  return halfTurns != 0 && this->IsFoldOnBorder(triangle) ? 0 : halfTurns;
}

int DirectionIndex::HalfTurns(Id triangle) const
{
  DirectionFans::Memory memory(4);
  return this->HalfTurns(triangle, memory);
}

int DirectionIndex::HalfTurns(const std::vector<Id>& region) const
{
  // Edges inside count in both senses, for nothing.
  double turned = 0.0;
  DirectionFans::Memory memory;
  for (const Id t : region)
  {
    const double here = this->Turned(t, memory);
    const double halfTurns = std::round(here / Pi);
    turned += here;
    turned -= halfTurns != 0.0 && this->IsFoldOnBorder(t) ? halfTurns * Pi : 0.0;
  }
  return static_cast<int>(std::lround(turned / Pi));
}

} // namespace ridges
