// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesOwnedFits.h"

#include "Core/Base/LargeMemory.h"
#include "Core/Base/RankGathering.h"
#include "Core/Mesh/CurveOrder.h"
#include "Core/Shares/EdgeFaults.h"
#include "vtkJetFitting.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesFitSettings.h"
#include "vtkRidgesGhosts.h"
#include "vtkRidgesJetBlend.h"
#include "vtkRidgesJetSelection.h"
#include "vtkRidgesMesh.h"
#include "vtkRidgesPartsToPieces.h"
#include "vtkRidgesRangeLoop.h"
#include "vtkRidgesSharedRows.h"
#include "vtkRidgesUmbilicMarks.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <numeric>

using ridges::Id;

vtkRidgesOwnedFits::vtkRidgesOwnedFits(
  vtkJetFitting* filter, ridges::Ranks& ranks, ridges::SharedMesh& shared)
  : Filter(filter)
  , Ranks(ranks)
  , Shared(shared)
  , Order(vtkRidgesFitOrder(filter))
  , IsAutomatic(filter->GetNeighborhood() == vtkJetFitting::AUTOMATIC)
  , SeenOf(shared.NumberOfOwned(), Seen::No)
{
}

bool vtkRidgesOwnedFits::Choose()
{
  this->Settings = { vtkRidgesFitSettings(this->Filter) };
  if (!this->IsAutomatic)
  {
    return true;
  }
  if (!vtkRidgesSelectJets(this->Filter, this->Ranks, this->Shared, 0.1, 0.3, this->Choice))
  {
    return false;
  }
  this->Settings = vtkRidgesFitSettings(this->Filter, this->Choice);
  return true;
}

const ridges::JetChoice* vtkRidgesOwnedFits::GetChoice() const
{
  return this->IsAutomatic && this->Shared.Points().NumberOfAll() > 0 ? &this->Choice : nullptr;
}

void vtkRidgesOwnedFits::SetProgress(double from, double to)
{
  this->From = from;
  this->To = to;
}

/// How many rings most fits will look at.
int vtkRidgesOwnedFits::GuessReach() const
{
  constexpr int ofARadius = 4;
  const ridges::NeighborhoodRule& last = this->Settings.back().rule; // that looks farthest
  switch (last.kind)
  {
    case ridges::NeighborhoodRule::Kind::PointCount:
      return vtkRidgesGhostLevelsOf(this->Filter);
    case ridges::NeighborhoodRule::Kind::Radius:
      return ofARadius;
    default:
      return last.numberOfRings;
  }
}

/// `points` are those that are fitted, or those of them whose values are to be replaced.
bool vtkRidgesOwnedFits::FitShare(const std::vector<Id>& points, int rings, std::vector<int>& reach)
{
  const ridges::MeshShare share(
    this->Ranks, this->Shared, points, rings, vtkRidgesRangeLoop, vtkRidgesSharesOfThreads());
  const ridges::TriangleMesh& mesh = share.Mesh();
  ridges::OrderedRings ordered(mesh);
  vtkRidgesRangeLoop(
    mesh.NumberOfPoints(), [&ordered](Id begin, Id end) { ordered.Build(begin, end); });

  const auto count = static_cast<vtkIdType>(points.size());
  auto values =
    std::make_unique<vtkRidgesMongeOutput>(count, this->Order, this->Settings[0].standardErrors);
  reach.assign(points.size(), 0);
  const vtkRidgesJets jets{ mesh, ordered, count, this->Order, this->Settings,
    this->Choice.noiseInBlend };
  const bool isDone = vtkRidgesFitJets(this->Filter, jets, this->From, this->To, *values, &reach);
  if (ridges::IsAnywhere(this->Ranks, !isDone))
  {
    return false;
  }
  this->LookAt(share, ordered, points);
  this->Values = std::move(values);
  return true;
}

/// The values at these points, in their order. Null if the user aborted.
std::unique_ptr<vtkRidgesMongeOutput> vtkRidgesOwnedFits::FitPoints(const std::vector<Id>& points)
{
  std::unique_ptr<vtkRidgesMongeOutput> fitted;
  std::vector<Id> places; // of those that are fitted again
  std::vector<Id> again;
  int rings = this->GuessReach();
  bool isDone = false;
  while (!isDone)
  {
    std::vector<int> reach;
    if (!this->FitShare(fitted ? again : points, rings, reach))
    {
      return nullptr;
    }
    const bool isFirst = !fitted;
    if (isFirst)
    {
      fitted = std::move(this->Values);
    }
    else
    {
      fitted->StoreAll(*this->Values, places);
      this->Values = nullptr;
    }
    std::vector<Id> farPlaces;
    for (std::size_t i = 0; i < reach.size(); ++i)
    {
      if (reach[i] > rings)
      {
        farPlaces.push_back(isFirst ? static_cast<Id>(i) : places[i]);
      }
    }
    places.swap(farPlaces);
    again.resize(places.size());
    std::transform(
      places.begin(), places.end(), again.begin(), [&points](Id place) { return points[place]; });
    // What lies beyond may be cut off: how far it really goes is not known yet.
    const int farthest = reach.empty() ? 0 : *std::max_element(reach.begin(), reach.end());
    const std::vector<int> ofAll = ridges::GatherAllOne(this->Ranks, farthest);
    rings = std::max(rings + 1, *std::max_element(ofAll.begin(), ofAll.end()));
    isDone = !ridges::IsAnywhere(this->Ranks, !again.empty());
  }
  this->CountPoints(points, fitted->GetStatus());
  return fitted;
}

bool vtkRidgesOwnedFits::Fit(const std::vector<Id>& points, vtkPointData* values)
{
  const std::unique_ptr<vtkRidgesMongeOutput> fitted = this->FitPoints(points);
  if (fitted)
  {
    fitted->AddTo(values);
  }
  return fitted != nullptr;
}

/// All owned points, so that those of each part lie together, each as they lie in memory. As many
/// parts on all ranks.
std::vector<Id> vtkRidgesOwnedFits::PointsInParts(std::vector<Id>& begins) const
{
  // Of smaller parts, what lies around is as much as they are; of larger ones, each takes new
  // memory from the system.
  constexpr Id smallestPart = 1 << 14;
  const Id count = this->Shared.NumberOfOwned();
  const std::vector<Id> ofAll = ridges::GatherAllOne(this->Ranks, count);
  const Id most = *std::max_element(ofAll.begin(), ofAll.end());
  const Id parts = std::max<Id>(most / smallestPart, 1);
  for (Id i = 0; i <= parts; ++i)
  {
    begins.push_back(static_cast<Id>(static_cast<std::int64_t>(count) * i / parts));
  }
  if (parts == 1)
  {
    std::vector<Id> points(count);
    std::iota(points.begin(), points.end(), 0);
    return points;
  }
  std::vector<Id> points = ridges::PointsAlongCurve(this->Shared.Around(), count);
  for (Id i = 0; i < parts; ++i)
  {
    std::sort(points.begin() + begins[i], points.begin() + begins[i + 1]);
  }
  return points;
}

/// In parts, as the share of the mesh that fits look at takes memory. False if the user aborted.
template <typename TakePart>
bool vtkRidgesOwnedFits::FitInParts(
  const std::vector<Id>& points, const std::vector<Id>& begins, const TakePart& takePart)
{
  ridges::ReturnFreeMemory();
  const double from = this->From;
  const double step = (this->To - from) / static_cast<double>(begins.size() - 1);
  for (std::size_t i = 0; i + 1 < begins.size(); ++i)
  {
    this->SetProgress(
      from + step * static_cast<double>(i), from + step * static_cast<double>(i + 1));
    const std::vector<Id> part(points.begin() + begins[i], points.begin() + begins[i + 1]);
    const std::unique_ptr<vtkRidgesMongeOutput> fitted = this->FitPoints(part);
    if (!fitted)
    {
      return false;
    }
    takePart(i, part, *fitted);
  }
  return true;
}

bool vtkRidgesOwnedFits::FitPiece(vtkPointData* values)
{
  std::vector<Id> begins;
  const std::vector<Id> points = this->PointsInParts(begins);
  const ridges::SharedPoints& shared = this->Shared.Points();
  const bool standardErrors = this->Settings[0].standardErrors;
  if (this->Choice.numberOfAverages == 0)
  {
    const vtkRidgesPartsToPieces toPieces(this->Ranks, shared, points, begins);
    vtkRidgesMongeOutput ofPiece(shared.NumberOfPoints(), this->Order, standardErrors);
    const bool isDone = this->FitInParts(points, begins,
      [&toPieces, &ofPiece](std::size_t i, const auto& part, const vtkRidgesMongeOutput& fitted)
      { toPieces.Send(i, part, fitted, ofPiece); });
    ofPiece.AddTo(values);
    return isDone;
  }
  vtkRidgesMongeOutput all(this->Shared.NumberOfOwned(), this->Order, standardErrors);
  if (!this->FitInParts(points, begins,
        [&all](std::size_t, const std::vector<Id>& part, const vtkRidgesMongeOutput& fitted)
        { all.StoreAll(fitted, part); }))
  {
    return false;
  }
  vtkNew<vtkPointData> owned;
  all.AddTo(owned);
  this->Average(owned);
  vtkRidgesRowsOfPiece(this->Ranks, shared, owned, values);
  return true;
}

bool vtkRidgesOwnedFits::FitAndAverage(const std::vector<Id>& points, vtkPointData* values)
{
  if (this->Choice.numberOfAverages == 0)
  {
    return this->Fit(points, values);
  }
  // Of the points around these, too: they are averaged with them.
  ridges::MeshShare share(this->Ranks, this->Shared, points, this->Choice.numberOfAverages,
    vtkRidgesRangeLoop, vtkRidgesSharesOfThreads());
  vtkNew<vtkPointData> ofShare;
  if (!this->Fit(share.Owned(), ofShare))
  {
    return false;
  }
  this->AverageOn(share, ofShare, values);
  return true;
}

/// The values are those of all owned points.
void vtkRidgesOwnedFits::Average(vtkPointData* values)
{
  std::vector<Id> points(this->Shared.NumberOfOwned());
  std::iota(points.begin(), points.end(), 0);
  ridges::MeshShare share(this->Ranks, this->Shared, std::move(points),
    this->Choice.numberOfAverages, vtkRidgesRangeLoop, vtkRidgesSharesOfThreads());
  vtkNew<vtkPointData> ofShare;
  vtkRidgesRowsOfShare(this->Ranks, share, values, ofShare);
  values->Initialize();
  this->AverageOn(share, ofShare, values);
}

/// Averages look at neighbours: the values are those of all points of the share, the averages of
/// those that come first.
void vtkRidgesOwnedFits::AverageOn(
  ridges::MeshShare& share, vtkPointData* ofShare, vtkPointData* values)
{
  vtkNew<vtkPolyData> data;
  data->GetPointData()->ShallowCopy(ofShare);
  ofShare->Initialize();
  const Id inner = share.NumberOfInner();
  const Id count = share.Mesh().NumberOfPoints();
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  vtkNew<vtkPoints> positions;
  positions->SetDataTypeToDouble();
  if (count > 0)
  {
    // Not written to: the values are const for all who take them.
    coordinates->SetArray(const_cast<double*>(share.Mesh().Point(0).data()), 3 * count, 1);
    positions->SetData(coordinates);
  }
  data->SetPoints(positions);
  vtkNew<vtkCellArray> polys;
  for (const ridges::Triangle& corners : share.Mesh().Triangles())
  {
    const vtkIdType ids[] = { corners[0], corners[1], corners[2] };
    polys->InsertNextCell(3, ids);
  }
  data->SetPolys(polys);
  vtkRidgesMesh mesh;
  mesh.Adopt(data, share.TakeMesh());
  // Ranks have to go on together.
  vtkRidgesAverageJets(nullptr, mesh, data, this->Choice, 0.0, 1.0);

  vtkPointData* averaged = data->GetPointData();
  for (int i = 0; i < averaged->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = averaged->GetArray(i);
    array->Resize(inner);
    array->SetNumberOfTuples(inner);
    values->AddArray(array);
  }
}

/// At points that were not looked at before.
void vtkRidgesOwnedFits::LookAt(
  const ridges::MeshShare& share, const ridges::OrderedRings& rings, const std::vector<Id>& points)
{
  const ridges::TriangleMesh& mesh = share.Mesh();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    Seen& seen = this->SeenOf[points[i]];
    if (seen != Seen::No)
    {
      continue;
    }
    const auto p = static_cast<Id>(i);
    seen = rings.OnBorder(p) ? Seen::OnBorder : Seen::Inside;
    const Id triangles = mesh.TrianglesAround(p).size();
    const bool isOne = rings.IsRegular(p) && triangles > 0;
    this->Fans += isOne ? 1 : mesh.NumberOfFans(p);
    this->SharedEdges +=
      isOne ? triangles - (rings.IsClosed(p) ? 0 : 1) : ridges::SharedEdgesAt(mesh, p);
    // Edges are at fault only where fans are.
    if (!rings.IsRegular(p))
    {
      const ridges::EdgeFaults faults =
        ridges::EdgeFaultsAt(mesh, p, [&share, p](Id q) { return share.IsFirstEnd(p, q); });
      this->Faults.nonManifoldEdges += faults.nonManifold;
      this->Faults.inconsistentEdges += faults.inconsistent;
    }
  }
}

/// By their status, those that were not counted before.
void vtkRidgesOwnedFits::CountPoints(const std::vector<Id>& points, vtkIntArray* status)
{
  this->IsCounted.resize(this->SeenOf.size(), false);
  vtkNew<vtkIntArray> statuses;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (!this->IsCounted[points[i]])
    {
      statuses->InsertNextValue(status->GetValue(static_cast<vtkIdType>(i)));
      this->IsCounted[points[i]] = true;
    }
  }
  this->Faults.CountPoints(statuses);
}

vtkRidgesFitFaults vtkRidgesOwnedFits::CountFaults() const
{
  vtkRidgesFitFaults all = this->Faults;
  if (!this->Shared.Points().Coincident().empty()) // as it takes long
  {
    all.coincident =
      vtkRidgesCountCoincidentPoints(this->Shared.Around(), this->Shared.NumberOfOwned());
  }
  return all;
}

void vtkRidgesOwnedFits::KeepSurface(ridges::SharedSurface& surface)
{
  using ridges::SumOverRanks;
  const std::int64_t triangles = this->Shared.NumberOfTriangles();
  const std::int64_t fans = SumOverRanks(this->Ranks, this->Fans);
  const std::int64_t sharedEdges = SumOverRanks(this->Ranks, this->SharedEdges) / 2;
  surface.eulerCharacteristic = fans - (3 * triangles - sharedEdges) + triangles;
  surface.isClosed = 2 * sharedEdges == 3 * triangles;
  surface.hasCoincident =
    ridges::IsAnywhere(this->Ranks, !this->Shared.Points().Coincident().empty());
  surface.onBorder.resize(this->SeenOf.size());
  std::transform(this->SeenOf.begin(), this->SeenOf.end(), surface.onBorder.begin(),
    [](Seen seen) { return seen == Seen::OnBorder ? 1 : 0; });
}

void vtkRidgesOwnedFits::Store(vtkPolyData* piece, vtkPointData* values, vtkPolyData* output) const
{
  output->ShallowCopy(piece);
  vtkPointData* arrays = output->GetPointData();
  vtkRidgesMongeOutput(0, this->Order, false).AddTo(arrays);
  for (int i = 0; i < values->GetNumberOfArrays(); ++i)
  {
    arrays->AddArray(values->GetAbstractArray(i));
  }
  arrays->SetActiveNormals(vtkRidgesArrayNames::Normals);
  vtkRidgesUmbilicMarks::RemoveFrom(output);
  vtkRidgesStoreJetChoice(output, this->GetChoice());
}
