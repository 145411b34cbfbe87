// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Jets on any number of ranks against those of one: byte for byte.

#include "FilterTestTools.h"
#include "MessageRecorder.h"
#include "ParallelTestTools.h"

#include "vtkFieldData.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPJetFitting.h"
#include "vtkPointData.h"
#include "vtkRidgesArrayNames.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

using Properties = std::function<void(vtkJetFitting*)>;

struct Expected
{
  vtkSmartPointer<vtkPolyData> data;
  std::string warnings; ///< On rank 0.
};

Expected OnOneRank(const Mesh& mesh, const Properties& set)
{
  Expected expected;
  expected.data = FromFirstRank(
    [&mesh, &set, &expected]
    {
      vtkNew<vtkJetFitting> serial;
      const MessageRecorder recorder(serial);
      set(serial);
      serial->SetInputData(ToPolyData(mesh));
      serial->Update();
      expected.warnings = Bare(recorder.WarningText());
      vtkSmartPointer<vtkPolyData> result = serial->GetOutput();
      return result;
    });
  return expected;
}

void ExpectTheSameJets(
  const Expected& expected, const NamedMesh& named, Partition partition, const Properties& set)
{
  SCOPED_TRACE(
    std::string(named.name) + ", partition " + std::to_string(static_cast<int>(partition)));
  const RankPiece own = PieceOfRank(named.mesh, partition);
  vtkNew<vtkPJetFitting> parallel;
  const MessageRecorder recorder(parallel);
  set(parallel);
  parallel->SetInputData(own.data);
  parallel->Update();
  vtkPolyData* actual = parallel->GetOutput();
  EXPECT_EQ(recorder.ErrorText(), "");
  EXPECT_EQ(Bare(recorder.WarningText()), expected.warnings);
  EXPECT_EQ(actual->GetNumberOfCells(), own.data->GetNumberOfCells());
  EXPECT_EQ(
    FirstOtherRow(expected.data->GetPointData(), actual->GetPointData(), own.piece.points), "");
  EXPECT_EQ(FirstOtherRow(expected.data->GetFieldData(), actual->GetFieldData(), { 0 }), "");
}

} // namespace

// The automatic choice on other meshes and partitions is tested with the ridges.
TEST(PJetFitting, GivesTheBytesOfOneRank)
{
  const Properties none = [](vtkJetFitting*) {};
  const NamedMesh named = SmallMeshes()[1];
  ExpectTheSameJets(OnOneRank(named.mesh, none), named, Partition::Random, none);
}

TEST(PJetFitting, GivesTheBytesOfOneRankWithBlendedNoisyFits)
{
  const Properties set = [](vtkJetFitting* filter) { filter->BlendNoisyFitsOn(); };
  const Mesh clean = EllipsoidMesh(20, 1.4, 1.0, 0.6);
  const NamedMesh named{ "noisy", AddNormalNoise(clean, 0.05 * MeanEdgeLength(clean), 3) };
  const Expected expected = OnOneRank(named.mesh, set);
  if (Controller()->GetLocalProcessId() == 0)
  {
    EXPECT_EQ(Value(expected.data->GetFieldData(), names::SelectedDegree, 0), 6.0); // of the last
  }
  ExpectTheSameJets(expected, named, Partition::Random, set);
  ExpectTheSameJets(expected, named, Partition::Strips, set);
}

TEST(PJetFitting, GivesTheBytesOfOneRankInAnyNeighborhood)
{
  const auto meshes = SmallMeshes();
  for (const int kind :
    { vtkJetFitting::BY_POINT_COUNT, vtkJetFitting::BY_RINGS, vtkJetFitting::BY_RADIUS })
  {
    const Properties set = [kind](vtkJetFitting* filter)
    {
      filter->SetNeighborhood(kind);
      filter->SetRadius(0.35);
      filter->SetStandardErrors(true);
      filter->SetWeightingToGaussian();
    };
    for (const std::size_t i : { 1, 4 })
    {
      const Expected expected = OnOneRank(meshes[i].mesh, set);
      ExpectTheSameJets(expected, meshes[i], Partition::Random, set);
      ExpectTheSameJets(expected, meshes[i], Partition::Strips, set);
    }
  }
}

// Ranks that own many points fit them in parts, and send triangles and rows in several messages.
TEST(PJetFitting, GivesTheBytesOfOneRankInParts)
{
  const Properties set = [](vtkJetFitting* filter) { filter->SetNeighborhoodToPointCount(); };
  const NamedMesh named{ "large", EllipsoidMesh(128, 1.0, 0.8, 0.6) };
  const Expected expected = OnOneRank(named.mesh, set);
  ExpectTheSameJets(expected, named, Partition::Random, set);
  ExpectTheSameJets(expected, named, Partition::AllOnFirst, set);
}

// What is wrong with the mesh is counted once, wherever its pieces are: the warnings are compared.
TEST(PJetFitting, CountsFaultsOnce)
{
  NamedMesh named{ "faulty", EllipsoidMesh(10, 1.0, 0.8, 0.6) };
  Mesh& mesh = named.mesh;
  for (const std::size_t t : { 100, 500, 900 })
  {
    const auto tip = static_cast<std::int32_t>(mesh.PointCount());
    mesh.AddPoint(1.2 * mesh.Point(mesh.triangles[3 * t]));
    mesh.AddTriangle(mesh.triangles[3 * t], mesh.triangles[3 * t + 1], tip); // a fin
    std::swap(mesh.triangles[3 * t + 60], mesh.triangles[3 * t + 61]);       // upside down
  }
  const Properties none = [](vtkJetFitting*) {};
  const Expected expected = OnOneRank(mesh, none);
  if (Controller()->GetLocalProcessId() == 0)
  {
    EXPECT_NE(expected.warnings.find("3 edges with more than two triangles"), std::string::npos);
    EXPECT_NE(expected.warnings.find("9 edges lie between"), std::string::npos);
  }
  ExpectTheSameJets(expected, named, Partition::Random, none);
  ExpectTheSameJets(expected, named, Partition::Blocks, none);
}
