// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/ShapeSample.h"

#include "Base/RankGathering.h"
#include "Mesh/PositionHash.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <tuple>

namespace ridges
{
namespace
{

/// Sums of integers do not depend on the order. Of so many steps 2^27 can be added.
constexpr double Steps = 0x1p35;

/// How finely distances are told apart: far more coarsely than they are rounded.
constexpr double StepsOfDistance = 0x1p17;

bool IsOnSurface(const TriangleMesh& mesh, Id p)
{
  return mesh.TrianglesAround(p).size() > 0;
}

/// Of all ranks, of the first `count` points of each.
std::int64_t CountOnSurface(const TriangleMesh& mesh, Id count, Ranks& ranks)
{
  std::int64_t sum = 0;
  for (Id p = 0; p < count; ++p)
  {
    sum += IsOnSurface(mesh, p) ? 1 : 0;
  }
  return SumOverRanks(ranks, sum);
}

/// Points that a rank draws from.
struct Points
{
  const TriangleMesh& mesh;
  Id count;
  Ranks& ranks;
  std::int64_t onSurface; ///< Of all ranks.
};

/// The mean of what is `valueOf` at the points of the surface, from 0 to `greatest`.
template <typename ValueOf>
double Mean(const Points& points, double greatest, const ValueOf& valueOf)
{
  std::int64_t sum = 0;
  for (Id p = 0; p < points.count; ++p)
  {
    if (IsOnSurface(points.mesh, p))
    {
      // Of huge coordinates it may be no number.
      const double part = valueOf(p) / greatest;
      sum += part < 1.0 ? std::llround(part * Steps) : std::llround(Steps);
    }
  }
  return static_cast<double>(SumOverRanks(points.ranks, sum)) /
    static_cast<double>(points.onSurface) * greatest / Steps;
}

struct Bounds
{
  std::array<double, 3> least;
  std::array<double, 3> most;
  bool isFinite;
};

/// Of the points on the surface, of all ranks.
Bounds BoundsOf(const Points& points)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Bounds own{ { infinity, infinity, infinity }, { -infinity, -infinity, -infinity }, true };
  const auto include = [](Bounds& bounds, const Bounds& other)
  {
    bounds.isFinite = bounds.isFinite && other.isFinite;
    for (int i = 0; i < 3; ++i)
    {
      bounds.least[i] = std::min(bounds.least[i], other.least[i]);
      bounds.most[i] = std::max(bounds.most[i], other.most[i]);
    }
  };
  for (Id p = 0; p < points.count; ++p)
  {
    if (IsOnSurface(points.mesh, p))
    {
      const auto x = points.mesh.Point(p);
      include(own, { { x[0], x[1], x[2] }, { x[0], x[1], x[2] }, x.allFinite() });
    }
  }
  for (const Bounds& other : GatherAllOne(points.ranks, own))
  {
    include(own, other);
  }
  return own;
}

/// The distance of a point from the centroid over its mean, in steps. Empty if there is none.
std::function<std::uint64_t(Id)> StepsFromCentroid(const Points& points)
{
  const Bounds bounds = BoundsOf(points);
  const Eigen::Vector3d least(bounds.least[0], bounds.least[1], bounds.least[2]);
  const Eigen::Vector3d most(bounds.most[0], bounds.most[1], bounds.most[2]);
  const double extent = (most - least).maxCoeff();
  if (!bounds.isFinite || !(extent > 0.0) || !std::isfinite(extent))
  {
    return {};
  }
  const TriangleMesh& mesh = points.mesh;
  Eigen::Vector3d centroid;
  for (int i = 0; i < 3; ++i)
  {
    centroid[i] =
      Mean(points, extent, [&mesh, &least, i](Id p) { return mesh.Point(p)[i] - least[i]; });
  }
  const auto distance = [&mesh, least, centroid](Id p)
  { return (mesh.Point(p) - least - centroid).norm(); };
  const double mean = Mean(points, 2.0 * extent, distance);
  return [distance, mean](Id p)
  { return static_cast<std::uint64_t>(distance(p) / mean * StepsOfDistance); };
}

} // namespace

std::vector<DrawnPoint> ShapeSample(const TriangleMesh& mesh, Id count, double wanted, Ranks& ranks)
{
  if (static_cast<double>(SumOverRanks(ranks, count)) <= wanted)
  {
    return PositionSample(mesh, count, wanted, ranks);
  }
  const Points points{ mesh, count, ranks, CountOnSurface(mesh, count, ranks) };
  const auto stepsOf = StepsFromCentroid(points);
  const double part = wanted / static_cast<double>(points.onSurface);
  std::vector<DrawnPoint> own;
  for (Id p = 0; stepsOf && p < count; ++p)
  {
    if (!IsOnSurface(mesh, p))
    {
      continue;
    }
    const std::uint64_t hash = MixedBits(stepsOf(p));
    if (static_cast<double>(hash) < part * 0x1p64)
    {
      const auto x = mesh.Point(p);
      own.push_back({ hash, { x[0], x[1], x[2] }, ranks.Rank(), p });
    }
  }
  const std::vector<DrawnPoint> chosen = GatherInOneRow(ranks, own,
    [](const DrawnPoint& a, const DrawnPoint& b)
    { return std::tie(a.hash, a.x) < std::tie(b.hash, b.x); });
  std::vector<DrawnPoint> sample;
  std::size_t different = 0;
  for (std::size_t i = 0; i < chosen.size(); ++i)
  {
    const auto isAt = [&chosen, i](std::size_t j) { return chosen[j].x == chosen[i].x; };
    different += i == 0 || chosen[i - 1].hash != chosen[i].hash ? 1 : 0;
    if ((i == 0 || !isAt(i - 1)) && (i + 1 == chosen.size() || !isAt(i + 1)))
    {
      sample.push_back(chosen[i]);
    }
  }
  // A mesh may have a few planes of symmetry.
  constexpr double fewest = 1.0 / 16.0;
  const bool isVaried = static_cast<double>(different) > fewest * wanted &&
    static_cast<double>(sample.size()) > 0.5 * wanted;
  return isVaried ? sample : PositionSample(mesh, count, wanted, ranks);
}

std::vector<Id> ShapeSample(const TriangleMesh& mesh, double wanted)
{
  OneRank alone;
  return DrawnOn(0, ShapeSample(mesh, mesh.NumberOfPoints(), wanted, alone));
}

} // namespace ridges
