// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTestTools.h"
#include "MessageRecorder.h"
#include "RidgePaths.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRidgeSharpnessFilter.h"
#include "vtkRidgesArrayNames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

vtkPolyData* BlendRidges()
{
  static const vtkSmartPointer<vtkPolyData> ridges = RunFilters(BlendData(32)).ridges;
  return ridges;
}

RidgeMap Where(vtkPolyData* ridges, const std::function<bool(const PolylineValues&)>& kept)
{
  RidgeMap chosen;
  for (const auto& entry : RidgesByPath(ridges))
  {
    if (kept(entry.second))
    {
      chosen.insert(entry);
    }
  }
  return chosen;
}

/// The filter keeps what it should, which is some but not all.
void ExpectKept(
  vtkRidgeSharpnessFilter* filter, const std::function<bool(const PolylineValues&)>& kept)
{
  filter->SetInputData(BlendRidges());
  filter->Update();
  const RidgeMap expected = Where(BlendRidges(), kept);
  EXPECT_GT(expected.size(), 0u);
  EXPECT_LT(static_cast<vtkIdType>(expected.size()), BlendRidges()->GetNumberOfLines());
  ExpectSameRidges(expected, RidgesByPath(filter->GetOutput()), 0.0);
}

/// Two lines behind a vert, with a type each.
vtkSmartPointer<vtkPolyData> TwoLinesBehindAVert()
{
  auto data = MakePolyData({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 9, 9, 9 } }, {});
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 4 });
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1 });
  lines->InsertNextCell({ 2, 3, 1 });
  data->SetVerts(verts);
  data->SetLines(lines);
  vtkNew<vtkIntArray> type;
  type->SetName(names::RidgeType);
  type->InsertNextValue(3); // of the vert
  type->InsertNextValue(1);
  type->InsertNextValue(2);
  data->GetCellData()->AddArray(type);
  return data;
}

} // namespace

TEST(RidgeSharpnessFilter, KeepsAllByDefault)
{
  vtkNew<vtkRidgeSharpnessFilter> filter;
  filter->SetInputData(BlendRidges());
  filter->Update();
  ExpectSameRidges(RidgesByPath(BlendRidges()), RidgesByPath(filter->GetOutput()), 0.0);
}

TEST(RidgeSharpnessFilter, SharpnessThresholdIsInclusive)
{
  vtkNew<vtkRidgeSharpnessFilter> filter;
  const double threshold = Value(BlendRidges()->GetCellData(), names::Sharpness, 3);
  filter->SetMinimumSharpness(threshold);
  ExpectKept(filter, [=](const PolylineValues& line) { return line.sharpness >= threshold; });
}

TEST(RidgeSharpnessFilter, StrengthThresholdIsInclusive)
{
  vtkNew<vtkRidgeSharpnessFilter> filter;
  const double threshold = Value(BlendRidges()->GetCellData(), names::Strength, 3);
  filter->SetMinimumStrength(threshold);
  ExpectKept(filter, [=](const PolylineValues& line) { return line.strength >= threshold; });
}

TEST(RidgeSharpnessFilter, LengthThresholdIsInclusive)
{
  vtkNew<vtkRidgeSharpnessFilter> filter;
  const double threshold = Value(BlendRidges()->GetCellData(), names::Length, 3);
  filter->SetMinimumLength(threshold);
  ExpectKept(filter, [=](const PolylineValues& line) { return line.length >= threshold; });
}

TEST(RidgeSharpnessFilter, TypesAreKeptOrLeftOut)
{
  for (int type = 1; type <= 4; ++type)
  {
    vtkNew<vtkRidgeSharpnessFilter> filter;
    filter->SetKeepMaximumElliptic(type != 1);
    filter->SetKeepMaximumHyperbolic(type != 2);
    filter->SetKeepMinimumElliptic(type != 3);
    filter->SetKeepMinimumHyperbolic(type != 4);
    ExpectKept(filter, [=](const PolylineValues& line) { return line.type != type; });
  }
}

TEST(RidgeSharpnessFilter, CrestOnlyKeepsCrests)
{
  vtkNew<vtkRidgeSharpnessFilter> filter;
  filter->CrestOnlyOn();
  ExpectKept(filter, [](const PolylineValues& line) { return line.crest == 1; });
}

/// Sums of an array over the lines of each ridge.
std::map<int, double> SumsOfRidges(vtkPolyData* ridges, const char* name)
{
  std::map<int, double> sums;
  for (vtkIdType i = 0; i < ridges->GetNumberOfCells(); ++i)
  {
    sums[static_cast<int>(Value(ridges->GetCellData(), names::RidgeId, i))] +=
      Value(ridges->GetCellData(), name, i);
  }
  return sums;
}

TEST(RidgeSharpnessFilter, ThresholdsApplyToWholeRidges)
{
  const std::map<int, double> all = SumsOfRidges(BlendRidges(), names::Length);
  std::vector<double> lengths;
  lengths.reserve(all.size());
  for (const auto& [id, length] : all)
  {
    lengths.push_back(length);
  }
  std::sort(lengths.begin(), lengths.end());
  const double minimum = lengths[lengths.size() / 2];
  vtkNew<vtkRidgeSharpnessFilter> filter;
  filter->SetInputData(BlendRidges());
  filter->SetMinimumLength(minimum);
  filter->WholeRidgesOn();
  filter->Update();
  // Those kept are whole, the others are gone.
  std::map<int, double> expected;
  std::copy_if(all.begin(), all.end(), std::inserter(expected, expected.end()),
    [minimum](const auto& entry) { return entry.second >= minimum; });
  EXPECT_EQ(SumsOfRidges(filter->GetOutput(), names::Length), expected);
  EXPECT_LT(expected.size(), all.size());

  // A ridge has more than its lines.
  const vtkIdType whole = filter->GetOutput()->GetNumberOfLines();
  filter->WholeRidgesOff();
  filter->Update();
  EXPECT_LT(filter->GetOutput()->GetNumberOfLines(), whole);
}

TEST(RidgeSharpnessFilter, OnlyTypesThatAreKeptCountForWholeRidges)
{
  vtkNew<vtkRidgeSharpnessFilter> blue;
  blue->SetInputData(BlendRidges());
  blue->KeepMaximumHyperbolicOff();
  blue->KeepMinimumEllipticOff();
  blue->KeepMinimumHyperbolicOff();
  blue->KeepUndecidedOff();
  blue->Update();
  vtkNew<vtkPolyData> blueOnly;
  blueOnly->DeepCopy(blue->GetOutput());
  double longest = 0.0;
  for (const auto& [id, length] : SumsOfRidges(blueOnly, names::Length))
  {
    longest = std::max(longest, length);
  }
  blue->WholeRidgesOn();
  blue->SetMinimumLength(longest);
  blue->Update();
  EXPECT_EQ(SumsOfRidges(blue->GetOutput(), names::Length).size(), 1u);
  blue->SetMinimumLength(std::nextafter(longest, 2.0 * longest));
  blue->Update();
  EXPECT_TRUE(IsEmpty(blue->GetOutput()));
}

TEST(RidgeSharpnessFilter, KeepsTheFirst)
{
  const std::pair<int, const char*> ranks[] = { { vtkRidgeSharpnessFilter::SHARPNESS,
                                                  names::Sharpness },
    { vtkRidgeSharpnessFilter::STRENGTH, names::Strength },
    { vtkRidgeSharpnessFilter::LENGTH, names::Length } };
  for (const auto& [rank, name] : ranks)
  {
    std::vector<double> values;
    for (vtkIdType i = 0; i < BlendRidges()->GetNumberOfCells(); ++i)
    {
      values.push_back(Value(BlendRidges()->GetCellData(), name, i));
    }
    std::sort(values.rbegin(), values.rend());
    vtkNew<vtkRidgeSharpnessFilter> filter;
    filter->SetInputData(BlendRidges());
    filter->SetMaximumNumber(5);
    filter->SetRankBy(rank);
    filter->Update();
    ASSERT_EQ(filter->GetOutput()->GetNumberOfLines(), 5);
    for (vtkIdType i = 0; i < 5; ++i)
    {
      EXPECT_GE(Value(filter->GetOutput()->GetCellData(), name, i), values[4]);
    }
    filter->WholeRidgesOn();
    filter->Update();
    EXPECT_EQ(SumsOfRidges(filter->GetOutput(), name).size(), 5u);
    filter->SetMaximumNumber(1000000);
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfLines(), BlendRidges()->GetNumberOfLines());
  }
}

TEST(RidgeSharpnessFilter, CarriesAllArraysAndOnlyTheUsedPoints)
{
  const auto input = vtkSmartPointer<vtkPolyData>::New();
  input->DeepCopy(BlendRidges());
  vtkNew<vtkDoubleArray> note;
  note->SetName("Note");
  note->InsertNextValue(42.0);
  input->GetFieldData()->AddArray(note);
  vtkNew<vtkRidgeSharpnessFilter> filter;
  filter->CrestOnlyOn();
  filter->SetInputData(input);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(Value(output->GetFieldData(), "Note", 0), 42.0);
  EXPECT_EQ(output->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_STREQ(output->GetCellData()->GetScalars()->GetName(), names::RidgeType);

  std::set<vtkIdType> used;
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < output->GetNumberOfLines(); ++line)
  {
    output->GetLines()->GetCellAtId(line, ids);
    used.insert(ids->begin(), ids->end());
  }
  EXPECT_EQ(static_cast<vtkIdType>(used.size()), output->GetNumberOfPoints());
  EXPECT_LT(output->GetNumberOfPoints(), input->GetNumberOfPoints());
  for (int i = 0; i < input->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = input->GetPointData()->GetArray(i);
    ExpectArray(output->GetPointData(), array->GetName(), array->GetDataType(), 1,
      output->GetNumberOfPoints());
  }
  for (int i = 0; i < input->GetCellData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = input->GetCellData()->GetArray(i);
    ExpectArray(
      output->GetCellData(), array->GetName(), array->GetDataType(), 1, output->GetNumberOfCells());
  }
}

TEST(RidgeSharpnessFilter, PointsKeepTheirArraysAndPositions)
{
  vtkNew<vtkRidgeSharpnessFilter> filter;
  filter->SetMinimumSharpness(20.0);
  filter->SetInputData(BlendRidges());
  filter->Update();
  std::set<std::vector<double>> input;
  const auto signature = [](vtkPolyData* data, vtkIdType id)
  {
    const Eigen::Vector3d x = PointAt(data, id);
    return std::vector<double>{ x[0], x[1], x[2],
      Value(data->GetPointData(), names::EdgePoint0, id),
      Value(data->GetPointData(), names::EdgeParameter, id),
      Value(data->GetPointData(), names::SecondDerivative, id) };
  };
  for (vtkIdType i = 0; i < BlendRidges()->GetNumberOfPoints(); ++i)
  {
    input.insert(signature(BlendRidges(), i));
  }
  ASSERT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
  for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(input.count(signature(filter->GetOutput(), i)), 1u);
  }
}

TEST(RidgeSharpnessFilter, NamesAllMissingArraysInOneError)
{
  auto input = TwoLinesBehindAVert();
  input->GetCellData()->RemoveArray(names::RidgeType);
  vtkNew<vtkRidgeSharpnessFilter> filter;
  const MessageRecorder recorder(filter);
  filter->SetInputData(input);
  filter->SetMinimumSharpness(1.0);
  filter->SetMinimumStrength(1.0);
  filter->SetMinimumLength(1.0);
  filter->CrestOnlyOn();
  filter->Update();
  EXPECT_EQ(recorder.NumberOfErrors(), 1u);
  EXPECT_NE(
    recorder.ErrorText().find("RidgeType, Crest, Sharpness, Strength, Length"), std::string::npos)
    << recorder.ErrorText();
  EXPECT_TRUE(IsEmpty(filter->GetOutput()));
}

TEST(RidgeSharpnessFilter, NeedsOnlyTheArraysItUses)
{
  vtkNew<vtkRidgeSharpnessFilter> filter;
  const MessageRecorder recorder(filter);
  filter->SetInputData(TwoLinesBehindAVert());
  filter->Update();
  EXPECT_EQ(recorder.NumberOfErrors(), 0u) << recorder.ErrorText();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfLines(), 2);
}

TEST(RidgeSharpnessFilter, CellArraysOfLinesBehindVertsAreRead)
{
  vtkNew<vtkRidgeSharpnessFilter> filter;
  filter->KeepMaximumEllipticOff();
  filter->KeepMinimumEllipticOff();
  filter->SetInputData(TwoLinesBehindAVert());
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(output->GetNumberOfVerts(), 0);
  ASSERT_EQ(output->GetNumberOfLines(), 1);
  EXPECT_EQ(output->GetNumberOfPoints(), 3);
  ExpectArray(output->GetCellData(), names::RidgeType, VTK_INT, 1, 1);
  EXPECT_EQ(Value(output->GetCellData(), names::RidgeType, 0), 2.0);
  EXPECT_EQ(PointAt(output, 0)[0], 2.0);
}

TEST(RidgeSharpnessFilter, SettersClampAndAllIsPrinted)
{
  vtkNew<vtkRidgeSharpnessFilter> filter;
  EXPECT_EQ(filter->GetMinimumSharpness(), 0.0);
  EXPECT_EQ(filter->GetMinimumStrength(), 0.0);
  EXPECT_EQ(filter->GetMinimumLength(), 0.0);
  filter->SetMinimumSharpness(-1.0);
  filter->SetMinimumStrength(-1.0);
  filter->SetMinimumLength(-1.0);
  EXPECT_EQ(filter->GetMinimumSharpness(), 0.0);
  EXPECT_EQ(filter->GetMinimumStrength(), 0.0);
  EXPECT_EQ(filter->GetMinimumLength(), 0.0);
  filter->SetMinimumSharpness(1.5);
  filter->SetMinimumStrength(2.5);
  filter->SetMinimumLength(3.5);
  filter->KeepUndecidedOff();
  std::ostringstream text;
  filter->Print(text);
  for (const char* line : { "MinimumSharpness: 1.5", "MinimumStrength: 2.5", "MinimumLength: 3.5",
         "KeepMaximumElliptic: On", "KeepMaximumHyperbolic: On", "KeepMinimumElliptic: On",
         "KeepMinimumHyperbolic: On", "KeepUndecided: Off", "CrestOnly: Off" })
  {
    EXPECT_NE(text.str().find(line), std::string::npos) << line;
  }
}
