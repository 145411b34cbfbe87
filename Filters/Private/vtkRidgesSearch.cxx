// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesSearch.h"

#include "Core/Ridges/Patch/PatchRidges.h"
#include "Core/Ridges/SmallLoops.h"
#include "Core/Ridges/TypeErrors.h"
#include "Core/Ridges/TypeRuns.h"
#include "Core/Umbilics/UmbilicForm.h"
#include "vtkRidgesBatches.h"
#include "vtkRidgesCollect.h"
#include "vtkRidgesMongeInput.h"
#include "vtkRidgesUmbilicMarks.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace
{

/// The number of segments of a ridge.
struct SizeOf
{
  const std::vector<ridges::Ridge>& ridges;

  vtkIdType operator()(vtkIdType i) const
  {
    return static_cast<vtkIdType>(this->ridges[i].segments.size());
  }
};

struct PlaceCrossings
{
  ridges::RidgeCrossings& crossings;

  void operator()(vtkIdType begin, vtkIdType end)
  {
    this->crossings.Place(static_cast<ridges::Id>(begin), static_cast<ridges::Id>(end));
  }
};

/// Draws the ridges inside patches, some of them at a time: they share no triangle.
class DrawShares
{
public:
  DrawShares(const ridges::RidgeCrossings& crossings,
    const std::vector<ridges::RidgePatch>& patches, std::vector<std::uint8_t>& isReplaced)
    : Crossings(crossings)
    , Patches(patches)
    , IsReplaced(isReplaced)
    , Shares(patches.size() / Size + (patches.size() % Size > 0 ? 1 : 0))
  {
  }

  vtkIdType GetNumberOfShares() const { return static_cast<vtkIdType>(this->Shares.size()); }

  void operator()(vtkIdType begin, vtkIdType end)
  {
    const ridges::PatchRidges patchRidges(this->Crossings);
    for (auto share = static_cast<std::size_t>(begin); share < static_cast<std::size_t>(end);
         ++share)
    {
      const std::size_t last = std::min(Size * (share + 1), this->Patches.size());
      for (std::size_t i = Size * share; i < last; ++i)
      {
        patchRidges.Draw(this->Patches[i], this->Shares[share].segments, this->Shares[share].paths,
          this->IsReplaced);
      }
    }
  }

  void AppendTo(std::vector<ridges::RidgeSegment>& segments, std::vector<ridges::RidgePath>& paths)
  {
    for (Share& share : this->Shares)
    {
      for (ridges::RidgeSegment segment : share.segments)
      {
        segment.path += static_cast<ridges::Id>(paths.size());
        segments.push_back(segment);
      }
      std::move(share.paths.begin(), share.paths.end(), std::back_inserter(paths));
    }
  }

private:
  static constexpr std::size_t Size = 64;

  struct Share
  {
    std::vector<ridges::RidgeSegment> segments; ///< Each has a path of the share.
    std::vector<ridges::RidgePath> paths;
  };

  const ridges::RidgeCrossings& Crossings;
  const std::vector<ridges::RidgePatch>& Patches;
  std::vector<std::uint8_t>& IsReplaced;
  std::vector<Share> Shares;
};

/// Traces ridges, each for itself, and forgets what they were traced from.
struct TraceRidges
{
  std::vector<ridges::Ridge>& ridges;
  const std::vector<ridges::RidgeSegment>& segments;
  const std::vector<ridges::RidgePath>& paths;
  const ridges::RidgeCrossings& crossings;
  ridges::TypeRule rule;
  const ridges::UmbilicLookup& umbilics;
  std::vector<ridges::RidgeTrace>& traces;

  void operator()(vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      this->traces[i] = ridges::TraceRidge(
        this->ridges[i], this->segments, this->paths, this->crossings, this->rule, this->umbilics);
      this->ridges[i] = ridges::Ridge();
      ridges::MakeCanonical(this->crossings.Mesh(), this->traces[i]);
    }
  }
};

/// Decides where the type of a ridge changes, of each ridge for itself.
struct DecideTypesOfRidges
{
  std::vector<ridges::RidgeTrace>& traces;
  const ridges::TriangleMesh& mesh;
  const ridges::TypeErrors& typeErrors;
  double typeSignificance;
  double shortestRun;
  bool measuresTypes;

  void operator()(vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      ridges::RidgeTrace& trace = this->traces[i];
      // After it, the start of a loop may not be that of a run any more.
      if (this->typeSignificance > 0.0)
      {
        ridges::AbsorbInsignificantRuns(trace, this->typeErrors, this->typeSignificance);
        ridges::MakeCanonical(this->mesh, trace);
      }
      if (this->shortestRun > 0.0)
      {
        ridges::AbsorbShortRuns(trace, this->shortestRun);
        ridges::MakeCanonical(this->mesh, trace);
      }
      if (this->measuresTypes)
      {
        // By this many standard errors P is on the right side of 0 in 97.5 % of all cases.
        constexpr double significance = 2.0;
        trace.sureLengths = ridges::SureLengthsOf(trace, this->typeErrors, significance);
      }
    }
  }
};

} // namespace

vtkRidgesSearch::vtkRidgesSearch(
  const vtkRidgesMongeInput& monge, const vtkRidgesUmbilicMarks& umbilics)
  : Monge(monge)
  , Mesh(monge.mesh)
  , Field(monge.arrays.GetField())
  , Errors(monge.arrays.GetErrors())
  , Umbilics(umbilics)
{
}

ridges::UmbilicLookup vtkRidgesSearch::MakeLookup() const
{
  const ridges::TriangleMesh& triangles = this->Mesh.GetTriangles();
  ridges::UmbilicLookup lookup;
  if (!this->UsePatches)
  {
    lookup.positionOf = [&triangles](ridges::Id t) { return triangles.Centroid(t); };
    return lookup;
  }
  lookup.positionOf = [this, &triangles](ridges::Id t) -> Eigen::Vector3d
  {
    const vtkIdType umbilic = this->Umbilics.UmbilicAt(t);
    return umbilic >= 0 ? this->Umbilics.GetPositions()[umbilic]
                        : ridges::UmbilicInTriangle(triangles, this->Field, t);
  };
  lookup.patchOf = [this](ridges::Id t)
  { return static_cast<ridges::Id>(this->Umbilics.PatchOf(t)); };
  return lookup;
}

bool vtkRidgesSearch::Find(vtkAlgorithm* filter, ridges::Color color, double from, double to,
  std::vector<ridges::RidgeTrace>& found, vtkRidgesZones* zones) const
{
  ridges::RidgeCrossings crossings(
    this->Mesh.GetTriangles(), this->Field, color, this->CrossingRule, this->ExtremalityRule);
  const auto at = [from, to](double part) { return from + part * (to - from); };
  Pieces pieces;
  std::vector<ridges::Ridge> whole;
  return this->FindCrossings(filter, from, at(0.35), crossings) &&
    this->DrawPatches(filter, at(0.35), at(0.45), crossings, pieces) &&
    this->March(filter, at(0.45), at(0.55), crossings, pieces) &&
    this->LeaveOutSmallLoops(filter, at(0.55), at(0.65), crossings, pieces, whole) &&
    this->LeaveOutZones(filter, at(0.65), at(0.7), color, pieces, whole, zones) &&
    this->Trace(filter, at(0.7), to, crossings, pieces, whole, found);
}

bool vtkRidgesSearch::FindCrossings(
  vtkAlgorithm* filter, double from, double to, ridges::RidgeCrossings& crossings) const
{
  const auto find = [&crossings](ridges::Id begin, ridges::Id end, std::vector<ridges::Id>& edges)
  { crossings.Find(begin, end, edges); };
  vtkRidgesCollector<ridges::Id, decltype(find)> finder(
    this->Mesh.GetTriangles().NumberOfEdges(), find);
  const double middle = 0.5 * (from + to);
  if (!vtkRidgesForBatches(filter, finder.GetNumberOfRanges(), from, middle, finder, 64))
  {
    return false;
  }
  std::vector<ridges::Id> crossed;
  finder.AppendTo(crossed);
  crossings.SetCrossed(std::move(crossed));
  PlaceCrossings place{ crossings };
  return vtkRidgesForBatches(filter, crossings.Size(), middle, to, place);
}

bool vtkRidgesSearch::DrawPatches(vtkAlgorithm* filter, double from, double to,
  const ridges::RidgeCrossings& crossings, Pieces& pieces) const
{
  pieces.isReplaced.assign(this->Mesh.GetTriangles().NumberOfTriangles(), 0);
  if (!this->UsePatches)
  {
    return true;
  }
  DrawShares draw(crossings, this->Umbilics.GetPatches(), pieces.isReplaced);
  if (!vtkRidgesForBatches(filter, draw.GetNumberOfShares(), from, to, draw, 1024))
  {
    return false;
  }
  draw.AppendTo(pieces.segments, pieces.paths);
  return true;
}

bool vtkRidgesSearch::March(vtkAlgorithm* filter, double from, double to,
  const ridges::RidgeCrossings& crossings, Pieces& pieces) const
{
  const auto march = [this, &crossings, &pieces](ridges::Id begin, ridges::Id end,
                       std::vector<ridges::RidgeSegment>& segments)
  {
    for (ridges::Id t = begin; t < end; ++t)
    {
      if (!pieces.isReplaced[t])
      {
        ridges::MarchTriangle(crossings, this->TypeRule, t, segments);
      }
    }
  };
  vtkRidgesCollector<ridges::RidgeSegment, decltype(march)> marcher(
    this->Mesh.GetTriangles().NumberOfTriangles(), march);
  if (!vtkRidgesForBatches(filter, marcher.GetNumberOfRanges(), from, to, marcher, 64))
  {
    return false;
  }
  marcher.AppendTo(pieces.segments);
  return true;
}

bool vtkRidgesSearch::LeaveOutSmallLoops(vtkAlgorithm* filter, double from, double to,
  const ridges::RidgeCrossings& crossings, const Pieces& pieces,
  std::vector<ridges::Ridge>& whole) const
{
  whole = ridges::AssembleRidges(crossings, pieces.segments);
  if (!(this->LoopSignificance > 0.0))
  {
    return true;
  }
  const ridges::SmallLoops smallLoops(crossings, this->Errors, this->LoopSignificance);
  std::vector<std::uint8_t> isLeftOut(whole.size(), 0);
  const auto look = [&smallLoops, &pieces, &whole, &isLeftOut](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      isLeftOut[i] = smallLoops.Contain(whole[i], pieces.segments, pieces.paths) ? 1 : 0;
    }
  };
  if (!vtkRidgesForSizedBatches(
        filter, static_cast<vtkIdType>(whole.size()), from, to, look, SizeOf{ whole }))
  {
    return false;
  }
  ridges::LeaveOut(whole, isLeftOut);
  return true;
}

bool vtkRidgesSearch::LeaveOutZones(vtkAlgorithm* filter, double from, double to,
  ridges::Color color, const Pieces& pieces, std::vector<ridges::Ridge>& whole,
  vtkRidgesZones* zones) const
{
  if (!zones || !(this->ZoneSignificance > 0.0))
  {
    return true;
  }
  vtkRidgesZoneSearch search(this->Monge, color, this->ZoneSignificance);
  return search.Run(filter, from, to, pieces.segments, pieces.paths, whole, *zones);
}

bool vtkRidgesSearch::Trace(vtkAlgorithm* filter, double from, double to,
  const ridges::RidgeCrossings& crossings, const Pieces& pieces, std::vector<ridges::Ridge>& whole,
  std::vector<ridges::RidgeTrace>& found) const
{
  const ridges::UmbilicLookup lookup = this->MakeLookup();
  found.resize(whole.size());
  TraceRidges trace{ whole, pieces.segments, pieces.paths, crossings, this->TypeRule, lookup,
    found };
  const double middle = 0.5 * (from + to);
  if (!vtkRidgesForSizedBatches(
        filter, static_cast<vtkIdType>(whole.size()), from, middle, trace, SizeOf{ whole }) ||
    !this->DecideTypes(filter, middle, to, found))
  {
    return false;
  }
  const ridges::TriangleMesh& mesh = crossings.Mesh();
  std::sort(found.begin(), found.end(),
    [&mesh](const ridges::RidgeTrace& a, const ridges::RidgeTrace& b)
    { return ridges::ComesBefore(mesh, a, b); });
  return true;
}

bool vtkRidgesSearch::DecideTypes(
  vtkAlgorithm* filter, double from, double to, std::vector<ridges::RidgeTrace>& found) const
{
  const bool byP = this->TypeRule == ridges::TypeRule::FourthOrder &&
    this->ExtremalityRule == ridges::ExtremalityRule::Principal;
  const double significance = byP ? this->TypeSignificance : 0.0;
  const ridges::TriangleMesh& mesh = this->Mesh.GetTriangles();
  ridges::TypeErrors errors(mesh, this->Field, this->Errors);
  const double middle = 0.5 * (from + to);
  if (significance > 0.0 || this->MeasuresTypes)
  {
    for (const ridges::RidgeTrace& trace : found)
    {
      errors.Require(trace);
    }
    const auto find = [&errors](vtkIdType begin, vtkIdType end)
    { errors.Find(static_cast<ridges::Id>(begin), static_cast<ridges::Id>(end)); };
    if (!vtkRidgesForBatches(filter, mesh.NumberOfPoints(), from, middle, find))
    {
      return false;
    }
  }
  DecideTypesOfRidges decide{ found, mesh, errors, significance, this->ShortestRun,
    this->MeasuresTypes };
  const auto sizeOf = [&found](vtkIdType i)
  { return static_cast<vtkIdType>(found[i].vertices.size()); };
  return vtkRidgesForSizedBatches(
    filter, static_cast<vtkIdType>(found.size()), middle, to, decide, sizeOf);
}
