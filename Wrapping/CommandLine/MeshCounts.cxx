// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshCounts.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRidgesArrayNames.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace names = vtkRidgesArrayNames;

namespace program
{
namespace
{

using MeshEdge = std::pair<vtkIdType, vtkIdType>;

/// Calls visit(edge, number of triangles) for each.
template <typename Visit>
void ForEdges(std::vector<MeshEdge>& sides, const Visit& visit)
{
  std::sort(sides.begin(), sides.end());
  for (auto first = sides.begin(); first != sides.end();)
  {
    const auto last =
      std::find_if(first, sides.end(), [&first](const MeshEdge& edge) { return edge != *first; });
    visit(*first, last - first);
    first = last;
  }
}

/// The sides of triangles, by the ids of their points or, where they have such, those in the whole
/// mesh.
std::vector<MeshEdge> SidesOf(vtkPolyData* mesh, vtkDataArray* wholeIds)
{
  std::vector<MeshEdge> sides;
  sides.reserve(3 * static_cast<std::size_t>(mesh->GetNumberOfPolys()));
  const auto idOf = [wholeIds](vtkIdType p)
  { return wholeIds ? static_cast<vtkIdType>(wholeIds->GetTuple1(p)) : p; };
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  for (mesh->GetPolys()->InitTraversal(); mesh->GetPolys()->GetNextCell(size, corners);)
  {
    for (vtkIdType i = 0; i < size; ++i)
    {
      sides.push_back(std::minmax({ idOf(corners[i]), idOf(corners[(i + 1) % size]) }));
    }
  }
  return sides;
}

/// Those with one triangle in a piece may have another one in others.
void CountEdges(vtkPolyData* mesh, vtkDataArray* wholeIds, const Ranks& ranks, MeshCounts& counts)
{
  vtkNew<vtkIdTypeArray> open;
  open->SetNumberOfComponents(2);
  std::vector<MeshEdge> sides = SidesOf(mesh, wholeIds);
  const auto count = [&counts, &open](const MeshEdge& edge, std::ptrdiff_t triangles)
  {
    counts.nonManifoldEdges += triangles > 2 ? 1 : 0;
    if (triangles == 1)
    {
      open->InsertNextTuple2(static_cast<double>(edge.first), static_cast<double>(edge.second));
    }
  };
  ForEdges(sides, count);
  if (!ranks.AreSeveral())
  {
    counts.borderEdges = open->GetNumberOfTuples();
    return;
  }
  vtkNew<vtkIdTypeArray> all;
  ranks.GatherOnFirst(open, all);
  sides.clear();
  for (vtkIdType i = 0; i < all->GetNumberOfTuples(); ++i)
  {
    sides.emplace_back(all->GetTypedComponent(i, 0), all->GetTypedComponent(i, 1));
  }
  ForEdges(sides,
    [&counts](const MeshEdge&, std::ptrdiff_t triangles)
    {
      counts.borderEdges += triangles == 1 ? 1 : 0;
      counts.nonManifoldEdges += triangles > 2 ? 1 : 0;
    });
}

long long CountInZone(vtkPolyData* mesh, const char* name, int component)
{
  vtkDataArray* zones = mesh->GetCellData()->GetArray(name);
  long long count = 0;
  for (vtkIdType i = 0; zones && i < zones->GetNumberOfTuples(); ++i)
  {
    count += zones->GetComponent(i, component) >= 0.0 ? 1 : 0;
  }
  return count;
}

/// Pieces share the points of their seams: each counts for the first rank that has it. Ids in the
/// whole mesh follow the ranks.
void CountPoints(vtkPolyData* mesh, vtkDataArray* wholeIds, const Ranks& ranks, MeshCounts& counts)
{
  long long own = 0;
  for (vtkIdType p = 0; wholeIds && p < wholeIds->GetNumberOfTuples(); ++p)
  {
    own = std::max(own, static_cast<long long>(wholeIds->GetTuple1(p)) + 1);
  }
  const std::vector<long long> ends = ranks.GatherAll({ own });
  const auto here = ends.begin() + ranks.Rank();
  const long long first =
    wholeIds && here != ends.begin() ? *std::max_element(ends.begin(), here) : 0;
  constexpr std::array<int, 4> bits = { vtkJetFitting::FIT_BOUNDARY,
    vtkJetFitting::FIT_TOO_FEW_POINTS, vtkJetFitting::FIT_ILL_CONDITIONED,
    vtkJetFitting::FIT_INVALID };
  vtkDataArray* status = mesh->GetPointData()->GetArray(names::FitStatus);
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    if (wholeIds && static_cast<long long>(wholeIds->GetTuple1(p)) < first)
    {
      continue;
    }
    ++counts.points;
    for (std::size_t i = 0; status && i < bits.size(); ++i)
    {
      counts.degraded[i] += (static_cast<int>(status->GetTuple1(p)) & bits[i]) != 0 ? 1 : 0;
    }
  }
}

} // namespace

MeshCounts CountMesh(vtkPolyData* mesh, const Ranks& ranks)
{
  MeshCounts counts;
  vtkDataArray* wholeIds =
    ranks.AreSeveral() ? mesh->GetPointData()->GetArray(names::GatheredPointId) : nullptr;
  CountPoints(mesh, wholeIds, ranks, counts);
  CountEdges(mesh, wholeIds, ranks, counts);
  counts.triangles = mesh->GetNumberOfPolys();
  counts.umbilicZone = CountInZone(mesh, names::UmbilicZone, 0);
  counts.ridgeZone = { CountInZone(mesh, names::RidgeZone, 0),
    CountInZone(mesh, names::RidgeZone, 1) };

  const std::array<long long*, 11> all = { &counts.points, &counts.triangles, &counts.borderEdges,
    &counts.nonManifoldEdges, &counts.degraded[0], &counts.degraded[1], &counts.degraded[2],
    &counts.degraded[3], &counts.umbilicZone, &counts.ridgeZone[0], &counts.ridgeZone[1] };
  std::vector<long long> own;
  for (long long* value : all)
  {
    own.push_back(std::exchange(*value, 0));
  }
  const std::vector<long long> values = ranks.GatherAll(own);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    *all[i % all.size()] += values[i];
  }
  return counts;
}

void PieceCounts::Add(vtkPolyData* piece)
{
  std::vector<MeshEdge> sides = SidesOf(piece, nullptr);
  std::vector<char> isInner(piece->GetNumberOfPoints(), 0);
  for (const MeshEdge& side : sides)
  {
    isInner[side.first] = 1;
    isInner[side.second] = 1;
  }
  const auto placeOf = [piece](vtkIdType p)
  {
    Place place;
    piece->GetPoint(p, place.data());
    return place;
  };
  const auto count = [this, &isInner, &placeOf](const MeshEdge& edge, std::ptrdiff_t triangles)
  {
    this->NonManifoldEdges += triangles > 2 ? 1 : 0;
    if (triangles == 1)
    {
      isInner[edge.first] = 0;
      isInner[edge.second] = 0;
      ++this->OpenEdges[std::minmax(placeOf(edge.first), placeOf(edge.second))];
    }
  };
  ForEdges(sides, count);
  for (vtkIdType p = 0; p < piece->GetNumberOfPoints(); ++p)
  {
    if (isInner[p] != 0)
    {
      ++this->InnerPoints;
    }
    else
    {
      this->OpenPoints.insert(placeOf(p));
    }
  }
  this->Triangles += piece->GetNumberOfPolys();
}

MeshCounts PieceCounts::Counts() const
{
  MeshCounts counts;
  counts.points = this->InnerPoints + static_cast<long long>(this->OpenPoints.size());
  counts.triangles = this->Triangles;
  counts.nonManifoldEdges = this->NonManifoldEdges;
  for (const auto& [edge, pieces] : this->OpenEdges)
  {
    counts.borderEdges += pieces == 1 ? 1 : 0;
    counts.nonManifoldEdges += pieces > 2 ? 1 : 0;
  }
  return counts;
}

} // namespace program
