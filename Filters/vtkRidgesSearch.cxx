// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesSearch.h"

#include "Core/PatchRidges.h"
#include "Core/SmallLoops.h"
#include "Core/UmbilicForm.h"
#include "vtkRidgesBatches.h"
#include "vtkRidgesFitErrors.h"
#include "vtkRidgesMesh.h"
#include "vtkRidgesUmbilicMarks.h"

#include "vtkPolyData.h"

#include <algorithm>

namespace
{

struct FindCrossings
{
  ridges::RidgeCrossings& crossings;

  void operator()(vtkIdType begin, vtkIdType end)
  {
    this->crossings.Find(static_cast<ridges::Id>(begin), static_cast<ridges::Id>(end));
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

/// Marches chunks of triangles, each into segments of its own: their order does not depend on the
/// threads.
class MarchTriangles
{
public:
  /// Triangles with a flag set in `isReplaced` are passed over.
  MarchTriangles(const ridges::RidgeCrossings& crossings, ridges::TypeRule rule,
    const std::vector<std::uint8_t>& isReplaced)
    : Crossings(crossings)
    , Rule(rule)
    , IsReplaced(isReplaced)
    , Segments((crossings.Mesh().NumberOfTriangles() + ChunkSize - 1) / ChunkSize)
  {
  }

  vtkIdType GetNumberOfChunks() const { return static_cast<vtkIdType>(this->Segments.size()); }

  void operator()(vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType chunk = begin; chunk < end; ++chunk)
    {
      const auto first = static_cast<ridges::Id>(chunk * ChunkSize);
      const ridges::Id last =
        std::min<ridges::Id>(first + ChunkSize, this->Crossings.Mesh().NumberOfTriangles());
      for (ridges::Id t = first; t < last; ++t)
      {
        if (!this->IsReplaced[t])
        {
          ridges::MarchTriangle(this->Crossings, this->Rule, t, this->Segments[chunk]);
        }
      }
    }
  }

  /// Appends what was found.
  void Collect(std::vector<ridges::RidgeSegment>& all) const
  {
    for (const auto& chunk : this->Segments)
    {
      all.insert(all.end(), chunk.begin(), chunk.end());
    }
  }

private:
  static constexpr ridges::Id ChunkSize = 8192;

  const ridges::RidgeCrossings& Crossings;
  ridges::TypeRule Rule;
  const std::vector<std::uint8_t>& IsReplaced;
  std::vector<std::vector<ridges::RidgeSegment>> Segments;
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
  FindCrossings find{ crossings };
  if (!vtkRidgesForBatches(filter, triangles.NumberOfEdges(), from, at(0.2), find))
  {
    return false;
  }
  crossings.Number();
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
  MarchTriangles march(crossings, this->TypeRule, isReplaced);
  if (!vtkRidgesForBatches(filter, march.GetNumberOfChunks(), at(0.4), at(0.6), march, 64))
  {
    return false;
  }
  march.Collect(segments);

  std::vector<ridges::Ridge> whole = ridges::AssembleRidges(triangles, segments);
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
