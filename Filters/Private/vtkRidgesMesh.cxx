// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesMesh.h"

#include "Core/Base/Finite.h"
#include "vtkRidgesArrayReader.h"
#include "vtkRidgesRangeLoop.h"
#include "vtkRidgesTriangleFetch.h"
#include "vtkRidgesTriangulate.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <array>
#include <limits>
#include <mutex>
#include <utility>

namespace
{

using ridges::Id;
using ridges::Triangle;

vtkIdType CountTriangulatedCells(vtkPolyData* input)
{
  vtkIdType polygons = 0;
  const auto polys = vtk::TakeSmartPointer(input->GetPolys()->NewIterator());
  for (polys->GoToFirstCell(); !polys->IsDoneWithTraversal(); polys->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    polys->GetCurrentCell(size, corners);
    polygons += size > 3 ? 1 : 0;
  }
  return polygons + input->GetNumberOfStrips();
}

/// What a mesh was built from. Modification times are unique in a process, so that an object made
/// later in the same place is told apart.
struct Origin
{
  explicit Origin(vtkPolyData* data)
  {
    const auto object = [](vtkObject* o, int i, auto& entries) {
      entries[i] = { o, o ? o->GetMTime() : 0 };
    };
    vtkPoints* points = data->GetPoints();
    vtkCellArray* polys = data->GetPolys();
    object(points, 0, this->objects);
    object(points ? points->GetData() : nullptr, 1, this->objects);
    object(polys, 2, this->objects);
    object(polys->GetConnectivityArray(), 3, this->objects);
    object(polys->GetOffsetsArray(), 4, this->objects);
    const char* ghosts = vtkDataSetAttributes::GhostArrayName();
    object(data->GetCellData()->GetAbstractArray(ghosts), 5, this->objects);
    object(data->GetPointData()->GetAbstractArray(ghosts), 6, this->objects);
    this->numberOfPoints = data->GetNumberOfPoints();
    this->numberOfPolys = polys->GetNumberOfCells();
  }

  bool operator==(const Origin& other) const
  {
    return this->objects == other.objects && this->numberOfPoints == other.numberOfPoints &&
      this->numberOfPolys == other.numberOfPolys;
  }

  std::array<std::pair<vtkObject*, vtkMTimeType>, 7> objects;
  vtkIdType numberOfPoints;
  vtkIdType numberOfPolys;
};

/// Whether the three corners of every triangle can be numbered in 32 bits.
bool IsSmallEnough(vtkPolyData* data)
{
  constexpr vtkIdType largest = std::numeric_limits<Id>::max() / 3;
  return data->GetNumberOfPoints() <= largest && data->GetPolys()->GetNumberOfCells() <= largest;
}

vtkDataArray* CoordinatesOf(vtkPolyData* data)
{
  return data->GetPoints() ? data->GetPoints()->GetData() : nullptr;
}

} // namespace

/// Does not change once it is built, but for the edges.
struct vtkRidgesMesh::Adjacency
{
  void FetchPoints(vtkPolyData* data);
  bool IsOf(vtkPolyData* data) const;
  ridges::Buffer<Triangle> FetchGoodTriangles(vtkPolyData* data,
    const std::vector<std::uint8_t>& usable, const vtkRidgesGhosts& ghosts, Duplicates duplicates);

  std::vector<double> convertedPoints;
  const double* points = nullptr; ///< x, y, z; those of the data set, if they are doubles.
  ridges::TriangleMesh triangles;
  std::vector<Id> polyIds;            ///< Empty where all polys are triangles.
  std::vector<std::uint8_t> isHidden; ///< Per point: hidden, or of a hidden cell. May be empty.
  vtkIdType unusableTriangles = 0;
  std::mutex edgesMutex;
  bool hasEdges = false;
  bool isWhole = true; ///< Nothing is left out that another filter may want.
};

void vtkRidgesMesh::Adjacency::FetchPoints(vtkPolyData* data)
{
  vtkDataArray* coordinates = CoordinatesOf(data);
  this->points = coordinates ? vtkRidgesDoubles(coordinates, this->convertedPoints) : nullptr;
}

/// Whether the points are a copy, or where the data set stores them now.
bool vtkRidgesMesh::Adjacency::IsOf(vtkPolyData* data) const
{
  vtkDataArray* coordinates = CoordinatesOf(data);
  if (!this->convertedPoints.empty() || !coordinates)
  {
    return true;
  }
  std::vector<double> copy;
  return vtkRidgesDoubles(coordinates, copy) == this->points;
}

/// One by one, leaving out what is bad or hidden.
ridges::Buffer<Triangle> vtkRidgesMesh::Adjacency::FetchGoodTriangles(vtkPolyData* data,
  const std::vector<std::uint8_t>& usable, const vtkRidgesGhosts& ghosts, Duplicates duplicates)
{
  const vtkIdType numberOfPoints = data->GetNumberOfPoints();
  std::vector<std::uint8_t> isUsable(numberOfPoints, 0);
  this->isHidden.assign(ghosts.HasHidden() ? numberOfPoints : 0, 0);
  for (vtkIdType p = 0; p < numberOfPoints; ++p)
  {
    const bool finite = ridges::AllFinite(this->points + 3 * p, this->points + 3 * p + 3);
    isUsable[p] = finite && (usable.empty() || usable[p] != 0) ? 1 : 0;
    if (ghosts.IsHiddenPoint(p))
    {
      this->isHidden[p] = 1;
    }
  }
  const auto isThere = [numberOfPoints](vtkIdType p) { return p >= 0 && p < numberOfPoints; };
  const auto isGood = [&isUsable, isThere](vtkIdType p) { return isThere(p) && isUsable[p]; };
  const auto isHiddenPoint = [&ghosts, isThere](vtkIdType p)
  { return isThere(p) && ghosts.IsHiddenPoint(p); };

  vtkCellArray* polys = data->GetPolys();
  const vtkIdType firstPoly = data->GetNumberOfVerts() + data->GetNumberOfLines();
  ridges::Buffer<Triangle> fetched(polys->GetNumberOfCells());
  this->polyIds.reserve(polys->GetNumberOfCells());
  const auto cell = vtk::TakeSmartPointer(polys->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cell->GetCurrentCell(size, corners);
    const vtkIdType id = cell->GetCurrentCellId();
    if (ghosts.IsHiddenCell(firstPoly + id) || std::any_of(corners, corners + size, isHiddenPoint))
    {
      std::for_each(corners, corners + size,
        [this, isThere](vtkIdType p)
        {
          if (isThere(p))
          {
            this->isHidden[p] = 1;
          }
        });
    }
    else if (duplicates == Duplicates::LeftOut && ghosts.IsDuplicateCell(firstPoly + id))
    {
      continue;
    }
    else if (size == 3 && corners[0] != corners[1] && corners[1] != corners[2] &&
      corners[2] != corners[0] && std::all_of(corners, corners + 3, isGood))
    {
      fetched[this->polyIds.size()] = { static_cast<Id>(corners[0]), static_cast<Id>(corners[1]),
        static_cast<Id>(corners[2]) };
      this->polyIds.push_back(static_cast<Id>(id));
    }
    else
    {
      ++this->unusableTriangles;
    }
  }
  fetched.Shorten(this->polyIds.size());
  return fetched;
}

class vtkRidgesMesh::Carrier : public vtkObject
{
public:
  static Carrier* New();
  vtkTypeMacro(Carrier, vtkObject);

  ~Carrier() override
  {
    if (this->Watched)
    {
      this->Watched->RemoveObserver(this->Tag);
    }
  }

  /// Stays with a data set until that loses its arrays, by Initialize or ReleaseData.
  void StayWith(vtkPolyData* data)
  {
    this->Data = data;
    this->Watched = data->GetPointData();
    this->Tag = this->Watched->AddObserver(vtkCommand::ModifiedEvent, this, &Carrier::LeaveIfEmpty);
    data->GetInformation()->Set(MESH(), this);
  }

  std::shared_ptr<Adjacency> mesh;
  std::unique_ptr<Origin> madeFrom;

private:
  void LeaveIfEmpty()
  {
    const vtkSmartPointer<Carrier> untilReturn(this);
    if (this->Data && this->Watched->GetNumberOfArrays() == 0)
    {
      this->Data->GetInformation()->Remove(MESH());
    }
  }

  vtkWeakPointer<vtkPolyData> Data;
  vtkWeakPointer<vtkPointData> Watched;
  unsigned long Tag = 0;
};

vtkStandardNewMacro(vtkRidgesMesh::Carrier);

vtkInformationKeyMacro(vtkRidgesMesh, MESH, ObjectBase);

void vtkRidgesMesh::HandOnWith(vtkPolyData* output) const
{
  if (!this->Shared->isWhole)
  {
    return;
  }
  vtkNew<Carrier> carrier;
  carrier->mesh = this->Shared;
  carrier->madeFrom = std::make_unique<Origin>(output);
  carrier->StayWith(output);
}

bool vtkRidgesMesh::TakeHandedOn(vtkPolyData* input, const std::vector<std::uint8_t>& usable)
{
  auto* carrier = static_cast<Carrier*>(input->GetInformation()->Get(MESH()));
  if (!carrier || input->GetNumberOfStrips() > 0 || !(*carrier->madeFrom == Origin(input)))
  {
    return false;
  }
  // The array may have moved its values without saying so.
  if (!carrier->mesh->IsOf(input))
  {
    return false;
  }
  // Points without triangles are no loss.
  const ridges::TriangleMesh& triangles = carrier->mesh->triangles;
  for (auto p = std::find(usable.begin(), usable.end(), 0); p != usable.end();
       p = std::find(p + 1, usable.end(), 0))
  {
    if (triangles.TrianglesAround(static_cast<Id>(p - usable.begin())).size() > 0)
    {
      return false;
    }
  }
  this->Take(carrier->mesh);
  return true;
}

std::string vtkRidgesMesh::Build(vtkPolyData* input, const std::vector<std::uint8_t>& usable,
  ridges::TriangleMesh::Edges edges, Duplicates duplicates)
{
  this->PolyData = input;
  this->NumberOfTriangulatedCells = 0;
  std::string faults = this->Ghosts.Read(input);
  const bool leavesOut = duplicates == Duplicates::LeftOut && this->HasDuplicates();
  if (faults.empty() && (leavesOut || !this->TakeHandedOn(input, usable)))
  {
    faults = this->BuildAnew(input, usable, duplicates);
  }
  if (faults.empty() && edges == ridges::TriangleMesh::Edges::Built)
  {
    this->BuildEdges();
  }
  return faults;
}

std::string vtkRidgesMesh::BuildAnew(
  vtkPolyData* input, const std::vector<std::uint8_t>& usable, Duplicates duplicates)
{
  const char* const tooLarge = "it has more points or triangles than 32-bit numbering allows";
  if (!IsSmallEnough(input))
  {
    return tooLarge;
  }
  auto adjacency = std::make_shared<Adjacency>();
  adjacency->FetchPoints(input);
  ridges::Buffer<Triangle> triangles;
  const bool all =
    !this->Ghosts.HasHidden() && (duplicates == Duplicates::Kept || !this->HasDuplicates());
  if (!all || !vtkRidgesFetchAllTriangles(input, adjacency->points, usable, triangles))
  {
    this->NumberOfTriangulatedCells = CountTriangulatedCells(input);
    if (this->NumberOfTriangulatedCells > 0)
    {
      this->PolyData = vtkRidgesTriangulate(input);
      if (!IsSmallEnough(this->PolyData))
      {
        return tooLarge;
      }
      this->Ghosts.Read(this->PolyData);
    }
    triangles = adjacency->FetchGoodTriangles(this->PolyData, usable, this->Ghosts, duplicates);
    adjacency->isWhole =
      duplicates == Duplicates::Kept && std::find(usable.begin(), usable.end(), 0) == usable.end();
  }
  const auto numberOfPoints = static_cast<Id>(this->PolyData->GetNumberOfPoints());
  adjacency->triangles =
    ridges::TriangleMesh(adjacency->points, numberOfPoints, std::move(triangles),
      ridges::TriangleMesh::Edges::NotBuilt, vtkRidgesRangeLoop, vtkRidgesSharesOfThreads());
  this->Take(std::move(adjacency));
  return {};
}

void vtkRidgesMesh::Take(std::shared_ptr<Adjacency> adjacency)
{
  this->Shared = std::move(adjacency);
  this->Triangles = &this->Shared->triangles;
  this->PolyIds = &this->Shared->polyIds;
  this->FirstPoly = this->PolyData->GetNumberOfVerts() + this->PolyData->GetNumberOfLines();
}

void vtkRidgesMesh::BuildEdges()
{
  // Filters in different threads may share the mesh.
  const std::lock_guard<std::mutex> lock(this->Shared->edgesMutex);
  if (!this->Shared->hasEdges)
  {
    this->Shared->triangles.BuildEdges(vtkRidgesRangeLoop);
    this->Shared->hasEdges = true;
  }
}

vtkIdType vtkRidgesMesh::GetNumberOfUnusableTriangles() const
{
  return this->Shared->unusableTriangles;
}

bool vtkRidgesMesh::IsHidden(ridges::Id point) const
{
  return !this->Shared->isHidden.empty() && this->Shared->isHidden[point] != 0 &&
    this->Triangles->TrianglesAround(point).size() == 0;
}

void vtkRidgesMesh::SetPart(const ridges::MeshPart* part)
{
  this->Shared->triangles.SetPart(part);
}

int vtkRidgesMesh::GetEulerCharacteristic() const
{
  if (const ridges::MeshPart* part = this->Triangles->Part())
  {
    return part->eulerCharacteristic;
  }
  return this->Triangles->EulerCharacteristic(vtkRidgesRangeLoop);
}

vtkIdType vtkRidgesMesh::CountCoincidentPoints() const
{
  return vtkRidgesCountCoincidentPoints(*this->Triangles, this->Triangles->NumberOfPoints());
}

vtkIdType vtkRidgesCountCoincidentPoints(const ridges::TriangleMesh& mesh, ridges::Id end)
{
  std::vector<Id> order;
  for (Id p = 0; p < end; ++p)
  {
    if (mesh.TrianglesAround(p).size() > 0)
    {
      order.push_back(p);
    }
  }
  const auto position = [&mesh](Id p) { return mesh.Point(p).data(); };
  std::sort(order.begin(), order.end(),
    [position](Id p, Id q)
    {
      return std::lexicographical_compare(
        position(p), position(p) + 3, position(q), position(q) + 3);
    });
  vtkIdType count = 0;
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    count += std::equal(position(order[i]), position(order[i]) + 3, position(order[i - 1])) ? 1 : 0;
  }
  return count;
}

void vtkRidgesMesh::Adopt(vtkPolyData* data, ridges::TriangleMesh triangles)
{
  this->PolyData = data;
  this->Ghosts.Read(data);
  auto adjacency = std::make_shared<Adjacency>();
  adjacency->FetchPoints(data);
  adjacency->triangles = std::move(triangles);
  this->Take(std::move(adjacency));
}

ridges::Id vtkRidgesSharesOfThreads()
{
  return std::clamp(vtkSMPTools::GetEstimatedNumberOfThreads(), 1, 8);
}
