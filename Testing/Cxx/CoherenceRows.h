// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The table of vtkRidgeCoherence, row by row.

#ifndef CoherenceRows_h
#define CoherenceRows_h

#include "FilterTestTools.h"
#include "MessageRecorder.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkRidgeCoherence.h"
#include "vtkRidgesArrayNames.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <string>

namespace ridges
{
namespace testing
{

struct Row
{
  bool applies = false;
  bool passed = false;
  vtkIdType count = -1;
  std::string kind;
  std::string offenders;
  std::string found;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

inline Row RowOf(vtkTable* table, const std::string& check)
{
  Row row;
  for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i)
  {
    const auto value = [&](const char* column) { return table->GetValueByName(i, column); };
    if (value(vtkRidgesArrayNames::Check).ToString() == check)
    {
      row.applies = value(vtkRidgesArrayNames::Applies).ToInt() != 0;
      row.passed = value(vtkRidgesArrayNames::Passed).ToInt() != 0;
      row.count = value(vtkRidgesArrayNames::NumberOfOffenders).ToLongLong();
      row.kind = value(vtkRidgesArrayNames::OffenderKind).ToString();
      row.offenders = value(vtkRidgesArrayNames::Offenders).ToString();
      row.found = value(vtkRidgesArrayNames::Found).ToString();
      vtkDataArray::SafeDownCast(table->GetColumnByName(vtkRidgesArrayNames::OffenderPosition))
        ->GetTuple(i, row.position.data());
    }
  }
  EXPECT_GE(row.count, 0) << "there is no check " << check;
  return row;
}

/// Names of the failed checks, each with a blank behind it.
inline std::string Failed(vtkTable* table)
{
  std::string failed;
  for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i)
  {
    if (table->GetValueByName(i, vtkRidgesArrayNames::Passed).ToInt() == 0)
    {
      failed += table->GetValueByName(i, vtkRidgesArrayNames::Check).ToString() + "; ";
    }
  }
  return failed;
}

inline vtkSmartPointer<vtkTable> Check(
  vtkPolyData* mesh, vtkPolyData* ridges, vtkPolyData* umbilics)
{
  vtkNew<vtkRidgeCoherence> coherence;
  const MessageRecorder recorder(coherence);
  coherence->SetInputData(0, mesh);
  coherence->SetInputData(1, ridges);
  if (umbilics)
  {
    coherence->SetInputData(2, umbilics);
  }
  coherence->Update();
  EXPECT_EQ(recorder.ErrorText() + recorder.ExecutiveErrorText() + recorder.WarningText(), "");
  return coherence->GetOutput();
}

inline vtkSmartPointer<vtkTable> Check(const Outputs& outputs)
{
  return Check(outputs.marked, outputs.ridges, outputs.umbilics);
}

inline vtkSmartPointer<vtkPolyData> CopyOf(vtkPolyData* data)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(data);
  return copy;
}

} // namespace testing
} // namespace ridges

#endif
