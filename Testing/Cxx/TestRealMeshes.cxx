// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Scanned, designed and dirty meshes, as CGAL is distributed with: whatever is in them, the
// pipeline runs through, nothing is NaN, and ridges end only where they may.

#include "CoherenceRows.h"
#include "FilterTestTools.h"
#include "Reading/MeshReader.h"
#include "RidgeGraph.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRidgesAndUmbilics.h"
#include "vtkRidgesArrayNames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

class RealMeshes : public ::testing::TestWithParam<const char*>
{
protected:
  void SetUp() override
  {
    this->Path = std::string(RIDGES_MESH_DIRECTORY) + "/" + this->GetParam() + ".off";
    if (!std::ifstream(this->Path))
    {
      GTEST_SKIP() << this->Path << " is not there";
    }
  }

  std::string Path;
};

double ShareOfInvalidPoints(vtkPolyData* fitted)
{
  double invalid = 0.0;
  for (vtkIdType p = 0; p < fitted->GetNumberOfPoints(); ++p)
  {
    invalid += static_cast<int>(Value(fitted->GetPointData(), names::FitStatus, p)) & 8 ? 1.0 : 0.0;
  }
  return invalid / static_cast<double>(fitted->GetNumberOfPoints());
}

class CleanMeshes : public RealMeshes
{
};

class UncrossedMeshes : public RealMeshes
{
};

class ZonedMeshes : public RealMeshes
{
};

void ExpectSoundRidges(const Outputs& outputs)
{
  EXPECT_EQ(outputs.errors, "");
  ExpectAllFinite(outputs.fitted);
  ExpectAllFinite(outputs.umbilics);
  ExpectAllFinite(outputs.ridges);
  ExpectCompleteRidgeGraph(outputs.marked, outputs.ridges);
  ExpectJoinedPolylines(outputs.ridges);
}

} // namespace

TEST_P(CleanMeshes, AreFittedEverywhere)
{
  const Outputs outputs = RunFilters(program::ReadMesh(this->Path).mesh.ToPolyData());
  EXPECT_EQ(ShareOfInvalidPoints(outputs.fitted), 0.0);
  EXPECT_GT(outputs.ridges->GetNumberOfLines(), 0);
  EXPECT_GT(outputs.umbilics->GetNumberOfPoints(), 0);
  ExpectSoundRidges(outputs);
}

TEST_P(RealMeshes, RunThroughAndEndRidgesOnlyWhereTheyMay)
{
  ExpectSoundRidges(RunFilters(program::ReadMesh(this->Path).mesh.ToPolyData()));
}

TEST_P(UncrossedMeshes, HaveRidgesThatDoNotCross)
{
  const Outputs outputs = RunFilters(program::ReadMesh(this->Path).mesh.ToPolyData());
  ExpectNoRidgesCross(outputs.marked, outputs.ridges);
}

// Ridges that lie in zones are left out, and so are small loops, some of them partly in a zone.
TEST_P(ZonedMeshes, LoseNoOtherCrossings)
{
  vtkNew<vtkRidgesAndUmbilics> filter;
  filter->SetInputData(program::ReadMesh(this->Path).mesh.ToPolyData());
  filter->SetMinimumSharpness(0.0);
  filter->SetMinimumStrength(0.0);
  filter->Update();
  const Row row =
    RowOf(Check(filter->GetOutput(2), filter->GetOutput(0), filter->GetOutput(1)), "crossings");
  EXPECT_TRUE(row.passed) << row.found << ": " << row.offenders;
}

// In the last three, three ridges meet and run to their umbilic over one triangle.
INSTANTIATE_TEST_SUITE_P(Scans, UncrossedMeshes,
  ::testing::Values(
    "blade", "mushroom", "fandisk_large", "bunny00", "mannequin-devil", "elephant-with-holes"));

INSTANTIATE_TEST_SUITE_P(Zones, ZonedMeshes,
  ::testing::Values("ellipe0.003", "blobby_3cc", "turbine"),
  [](const ::testing::TestParamInfo<const char*>& instance)
  {
    std::string name = instance.param;
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
  });

INSTANTIATE_TEST_SUITE_P(Scans, CleanMeshes, ::testing::Values("bunny00", "mannequin-devil"));

// Sharp edges, holes, isolated points, non-manifold edges, soups, thin walls.
INSTANTIATE_TEST_SUITE_P(Dirty, RealMeshes,
  ::testing::Values("3torus", "ALSTOM_TEST4", "blade", "blobby_3cc", "boeing", "cheese-box",
    "cross_quad", "cylinder_locally_refined", "degtri_sliding", "elephant-with-holes",
    "fandisk_large", "mech-holes-shark", "mesh_with_border", "mushroom", "open_cube", "part",
    "refined_elephant"));
