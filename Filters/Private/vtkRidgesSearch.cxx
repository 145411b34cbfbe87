// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesSearch.h"

#include "Core/Ridges/Patch/PatchRidges.h"
#include "Core/Ridges/SmallLoops.h"
#include "Core/Umbilics/UmbilicForm.h"
#include "vtkRidgesBatches.h"
#include "vtkRidgesCollect.h"
#include "vtkRidgesFitErrors.h"
#include "vtkRidgesMesh.h"
#include "vtkRidgesUmbilicMarks.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <utility>

namespace
{

struct PlaceCrossings
{
  ridges::RidgeCrossings& crossings;

  void operator()(vtkIdType begin, vtkIdType end)
  {
    this->crossings.Place(static_cast<ridges::Id>(begin), static_cast<ridges::Id>(end));
  }
};

/// Traces ridges, each for itself.
struct TraceRidges
{
  const std::vector<ridges::Ridge>& ridges;
  const std::vector<ridges::RidgeSegment>& segments;
  const std::vector<ridges::RidgePath>& paths;
  const ridges::RidgeCrossings& crossings;
  ridges::TypeRule rule;
  const ridges::UmbilicLookup& umbilics;
  double shortestRun;
  std::vector<ridges::RidgeTrace>& traces;

  void operator()(vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      ridges::RidgeTrace& trace = this->traces[i];
      trace = ridges::TraceRidge(
        this->ridges[i], this->segments, this->paths, this->crossings, this->rule, this->umbilics);
      if (this->shortestRun > 0.0)
      {
        ridges::AbsorbShortRuns(trace, this->shortestRun);
      }
      ridges::MakeCanonical(trace);
    }
  }
};

} // namespace

vtkRidgesSearch::vtkRidgesSearch(
  const vtkRidgesMesh& mesh, const ridges::MongeField& field, const vtkRidgesUmbilicMarks& umbilics)
  : Mesh(mesh)
  , Field(field)
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
  std::vector<ridges::RidgeTrace>& found) const
{
  const ridges::TriangleMesh& triangles = this->Mesh.GetTriangles();
  const auto at = [from, to](double part) { return from + part * (to - from); };
  ridges::RidgeCrossings crossings(
    triangles, this->Field, color, this->CrossingRule, this->ExtremalityRule);
  const auto find = [&](ridges::Id begin, ridges::Id end, std::vector<ridges::Id>& edges)
  { crossings.Find(begin, end, edges); };
  vtkRidgesCollector<ridges::Id, decltype(find)> finder(triangles.NumberOfEdges(), find);
  if (!vtkRidgesForBatches(filter, finder.GetNumberOfRanges(), from, at(0.2), finder, 64))
  {
    return false;
  }
  std::vector<ridges::Id> crossed;
  finder.AppendTo(crossed);
  crossings.SetCrossed(std::move(crossed));
  PlaceCrossings place{ crossings };
  if (!vtkRidgesForBatches(filter, crossings.Size(), at(0.2), at(0.4), place))
  {
    return false;
  }

  std::vector<ridges::RidgeSegment> segments;
  std::vector<ridges::RidgePath> paths;
  std::vector<std::uint8_t> isReplaced(triangles.NumberOfTriangles(), 0);
  if (this->UsePatches)
  {
    const ridges::PatchRidges patchRidges(crossings);
    for (const ridges::RidgePatch& patch : this->Umbilics.GetPatches())
    {
      patchRidges.Draw(patch, segments, paths, isReplaced);
    }
  }
  const auto march = [&](
                       ridges::Id begin, ridges::Id end, std::vector<ridges::RidgeSegment>& pieces)
  {
    for (ridges::Id t = begin; t < end; ++t)
    {
      if (!isReplaced[t])
      {
        ridges::MarchTriangle(crossings, this->TypeRule, t, pieces);
      }
    }
  };
  vtkRidgesCollector<ridges::RidgeSegment, decltype(march)> marcher(
    triangles.NumberOfTriangles(), march);
  if (!vtkRidgesForBatches(filter, marcher.GetNumberOfRanges(), at(0.4), at(0.6), marcher, 64))
  {
    return false;
  }
  marcher.AppendTo(segments);

  std::vector<ridges::Ridge> whole = ridges::AssembleRidges(crossings, segments);
  if (this->LoopSignificance > 0.0)
  {
    const ridges::SmallLoops smallLoops(
      crossings, vtkRidgesFetchFitErrors(this->Mesh.GetPolyData()), this->LoopSignificance);
    whole.erase(
      std::remove_if(whole.begin(), whole.end(),
        [&](const ridges::Ridge& ridge) { return smallLoops.Contain(ridge, segments, paths); }),
      whole.end());
  }
  const ridges::UmbilicLookup lookup = this->MakeLookup();
  found.resize(whole.size());
  TraceRidges trace{ whole, segments, paths, crossings, this->TypeRule, lookup, this->ShortestRun,
    found };
  if (!vtkRidgesForBatches(filter, static_cast<vtkIdType>(whole.size()), at(0.7), to, trace))
  {
    return false;
  }
  std::sort(found.begin(), found.end(), ridges::ComesBefore);
  return true;
}
