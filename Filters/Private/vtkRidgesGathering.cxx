// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesGathering.h"

#include "Core/Base/RankGathering.h"
#include "Core/Fit/JetFit.h"
#include "Core/Mesh/CoordinateRounding.h"
#include "Core/Shares/PieceWalks.h"
#include "Core/Umbilics/TriangleContent.h"
#include "vtkRidgesArrayMessages.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesFieldData.h"
#include "vtkRidgesGatheredRows.h"
#include "vtkRidgesMakeArray.h"
#include "vtkRidgesMongeArrays.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace names = vtkRidgesArrayNames;
using ridges::Id;

namespace
{

constexpr std::uint8_t Beyond = std::numeric_limits<std::uint8_t>::max();

/// Whether a point with triangles has no fit.
bool LacksFit(vtkPolyData* piece, const ridges::TriangleMesh& mesh)
{
  vtkDataArray* status = piece->GetPointData()->GetArray(names::FitStatus);
  for (Id p = 0; status && p < mesh.NumberOfPoints(); ++p)
  {
    if ((static_cast<int>(status->GetTuple1(p)) & ridges::FitInvalid) != 0 &&
      mesh.TrianglesAround(p).size() > 0)
    {
      return true;
    }
  }
  return false;
}

/// A copy of an array of ids, with others.
void Renumber(vtkFieldData* data, const char* name, const std::vector<std::int64_t>& numbers)
{
  vtkDataArray* ids = data->GetArray(name);
  if (!ids)
  {
    return;
  }
  const auto array = vtkRidgesMakeArrayLike(ids);
  array->SetNumberOfTuples(ids->GetNumberOfTuples());
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    const double id = ids->GetTuple1(i);
    array->SetTuple1(i, id < 0.0 ? id : static_cast<double>(numbers[static_cast<std::size_t>(id)]));
  }
  data->AddArray(array);
}

} // namespace

void vtkRidgesGathering::Extent::Enlarge()
{
  constexpr int most = 100;
  this->ringsOfRidges = 2 * this->ringsOfRidges + 1;
  this->ringsOfUmbilics = 2 * this->ringsOfUmbilics;
  this->isAll = this->ringsOfUmbilics > most;
}

bool vtkRidgesGathering::Extent::operator==(const Extent& other) const
{
  return this->isAll == other.isAll && this->significance == other.significance &&
    this->ringsOfUmbilics == other.ringsOfUmbilics && this->ringsOfRidges == other.ringsOfRidges;
}

void vtkRidgesGathering::Take(
  ridges::Ranks& ranks, vtkPolyData* piece, ridges::SharedSurface& surface)
{
  // The fit has found nothing wrong.
  this->Piece.Build(
    piece, {}, ridges::TriangleMesh::Edges::NotBuilt, vtkRidgesMesh::Duplicates::LeftOut);
  const ridges::TriangleMesh& mesh = this->Piece.GetTriangles();
  this->Mesh = &mesh;
  this->PointIds = ridges::NumbersByPieces(ranks, surface.points);
  this->Seams = ridges::PieceSeams(ranks, surface.points);
  this->First = { 0 };
  for (const Id count : ridges::GatherAllOne(ranks, mesh.NumberOfTriangles()))
  {
    this->First.push_back(this->First.back() + count);
  }
  // Coincident points are told apart by what lies around them, and without a fit there are holes.
  this->PartMayDo = !surface.hasCoincident && !ridges::IsAnywhere(ranks, LacksFit(piece, mesh));
  if (this->PartMayDo)
  {
    auto* scale = vtkDoubleArray::SafeDownCast(piece->GetPointData()->GetArray(names::FitScale));
    this->Know(ranks, surface,
      surface.isClosed ? std::vector<std::uint8_t>()
                       : surface.points.ToPiece(ranks, surface.onBorder.data(), 1),
      scale ? scale->GetPointer(0) : nullptr);
  }
  surface = ridges::SharedSurface();
}

void vtkRidgesGathering::Know(ridges::Ranks& ranks, const ridges::SharedSurface& surface,
  const std::vector<std::uint8_t>& onBorder, const double* radii)
{
  this->EulerCharacteristic = surface.eulerCharacteristic;
  this->IsClosed = surface.isClosed;
  this->EnclosingRadius = ridges::EnclosingRadiusOfPieces(ranks, *this->Mesh);
  this->CoordinateRounding = {};
  for (const ridges::CoordinateRounding& ofRank :
    ridges::GatherAllOne(ranks, ridges::FindCoordinateRounding(*this->Mesh)))
  {
    this->CoordinateRounding.Include(ofRank);
  }
  this->BorderStrip.clear();
  if (!surface.isClosed)
  {
    this->BorderStrip =
      ridges::BorderStripOfPiece(ranks, *this->Mesh, this->Seams, onBorder, radii);
  }
}

vtkSmartPointer<vtkPolyData> vtkRidgesGathering::Gather(
  ridges::Ranks& ranks, vtkAlgorithm* filter, const Extent& extent)
{
  const bool isPart = !extent.isAll && this->Choose(ranks, filter, extent);
  if (!isPart)
  {
    this->ChooseAll();
  }
  this->Part = nullptr;
  vtkSmartPointer<vtkPolyData> part;
  if (ranks.Rank() == 0)
  {
    part = vtkSmartPointer<vtkPolyData>::New();
    if (isPart)
    {
      this->Part = std::make_unique<ridges::MeshPart>();
      this->Part->eulerCharacteristic = static_cast<Id>(this->EulerCharacteristic);
      this->Part->isClosed = this->IsClosed;
      this->Part->enclosingRadius = this->EnclosingRadius;
      this->Part->coordinateRounding = this->CoordinateRounding;
    }
  }
  const std::vector<Id> points = this->ChosenPoints();
  this->GatherTriangles(ranks, points, part);
  this->GatherPoints(ranks, points, part);
  if (part)
  {
    this->AddFieldData(part);
  }
  return part;
}

void vtkRidgesGathering::AddFieldData(vtkPolyData* part)
{
  part->GetFieldData()->ShallowCopy(this->Piece.GetPolyData()->GetFieldData());
}

vtkRidgesGathering::Contents vtkRidgesGathering::ContentsOf(
  vtkAlgorithm* filter, const Extent& extent)
{
  return ContentsOf(filter, this->Piece.GetPolyData(), this->Mesh->Triangles(), extent,
    this->CoordinateRounding.Height());
}

vtkRidgesGathering::Contents vtkRidgesGathering::ContentsOf(vtkAlgorithm* filter, vtkPolyData* data,
  ridges::Span<ridges::Triangle> triangles, const Extent& extent, double rounding)
{
  const auto count = static_cast<Id>(data->GetNumberOfPoints());
  Contents atPoints(count, ridges::TriangleContent::Nothing);
  if (triangles.size() == 0)
  {
    return atPoints;
  }
  vtkRidgesMongeArrays arrays;
  arrays.Fetch(filter, data, false);
  ridges::FitErrorSource errors = arrays.GetErrors();
  errors.rounding = rounding;
  const ridges::TriangleContents contents(arrays.GetField(), errors, extent.significance, count);
  // Along borders it takes all fits that are one-sided to know what their ridges mean.
  const std::vector<std::uint8_t> isFlagged = arrays.FlaggedPoints();
  const auto contentOf = [&contents, &isFlagged](const ridges::Triangle& corners)
  {
    const bool any = !isFlagged.empty() &&
      std::any_of(corners.begin(), corners.end(), [&isFlagged](Id p) { return isFlagged[p] != 0; });
    return any ? ridges::TriangleContent::Umbilic : contents.At(corners);
  };
  for (const ridges::Triangle& corners : triangles)
  {
    const ridges::TriangleContent content = contentOf(corners);
    for (const Id p : corners)
    {
      atPoints[p] = std::max(atPoints[p], content);
    }
  }
  return atPoints;
}

/// The triangles of the piece. False if they are nearly all.
bool vtkRidgesGathering::Choose(ridges::Ranks& ranks, vtkAlgorithm* filter, const Extent& extent)
{
  const ridges::TriangleMesh& mesh = *this->Mesh;
  this->Triangles.clear();
  this->HighestLevel = std::max(extent.ringsOfUmbilics, extent.ringsOfRidges);
  const auto levelOf = [this, &extent](ridges::TriangleContent content)
  {
    const int rings =
      content == ridges::TriangleContent::Ridge ? extent.ringsOfRidges : extent.ringsOfUmbilics;
    return content == ridges::TriangleContent::Nothing
      ? Beyond
      : static_cast<std::uint8_t>(this->HighestLevel - rings);
  };
  const Contents contents = this->ContentsOf(filter, extent);
  this->Levels.resize(contents.size());
  std::transform(contents.begin(), contents.end(), this->Levels.begin(), levelOf);
  const auto highest = static_cast<std::uint8_t>(this->HighestLevel);
  ridges::SpreadLevels(ranks, mesh, this->Seams, highest, this->Levels);
  // What is saved has to be worth the trouble.
  constexpr double most = 0.75;
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const ridges::Triangle& c = mesh.Corners(t);
    if (std::min({ this->Levels[c[0]], this->Levels[c[1]], this->Levels[c[2]] }) < highest)
    {
      this->Triangles.push_back(t);
    }
  }
  const auto chosen = static_cast<double>(
    ridges::SumOverRanks(ranks, static_cast<std::int64_t>(this->Triangles.size())));
  return chosen <= most * static_cast<double>(this->First.back());
}

void vtkRidgesGathering::ChooseAll()
{
  this->Levels.clear();
  this->Triangles.resize(this->Mesh->NumberOfTriangles());
  std::iota(this->Triangles.begin(), this->Triangles.end(), 0);
}

/// Those of the chosen triangles or, with all triangles, all.
std::vector<Id> vtkRidgesGathering::ChosenPoints() const
{
  const ridges::TriangleMesh& mesh = *this->Mesh;
  const bool isAll = static_cast<Id>(this->Triangles.size()) == mesh.NumberOfTriangles();
  std::vector<std::uint8_t> isChosen(mesh.NumberOfPoints(), isAll ? 1 : 0);
  for (const Id t : this->Triangles)
  {
    for (const Id p : mesh.Corners(t))
    {
      isChosen[p] = 1;
    }
  }
  std::vector<Id> points;
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    if (isChosen[p] != 0)
    {
      points.push_back(p);
    }
  }
  return points;
}

vtkIdType vtkRidgesGathering::IdInPart(std::int64_t number) const
{
  const bool areAll =
    this->PointsOfPart.back() + 1 == static_cast<std::int64_t>(this->PointsOfPart.size());
  return areAll ? number
                : std::lower_bound(this->PointsOfPart.begin(), this->PointsOfPart.end(), number) -
      this->PointsOfPart.begin();
}

/// And what is known of their points.
void vtkRidgesGathering::GatherTriangles(
  ridges::Ranks& ranks, const std::vector<Id>& points, vtkPolyData* part)
{
  const ridges::TriangleMesh& mesh = *this->Mesh;
  std::vector<std::int64_t> pointIds;
  std::vector<std::int64_t> corners;
  std::vector<std::uint8_t> rings;
  std::vector<std::uint8_t> strip;
  for (const Id p : points)
  {
    pointIds.push_back(this->NumberOf(p));
    if (!this->Levels.empty())
    {
      rings.push_back(static_cast<std::uint8_t>(
        this->HighestLevel - std::min<int>(this->Levels[p], this->HighestLevel)));
    }
    if (!this->BorderStrip.empty())
    {
      strip.push_back(this->BorderStrip[p]);
    }
  }
  for (const Id t : this->Triangles)
  {
    for (const Id p : mesh.Corners(t))
    {
      corners.push_back(this->NumberOf(p));
    }
  }
  std::vector<ridges::Bytes> messages(ranks.Size());
  ridges::Pack(messages[0], pointIds);
  ridges::Pack(messages[0], this->Triangles);
  ridges::Pack(messages[0], corners);
  ridges::Pack(messages[0], rings);
  ridges::Pack(messages[0], strip);
  pointIds = {};
  corners = {};
  messages = ranks.Exchange(std::move(messages));
  if (!part)
  {
    return;
  }

  this->PointsOfPart.clear();
  for (const ridges::Bytes& message : messages)
  {
    const auto ids = ridges::Unpacker(message).Take<std::int64_t>();
    this->PointsOfPart.insert(this->PointsOfPart.end(), ids.begin(), ids.end());
  }
  std::sort(this->PointsOfPart.begin(), this->PointsOfPart.end());
  this->PointsOfPart.erase(
    std::unique(this->PointsOfPart.begin(), this->PointsOfPart.end()), this->PointsOfPart.end());
  if (this->Part)
  {
    this->Part->rings.assign(this->PointsOfPart.size(), 0);
    this->Part->borderStrip.clear();
  }
  this->TrianglesOfPart.clear();
  this->FirstOfPart = { 0 };
  this->PointsFrom.assign(messages.size(), {});
  vtkNew<vtkCellArray> polys;
  for (std::size_t rank = 0; rank < messages.size(); ++rank)
  {
    ridges::Unpacker message(messages[rank]);
    for (const std::int64_t id : message.Take<std::int64_t>())
    {
      this->PointsFrom[rank].push_back(this->IdInPart(id));
    }
    for (const Id t : message.Take<Id>())
    {
      this->TrianglesOfPart.push_back(this->First[rank] + t);
    }
    this->FirstOfPart.push_back(static_cast<vtkIdType>(this->TrianglesOfPart.size()));
    const auto ids = message.Take<std::int64_t>();
    for (std::size_t i = 0; i < ids.size(); i += 3)
    {
      const vtkIdType triangle[] = { this->IdInPart(ids[i]), this->IdInPart(ids[i + 1]),
        this->IdInPart(ids[i + 2]) };
      polys->InsertNextCell(3, triangle);
    }
    const auto ringsThere = message.Take<std::uint8_t>();
    const auto stripThere = message.Take<std::uint8_t>();
    for (std::size_t i = 0; this->Part && i < ringsThere.size(); ++i)
    {
      std::uint8_t& most = this->Part->rings[this->PointsFrom[rank][i]];
      most = std::max(most, ringsThere[i]);
    }
    for (std::size_t i = 0; this->Part && i < stripThere.size(); ++i)
    {
      this->Part->borderStrip.resize(this->PointsOfPart.size(), 0);
      this->Part->borderStrip[this->PointsFrom[rank][i]] = stripThere[i];
    }
    messages[rank] = {};
  }
  part->SetPolys(polys);
}

void vtkRidgesGathering::GatherPoints(
  ridges::Ranks& ranks, const std::vector<Id>& points, vtkPolyData* part)
{
  std::vector<ridges::Bytes> messages(ranks.Size());
  this->PackPoints(messages[0], points);
  messages = ranks.Exchange(std::move(messages));
  if (!part)
  {
    return;
  }
  const auto count = static_cast<vtkIdType>(this->PointsOfPart.size());
  vtkNew<vtkFieldData> coordinates;
  vtkNew<vtkFieldData> rows;
  for (std::size_t rank = 0; rank < messages.size(); ++rank)
  {
    ridges::Unpacker message(messages[rank]);
    for (vtkFieldData* all : { coordinates.GetPointer(), rows.GetPointer() })
    {
      vtkNew<vtkFieldData> from;
      vtkRidgesTakeArrays(message, from);
      vtkRidgesPutRows(from, this->PointsFrom[rank], count, all == coordinates.GetPointer(), all);
    }
    messages[rank] = {};
  }
  this->PointsFrom.clear();
  vtkNew<vtkPoints> positions;
  if (coordinates->GetNumberOfArrays() > 0)
  {
    positions->SetDataType(coordinates->GetArray(0)->GetDataType());
    positions->SetData(coordinates->GetArray(0));
  }
  part->SetPoints(positions);
  for (int k = 0; k < rows->GetNumberOfArrays(); ++k)
  {
    part->GetPointData()->AddArray(rows->GetArray(k));
  }
}

void vtkRidgesGathering::PackPoints(ridges::Bytes& message, const std::vector<Id>& points)
{
  vtkRidgesPackPoints(message, this->Piece.GetPolyData(), points);
}

void vtkRidgesGathering::NumberPoints(vtkFieldData* data, const char* name) const
{
  Renumber(data, name, this->PointsOfPart);
}

void vtkRidgesGathering::NumberTriangles(vtkFieldData* data, const char* name) const
{
  Renumber(data, name, this->TrianglesOfPart);
}

void vtkRidgesGathering::GiveBack(ridges::Ranks& ranks, vtkPolyData* part, vtkPolyData* output)
{
  std::vector<ridges::Bytes> messages(ranks.Size());
  for (int rank = 0; part && rank < ranks.Size(); ++rank)
  {
    vtkNew<vtkFieldData> rows;
    vtkCellData* cells = part->GetCellData();
    for (int i = 0; i < cells->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = cells->GetArray(i);
      const auto own = vtkRidgesMakeArrayLike(array);
      own->InsertTuples(
        0, this->FirstOfPart[rank + 1] - this->FirstOfPart[rank], this->FirstOfPart[rank], array);
      rows->AddArray(own);
    }
    vtkNew<vtkFieldData> field;
    field->ShallowCopy(part->GetFieldData());
    this->NumberTriangles(field, names::UmbilicTriangle);
    vtkRidgesPackArrays(messages[rank], rows);
    vtkRidgesPackArrays(messages[rank], field);
  }
  const std::vector<ridges::Bytes> received = ranks.Exchange(std::move(messages));
  ridges::Unpacker message(received[0]);
  vtkNew<vtkFieldData> rows;
  vtkRidgesTakeArrays(message, rows);

  output->ShallowCopy(this->Piece.GetPolyData());
  const ridges::TriangleMesh& mesh = this->Piece.GetTriangles();
  const auto add = [output](vtkDataArray* like)
  {
    auto array = vtkRidgesMakeArrayLike(like);
    array->SetNumberOfTuples(output->GetNumberOfCells());
    array->Fill(-1.0);
    output->GetCellData()->AddArray(array);
    return array;
  };
  for (int i = 0; i < rows->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* from = rows->GetArray(i);
    const auto array = add(from);
    for (std::size_t k = 0; k < this->Triangles.size(); ++k)
    {
      array->SetTuple(this->Piece.GetCellId(this->Triangles[k]), static_cast<vtkIdType>(k), from);
    }
  }
  const auto cellNumbers = add(vtkRidgesMakeArray<vtkIdTypeArray>(names::GatheredCellId));
  auto* cellIds = vtkIdTypeArray::SafeDownCast(cellNumbers);
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    cellIds->SetValue(this->Piece.GetCellId(t), this->First[ranks.Rank()] + t);
  }
  auto pointNumbers = vtkRidgesMakeArray<vtkIdTypeArray>(names::GatheredPointId);
  pointNumbers->SetNumberOfValues(static_cast<vtkIdType>(this->PointIds.size()));
  std::copy(this->PointIds.begin(), this->PointIds.end(), pointNumbers->GetPointer(0));
  output->GetPointData()->AddArray(pointNumbers);
  vtkRidgesTakeArrays(message, vtkRidgesOwnFieldData(output));
}
