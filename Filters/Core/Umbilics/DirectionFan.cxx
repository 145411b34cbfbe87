// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Umbilics/DirectionFan.h"

#include "Mesh/PositionOrder.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

namespace ridges
{
namespace
{

constexpr double Pi = 3.14159265358979323846;

/// Points with more triangles are looked at once and for all.
constexpr Id LargestSmallFan = 32;

/// An edge from the point in the middle of a fan.
struct Spoke
{
  Id end = 0;
  Eigen::Vector3d direction = Eigen::Vector3d::Zero(); ///< Unit, or zero.
  double length = 0.0;                                 ///< As a part of the longest.
  double alpha = 0.0; ///< Angle from the first spoke, as the triangles have it.
};

/// Fixes all spokes of a fan of so many triangles: one more, which in a closed fan is the first.
void GatherSpokes(const TriangleMesh& mesh, const FanCorner* fan, Id size, Spoke* spokes)
{
  const auto endOf = [&](Id i)
  {
    const FanCorner& at = fan[std::min(i, size - 1)];
    return mesh.Corners(at.triangle)[(at.corner + (i < size ? 1 : 2)) % 3];
  };
  const Eigen::Vector3d center = mesh.Point(mesh.Corners(fan[0].triangle)[fan[0].corner]);
  // In units of the longest coordinate, so that no square is too large or too small.
  double unit = 0.0;
  for (Id i = 0; i <= size; ++i)
  {
    unit = std::max(unit, (mesh.Point(endOf(i)) - center).cwiseAbs().maxCoeff());
  }
  for (Id i = 0; i <= size; ++i)
  {
    Spoke spoke;
    spoke.end = endOf(i);
    const Eigen::Vector3d edge = mesh.Point(spoke.end) - center;
    const double own = edge.cwiseAbs().maxCoeff();
    if (own > 0.0)
    {
      spoke.direction = (edge / own).normalized();
      spoke.length = (edge / unit).norm();
    }
    spokes[i] = spoke;
  }
}

/// The angles between the spokes, each 0 with a triangle that has none.
void MeasureAngles(Spoke* spokes, Id size)
{
  for (Id i = 0; i < size; ++i)
  {
    const Eigen::Vector3d& a = spokes[i].direction;
    const Eigen::Vector3d& b = spokes[i + 1].direction;
    spokes[i + 1].alpha = spokes[i].alpha + std::atan2(a.cross(b).norm(), a.dot(b));
  }
}

/// The angles of a closed fan, to a full turn.
void StretchToFullTurn(Spoke* spokes, Id size)
{
  const double total = spokes[size].alpha;
  for (Id i = 0; i <= size; ++i)
  {
    spokes[i].alpha =
      2.0 * Pi * (total > 0.0 ? spokes[i].alpha / total : static_cast<double>(i) / size);
  }
}

/// On which side of the frame the triangles are: 1 or -1.
double SideOf(const MongeField& field, Id point, const Spoke* spokes, Id size)
{
  double area = 0.0;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (Id i = 0; i < size; ++i)
  {
    const Eigen::Vector3d ofTriangle =
      spokes[i].length * spokes[i + 1].length * spokes[i].direction.cross(spokes[i + 1].direction);
    normal += ofTriangle;
    area += ofTriangle.norm();
  }
  // A fan that is folded flat has no side: round-off must not choose it by where the fan starts.
  constexpr double roundOff = 1e-9;
  return field.D1(point).cross(field.D2(point)).dot(normal) >= -roundOff * area ? 1.0 : -1.0;
}

/// The angle of d1 from the first spoke.
double AngleOfD1(const TriangleMesh& mesh, const MongeField& field, Id point, const Spoke* spokes,
  FanExtent extent)
{
  const Eigen::Vector3d d1 = field.D1(point);
  const Eigen::Vector3d d2 = field.D2(point);
  const double side = SideOf(field, point, spokes, extent.size);
  const auto projected = [&](const Spoke& spoke)
  { return std::complex<double>(spoke.direction.dot(d1), side * spoke.direction.dot(d2)); };
  // The turn by alpha and back by the angle of the spoke with d1; the former alone where there is
  // no angle.
  const auto turnOf = [&](const Spoke& spoke)
  {
    const std::complex<double> z = projected(spoke);
    const double length = std::abs(z);
    return std::polar(1.0, spoke.alpha) * (length > 0.0 ? std::conj(z) / length : 1.0);
  };
  const auto comesBefore = [&](const Spoke& a, const Spoke& b)
  {
    const bool aHasAngle = projected(a) != 0.0;
    const bool bHasAngle = projected(b) != 0.0;
    const auto x = mesh.Point(a.end);
    const auto y = mesh.Point(b.end);
    return aHasAngle != bHasAngle ? aHasAngle
                                  : ComesBefore(x, y) || (!ComesBefore(y, x) && a.end < b.end);
  };
  const Spoke* end = spokes + extent.size + (extent.closed ? 0 : 1);
  std::complex<double> sum = 0.0;
  for (const Spoke* spoke = spokes; spoke != end; ++spoke)
  {
    sum += projected(*spoke) != 0.0 ? turnOf(*spoke) : 0.0;
  }
  // Where they agree nowhere, as in a fold, one spoke decides, wherever the fan starts.
  constexpr double agreement = 1e-3;
  return std::arg(
    std::abs(sum) > agreement ? sum : turnOf(*std::min_element(spokes, end, comesBefore)));
}

/// What the triangles of a fan have, in their order.
void LookAtFan(const TriangleMesh& mesh, const MongeField& field, const FanCorner* fan,
  FanExtent extent, Spoke* spokes, CornerDirection* found)
{
  GatherSpokes(mesh, fan, extent.size, spokes);
  MeasureAngles(spokes, extent.size);
  if (extent.closed)
  {
    StretchToFullTurn(spokes, extent.size);
  }
  const Id point = mesh.Corners(fan[0].triangle)[fan[0].corner];
  const double angle = AngleOfD1(mesh, field, point, spokes, extent);
  for (Id i = 0; i < extent.size; ++i)
  {
    found[i].corner = spokes[i + 1].alpha - spokes[i].alpha;
    found[i].angle = angle - spokes[i].alpha;
  }
}

} // namespace

DirectionFans::DirectionFans(const TriangleMesh& mesh, const MongeField& field)
  : Mesh_(mesh)
  , Field_(field)
{
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    if (mesh.TrianglesAround(p).size() > LargestSmallFan)
    {
      this->Large_[p] = this->AtAllTriangles(p);
    }
  }
}

std::vector<CornerDirection> DirectionFans::AtAllTriangles(Id point) const
{
  const Span<Id> around = this->Mesh_.TrianglesAround(point);
  std::vector<CornerDirection> all(around.size());
  std::vector<bool> isDone(around.size(), false);
  std::vector<FanCorner> fan(around.size());
  std::vector<Spoke> spokes(around.size() + 1);
  std::vector<CornerDirection> found(around.size());
  for (Id i = 0; i < around.size(); ++i)
  {
    if (isDone[i])
    {
      continue;
    }
    const int corner = CornerOf(this->Mesh_.Corners(around[i]), point);
    const FanExtent extent = GatherFan(this->Mesh_, { around[i], corner }, fan.data());
    LookAtFan(this->Mesh_, this->Field_, fan.data(), extent, spokes.data(), found.data());
    for (Id j = 0; j < extent.size; ++j)
    {
      const auto place =
        std::lower_bound(around.begin(), around.end(), fan[j].triangle) - around.begin();
      all[place] = found[j];
      isDone[place] = true;
    }
  }
  return all;
}

CornerDirection DirectionFans::At(FanCorner corner) const
{
  const Id point = this->Mesh_.Corners(corner.triangle)[corner.corner];
  const Span<Id> around = this->Mesh_.TrianglesAround(point);
  if (around.size() > LargestSmallFan)
  {
    const auto place = std::lower_bound(around.begin(), around.end(), corner.triangle);
    return this->Large_.at(point)[place - around.begin()];
  }
  std::array<FanCorner, LargestSmallFan> fan;
  std::array<Spoke, LargestSmallFan + 1> spokes;
  std::array<CornerDirection, LargestSmallFan> found;
  const FanExtent extent = GatherFan(this->Mesh_, corner, fan.data());
  LookAtFan(this->Mesh_, this->Field_, fan.data(), extent, spokes.data(), found.data());
  const auto* place = std::find_if(fan.data(), fan.data() + extent.size,
    [corner](const FanCorner& at) { return at.triangle == corner.triangle; });
  return found[place - fan.data()];
}

} // namespace ridges
