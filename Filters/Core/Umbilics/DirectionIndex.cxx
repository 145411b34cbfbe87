// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Umbilics/DirectionIndex.h"

#include "Mesh/PositionOrder.h"
#include "Monge/AcuteRule.h"

#include <Eigen/Geometry>

#include <cmath>
#include <complex>

namespace ridges
{
namespace
{

constexpr double Pi = 3.14159265358979323846;

} // namespace

DirectionIndex::DirectionIndex(
  const TriangleMesh& mesh, const MongeField& field, const std::uint8_t* usable)
  : Mesh_(mesh)
  , Field_(field)
  , Usable_(usable)
{
}

bool DirectionIndex::MayTurn(Id triangle, const std::vector<std::uint8_t>& isTame) const
{
  // Two half turns need 120 degrees on some edge, of which what tame points leave open can be but
  // a part.
  constexpr double cosineOfTurn = 0.5;
  const Triangle& c = this->Mesh_.Corners(triangle);
  bool singular = false;
  for (int i = 0; i < 3; ++i)
  {
    const double cosine = this->Field_.D1(c[i]).dot(this->Field_.D1(c[(i + 1) % 3]));
    if (!(std::abs(cosine) > cosineOfTurn) || !isTame[c[i]])
    {
      return true;
    }
    singular = singular != (cosine < 0.0);
  }
  return singular;
}

Id DirectionIndex::AcrossInFan(Id triangle, int corner, int side, int& cornerOfNeighbor) const
{
  const Triangle& corners = this->Mesh_.Corners(triangle);
  const Id neighbor = this->Mesh_.Neighbor(triangle, side);
  if (neighbor < 0)
  {
    return neighbor;
  }
  // Where the orientation changes a fan ends, as it does on the border: the point at the other end
  // of the side comes before this one there if it comes after it here.
  const Triangle& others = this->Mesh_.Corners(neighbor);
  cornerOfNeighbor = CornerOf(others, corners[corner]);
  const int toOtherEnd = side == corner ? 1 : 2;
  const bool sameSense =
    others[(cornerOfNeighbor + 3 - toOtherEnd) % 3] == corners[(corner + toOtherEnd) % 3];
  return sameSense ? neighbor : TriangleMesh::Border;
}

Id DirectionIndex::NextInFan(Id triangle, int corner, int& cornerOfNext) const
{
  return this->AcrossInFan(triangle, corner, (corner + 2) % 3, cornerOfNext);
}

Id DirectionIndex::PreviousInFan(Id triangle, int corner, int& cornerOfPrevious) const
{
  return this->AcrossInFan(triangle, corner, corner, cornerOfPrevious);
}

double DirectionIndex::Angle(Id triangle, int corner) const
{
  const Triangle& corners = this->Mesh_.Corners(triangle);
  const Eigen::Vector3d a =
    this->Mesh_.Point(corners[(corner + 1) % 3]) - this->Mesh_.Point(corners[corner]);
  const Eigen::Vector3d b =
    this->Mesh_.Point(corners[(corner + 2) % 3]) - this->Mesh_.Point(corners[corner]);
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

// The directions of the edges are known twice, by the stretched angles between them and by their
// projection on the tangent plane: the angle of d1 is that at which both agree best.
DirectionIndex::Fan DirectionIndex::FanAt(Id triangle, int corner, Scratch& angles) const
{
  const Id p = this->Mesh_.Corners(triangle)[corner];

  Id first = triangle;
  int cornerOfFirst = corner;
  bool closed = false;
  double before = 0.0; ///< Angle from the first edge of an open fan to that asked for.
  for (;;)
  {
    int cornerOfPrevious = 0;
    const Id previous = this->PreviousInFan(first, cornerOfFirst, cornerOfPrevious);
    if (previous < 0)
    {
      break;
    }
    first = previous;
    cornerOfFirst = cornerOfPrevious;
    if (previous == triangle)
    {
      closed = true;
      break;
    }
    before += this->Angle(first, cornerOfFirst);
  }
  if (closed)
  {
    before = 0.0;
  }

  double total = 0.0;
  double area = 0.0;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  angles.clear();
  Id t = first;
  int c = cornerOfFirst;
  do
  {
    angles.push_back(this->Angle(t, c));
    total += angles.back();
    const Eigen::Vector3d ofTriangle = this->Mesh_.AreaNormal(t);
    normal += ofTriangle;
    area += ofTriangle.norm();
    t = this->NextInFan(t, c, c);
  } while (t >= 0 && t != first);

  Fan fan;
  fan.stretch = closed && total > 0.0 ? 2.0 * Pi / total : 1.0;

  const Eigen::Vector3d d1 = this->Field_.D1(p);
  const Eigen::Vector3d d2 = this->Field_.D2(p);
  // A fan that is folded flat has no side: round-off must not choose it by where the fan starts.
  constexpr double roundOff = 1e-9;
  const double side = d1.cross(d2).dot(normal) >= -roundOff * area ? 1.0 : -1.0;
  std::complex<double> sum = 0.0;
  // Where they agree nowhere, as in a fold, one edge decides, wherever the fan starts.
  std::complex<double> ofFirst = 1.0;
  Id firstEnd = -1;
  double alpha = -before;
  const auto add = [&](Id end)
  {
    // The turn by alpha and back by the angle of the edge with d1, as a product.
    const Eigen::Vector3d edge = this->Mesh_.Point(end) - this->Mesh_.Point(p);
    const std::complex<double> projected(edge.dot(d1), side * edge.dot(d2));
    const double length = std::abs(projected);
    if (!(length > 0.0))
    {
      return;
    }
    const std::complex<double> turn =
      std::polar(1.0, fan.stretch * alpha) * std::conj(projected) / length;
    sum += turn;
    if (firstEnd < 0 || ComesBefore(this->Mesh_.Point(end), this->Mesh_.Point(firstEnd)))
    {
      firstEnd = end;
      ofFirst = turn;
    }
  };
  t = first;
  c = cornerOfFirst;
  for (const double angle : angles)
  {
    const Triangle& corners = this->Mesh_.Corners(t);
    add(corners[(c + 1) % 3]);
    alpha += angle;
    if (t == triangle)
    {
      fan.corner = angle;
    }
    const int cornerOfLast = c;
    t = this->NextInFan(t, c, c);
    if (t < 0)
    {
      add(corners[(cornerOfLast + 2) % 3]);
    }
  }
  constexpr double agreement = 1e-3;
  fan.angle = std::arg(std::abs(sum) > agreement ? sum : ofFirst);
  return fan;
}

DirectionIndex::Fans DirectionIndex::FansAt(Id triangle, Scratch& scratch) const
{
  return { this->FanAt(triangle, 0, scratch), this->FanAt(triangle, 1, scratch),
    this->FanAt(triangle, 2, scratch) };
}

double DirectionIndex::TurnWithin(Id triangle, int side, const Fans& fans) const
{
  const Triangle& corners = this->Mesh_.Corners(triangle);
  const int end = (side + 1) % 3;
  if (this->Usable_ && !(this->Usable_[corners[side]] && this->Usable_[corners[end]]))
  {
    return 0.0;
  }
  // Of d1 at q from the edge back to p, and of that at p carried to q.
  const double atQ = fans[end].angle - fans[end].stretch * fans[end].corner;
  const double carried = fans[side].angle + Pi;
  const double flip = AcuteSign(this->Field_, corners[side], corners[end]) > 0 ? 0.0 : Pi;
  return std::remainder(atQ + flip - carried, 2.0 * Pi);
}

double DirectionIndex::TurnForBoth(Id triangle, int side, Scratch& scratch) const
{
  const Edge& edge = this->Mesh_.EdgeAt(this->Mesh_.EdgeOf(triangle, side));
  const Triangle& corners = this->Mesh_.Corners(triangle);
  if (edge.t1 >= 0 && edge.t0 != triangle)
  {
    const Triangle& other = this->Mesh_.Corners(edge.t0);
    const int sideInOther = CornerOf(other, corners[(side + 1) % 3]);
    if (other[(sideInOther + 1) % 3] == corners[side])
    {
      return -this->TurnWithin(edge.t0, sideInOther, this->FansAt(edge.t0, scratch));
    }
  }
  return this->TurnWithin(triangle, side, this->FansAt(triangle, scratch));
}

// All turns around a triangle.
double DirectionIndex::Turned(Id triangle, Scratch& scratch) const
{
  // A turn by half a turn is one in either sense, and round-off decides in which: then one triangle
  // of the edge has to decide for both.
  constexpr double nearlyHalf = Pi - 1e-6;
  const Fans fans = this->FansAt(triangle, scratch);
  double turned = -Pi;
  for (int side = 0; side < 3; ++side)
  {
    const double turn = this->TurnWithin(triangle, side, fans);
    turned += fans[side].stretch * fans[side].corner;
    turned += std::abs(turn) < nearlyHalf ? turn : this->TurnForBoth(triangle, side, scratch);
  }
  return turned;
}

int DirectionIndex::HalfTurns(Id triangle, Scratch& scratch) const
{
  return static_cast<int>(std::lround(this->Turned(triangle, scratch) / Pi));
}

int DirectionIndex::HalfTurns(const std::vector<Id>& region) const
{
  // Edges inside count in both senses, for nothing.
  Scratch scratch;
  double turned = 0.0;
  for (const Id t : region)
  {
    turned += this->Turned(t, scratch);
  }
  return static_cast<int>(std::lround(turned / Pi));
}

} // namespace ridges
