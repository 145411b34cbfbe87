// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Umbilics/DirectionFan.h"

#include "Monge/FieldOrder.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <complex>

namespace ridges
{
namespace
{

constexpr double Pi = 3.14159265358979323846;

/// Points with more triangles are looked at once and for all.
constexpr Id LargestSmallFan = 32;

} // namespace

// Points that nothing distinguishes are ordered by their numbers, as all triangles of a fan must
// agree.
bool DirectionFans::IsFirst(Id p, Id q) const
{
  return ComesBefore(this->Mesh_, this->Field_, p, q) ||
    (!ComesBefore(this->Mesh_, this->Field_, q, p) && p < q);
}

// A closed fan begins where its first spoke ends at the point that comes first by position, so that
// not even round-off depends on the triangle asked for.
FanExtent DirectionFans::GatherFromFirst(FanCorner corner, std::vector<FanCorner>& fan) const
{
  const FanExtent extent = GatherFan(this->Mesh_, corner, fan.data());
  if (extent.closed)
  {
    const auto comesBefore = [this](const FanCorner& a, const FanCorner& b)
    {
      const Id p = this->Mesh_.Corners(a.triangle)[(a.corner + 1) % 3];
      const Id q = this->Mesh_.Corners(b.triangle)[(b.corner + 1) % 3];
      return this->IsFirst(p, q);
    };
    const auto end = fan.begin() + extent.size;
    std::rotate(fan.begin(), std::min_element(fan.begin(), end, comesBefore), end);
  }
  return extent;
}

/// Finds all spokes of a fan of so many triangles: one more, which in a closed fan is the first.
void DirectionFans::GatherSpokes(
  const std::vector<FanCorner>& fan, Id size, std::vector<Spoke>& spokes) const
{
  const auto endOf = [this, &fan, size](Id i)
  {
    const FanCorner& at = fan[std::min(i, size - 1)];
    return this->Mesh_.Corners(at.triangle)[(at.corner + (i < size ? 1 : 2)) % 3];
  };
  const Eigen::Vector3d center =
    this->Mesh_.Point(this->Mesh_.Corners(fan[0].triangle)[fan[0].corner]);
  // In units of the longest coordinate, so that no square is too large or too small.
  double unit = 0.0;
  for (Id i = 0; i <= size; ++i)
  {
    Spoke& spoke = spokes[i];
    spoke.end = endOf(i);
    spoke.direction = this->Mesh_.Point(spoke.end) - center;
    unit = std::max(unit, spoke.direction.cwiseAbs().maxCoeff());
  }
  for (Id i = 0; i <= size; ++i)
  {
    Spoke& spoke = spokes[i];
    const double own = spoke.direction.cwiseAbs().maxCoeff();
    spoke.length = own > 0.0 ? (spoke.direction / unit).norm() : 0.0;
    if (own > 0.0)
    {
      spoke.direction = (spoke.direction / own).normalized();
    }
  }
}

/// The angles between the spokes, each 0 with a triangle that has none; of a closed fan stretched
/// to a full turn.
void DirectionFans::MeasureAngles(std::vector<Spoke>& spokes, FanExtent extent)
{
  spokes[0].alpha = 0.0;
  for (Id i = 0; i < extent.size; ++i)
  {
    const Eigen::Vector3d& a = spokes[i].direction;
    const Eigen::Vector3d& b = spokes[i + 1].direction;
    spokes[i + 1].alpha = spokes[i].alpha + std::atan2(a.cross(b).norm(), a.dot(b));
  }
  if (!extent.closed)
  {
    return;
  }
  const double total = spokes[extent.size].alpha;
  for (Id i = 0; i <= extent.size; ++i)
  {
    spokes[i].alpha =
      2.0 * Pi * (total > 0.0 ? spokes[i].alpha / total : static_cast<double>(i) / extent.size);
  }
}

/// On which side of the frame the triangles are: 1 or -1.
double DirectionFans::SideOf(Id point, const std::vector<Spoke>& spokes, Id size) const
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
  const Eigen::Vector3d ofFrame = this->Field_.D1(point).cross(this->Field_.D2(point));
  return ofFrame.dot(normal) >= -roundOff * area ? 1.0 : -1.0;
}

/// The angle of d1 from the first spoke.
double DirectionFans::AngleOfD1(Id point, const std::vector<Spoke>& spokes, FanExtent extent) const
{
  const Eigen::Vector3d d1 = this->Field_.D1(point);
  const Eigen::Vector3d d2 = this->Field_.D2(point);
  const double side = this->SideOf(point, spokes, extent.size);
  const auto projected = [&d1, &d2, side](const Spoke& spoke)
  { return std::complex<double>(spoke.direction.dot(d1), side * spoke.direction.dot(d2)); };
  // The turn by alpha and back by the angle of the spoke with d1; the former alone where there is
  // no angle.
  const auto turnOf = [](const Spoke& spoke, const std::complex<double>& z)
  {
    const double length = std::sqrt(std::norm(z));
    return std::polar(1.0, spoke.alpha) * (length > 0.0 ? std::conj(z) / length : 1.0);
  };
  const auto comesBefore = [this, &projected](const Spoke& a, const Spoke& b)
  {
    const bool aHasAngle = projected(a) != 0.0;
    const bool bHasAngle = projected(b) != 0.0;
    return aHasAngle != bHasAngle ? aHasAngle : this->IsFirst(a.end, b.end);
  };
  const auto end = spokes.begin() + extent.size + (extent.closed ? 0 : 1);
  std::complex<double> sum = 0.0;
  for (auto spoke = spokes.begin(); spoke != end; ++spoke)
  {
    const std::complex<double> z = projected(*spoke);
    sum += z != 0.0 ? turnOf(*spoke, z) : 0.0;
  }
  // Where they agree nowhere, as in a fold, one spoke decides, wherever the fan starts.
  constexpr double agreement = 1e-3;
  if (!(std::norm(sum) > agreement * agreement))
  {
    const Spoke& first = *std::min_element(spokes.begin(), end, comesBefore);
    sum = turnOf(first, projected(first));
  }
  return std::arg(sum);
}

DirectionFans::DirectionFans(const TriangleMesh& mesh, const MongeField& field)
  : Mesh_(mesh)
  , Field_(field)
{
  Memory memory(1);
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    if (mesh.TrianglesAround(p).size() > LargestSmallFan)
    {
      this->LookAround(p, memory, this->Large_[p]);
    }
  }
}

void DirectionFans::LookAround(Id point, Memory& memory, std::vector<CornerDirection>& all) const
{
  const Span<Id> around = this->Mesh_.TrianglesAround(point);
  all.resize(around.size());
  memory.Fan_.resize(around.size());
  memory.Spokes_.resize(around.size() + 1);
  memory.IsDone_.assign(around.size(), 0);
  for (Id i = 0; i < around.size(); ++i)
  {
    if (memory.IsDone_[i])
    {
      continue;
    }
    const int corner = CornerOf(this->Mesh_.Corners(around[i]), point);
    const FanExtent extent = this->GatherFromFirst({ around[i], corner }, memory.Fan_);
    const std::vector<Spoke>& spokes = memory.Spokes_;
    this->GatherSpokes(memory.Fan_, extent.size, memory.Spokes_);
    MeasureAngles(memory.Spokes_, extent);
    const double angle = this->AngleOfD1(point, spokes, extent);
    for (Id j = 0; j < extent.size; ++j)
    {
      const auto place =
        std::lower_bound(around.begin(), around.end(), memory.Fan_[j].triangle) - around.begin();
      all[place] = { spokes[j + 1].alpha - spokes[j].alpha, angle - spokes[j].alpha };
      memory.IsDone_[place] = 1;
    }
  }
}

CornerDirection DirectionFans::At(FanCorner corner, Memory& memory) const
{
  const Id point = this->Mesh_.Corners(corner.triangle)[corner.corner];
  const Span<Id> around = this->Mesh_.TrianglesAround(point);
  const auto place =
    std::lower_bound(around.begin(), around.end(), corner.triangle) - around.begin();
  if (around.size() > LargestSmallFan)
  {
    return this->Large_.at(point)[place];
  }
  Memory::Slot& slot = memory.Slots_[static_cast<std::size_t>(point) % memory.Slots_.size()];
  if (slot.point != point)
  {
    this->LookAround(point, memory, slot.at);
    slot.point = point;
  }
  return slot.at[place];
}

} // namespace ridges
