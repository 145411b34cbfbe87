// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/ShapeSample.h"

#include "Mesh/PositionHash.h"
#include "Mesh/PositionSample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace ridges
{
namespace
{

/// Sums of integers do not depend on the order. Of so many steps 2^27 can be added.
constexpr double Steps = 0x1p35;

/// How finely distances are told apart: far more coarsely than they are rounded.
constexpr double StepsOfDistance = 0x1p17;
constexpr std::uint64_t NotOnSurface = ~std::uint64_t(0);

bool IsOnSurface(const TriangleMesh& mesh, Id p)
{
  return mesh.TrianglesAround(p).size() > 0;
}

/// The mean of what is `valueOf` at the points of the surface, from 0 to `greatest`.
template <typename ValueOf>
double Mean(const TriangleMesh& mesh, double greatest, const ValueOf& valueOf)
{
  std::int64_t sum = 0;
  Id count = 0;
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    if (IsOnSurface(mesh, p))
    {
      sum += std::llround(valueOf(p) / greatest * Steps);
      ++count;
    }
  }
  return static_cast<double>(sum) / static_cast<double>(count) * greatest / Steps;
}

/// The distance of each point from the centroid over its mean, in steps. Empty if there is none.
std::vector<std::uint64_t> StepsFromCentroid(const TriangleMesh& mesh)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Eigen::Vector3d least = Eigen::Vector3d::Constant(infinity);
  Eigen::Vector3d most = -least;
  bool isFinite = true;
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    if (!IsOnSurface(mesh, p))
    {
      continue;
    }
    const Eigen::Vector3d x = mesh.Point(p);
    isFinite = isFinite && x.allFinite();
    least = least.cwiseMin(x);
    most = most.cwiseMax(x);
  }
  const double extent = (most - least).maxCoeff();
  if (!isFinite || !(extent > 0.0) || !std::isfinite(extent))
  {
    return {};
  }
  Eigen::Vector3d centroid;
  for (int i = 0; i < 3; ++i)
  {
    centroid[i] =
      Mean(mesh, extent, [&mesh, &least, i](Id p) { return mesh.Point(p)[i] - least[i]; });
  }
  const auto distance = [&mesh, &least, &centroid](Id p)
  { return (mesh.Point(p) - least - centroid).norm(); };
  const double mean = Mean(mesh, 2.0 * extent, distance);
  std::vector<std::uint64_t> steps;
  steps.reserve(static_cast<std::size_t>(mesh.NumberOfPoints()));
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    steps.push_back(IsOnSurface(mesh, p)
        ? static_cast<std::uint64_t>(distance(p) / mean * StepsOfDistance)
        : NotOnSurface);
  }
  return steps;
}

} // namespace

std::vector<Id> ShapeSample(const TriangleMesh& mesh, double wanted)
{
  if (static_cast<double>(mesh.NumberOfPoints()) <= wanted)
  {
    return PositionSample(mesh, wanted);
  }
  const std::vector<std::uint64_t> steps = StepsFromCentroid(mesh);
  const auto count = std::count_if(
    steps.begin(), steps.end(), [](std::uint64_t step) { return step != NotOnSurface; });
  const double part = wanted / static_cast<double>(count);
  std::vector<std::pair<std::uint64_t, Id>> chosen;
  for (std::size_t p = 0; p < steps.size(); ++p)
  {
    const std::uint64_t hash = MixedBits(steps[p]);
    if (steps[p] != NotOnSurface && static_cast<double>(hash) < part * 0x1p64)
    {
      chosen.emplace_back(hash, static_cast<Id>(p));
    }
  }
  const auto coordinates = [&mesh](Id p)
  {
    const Eigen::Vector3d x = mesh.Point(p);
    return std::array<double, 3>{ x[0], x[1], x[2] };
  };
  std::sort(chosen.begin(), chosen.end(),
    [&coordinates](const auto& a, const auto& b) {
      return std::pair(a.first, coordinates(a.second)) < std::pair(b.first, coordinates(b.second));
    });
  std::vector<Id> sample;
  std::size_t different = 0;
  for (std::size_t i = 0; i < chosen.size(); ++i)
  {
    const auto isAt = [&chosen, &coordinates, i](std::size_t j)
    { return coordinates(chosen[j].second) == coordinates(chosen[i].second); };
    different += i == 0 || chosen[i - 1].first != chosen[i].first ? 1 : 0;
    if ((i == 0 || !isAt(i - 1)) && (i + 1 == chosen.size() || !isAt(i + 1)))
    {
      sample.push_back(chosen[i].second);
    }
  }
  // A mesh may have a few planes of symmetry.
  constexpr double fewest = 1.0 / 16.0;
  const bool isVaried = static_cast<double>(different) > fewest * wanted &&
    static_cast<double>(sample.size()) > 0.5 * wanted;
  return isVaried ? sample : PositionSample(mesh, wanted);
}

} // namespace ridges
