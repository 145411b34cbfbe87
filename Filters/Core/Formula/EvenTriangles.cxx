// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Formula/EvenTriangles.h"

#include "Formula/TrianglesOfPoints.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace ridges
{
namespace
{

constexpr int Rounds = 10;
constexpr int LastRounds = 5; ///< Without changes of the number of points.
static_assert(
  MakeEvenLoops == 2 + 2 * (Rounds + LastRounds), "one at first and at the end, two to relax");

/// Moves points to the surface, each from its target; those stay for which there is no place within
/// a distance, and those on the border.
bool MovePoints(EditableMesh& mesh, const std::vector<Eigen::Vector3d>& targets,
  const ExactSurface& surface, double distance, const StoppableLoop& loop)
{
  const std::vector<std::uint8_t> isBorder = FindBorderPoints(mesh);
  const auto move = [&mesh, &targets, &surface, &isBorder, distance](Id begin, Id end)
  {
    for (Id first = begin; first < end; first += Lanes::Count)
    {
      SurfacePoints points;
      points.count = std::min(end - first, static_cast<Id>(Lanes::Count));
      std::copy_n(targets.begin() + first, points.count, points.position.begin());
      surface.Locate(points);
      for (int lane = 0; lane < points.count; ++lane)
      {
        const Id p = first + lane;
        const bool isGood = points.fault[lane] == ExactFault::None && !isBorder[p] &&
          (points.position[lane] - targets[p]).norm() <= distance;
        mesh.points[p] = isGood ? points.position[lane] : mesh.points[p];
      }
    }
  };
  return loop(static_cast<Id>(mesh.points.size()), move);
}

/// Every point to the middle of its triangles.
bool Relax(
  EditableMesh& mesh, const ExactSurface& surface, double edgeLength, const StoppableLoop& loop)
{
  const auto count = static_cast<Id>(mesh.points.size());
  const TrianglesOfPoints around(count, mesh.triangles);
  std::vector<Eigen::Vector3d> targets(mesh.points.size());
  const auto aim = [&mesh, &around, &targets](Id begin, Id end)
  {
    for (Id p = begin; p < end; ++p)
    {
      targets[p] = around.MeanCentroid(p, [&mesh](Id corner) { return mesh.points[corner]; });
    }
  };
  return loop(count, aim) && MovePoints(mesh, targets, surface, edgeLength, loop);
}

/// Runs passes until nothing changes or they have been many.
template <typename Pass>
void Repeat(int atMost, const Pass& pass)
{
  for (int i = 0; i < atMost && pass() > 0; ++i)
  {
  }
}

} // namespace

bool MakeEven(EditableMesh& mesh, const ExactSurface& rough, const ExactSurface& surface,
  double edgeLength, const StoppableLoop& loop, const Monitor& monitor)
{
  constexpr int passes = 5;
  const double shortest = 0.8 * edgeLength;
  const double longest = 4.0 / 3.0 * edgeLength;
  const PlacePoint place = [&rough, edgeLength](Eigen::Vector3d& point)
  {
    SurfacePoints single;
    single.count = 1;
    single.position[0] = point;
    rough.Locate(single);
    const bool isGood =
      single.fault[0] == ExactFault::None && (single.position[0] - point).norm() <= edgeLength;
    point = isGood ? single.position[0] : point;
    return isGood;
  };
  const auto flip = [&mesh, &monitor]() { return FlipToDelaunay(mesh, monitor); };
  const auto collapse = [&mesh, shortest, longest, &place, &monitor]()
  { return CollapseShortEdges(mesh, shortest, longest, place, monitor); };
  const auto split = [&mesh, longest, &place, &monitor]()
  { return SplitLongEdges(mesh, longest, place, monitor); };

  const std::vector<Eigen::Vector3d> first = mesh.points;
  bool isWanted = MovePoints(mesh, first, rough, edgeLength, loop);
  for (int round = 0; isWanted && round < Rounds + LastRounds; ++round)
  {
    if (round < Rounds)
    {
      Repeat(passes, collapse);
      Repeat(passes, split);
    }
    Repeat(passes, flip);
    isWanted = monitor(1.0) && Relax(mesh, rough, edgeLength, loop);
  }
  Repeat(passes, flip);
  isWanted = isWanted && monitor(1.0);
  if (isWanted && &rough != &surface)
  {
    const std::vector<Eigen::Vector3d> near = mesh.points;
    isWanted = MovePoints(mesh, near, surface, edgeLength, loop);
  }
  return isWanted;
}

} // namespace ridges
