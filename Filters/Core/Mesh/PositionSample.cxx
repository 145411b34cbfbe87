// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/PositionSample.h"

#include "Base/RankGathering.h"
#include "Mesh/PositionHash.h"

#include <algorithm>
#include <tuple>

namespace ridges
{

std::vector<DrawnPoint> PositionSample(
  const TriangleMesh& mesh, Id count, double wanted, Ranks& ranks)
{
  const auto all = static_cast<double>(SumOverRanks(ranks, count));
  const double part = wanted / std::max(wanted, all);
  std::vector<DrawnPoint> own;
  for (Id p = 0; p < count; ++p)
  {
    const auto x = mesh.Point(p);
    const std::uint64_t hash = PositionHash(x);
    if (part >= 1.0 || static_cast<double>(hash) < part * 0x1p64)
    {
      own.push_back({ hash, { x[0], x[1], x[2] }, ranks.Rank(), p });
    }
  }
  const std::vector<DrawnPoint> chosen = GatherInOneRow(ranks, own,
    [](const DrawnPoint& a, const DrawnPoint& b)
    { return std::tie(a.hash, a.rank, a.id) < std::tie(b.hash, b.rank, b.id); });
  std::vector<DrawnPoint> sample;
  for (std::size_t i = 0; i < chosen.size(); ++i)
  {
    const bool again = (i > 0 && chosen[i - 1].hash == chosen[i].hash) ||
      (i + 1 < chosen.size() && chosen[i + 1].hash == chosen[i].hash);
    if (!again)
    {
      sample.push_back(chosen[i]);
    }
  }
  return sample;
}

std::vector<Id> PositionSample(const TriangleMesh& mesh, double wanted)
{
  OneRank alone;
  return DrawnOn(0, PositionSample(mesh, mesh.NumberOfPoints(), wanted, alone));
}

std::vector<Id> DrawnOn(int rank, const std::vector<DrawnPoint>& sample)
{
  std::vector<Id> own;
  for (const DrawnPoint& point : sample)
  {
    if (point.rank == rank)
    {
      own.push_back(point.id);
    }
  }
  return own;
}

} // namespace ridges
