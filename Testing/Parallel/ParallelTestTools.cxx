// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ParallelTestTools.h"

#include "FilterTestTools.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMultiProcessController.h"

#include <cstring>

namespace ridges
{
namespace testing
{

vtkMultiProcessController* Controller()
{
  return vtkMultiProcessController::GetGlobalController();
}

vtkSmartPointer<vtkPolyData> FromFirstRank(
  const std::function<vtkSmartPointer<vtkPolyData>()>& make)
{
  auto data = Controller()->GetLocalProcessId() == 0 ? make() : vtkSmartPointer<vtkPolyData>::New();
  Controller()->Broadcast(data, 0);
  return data;
}

RankPiece PieceOfRank(const Mesh& mesh, Partition partition)
{
  RankPiece own;
  own.piece = PieceOf(mesh, PartsOf(mesh, partition, Controller()->GetNumberOfProcesses()),
    Controller()->GetLocalProcessId());
  own.data = ToPolyData(own.piece.mesh);
  return own;
}

std::string FirstOtherRow(
  vtkFieldData* expected, vtkFieldData* actual, const std::vector<std::int32_t>& ids)
{
  for (int i = 0; i < expected->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = expected->GetArray(i);
    if (!array)
    {
      continue;
    }
    vtkDataArray* other = actual->GetArray(array->GetName());
    const std::string name = array->GetName();
    if (!other || other->GetDataType() != array->GetDataType() ||
      other->GetNumberOfComponents() != array->GetNumberOfComponents() ||
      other->GetNumberOfTuples() != static_cast<vtkIdType>(ids.size()))
    {
      return name + " is missing or of another type or size";
    }
    const auto size =
      static_cast<std::size_t>(array->GetNumberOfComponents()) * array->GetDataTypeSize();
    const auto* rows = static_cast<const char*>(array->GetVoidPointer(0));
    const auto* otherRows = static_cast<const char*>(other->GetVoidPointer(0));
    for (std::size_t k = 0; k < ids.size(); ++k)
    {
      if (std::memcmp(rows + size * ids[k], otherRows + size * k, size) != 0)
      {
        return name + " at " + std::to_string(ids[k]);
      }
    }
  }
  return {};
}

std::vector<NamedMesh> SmallMeshes()
{
  Mesh two = EllipsoidMesh(10, 1.0, 0.8, 0.6);
  Append(
    two, Transform(TorusMesh(0.8, 0.3, 40, 20), GenericRotation(), Eigen::Vector3d(3.0, 0.2, 0.1)));
  const auto height = [](double x, double y)
  { return 0.4 * x * x - 0.3 * y * y + 0.3 * x * x * x + 0.2 * x * y * y; };
  return { { "ellipsoid", EllipsoidMesh(16, 1.0, 0.8, 0.6) },
    { "noisy ellipsoid", AddNormalNoise(EllipsoidMesh(20, 1.0, 0.8, 0.6), 0.002, 5) },
    { "blend", ToMesh(BlendData(14)) }, { "torus", TorusMesh(1.0, 0.4, 60, 30) },
    { "open patch", AddNormalNoise(GraphPatch(height, 1.0, 30, 0.2), 0.0005, 3) },
    { "two components", two } };
}

} // namespace testing
} // namespace ridges
