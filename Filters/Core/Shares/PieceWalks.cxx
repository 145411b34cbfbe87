// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shares/PieceWalks.h"

#include "Base/RankGathering.h"
#include "Mesh/BorderStrip.h"

#include <limits>

namespace ridges
{

void SpreadLevels(Ranks& ranks, const TriangleMesh& piece, const PieceSeams& seams,
  std::uint8_t highest, std::vector<std::uint8_t>& levels)
{
  for (std::uint8_t level = 0; level < highest; ++level)
  {
    seams.TakeLeast(ranks, levels);
    const auto next = static_cast<std::uint8_t>(level + 1);
    for (const Triangle& c : piece.Triangles())
    {
      if (levels[c[0]] == level || levels[c[1]] == level || levels[c[2]] == level)
      {
        for (const Id p : c)
        {
          levels[p] = std::min(levels[p], next);
        }
      }
    }
  }
}

std::vector<std::uint8_t> BorderStripOfPiece(Ranks& ranks, const TriangleMesh& piece,
  const PieceSeams& seams, const std::vector<std::uint8_t>& onBorder, const double* radii)
{
  std::vector<Id> from;
  std::vector<double> distances(onBorder.size(), std::numeric_limits<double>::infinity());
  for (std::size_t p = 0; p < onBorder.size(); ++p)
  {
    if (onBorder[p] != 0)
    {
      distances[p] = 0.0;
      from.push_back(static_cast<Id>(p));
    }
  }
  if (!IsAnywhere(ranks, !from.empty()))
  {
    return {};
  }
  double farthest = 0.0;
  const double own =
    radii && !onBorder.empty() ? *std::max_element(radii, radii + onBorder.size()) : 0.0;
  for (const double each : GatherAllOne(ranks, own))
  {
    farthest = std::max(farthest, each);
  }
  do
  {
    SpreadDistances(piece, from, farthest, distances);
    from = seams.TakeLeast(ranks, distances);
  } while (IsAnywhere(ranks, !from.empty()));
  return StripWithin(distances, radii);
}

double EnclosingRadiusOfPieces(Ranks& ranks, const TriangleMesh& piece)
{
  const auto farthest = [&ranks](const FarPoint& own)
  {
    FarPoint all;
    for (const FarPoint& each : GatherAllOne(ranks, own))
    {
      all = FartherOf(all, each);
    }
    return all;
  };
  const auto leastOfEach = [&ranks](const std::array<double, 6>& own)
  {
    std::array<double, 6> least = own;
    for (const std::array<double, 6>& each : GatherAllOne(ranks, own))
    {
      std::transform(each.begin(), each.end(), least.begin(), least.begin(),
        [](double a, double b) { return std::min(a, b); });
    }
    return least;
  };
  return SmallestEnclosingSphere(piece, SphereOfPieces{ farthest, leastOfEach }).radius;
}

} // namespace ridges
