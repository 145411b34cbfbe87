// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesSharedFit.h"

#include "Core/Base/RankGathering.h"
#include "Core/Shares/EdgeFaults.h"
#include "Core/Shares/SharedMesh.h"
#include "Core/Shares/SharedSurface.h"
#include "vtkJetFitting.h"
#include "vtkRidgesBatches.h"
#include "vtkRidgesFitFaults.h"
#include "vtkRidgesFitPoints.h"
#include "vtkRidgesFitSettings.h"
#include "vtkRidgesGhosts.h"
#include "vtkRidgesJetSelection.h"
#include "vtkRidgesMesh.h"
#include "vtkRidgesMongeOutput.h"
#include "vtkRidgesPiece.h"
#include "vtkRidgesRangeLoop.h"
#include "vtkRidgesSharedInput.h"
#include "vtkRidgesSharedRows.h"
#include "vtkRidgesUmbilicMarks.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace
{

using ridges::Id;

std::string TextOfProperties(vtkJetFitting* filter)
{
  std::ostringstream text;
  text << filter->GetDegree() << " " << filter->GetMongeOrder() << " " << filter->GetNeighborhood()
       << " " << filter->GetMinimumNumberOfPoints() << " " << filter->GetNumberOfRings() << " "
       << filter->GetRadius() << " " << filter->GetWeighting() << " "
       << filter->GetStandardErrors();
  return text.str();
}

/// The fits of one rank, from its piece to the values for it. Each step is taken by all ranks.
class SharedFit
{
public:
  SharedFit(vtkJetFitting* filter, ridges::Ranks& ranks)
    : Filter(filter)
    , Ranks(ranks)
    , Order(vtkRidgesFitOrder(filter))
    , IsAutomatic(filter->GetNeighborhood() == vtkJetFitting::AUTOMATIC)
  {
  }

  /// False after an error.
  bool Take(vtkInformationVector* input);

  /// False if the user aborted.
  bool Fit();

  void Warn();
  void Store(vtkPolyData* output);

  /// At the end, once.
  void Keep(ridges::SharedSurface& surface);

private:
  bool Choose(vtkRidgesFitPoints::Settings& settings);
  int GuessReach(const vtkRidgesFitPoints::Settings& settings) const;
  bool FitShare(const vtkRidgesFitPoints::Settings& settings, const std::vector<Id>& points,
    int rings, std::vector<int>& reach);
  void CountEdges(const ridges::MeshShare& share, const ridges::OrderedRings& rings);
  void LookAtSurface(const ridges::TriangleMesh& mesh, const ridges::OrderedRings& rings);
  void Average(vtkPointData* values);

  vtkJetFitting* Filter;
  ridges::Ranks& Ranks;
  int Order;
  bool IsAutomatic;
  vtkSmartPointer<vtkPolyData> Piece; ///< Of triangles.
  ridges::SharedMesh Shared;
  ridges::JetChoice Choice;
  std::unique_ptr<vtkRidgesMongeOutput> Values; ///< Of owned points.
  vtkRidgesFitFaults Faults;
  std::int64_t Fans = 0;        ///< Of owned points: see TriangleMesh::NumberOfFans.
  std::int64_t SharedEdges = 0; ///< With two triangles, each counted at both ends.
  bool HasCoincident = false;
  std::vector<std::uint8_t> OnBorder;
};

bool SharedFit::Take(vtkInformationVector* input)
{
  std::string faults;
  vtkPolyData* piece = vtkRidgesGetPiece(this->Ranks, input, faults);
  if (piece)
  {
    faults = vtkRidgesFitSettingsFault(this->Filter);
  }
  vtkRidgesMesh mesh;
  if (faults.empty())
  {
    faults = mesh.Build(
      piece, {}, ridges::TriangleMesh::Edges::NotBuilt, vtkRidgesMesh::Duplicates::LeftOut);
  }
  if (!vtkRidgesAgree(this->Filter, this->Ranks, piece, TextOfProperties(this->Filter), faults))
  {
    return false;
  }
  // Of the piece itself, nothing but the values of its points is needed any more.
  this->Piece = mesh.GetPolyData();
  this->Faults.triangulatedCells = mesh.GetNumberOfTriangulatedCells();
  this->Faults.unusableTriangles = mesh.GetNumberOfUnusableTriangles();
  // Found out together: all ranks have the same text.
  return vtkRidgesAgree(
    this->Filter, this->Ranks, this->Shared.Share(this->Ranks, vtkRidgesPiece(mesh).GetView()));
}

bool SharedFit::Choose(vtkRidgesFitPoints::Settings& settings)
{
  settings = vtkRidgesFitSettings(this->Filter);
  if (!this->IsAutomatic)
  {
    return true;
  }
  if (!vtkRidgesSelectJets(this->Filter, this->Ranks, this->Shared, 0.1, 0.3, this->Choice))
  {
    return false;
  }
  settings = vtkRidgesFitSettings(this->Filter, this->Choice);
  return true;
}

/// How many rings most fits will look at.
int SharedFit::GuessReach(const vtkRidgesFitPoints::Settings& settings) const
{
  constexpr int ofARadius = 4;
  switch (settings.rule.kind)
  {
    case ridges::NeighborhoodRule::Kind::PointCount:
      return vtkRidgesGhostLevelsOf(this->Filter);
    case ridges::NeighborhoodRule::Kind::Radius:
      return ofARadius;
    default:
      return settings.rule.numberOfRings;
  }
}

/// `points` are owned ones: all of them, or those whose values are to be replaced.
bool SharedFit::FitShare(const vtkRidgesFitPoints::Settings& settings,
  const std::vector<Id>& points, int rings, std::vector<int>& reach)
{
  const ridges::MeshShare share(
    this->Ranks, this->Shared, points, rings, vtkRidgesRangeLoop, vtkRidgesSharesOfThreads());
  const ridges::TriangleMesh& mesh = share.Mesh();
  ridges::OrderedRings ordered(mesh);
  vtkRidgesRangeLoop(
    mesh.NumberOfPoints(), [&ordered](Id begin, Id end) { ordered.Build(begin, end); });

  const auto count = static_cast<vtkIdType>(points.size());
  auto values = std::make_unique<vtkRidgesMongeOutput>(count, this->Order, settings.standardErrors);
  reach.assign(points.size(), 0);
  vtkRidgesFitPoints fitPoints(mesh, ordered, settings, *values);
  fitPoints.NoteReach(reach);
  const bool isDone =
    vtkRidgesForBatches(this->Filter, count, 0.3, 0.9, fitPoints, fitPoints.BatchSize());
  if (ridges::IsAnywhere(this->Ranks, !isDone))
  {
    return false;
  }
  if (this->Values)
  {
    this->Values->StoreAll(*values, points);
  }
  else
  {
    this->Values = std::move(values);
    this->CountEdges(share, ordered);
    this->LookAtSurface(mesh, ordered);
  }
  return true;
}

bool SharedFit::Fit()
{
  vtkRidgesFitPoints::Settings settings;
  if (!this->Choose(settings))
  {
    return false;
  }
  std::vector<Id> points(this->Shared.NumberOfOwned());
  std::iota(points.begin(), points.end(), 0);
  int rings = this->GuessReach(settings);
  std::vector<int> reach;
  do
  {
    if (!this->FitShare(settings, points, rings, reach))
    {
      return false;
    }
    std::vector<Id> again;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      if (reach[i] > rings)
      {
        again.push_back(points[i]);
      }
    }
    points.swap(again);
    // What lies beyond may be cut off: how far it really goes is not known yet.
    const int farthest = reach.empty() ? 0 : *std::max_element(reach.begin(), reach.end());
    const std::vector<int> all = ridges::GatherAllOne(this->Ranks, farthest);
    rings = std::max(rings + 1, *std::max_element(all.begin(), all.end()));
  } while (ridges::IsAnywhere(this->Ranks, !points.empty()));
  return true;
}

void SharedFit::CountEdges(const ridges::MeshShare& share, const ridges::OrderedRings& rings)
{
  for (Id p = 0; p < share.NumberOfInner(); ++p)
  {
    // Edges are at fault only where fans are.
    if (!rings.IsRegular(p))
    {
      const ridges::EdgeFaults faults =
        ridges::EdgeFaultsAt(share.Mesh(), p, [&share, p](Id q) { return share.IsFirstEnd(p, q); });
      this->Faults.nonManifoldEdges += faults.nonManifold;
      this->Faults.inconsistentEdges += faults.inconsistent;
    }
  }
  this->HasCoincident = !this->Shared.Points().Coincident().empty();
  if (this->HasCoincident) // as it takes long
  {
    this->Faults.coincident =
      vtkRidgesCountCoincidentPoints(this->Shared.Around(), this->Shared.NumberOfOwned());
  }
}

void SharedFit::LookAtSurface(const ridges::TriangleMesh& mesh, const ridges::OrderedRings& rings)
{
  const Id count = this->Shared.NumberOfOwned();
  this->OnBorder.assign(count, 0);
  for (Id p = 0; p < count; ++p)
  {
    const Id triangles = mesh.TrianglesAround(p).size();
    const bool isOne = rings.IsRegular(p) && triangles > 0;
    this->Fans += isOne ? 1 : mesh.NumberOfFans(p);
    this->SharedEdges +=
      isOne ? triangles - (rings.IsClosed(p) ? 0 : 1) : ridges::SharedEdgesAt(mesh, p);
    this->OnBorder[p] = rings.OnBorder(p) ? 1 : 0;
  }
}

void SharedFit::Keep(ridges::SharedSurface& surface)
{
  using ridges::SumOverRanks;
  const std::int64_t triangles = this->Shared.NumberOfTriangles();
  const std::int64_t fans = SumOverRanks(this->Ranks, this->Fans);
  const std::int64_t sharedEdges = SumOverRanks(this->Ranks, this->SharedEdges) / 2;
  surface.eulerCharacteristic = fans - (3 * triangles - sharedEdges) + triangles;
  surface.isClosed = 2 * sharedEdges == 3 * triangles;
  surface.hasCoincident = ridges::IsAnywhere(this->Ranks, this->HasCoincident);
  surface.onBorder = std::move(this->OnBorder);
  surface.points = this->Shared.TakePoints();
}

void SharedFit::Warn()
{
  this->Faults.CountPoints(this->Values->GetStatus());
  vtkRidgesFitFaults all;
  for (const vtkRidgesFitFaults& faults : ridges::GatherAllOne(this->Ranks, this->Faults))
  {
    all += faults;
  }
  all.triangles = this->Shared.NumberOfTriangles();
  const std::string text = all.GetText();
  if (!text.empty() && this->Ranks.Rank() == 0)
  {
    vtkWarningWithObjectMacro(this->Filter, << text << ".");
  }
}

/// Averages look at neighbours, the values of which are those that their owners fitted.
void SharedFit::Average(vtkPointData* values)
{
  std::vector<Id> points(this->Shared.NumberOfOwned());
  std::iota(points.begin(), points.end(), 0);
  ridges::MeshShare share(this->Ranks, this->Shared, std::move(points),
    this->Choice.numberOfAverages, vtkRidgesRangeLoop, vtkRidgesSharesOfThreads());
  vtkNew<vtkPolyData> data;
  vtkRidgesRowsOfShare(this->Ranks, share, values, data->GetPointData());

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
  vtkRidgesAverageJets(mesh, data, this->Choice);

  values->Initialize();
  vtkPointData* averaged = data->GetPointData();
  for (int i = 0; i < averaged->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = averaged->GetArray(i);
    array->Resize(this->Shared.NumberOfOwned());
    array->SetNumberOfTuples(this->Shared.NumberOfOwned());
    values->AddArray(array);
  }
}

void SharedFit::Store(vtkPolyData* output)
{
  vtkNew<vtkPointData> values;
  this->Values->AddTo(values);
  this->Values = nullptr;
  if (this->Choice.numberOfAverages > 0)
  {
    this->Average(values);
  }
  this->Shared.Release();
  output->ShallowCopy(this->Piece);
  vtkRidgesMongeOutput(0, this->Order, false).AddTo(output->GetPointData());
  vtkRidgesRowsOfPiece(this->Ranks, this->Shared.Points(), values, output->GetPointData());
  vtkRidgesUmbilicMarks::RemoveFrom(output);
  const bool hasChoice = this->IsAutomatic && this->Shared.Points().NumberOfAll() > 0;
  vtkRidgesStoreJetChoice(output, hasChoice ? &this->Choice : nullptr);
}

} // namespace

int vtkRidgesSharedFit(vtkJetFitting* filter, ridges::Ranks& ranks, vtkInformationVector* input,
  vtkPolyData* output, ridges::SharedSurface* surface)
{
  SharedFit fit(filter, ranks);
  if (!fit.Take(input))
  {
    return 0;
  }
  if (!fit.Fit())
  {
    return 1;
  }
  fit.Warn();
  fit.Store(output);
  if (surface)
  {
    fit.Keep(*surface);
  }
  return 1;
}
