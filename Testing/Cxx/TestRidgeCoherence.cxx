// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The table of coherence: it is clean for what the filters make of smooth surfaces, and there is
// one for whatever else, or an error.

#include "CoherenceRows.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

TEST(RidgeCoherence, EllipsoidsPass)
{
  for (const int frequency : { 23, 32, 45 }) // 5, 10 and 20 thousand points
  {
    const Outputs outputs = RunFilters(EllipsoidData(frequency));
    const auto table = Check(outputs);
    EXPECT_EQ(table->GetNumberOfRows(), 14);
    EXPECT_EQ(Failed(table), "") << frequency;
    EXPECT_EQ(RowOf(table, "index sum").found, "2");
    EXPECT_NE(RowOf(table, "ridge ends").found.find("2 loops, ends: 8 at umbilics, 0 at borders"),
      std::string::npos)
      << RowOf(table, "ridge ends").found;
  }
}

TEST(RidgeCoherence, BlendPasses)
{
  for (const int frequency : { 45, 63 }) // 20 and 40 thousand points
  {
    EXPECT_EQ(Failed(Check(RunFilters(BlendData(frequency)))), "") << frequency;
  }
}

TEST(RidgeCoherence, ReadsUmbilicsFromTheMeshToo)
{
  const Outputs outputs = RunFilters(BlendData(45));
  const auto with = Check(outputs);
  const auto without = Check(outputs.marked, outputs.ridges, nullptr);
  ASSERT_EQ(with->GetNumberOfRows(), without->GetNumberOfRows());
  for (vtkIdType row = 0; row < with->GetNumberOfRows(); ++row)
  {
    EXPECT_EQ(with->GetValueByName(row, names::Found).ToString(),
      without->GetValueByName(row, names::Found).ToString());
  }
}

TEST(RidgeCoherence, ColumnsAreAsDocumented)
{
  const auto table = Check(RunFilters(EllipsoidData(12)));
  ASSERT_EQ(table->GetNumberOfColumns(), 11);
  for (const char* name : { names::Check, names::Section, names::Expected, names::Found,
         names::OffenderKind, names::Offenders })
  {
    EXPECT_NE(vtkStringArray::SafeDownCast(table->GetColumnByName(name)), nullptr) << name;
  }
  const auto data = table->GetRowData();
  ExpectArray(data, names::Applies, VTK_INT, 1, 14);
  ExpectArray(data, names::Passed, VTK_INT, 1, 14);
  ExpectArray(data, names::Severity, VTK_INT, 1, 14);
  ExpectArray(data, names::NumberOfOffenders, VTK_ID_TYPE, 1, 14);
  ExpectArray(data, names::OffenderPosition, VTK_DOUBLE, 3, 14);
}

TEST(RidgeCoherence, IndexSumDoesNotApplyToAnOpenMesh)
{
  auto data = EllipsoidData(12);
  data->BuildCells();
  data->DeleteCell(100);
  data->RemoveDeletedCells();
  const auto table = Check(RunFilters(data));
  EXPECT_FALSE(RowOf(table, "index sum").applies);
  EXPECT_TRUE(RowOf(table, "index sum").passed);
}

TEST(RidgeCoherence, NoiseGivesATable)
{
  const Mesh clean = ToMesh(EllipsoidData(20));
  const Outputs outputs = RunFilters(ToPolyData(AddNormalNoise(clean, 0.01, 3)));
  const auto table = Check(outputs);
  EXPECT_EQ(table->GetNumberOfRows(), 14);
  for (const char* check : { "index sum", "ridge ends", "patches", "points on edges", "crossings" })
  {
    EXPECT_TRUE(RowOf(table, check).passed) << check << ": " << RowOf(table, check).found;
  }
}

TEST(RidgeCoherence, RandomFormsGiveATable)
{
  auto data = EllipsoidData(12);
  AddRandomMongeArrays(data, 5);
  vtkNew<vtkPolyData> noRidges;
  const Outputs outputs = RunFilters(EllipsoidData(12));
  auto mesh = CopyOf(outputs.marked);
  AddRandomMongeArrays(mesh, 5);
  EXPECT_NE(Failed(Check(mesh, outputs.ridges, outputs.umbilics)), "");
  EXPECT_EQ(RowOf(Check(mesh, noRidges, outputs.umbilics), "ridges at umbilics").count, 4);
}

TEST(RidgeCoherence, EmptyInputsGiveATableWhereNothingApplies)
{
  vtkNew<vtkPolyData> empty;
  const auto table = Check(empty, empty, empty);
  ASSERT_EQ(table->GetNumberOfRows(), 14);
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    EXPECT_EQ(table->GetValueByName(row, names::Applies).ToInt(), 0);
    EXPECT_EQ(table->GetValueByName(row, names::Passed).ToInt(), 1);
  }
}

TEST(RidgeCoherence, MissingArraysAreNamedInOneError)
{
  const Outputs outputs = RunFilters(EllipsoidData(8));
  vtkNew<vtkRidgeCoherence> coherence;
  const MessageRecorder recorder(coherence);
  coherence->SetInputData(0, outputs.marked);
  coherence->SetInputData(1, outputs.ridges);
  coherence->Update();
  ASSERT_EQ(coherence->GetOutput()->GetNumberOfRows(), 14);
  auto ridges = CopyOf(outputs.ridges);
  ridges->GetCellData()->RemoveArray(names::RidgeType);
  ridges->GetPointData()->RemoveArray(names::EdgeParameter);
  coherence->SetInputData(0, EllipsoidData(8));
  coherence->SetInputData(1, ridges);
  coherence->Update();
  EXPECT_EQ(recorder.NumberOfErrors(), 1u);
  for (const char* name : { names::MaximumDirection, names::ThirdOrder, names::UmbilicPatch,
         names::UmbilicPosition, names::RidgeType, names::EdgeParameter })
  {
    EXPECT_NE(recorder.ErrorText().find(name), std::string::npos) << recorder.ErrorText();
  }
  EXPECT_EQ(recorder.ErrorText().find(names::RidgeId), std::string::npos);
  EXPECT_EQ(coherence->GetOutput()->GetNumberOfRows(), 0); // nothing stale
}

TEST(RidgeCoherence, WrongInputsAreErrors)
{
  const Outputs outputs = RunFilters(EllipsoidData(8));
  vtkNew<vtkRidgeCoherence> coherence;
  const MessageRecorder recorder(coherence);
  coherence->SetInputData(0, outputs.marked);
  coherence->Update();
  EXPECT_NE(
    recorder.ExecutiveErrorText().find("0 connections but is not optional"), std::string::npos);
  coherence->SetInputData(1, vtkNew<vtkImageData>());
  coherence->Update();
  EXPECT_NE(recorder.ExecutiveErrorText().find("vtkPolyData"), std::string::npos);
  EXPECT_EQ(coherence->GetOutput()->GetNumberOfRows(), 0);
}

TEST(RidgeCoherence, ReportsProgressAndStopsWhenAborted)
{
  struct Watch
  {
    std::vector<double> values;
    double abortAt = 2.0;
  } watch;
  const Outputs outputs = RunFilters(EllipsoidData(8));
  vtkNew<vtkRidgeCoherence> coherence;
  coherence->SetInputData(0, outputs.marked);
  coherence->SetInputData(1, outputs.ridges);
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&watch);
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      auto* seen = static_cast<Watch*>(data);
      auto* algorithm = static_cast<vtkAlgorithm*>(caller);
      seen->values.push_back(algorithm->GetProgress());
      algorithm->SetAbortExecute(algorithm->GetProgress() >= seen->abortAt ? 1 : 0);
    });
  coherence->AddObserver(vtkCommand::ProgressEvent, command);
  coherence->Update();
  // Once a check, at the least.
  EXPECT_GE(watch.values.size(), 15u);
  EXPECT_TRUE(std::is_sorted(watch.values.begin(), watch.values.end()));
  EXPECT_EQ(coherence->GetOutput()->GetNumberOfRows(), 14);

  for (const double abortAt : { 0.1, 0.3, 0.5, 0.9 })
  {
    watch.values.clear();
    watch.abortAt = abortAt;
    coherence->Modified();
    coherence->Update();
    // The last event is that of the pipeline, after the filter has returned.
    EXPECT_EQ(std::count_if(watch.values.begin(), watch.values.end(),
                [abortAt](double value) { return value >= abortAt && value < 1.0; }),
      1)
      << abortAt;
    EXPECT_EQ(coherence->GetOutput()->GetNumberOfRows(), 0) << abortAt;
  }
  watch.abortAt = 2.0;
  coherence->SetAbortExecute(0);
  coherence->Modified();
  coherence->Update();
  EXPECT_EQ(coherence->GetOutput()->GetNumberOfRows(), 14);
}

TEST(RidgeCoherence, PrintsAndClampsItsProperty)
{
  vtkNew<vtkRidgeCoherence> coherence;
  EXPECT_EQ(coherence->GetRightAngleCosine(), 0.001);
  coherence->SetRightAngleCosine(7.0);
  std::ostringstream text;
  coherence->Print(text);
  EXPECT_NE(text.str().find("RightAngleCosine: 1\n"), std::string::npos);
}
