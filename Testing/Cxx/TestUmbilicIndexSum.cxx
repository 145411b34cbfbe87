// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Fit and umbilics on closed meshes of any shape: the indices sum to the Euler characteristic.

#include "FilterTestTools.h"
#include "MessageRecorder.h"
#include "RandomClosedMesh.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkRidgesArrayNames.h"
#include "vtkUmbilicDetection.h"

#include <gtest/gtest.h>

#include <cstdlib>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

// With RIDGES_RANDOM_MESHES in the environment, so many of them.
TEST(UmbilicIndexSum, IsTheEulerCharacteristicOfAnyClosedMesh)
{
  const char* wanted = std::getenv("RIDGES_RANDOM_MESHES");
  const int count = wanted ? std::atoi(wanted) : 60;
  for (int seed = 1; seed <= count; ++seed)
  {
    SCOPED_TRACE(seed);
    const RandomClosedMesh random = MakeRandomClosedMesh(seed);
    vtkNew<vtkJetFitting> jets;
    const MessageRecorder recorder(jets); // Much is wrong with these meshes.
    jets->SetInputData(ToPolyData(random.mesh));
    vtkNew<vtkUmbilicDetection> umbilics;
    umbilics->SetInputConnection(jets->GetOutputPort());
    umbilics->Update();
    vtkFieldData* field = umbilics->GetOutput()->GetFieldData();
    ASSERT_EQ(Value(field, names::EulerCharacteristic, 0), random.eulerCharacteristic);
    ASSERT_EQ(Value(field, names::UmbilicIndexSum, 0), random.eulerCharacteristic);
    ExpectAllFinite(umbilics->GetOutput(0));
    ExpectAllFinite(umbilics->GetOutput(1));
  }
}
