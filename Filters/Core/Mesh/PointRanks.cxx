// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/PointRanks.h"

#include "Mesh/PositionHash.h"
#include "Mesh/PositionOrder.h"
#include "Mesh/TriangleMesh.h"

#include <algorithm>
#include <numeric>

namespace ridges
{
namespace
{

/// Points that share their place with others, by id.
std::vector<Id> CoincidentPoints(const TriangleMesh& mesh)
{
  std::vector<Id> order(mesh.NumberOfPoints());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&mesh](Id p, Id q) { return ComesBefore(mesh.Point(p), mesh.Point(q)); });
  std::vector<Id> coincident;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const auto isAlike = [&mesh, &order, i](std::size_t j)
    { return mesh.Point(order[i]) == mesh.Point(order[j]); };
    if ((i > 0 && isAlike(i - 1)) || (i + 1 < order.size() && isAlike(i + 1)))
    {
      coincident.push_back(order[i]);
    }
  }
  std::sort(coincident.begin(), coincident.end());
  return coincident;
}

/// What a point and its triangles look like, the colors of all points given. Sums do not depend on
/// the order of the triangles.
std::uint64_t Refined(const TriangleMesh& mesh, const std::vector<std::uint64_t>& colors, Id p)
{
  std::uint64_t sum = 0;
  for (const Id t : mesh.TrianglesAround(p))
  {
    const Triangle& c = mesh.Corners(t);
    const int corner = CornerOf(c, p);
    sum += MixedBits(MixedBits(colors[c[(corner + 1) % 3]]) + colors[c[(corner + 2) % 3]]);
  }
  return MixedBits(MixedBits(colors[p]) ^ sum);
}

std::size_t NumberOfDifferent(std::vector<std::uint64_t> values)
{
  std::sort(values.begin(), values.end());
  return static_cast<std::size_t>(std::unique(values.begin(), values.end()) - values.begin());
}

} // namespace

void PointRanks::Build(const TriangleMesh& mesh)
{
  const std::vector<Id> points = CoincidentPoints(mesh);
  std::vector<std::uint64_t> colors;
  colors.reserve(mesh.NumberOfPoints());
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    // 0 and -0 are one place.
    colors.push_back(PositionHash(mesh.Point(p) + Eigen::Vector3d::Zero()));
  }
  // Very many points in one place may need as many rounds as there are rings of them: some are
  // enough.
  constexpr std::size_t fewestRounds = 16;
  constexpr std::size_t most = 20'000'000; // points looked at
  const std::size_t rounds = points.empty() ? 0 : std::max(fewestRounds, most / points.size());
  std::vector<std::uint64_t> refined(points.size());
  std::size_t different = 0;
  for (std::size_t round = 0; round < rounds; ++round)
  {
    std::transform(points.begin(), points.end(), refined.begin(),
      [&mesh, &colors](Id p) { return Refined(mesh, colors, p); });
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      colors[points[i]] = refined[i];
    }
    const std::size_t before = different;
    different = NumberOfDifferent(refined);
    if (different == points.size() || different == before)
    {
      break;
    }
  }
  this->Ranks_.reserve(points.size());
  for (const Id p : points)
  {
    this->Ranks_.emplace_back(p, colors[p]);
  }
}

std::uint64_t PointRanks::RankOf(const TriangleMesh& mesh, Id point)
{
  std::call_once(this->Once_, [this, &mesh] { this->Build(mesh); });
  const auto found = std::lower_bound(this->Ranks_.begin(), this->Ranks_.end(), point,
    [](const auto& entry, Id p) { return entry.first < p; });
  return found != this->Ranks_.end() && found->first == point ? found->second : 0;
}

} // namespace ridges
