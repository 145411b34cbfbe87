// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Ridges and umbilics of meshes of the size that users have, against those of one rank. Run by
// Testing/Evidence/ranks.sh, as they take minutes.

#include "FilterTestTools.h"
#include "ParallelTestTools.h"
#include "RankComparison.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

using namespace ridges::testing;

namespace
{

constexpr const char* NumberName = "NumberInMesh"; // of points and of triangles

/// Where files are, or will be.
std::string Directory()
{
  const char* value = std::getenv("RIDGES_DIRECTORY");
  return value ? std::string(value) + "/" : std::string();
}

std::vector<NamedMesh> LargeMeshes()
{
  const auto height = [](double x, double y)
  { return 0.4 * x * x - 0.3 * y * y + 0.3 * x * x * x + 0.2 * x * y * y; };
  const Mesh noisy = EllipsoidMesh(63, 1.0, 0.8, 0.6);
  Mesh two = EllipsoidMesh(40, 1.0, 0.8, 0.6);
  Append(two,
    Transform(TorusMesh(0.8, 0.3, 120, 60), GenericRotation(), Eigen::Vector3d(3.0, 0.2, 0.1)));
  std::vector<NamedMesh> meshes = { { "ellipsoid", EllipsoidMesh(127, 1.0, 0.8, 0.6) },
    { "blend", ToMesh(BlendData(30)) },
    { "noisy-ellipsoid", AddNormalNoise(noisy, 0.05 * MeanEdgeLength(noisy), 5) },
    { "torus", TorusMesh(1.0, 0.4, 240, 120) }, { "open-patch", GraphPatch(height, 1.0, 150, 0.2) },
    { "two-components", two } };
  const std::string bunny = RIDGES_MESH_DIRECTORY "/bunny00.off";
  if (std::filesystem::exists(bunny))
  {
    meshes.push_back({ "bunny00", ReadOff(bunny) });
  }
  return meshes;
}

bool IsFirst()
{
  return Controller()->GetLocalProcessId() == 0;
}

/// A row of a table, of which ranks.sh prints the head.
void PrintRow(const NamedMesh& named, const char* partition, bool isTheSame)
{
  const int here = isTheSame ? 1 : 0;
  int everywhere = 0;
  Controller()->AllReduce(&here, &everywhere, 1, vtkCommunicator::MIN_OP);
  if (IsFirst())
  {
    std::printf("| %s | %zu | %d | %s | %s |\n", named.name, named.mesh.PointCount(),
      Controller()->GetNumberOfProcesses(), partition,
      everywhere != 0 ? "identical" : "**different**");
    std::fflush(stdout);
  }
}

bool HasFailed()
{
  return testing::Test::HasFailure();
}

void Compare(const ExpectedRidges& expected, const NamedMesh& named, const char* partition,
  const RankPiece& own)
{
  SCOPED_TRACE(std::string(named.name) + ", " + partition);
  ExpectTheSameRidges(expected, own);
  PrintRow(named, partition, !HasFailed());
}

/// The numbers that a piece has for its points or triangles; it has none afterwards.
std::vector<std::int32_t> TakeNumbers(vtkDataSetAttributes* data)
{
  std::vector<std::int32_t> numbers;
  vtkDataArray* array = data->GetArray(NumberName);
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    numbers.push_back(static_cast<std::int32_t>(array->GetTuple1(i)));
  }
  data->Initialize();
  return numbers;
}

} // namespace

TEST(LargeMeshes, DISABLED_GiveTheBytesOfOneRank)
{
  for (const NamedMesh& named : LargeMeshes())
  {
    const ExpectedRidges expected = RidgesOnOneRank(named.mesh);
    Compare(expected, named, "strips", PieceOfRank(named.mesh, Partition::Strips));
    Compare(expected, named, "random", PieceOfRank(named.mesh, Partition::Random));
  }
}

// As files, which pvbatch then deals to ranks.
TEST(LargeMeshes, DISABLED_AreWritten)
{
  for (const NamedMesh& named : LargeMeshes())
  {
    const auto data = ToPolyData(named.mesh);
    for (vtkDataSetAttributes* attributes :
      { static_cast<vtkDataSetAttributes*>(data->GetPointData()),
        static_cast<vtkDataSetAttributes*>(data->GetCellData()) })
    {
      vtkNew<vtkIdTypeArray> numbers;
      numbers->SetName(NumberName);
      const bool isOfPoints = attributes == data->GetPointData();
      for (const std::int32_t i :
        AllOf(isOfPoints ? data->GetNumberOfPoints() : data->GetNumberOfCells()))
      {
        numbers->InsertNextValue(i);
      }
      attributes->AddArray(numbers);
    }
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetFileName((Directory() + named.name + ".vtp").c_str());
    writer->SetInputData(data);
    EXPECT_EQ(writer->Write(), 1);
  }
}

TEST(LargeMeshes, DISABLED_GiveTheBytesOfOneRankAfterRedistributeDataSet)
{
  for (const NamedMesh& named : LargeMeshes())
  {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName((Directory() + named.name + "/" + named.name + "_" +
      std::to_string(Controller()->GetLocalProcessId()) + ".vtp")
                          .c_str());
    reader->Update();
    RankPiece own;
    own.data = reader->GetOutput();
    own.piece.points = TakeNumbers(own.data->GetPointData());
    own.piece.triangles = TakeNumbers(own.data->GetCellData());
    own.data->GetFieldData()->Initialize();
    const auto ofPiece = static_cast<vtkIdType>(own.piece.triangles.size());
    vtkIdType triangles = 0;
    Controller()->AllReduce(&ofPiece, &triangles, 1, vtkCommunicator::SUM_OP);
    ASSERT_EQ(triangles, static_cast<vtkIdType>(named.mesh.TriangleCount()));
    Compare(RidgesOnOneRank(named.mesh), named, "RedistributeDataSet", own);
  }
}
