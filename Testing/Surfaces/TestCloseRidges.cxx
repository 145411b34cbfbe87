// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Umbilics of three ridges at which two are so near to each other that they cross the same edges of
// the mesh: with exact forms on a mesh of 5,000 points, all ridges that the cubic form tells of end
// at their umbilics all the same, and the checks of coherence pass.

#include "ExactForms.h"
#include "FilterPicture.h"
#include "FilterTestTools.h"
#include "RidgeComparison.h"
#include "TruthCache.h"

#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRidgeCoherence.h"
#include "vtkRidgeExtraction.h"
#include "vtkRidgesArrayNames.h"
#include "vtkTable.h"
#include "vtkUmbilicDetection.h"
#include "vtkVariant.h"

#include <gtest/gtest.h>

namespace
{

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

class CloseRidges : public ::testing::TestWithParam<const char*>
{
};

} // namespace

//------------------------------------------------------------------------------
TEST_P(CloseRidges, EndAtTheirUmbilics)
{
  const ClosedSurface closed = ClosedSurfaceByName(GetParam());
  const Mesh mesh = TruthCache(closed, "").MeshWith(5000);
  Truth truth;
  truth.umbilics = FindUmbilics(closed.surface, mesh);

  vtkNew<vtkUmbilicDetection> umbilics;
  umbilics->SetInputData(
    WithExactForms(ToPolyData(mesh), closed.surface, Eigen::Matrix3d::Identity()));
  vtkNew<vtkRidgeExtraction> ridges;
  ridges->SetInputConnection(umbilics->GetOutputPort());
  ridges->Update();
  const RidgeScore score = RidgeComparison(
    truth, PictureOf(umbilics->GetOutput(1), ridges->GetOutput()), MeanEdgeLength(mesh))
                             .Score();
  EXPECT_EQ(score.rightUmbilics, score.umbilics);
  EXPECT_EQ(score.joinedUmbilics, score.umbilics);
  EXPECT_EQ(score.looseEnds, 0);

  vtkNew<vtkRidgeCoherence> coherence;
  coherence->SetInputConnection(0, umbilics->GetOutputPort(0));
  coherence->SetInputConnection(1, ridges->GetOutputPort(0));
  coherence->SetInputConnection(2, umbilics->GetOutputPort(1));
  coherence->Update();
  vtkTable* table = coherence->GetOutput();
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    EXPECT_EQ(table->GetValueByName(row, names::Passed).ToInt(), 1)
      << table->GetValueByName(row, names::Check).ToString();
  }
}

INSTANTIATE_TEST_SUITE_P(OfThree, CloseRidges, ::testing::Values("sphere:2", "torus:2"),
  [](const ::testing::TestParamInfo<const char*>& instance)
  { return instance.index == 0 ? "sphere" : "torus"; });
