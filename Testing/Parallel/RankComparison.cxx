// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RankComparison.h"

#include "FilterTestTools.h"
#include "MessageRecorder.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPRidgesAndUmbilics.h"
#include "vtkPointData.h"
#include "vtkRidgesArrayNames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace names = vtkRidgesArrayNames;

namespace ridges
{
namespace testing
{
namespace
{

/// On rank 0 the names in the whole mesh, by the numbers that pieces have; -1 is of nothing.
std::vector<vtkIdType> Names(vtkDataArray* numbers, const std::vector<std::int32_t>& names)
{
  vtkNew<vtkIdTypeArray> own;
  own->SetNumberOfComponents(2);
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    own->InsertNextTuple2(numbers->GetTuple1(static_cast<vtkIdType>(i)), names[i]);
  }
  vtkNew<vtkIdTypeArray> all;
  Controller()->GatherV(own, all, 0);
  std::vector<vtkIdType> found;
  for (vtkIdType i = 0; i < all->GetNumberOfTuples(); ++i)
  {
    const auto number = static_cast<std::size_t>(all->GetComponent(i, 0));
    found.resize(std::max(found.size(), number + 1), -1);
    found[number] = static_cast<vtkIdType>(all->GetComponent(i, 1));
  }
  return found;
}

} // namespace

ExpectedRidges RidgesOnOneRank(const Mesh& mesh, const RidgeSettings& set)
{
  vtkNew<vtkRidgesAndUmbilics> serial;
  set(serial);
  const MessageRecorder recorder(serial);
  const auto output = [&serial, &mesh](int port)
  {
    return FromFirstRank(
      [&serial, &mesh, port]
      {
        if (!serial->GetInput())
        {
          serial->SetInputData(ToPolyData(mesh));
        }
        serial->Update();
        vtkSmartPointer<vtkPolyData> result = serial->GetOutput(port);
        return result;
      });
  };
  ExpectedRidges expected{ output(vtkRidgesAndUmbilics::RIDGES),
    output(vtkRidgesAndUmbilics::UMBILICS), output(vtkRidgesAndUmbilics::MESH), "" };
  expected.warnings = Bare(recorder.WarningText());
  return expected;
}

void ExpectTheSameRidges(
  const ExpectedRidges& expected, const RankPiece& own, const RidgeSettings& set)
{
  vtkNew<vtkPRidgesAndUmbilics> parallel;
  set(parallel);
  const MessageRecorder recorder(parallel);
  parallel->SetInputData(own.data);
  parallel->Update();
  ASSERT_EQ(recorder.ErrorText(), "");
  EXPECT_EQ(Bare(recorder.WarningText()), expected.warnings);
  vtkPolyData* mesh = parallel->GetOutput(vtkRidgesAndUmbilics::MESH);
  EXPECT_EQ(
    FirstOtherRow(expected.mesh->GetPointData(), mesh->GetPointData(), own.piece.points), "");
  EXPECT_EQ(
    FirstOtherRow(expected.mesh->GetCellData(), mesh->GetCellData(), own.piece.triangles), "");
  const auto bare = Without(expected.mesh, { names::UmbilicTriangle });
  for (int i = 0; i < bare->GetFieldData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = bare->GetFieldData()->GetArray(i);
    if (array)
    {
      vtkNew<vtkFieldData> one;
      one->AddArray(array);
      EXPECT_EQ(FirstOtherRow(one, mesh->GetFieldData(), AllOf(array->GetNumberOfTuples())), "");
    }
  }

  const bool isSerial = Controller()->GetNumberOfProcesses() == 1;
  const auto numbers = [mesh, isSerial](vtkFieldData* data, const char* name)
  {
    vtkSmartPointer<vtkDataArray> array = data->GetArray(name);
    if (isSerial)
    {
      vtkNew<vtkIdTypeArray> all;
      for (vtkIdType i = 0; i < mesh->GetNumberOfPoints() + mesh->GetNumberOfCells(); ++i)
      {
        all->InsertNextValue(i);
      }
      array = all;
    }
    return array;
  };
  const auto pointNames =
    Names(numbers(mesh->GetPointData(), names::GatheredPointId), own.piece.points);
  const auto cellNames =
    Names(numbers(mesh->GetCellData(), names::GatheredCellId), own.piece.triangles);
  vtkPolyData* ridges = parallel->GetOutput(vtkRidgesAndUmbilics::RIDGES);
  vtkPolyData* umbilics = parallel->GetOutput(vtkRidgesAndUmbilics::UMBILICS);
  if (Controller()->GetLocalProcessId() > 0)
  {
    EXPECT_TRUE(IsEmpty(ridges));
    EXPECT_TRUE(IsEmpty(umbilics));
    return;
  }
  ExpectTheSameLines(expected.ridges, ridges, pointNames);
  ExpectTheSameUmbilics(expected.umbilics, umbilics, cellNames);
  ExpectTheSameTriangles(expected.ridges->GetFieldData(), ridges->GetFieldData(), cellNames);
  ExpectTheSameTriangles(expected.umbilics->GetFieldData(), umbilics->GetFieldData(), cellNames);
}

} // namespace testing
} // namespace ridges
