// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Certification/TriangleCertificate.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ridges
{
namespace
{

constexpr int MostParts = 600;
constexpr int Deepest = 9;
constexpr int NumberOfDirections = 24;
using Directions = std::uint32_t;

/// One of the directions to try, by its shares of corner 1 - corner 0 and corner 2 - corner 0:
/// evenly spread in an equilateral triangle.
std::array<double, 2> DirectionAt(int i)
{
  const double angle = i * (2.0 * 3.14159265358979323846 / NumberOfDirections);
  const double y = std::sin(angle) * 2.0 / std::sqrt(3.0);
  return { std::cos(angle) - 0.5 * y, y };
}

/// Those along which the extremality grows.
Directions GrowingAlong(const ExtremalityBounds& extremality, int turn)
{
  Directions result = 0;
  for (int i = 0; i < NumberOfDirections; ++i)
  {
    const std::array<double, 2> d = DirectionAt(i);
    const Interval slope =
      Interval(turn * d[0]) * extremality.slope[0] + Interval(turn * d[1]) * extremality.slope[1];
    result |= IsPositive(slope) ? Directions(1) << i : 0;
  }
  return result;
}

struct Task
{
  Part part;
  double height;
  int depth;
};

/// What remains possible in the parts seen so far.
class TriangleState
{
public:
  /// Whether ridges matter, or only that there is no umbilic.
  explicit TriangleState(bool looksAtRidges)
    : LooksAtRidges_(looksAtRidges)
  {
  }

  /// The hypothesis that a part does not show to hold; 0 if it shows all.
  std::uint16_t Add(const PartBounds& bounds)
  {
    if (this->Reference_.isZero() && std::isfinite(bounds.height))
    {
      this->Reference_ = bounds.frame.col(0);
    }
    if (!bounds.isMapped)
    {
      return MeshFollowsSurface;
    }
    if (!bounds.hasGap || !bounds.isNarrow)
    {
      return OneUmbilic;
    }
    if (!this->LooksAtRidges_)
    {
      return 0;
    }
    // Signs agree with the direction in the middle of the first part, the whole triangle, while d1
    // cannot be at right angle to it: it is within 27 degrees of that of this part.
    const double along = bounds.frame.col(0).dot(this->Reference_);
    std::array<Directions, 2> possible = this->Possible_;
    for (int color = 0; color < 2; ++color)
    {
      const ExtremalityBounds& extremality = bounds.extremality[color];
      if (HasSign(extremality.value))
      {
        continue;
      }
      if (std::abs(along) < 0.5)
      {
        return NoRidgeInTriangle;
      }
      possible[color] &= GrowingAlong(extremality, along < 0.0 ? -1 : 1);
      if (possible[color] == 0)
      {
        return NoRidgeInTriangle;
      }
    }
    this->Possible_ = possible;
    return 0;
  }

private:
  bool LooksAtRidges_;
  Eigen::Vector3d Reference_ = Eigen::Vector3d::Zero();
  std::array<Directions, 2> Possible_{ ~Directions(0), ~Directions(0) };
};

TriangleCertificate Subdivide(
  const SurfaceBounds& surface, const MappedTriangle& whole, bool looksAtRidges)
{
  TriangleCertificate result;
  TriangleState state(looksAtRidges);
  std::vector<Task> tasks{ { Part::WholeTriangle(), 0.0, 0 } };
  int count = 0;
  while (!tasks.empty())
  {
    const Task task = tasks.back();
    tasks.pop_back();
    const PartBounds bounds = BoundPart(surface, whole, task.part, task.height);
    const std::uint16_t failed = state.Add(bounds);
    if (failed == 0)
    {
      continue;
    }
    if (++count >= MostParts || task.depth >= Deepest)
    {
      result.failed = failed;
      result.place = bounds.center;
      return result;
    }
    const double height = std::isfinite(bounds.height) ? bounds.height : 0.0;
    for (const auto& quarter : Quarters(task.part.corner))
    {
      tasks.push_back({ { quarter, 3 }, height, task.depth + 1 });
    }
  }
  return result;
}

constexpr int ProjectionDepth = 3;

bool IsMappedIn(
  const SurfaceBounds& surface, const MappedTriangle& whole, const Part& part, int depth)
{
  if (BoundPart(surface, whole, part, 0.0).isMapped)
  {
    return true;
  }
  const auto quarters = Quarters(part.corner);
  return depth < ProjectionDepth &&
    std::all_of(quarters.begin(), quarters.end(),
      [&surface, &whole, depth](const auto& quarter) {
        return IsMappedIn(surface, whole, { quarter, 3 }, depth + 1);
      });
}

} // namespace

bool IsMapped(const SurfaceBounds& surface, const MappedTriangle& whole)
{
  return IsMappedIn(surface, whole, Part::WholeTriangle(), 0);
}

TriangleCertificate CertifyTriangle(
  const SurfaceBounds& surface, const MappedTriangle& whole, bool isDegenerate)
{
  TriangleCertificate result;
  if (!isDegenerate)
  {
    result = Subdivide(surface, whole, true);
    if (result.failed == 0)
    {
      return result;
    }
  }
  // What stopped the search says nothing about the parts that it did not come to.
  const TriangleCertificate umbilics = Subdivide(surface, whole, false);
  if (umbilics.failed != 0)
  {
    result = umbilics;
    result.failed |= OneUmbilic;
    result.failed |=
      IsMapped(surface, whole) ? std::uint16_t(0) : std::uint16_t(MeshFollowsSurface);
  }
  result.place = result.failed != 0 ? result.place : whole.Position({ 0.3, 0.3, 0.4 });
  result.failed |= NoRidgeInTriangle;
  return result;
}

} // namespace ridges
