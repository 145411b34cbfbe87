// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Jets on any number of ranks against those of one: byte for byte.

#include "FilterTestTools.h"
#include "MessageRecorder.h"
#include "ParallelTestTools.h"

#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPJetFitting.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

using namespace ridges::testing;

namespace
{

using Setup = std::function<void(vtkJetFitting*)>;

/// Without what VTK puts before the text.
std::string Bare(const std::string& message)
{
  const std::size_t end = message.find("): ");
  return end == std::string::npos ? message : message.substr(end + 3);
}

void ExpectTheSameJets(
  const char* name, const Mesh& mesh, Partition partition, const Setup& setUp)
{
  SCOPED_TRACE(std::string(name) + ", partition " + std::to_string(static_cast<int>(partition)));
  std::string expectedWarnings;
  const auto expected = FromFirstRank(
    [&mesh, &setUp, &expectedWarnings]
    {
      vtkNew<vtkJetFitting> serial;
      const MessageRecorder recorder(serial);
      setUp(serial);
      serial->SetInputData(ToPolyData(mesh));
      serial->Update();
      expectedWarnings = Bare(recorder.WarningText());
      vtkSmartPointer<vtkPolyData> result = serial->GetOutput();
      return result;
    });
  const RankPiece own = PieceOfRank(mesh, partition);
  vtkNew<vtkPJetFitting> parallel;
  const MessageRecorder recorder(parallel);
  setUp(parallel);
  parallel->SetInputData(own.data);
  parallel->Update();
  EXPECT_EQ(recorder.ErrorText(), "");
  EXPECT_EQ(Bare(recorder.WarningText()), expectedWarnings); // of rank 0, on both sides
  EXPECT_EQ(parallel->GetOutput()->GetNumberOfCells(), own.data->GetNumberOfCells());
  EXPECT_EQ(FirstOtherRow(expected->GetPointData(), parallel->GetOutput()->GetPointData(),
              own.piece.points),
    "");
  EXPECT_EQ(
    FirstOtherRow(expected->GetFieldData(), parallel->GetOutput()->GetFieldData(), { 0 }), "");
}

} // namespace

TEST(PJetFitting, GivesTheBytesOfOneRank)
{
  for (const NamedMesh& named : SmallMeshes())
  {
    for (const Partition partition : AllPartitions)
    {
      ExpectTheSameJets(named.name, named.mesh, partition, [](vtkJetFitting*) {});
    }
  }
}

TEST(PJetFitting, GivesTheBytesOfOneRankInAnyNeighborhood)
{
  const auto meshes = SmallMeshes();
  for (const int kind :
    { vtkJetFitting::BY_POINT_COUNT, vtkJetFitting::BY_RINGS, vtkJetFitting::BY_RADIUS })
  {
    const auto setUp = [kind](vtkJetFitting* filter)
    {
      filter->SetNeighborhood(kind);
      filter->SetRadius(0.35);
      filter->SetStandardErrors(true);
      filter->SetWeightingToGaussian();
    };
    ExpectTheSameJets("noisy ellipsoid", meshes[1].mesh, Partition::Random, setUp);
    ExpectTheSameJets("open patch", meshes[4].mesh, Partition::Strips, setUp);
  }
}
