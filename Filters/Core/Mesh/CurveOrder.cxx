// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/CurveOrder.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

namespace ridges
{
namespace
{

constexpr int BitsPerAxis = 21;

/// The lowest 21 bits, with two zeros before each.
std::uint64_t Spread(std::uint64_t bits)
{
  bits &= 0x1fffff;
  bits = (bits | bits << 32) & 0x1f00000000ffff;
  bits = (bits | bits << 16) & 0x1f0000ff0000ff;
  bits = (bits | bits << 8) & 0x100f00f00f00f00f;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
  bits = (bits | bits << 2) & 0x1249249249249249;
  return bits;
}

} // namespace

std::vector<Id> PointsAlongCurve(const TriangleMesh& mesh)
{
  return PointsAlongCurve(mesh, mesh.NumberOfPoints());
}

std::vector<Id> PointsAlongCurve(const TriangleMesh& mesh, Id count)
{
  Eigen::Array3d least = Eigen::Array3d::Constant(std::numeric_limits<double>::max());
  Eigen::Array3d greatest = -least;
  for (Id p = 0; p < count; ++p)
  {
    // Points without triangles may be anywhere, or nowhere.
    if (mesh.TrianglesAround(p).size() > 0)
    {
      least = least.min(mesh.Point(p).array());
      greatest = greatest.max(mesh.Point(p).array());
    }
  }
  constexpr double cells = (1 << BitsPerAxis) - 1;
  const double extent = (greatest - least).maxCoeff();
  const double perLength = extent > 0.0 ? cells / extent : 0.0;
  std::vector<std::pair<std::uint64_t, Id>> keys(count);
  for (Id p = 0; p < count; ++p)
  {
    std::uint64_t key = 0;
    if (mesh.TrianglesAround(p).size() > 0)
    {
      const Eigen::Array3d at = (mesh.Point(p).array() - least) * perLength;
      for (int i = 0; i < 3; ++i)
      {
        key |= Spread(static_cast<std::uint64_t>(std::clamp(at[i], 0.0, cells))) << i;
      }
    }
    keys[p] = { key, p };
  }
  std::sort(keys.begin(), keys.end());
  std::vector<Id> points(count);
  std::transform(
    keys.begin(), keys.end(), points.begin(), [](const auto& key) { return key.second; });
  return points;
}

} // namespace ridges
