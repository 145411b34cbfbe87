// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesZoneSearch.h"

#include "Core/Mesh/PositionOrder.h"
#include "Core/Ridges/ExtremalityProbe.h"
#include "Core/Ridges/ZoneDoubt.h"
#include "vtkRidgesBatches.h"
#include "vtkRidgesMongeInput.h"
#include "vtkRidgesMonitor.h"
#include "vtkRidgesPerThread.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace
{

/// Fits around points of a sample on a larger scale.
struct TryPoints
{
  const ridges::TriangleMesh& mesh;
  const ridges::OrderedRings& rings;
  int numberOfRings;
  ridges::Color color;
  double significance;
  const std::vector<ridges::Id>& sample;
  std::vector<ridges::ExtremalityProbe::Trial>& trials;
  vtkRidgesPerThread<ridges::ExtremalityProbe> perThread;

  void operator()(vtkIdType begin, vtkIdType end)
  {
    ridges::ExtremalityProbe& probe = this->perThread.Get(
      [this] { return std::make_shared<ridges::ExtremalityProbe>(this->mesh, this->rings); });
    for (vtkIdType i = begin; i < end; ++i)
    {
      this->trials[i] =
        probe.Try(this->sample[i], this->numberOfRings, this->color, this->significance);
    }
  }
};

/// The regions that hold ridges.
std::vector<std::size_t> RegionsOf(const ridges::RidgeZones& zones,
  const ridges::TriangleMesh& mesh, const std::vector<ridges::Ridge>& whole,
  const std::vector<std::uint8_t>& isIn)
{
  std::vector<std::uint8_t> holds(zones.Regions().size(), 0);
  for (std::size_t i = 0; i < whole.size(); ++i)
  {
    if (isIn[i])
    {
      const ridges::Id node = whole[i].nodes.front();
      const ridges::Id point = ridges::Ridge::IsUmbilic(node)
        ? mesh.Corners(ridges::Ridge::TriangleOfUmbilic(node))[0]
        : mesh.EdgeAt(node).v0;
      holds[zones.RegionOf(point)] = 1;
    }
  }
  std::vector<std::size_t> regions;
  for (std::size_t i = 0; i < holds.size(); ++i)
  {
    if (holds[i])
    {
      regions.push_back(i);
    }
  }
  return regions;
}

} // namespace

vtkRidgesZoneSearch::vtkRidgesZoneSearch(
  const vtkRidgesMongeInput& monge, ridges::Color color, double significance)
  : Monge(monge)
  , Color(color)
  , Significance(significance)
  , IsFlagged(monge.arrays.FlaggedPoints())
  , Errors({ monge.mesh.GetTriangles(), monge.arrays.GetField(), monge.arrays.GetErrors(),
             this->IsFlagged },
      color, significance)
{
}

bool vtkRidgesZoneSearch::Run(vtkAlgorithm* filter, double from, double to,
  const std::vector<ridges::RidgeSegment>& segments, const std::vector<ridges::RidgePath>& paths,
  std::vector<ridges::Ridge>& whole, vtkRidgesZones& found)
{
  if (this->AreAllClear(whole))
  {
    return true;
  }
  if (const ridges::MeshPart* part = this->Monge.mesh.GetTriangles().Part())
  {
    // Whether a zone is one depends on how much of the mesh it is.
    if (!this->AreOutside(whole))
    {
      part->Want(ridges::MeshPart::Wants::All);
    }
    return true;
  }
  const double judged = from + 0.4 * (to - from);
  const double grown = from + 0.7 * (to - from);
  const ridges::TriangleMesh& mesh = this->Monge.mesh.GetTriangles();
  ridges::RidgeZones zones(mesh);
  if (!this->JudgePoints(filter, from, judged) ||
    !zones.Find(this->Errors.Verdicts(), vtkRidgesMonitor(filter, judged, grown)))
  {
    return false;
  }
  const auto inZones = [&zones, &mesh, &whole, &segments, &paths]
  { return ridges::RidgesInZones(zones, mesh, whole, segments, paths); };
  std::vector<std::uint8_t> isLeftOut = inZones();
  std::vector<std::size_t> regions = RegionsOf(zones, mesh, whole, isLeftOut);
  bool isAnyRemoved = false;
  if (!this->RemoveResolved(filter, grown, to, zones, regions, isAnyRemoved))
  {
    return false;
  }
  if (isAnyRemoved)
  {
    isLeftOut = inZones();
    regions = RegionsOf(zones, mesh, whole, isLeftOut);
  }
  for (const std::size_t region : regions)
  {
    found.triangles.push_back(zones.TrianglesOf(region));
  }
  ridges::SortByPosition(mesh, found.triangles);
  const std::size_t before = whole.size();
  ridges::LeaveOut(whole, isLeftOut);
  found.numberOfRidges += static_cast<vtkIdType>(before - whole.size());
  return true;
}

/// Whether a ridge passes a place, of a few, where the extremality is significant: then it lies in
/// no zone.
bool vtkRidgesZoneSearch::IsClear(const ridges::Ridge& ridge)
{
  constexpr std::size_t places = 5;
  const std::vector<ridges::Id>& nodes = ridge.nodes;
  for (std::size_t i = 0; i < places; ++i)
  {
    const ridges::Id node = nodes[nodes.size() * (2 * i + 1) / (2 * places)];
    if (!ridges::Ridge::IsUmbilic(node) &&
      this->Errors.VerdictAt(this->Monge.mesh.GetTriangles().EdgeAt(node).v0) ==
        ridges::ExtremalityErrors::Verdict::Significant)
    {
      return true;
    }
  }
  return false;
}

bool vtkRidgesZoneSearch::AreAllClear(const std::vector<ridges::Ridge>& whole)
{
  return std::all_of(whole.begin(), whole.end(),
    [this](const ridges::Ridge& ridge) { return this->IsClear(ridge); });
}

/// The same on a part of a mesh, from more places.
bool vtkRidgesZoneSearch::AreOutside(const std::vector<ridges::Ridge>& whole)
{
  ridges::ZoneDoubt doubt(
    this->Monge.mesh.GetTriangles(), [this](ridges::Id p) { return this->Errors.VerdictAt(p); });
  return std::all_of(whole.begin(), whole.end(),
    [this, &doubt](const ridges::Ridge& ridge)
    { return this->IsClear(ridge) || doubt.IsOutside(ridge); });
}

bool vtkRidgesZoneSearch::JudgePoints(vtkAlgorithm* filter, double from, double to)
{
  const vtkIdType count = this->Monge.mesh.GetTriangles().NumberOfPoints();
  const auto id = [](vtkIdType p) { return static_cast<ridges::Id>(p); };
  const auto measure = [this, &id](vtkIdType begin, vtkIdType end)
  { this->Errors.Measure(id(begin), id(end)); };
  const auto sum = [this, &id](vtkIdType begin, vtkIdType end)
  { this->Errors.Sum(id(begin), id(end)); };
  const auto judge = [this, &id](vtkIdType begin, vtkIdType end)
  { this->Errors.Judge(id(begin), id(end)); };
  const double step = (to - from) / 3.0;
  this->Errors.Begin();
  return vtkRidgesForBatches(filter, count, from, from + step, measure) &&
    vtkRidgesForBatches(filter, count, from + step, from + 2.0 * step, sum) &&
    vtkRidgesForBatches(filter, count, from + 2.0 * step, to, judge);
}

/// Regions where noise only hides ridges are no zones.
bool vtkRidgesZoneSearch::RemoveResolved(vtkAlgorithm* filter, double from, double to,
  ridges::RidgeZones& zones, const std::vector<std::size_t>& regions, bool& isAnyRemoved) const
{
  const ridges::FitErrorSource& errors = this->Monge.arrays.GetErrors();
  if (regions.empty() || !errors.fitResidual || !errors.fitScale)
  {
    return true;
  }
  const ridges::TriangleMesh& mesh = this->Monge.mesh.GetTriangles();
  ridges::OrderedRings rings(mesh);
  const auto build = [&rings](vtkIdType begin, vtkIdType end)
  { rings.Build(static_cast<ridges::Id>(begin), static_cast<ridges::Id>(end)); };
  const double middle = 0.5 * (from + to);
  if (!vtkRidgesForBatches(filter, mesh.NumberOfPoints(), from, middle, build))
  {
    return false;
  }
  const ridges::Monitor monitor = vtkRidgesMonitor(filter, middle, to);
  for (std::size_t i = 0; i < regions.size(); ++i)
  {
    if (!zones.IsRoundOff(regions[i]) &&
      (this->ShowsAsAWhole(zones, regions[i]) ||
        this->ShowsOnLargerScale(zones, regions[i], rings)))
    {
      zones.Remove(regions[i]);
      isAnyRemoved = true;
    }
    if (!monitor(static_cast<double>(i + 1) / static_cast<double>(regions.size())))
    {
      return false;
    }
  }
  return true;
}

/// Whether the extremality is not small against its errors in the mean over a region, though
/// nowhere significant, and beside it there are ridges. On surfaces without ridges errors are less
/// than they seem, as they are of fits that overlap: squares of b are hardly ever above half of
/// theirs. Where noise hides the ridges of an ellipsoid they are .7 to 2.3 times theirs.
bool vtkRidgesZoneSearch::ShowsAsAWhole(const ridges::RidgeZones& zones, std::size_t region) const
{
  constexpr double most = 0.5;
  return !zones.IsWhole(region) && this->Errors.MeanSquareInErrors(zones.Regions()[region]) > most;
}

bool vtkRidgesZoneSearch::ShowsOnLargerScale(
  const ridges::RidgeZones& zones, std::size_t region, const ridges::OrderedRings& rings) const
{
  const ridges::TriangleMesh& mesh = this->Monge.mesh.GetTriangles();
  const auto isIn = [this, &zones, region](ridges::Id p)
  {
    return zones.RegionOf(p) == static_cast<ridges::Id>(region) &&
      (this->IsFlagged.empty() || this->IsFlagged[p] == 0);
  };
  ridges::ExtremalityProbe depth(mesh, rings);
  // Noise in b falls with the fourth power of the scale. On fine meshes twelve rings are still
  // small.
  for (const int numberOfRings : { 4, 7, 12, 20, 33 })
  {
    const std::vector<ridges::Id> sample = ridges::SampleOf(mesh, zones.Regions()[region],
      [&depth, &isIn, numberOfRings](ridges::Id p)
      { return depth.IsDeepIn(isIn, p, numberOfRings); });
    std::vector<ridges::ExtremalityProbe::Trial> trials(sample.size());
    TryPoints tryPoints{ mesh, rings, numberOfRings, this->Color, this->Significance, sample,
      trials, {} };
    vtkSMPTools::For(0, static_cast<vtkIdType>(sample.size()), 1, tryPoints);

    // More than chance would have: a few are significant on surfaces without ridges.
    constexpr double chance = 0.1;
    constexpr std::ptrdiff_t most = 2;
    constexpr std::ptrdiff_t fewest = 8;
    using Trial = ridges::ExtremalityProbe::Trial;
    const auto usable = std::count_if(
      trials.begin(), trials.end(), [](const Trial& trial) { return trial.isUsable; });
    const auto significant = std::count_if(
      trials.begin(), trials.end(), [](const Trial& trial) { return trial.isSignificant; });
    if (usable < fewest)
    {
      return false;
    }
    if (significant > most &&
      static_cast<double>(significant) > chance * static_cast<double>(usable))
    {
      return true;
    }
  }
  return false;
}
