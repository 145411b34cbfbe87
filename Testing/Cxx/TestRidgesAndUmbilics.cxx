// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The whole job in one filter, against its four stages by hand.

#include "FilterTestTools.h"
#include "MessageRecorder.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRidgeSharpnessFilter.h"
#include "vtkRidgesAndUmbilics.h"
#include "vtkRidgesArrayNames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

/// The stages, chained by hand.
struct Chain
{
  explicit Chain(vtkPolyData* mesh)
  {
    this->jets->SetInputData(mesh);
    this->umbilics->SetInputConnection(this->jets->GetOutputPort());
    this->ridges->SetInputConnection(this->umbilics->GetOutputPort());
    this->selection->SetInputConnection(this->ridges->GetOutputPort());
  }

  std::vector<std::string> Bytes()
  {
    this->selection->Update();
    return { BytesOf(this->selection->GetOutput()), BytesOf(this->umbilics->GetOutput(1)),
      BytesOf(this->ridges->GetOutput(2)) };
  }

  vtkNew<vtkJetFitting> jets;
  vtkNew<vtkUmbilicDetection> umbilics;
  vtkNew<vtkRidgeExtraction> ridges;
  vtkNew<vtkRidgeSharpnessFilter> selection;
};

std::vector<std::string> BytesOfAll(vtkRidgesAndUmbilics* filter)
{
  filter->Update();
  return { BytesOf(filter->GetOutput(vtkRidgesAndUmbilics::RIDGES)),
    BytesOf(filter->GetOutput(vtkRidgesAndUmbilics::UMBILICS)),
    BytesOf(filter->GetOutput(vtkRidgesAndUmbilics::MESH)) };
}

void ExpectAllEmpty(vtkRidgesAndUmbilics* filter)
{
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    EXPECT_TRUE(IsEmpty(filter->GetOutput(port))) << port;
  }
}

/// Records the progress of an algorithm and, on demand, aborts it where that has been reached.
class ProgressWatch
{
public:
  explicit ProgressWatch(vtkAlgorithm* algorithm, double abortAt = 2.0)
    : Algorithm(algorithm)
    , AbortAt(abortAt)
  {
    this->Tag =
      algorithm->AddObserver(vtkCommand::ProgressEvent, this, &ProgressWatch::TakeProgress);
  }
  ~ProgressWatch()
  {
    this->Algorithm->RemoveObserver(this->Tag);
    this->Algorithm->SetAbortExecute(0); // VTK after 9.1 leaves it to those who have set it
  }
  ProgressWatch(const ProgressWatch&) = delete;
  ProgressWatch& operator=(const ProgressWatch&) = delete;

  const std::vector<double>& Reported() const { return this->Values; }

private:
  void TakeProgress(vtkObject*, unsigned long, void*)
  {
    this->Values.push_back(this->Algorithm->GetProgress());
    if (this->Values.back() >= this->AbortAt)
    {
      this->Algorithm->SetAbortExecute(1);
    }
  }

  vtkAlgorithm* Algorithm;
  double AbortAt;
  unsigned long Tag = 0;
  std::vector<double> Values;
};

} // namespace

TEST(RidgesAndUmbilics, GivesTheSameBytesAsTheChain)
{
  const auto mesh = BlendData(32);
  Chain chain(mesh);
  vtkNew<vtkRidgesAndUmbilics> filter;
  filter->SetInputData(mesh);
  const MessageRecorder recorder(filter);
  EXPECT_TRUE(BytesOfAll(filter) == chain.Bytes());
  EXPECT_EQ(recorder.ErrorText() + recorder.WarningText() + recorder.ExecutiveErrorText(), "");
  EXPECT_EQ(filter->GetOutput(vtkRidgesAndUmbilics::UMBILICS)->GetNumberOfPoints(), 8);
  EXPECT_GT(filter->GetOutput(vtkRidgesAndUmbilics::RIDGES)->GetNumberOfLines(), 0);
  EXPECT_TRUE(
    filter->GetOutput(vtkRidgesAndUmbilics::MESH)->GetPointData()->HasArray(names::ThirdOrder));
}

TEST(RidgesAndUmbilics, LeavesTheInputAsItIs)
{
  const auto mesh = EllipsoidData(8);
  const std::string bytes = BytesOf(mesh);
  vtkNew<vtkRidgesAndUmbilics> filter;
  filter->SetInputData(mesh);
  filter->Update();
  EXPECT_TRUE(BytesOf(mesh) == bytes);
}

// Every property by itself: set here and on its stage, the outputs change and are the same; but
// KeepUndecided and ModelSize, MinimumLength and the like, which need a value that bites.
TEST(RidgesAndUmbilics, ForwardsEveryProperty)
{
  const Mesh even = ToMesh(BlendData(16));
  const auto mesh = ToPolyData(AddNormalNoise(even, 0.05 * MeanEdgeLength(even), 1));
  Chain defaults(mesh);
  const std::vector<std::string> unchanged = defaults.Bytes();
  const auto expect = [&](const char* name, const auto& setStage, const auto& setFilter)
  {
    Chain chain(mesh);
    setStage(chain);
    vtkNew<vtkRidgesAndUmbilics> filter;
    filter->SetInputData(mesh);
    filter->Update(); // a change after an update has to be noticed
    setFilter(filter);
    EXPECT_TRUE(BytesOfAll(filter) == chain.Bytes()) << name;
    EXPECT_FALSE(chain.Bytes() == unchanged) << name << " has no effect that would be seen";
  };
#define EXPECT_FORWARDED(stage, name, value)                                                       \
  expect(                                                                                          \
    #name, [](Chain& chain) { chain.stage->Set##name(value); },                                    \
    [](vtkRidgesAndUmbilics* filter)                                                               \
    {                                                                                              \
      filter->Set##name(value);                                                                    \
      EXPECT_EQ(filter->Get##name(), value) << #name;                                              \
    })
  EXPECT_FORWARDED(jets, Degree, 6);
  EXPECT_FORWARDED(jets, Neighborhood, vtkJetFitting::BY_RINGS);
  EXPECT_FORWARDED(jets, MinimumNumberOfPoints, 400);
  EXPECT_FORWARDED(jets, Weighting, vtkJetFitting::GAUSSIAN);
  EXPECT_FORWARDED(jets, BlendNoisyFits, false);
  EXPECT_FORWARDED(jets, StandardErrors, true);
  EXPECT_FORWARDED(umbilics, Method, vtkUmbilicDetection::MINIMA);
  EXPECT_FORWARDED(umbilics, Significance, 100.0);
  EXPECT_FORWARDED(umbilics, PatchSize, 4.0);
  EXPECT_FORWARDED(ridges, TypeRule, vtkRidgeExtraction::THIRD_ORDER);
  EXPECT_FORWARDED(ridges, CrossingRule, vtkRidgeExtraction::LINEAR);
  EXPECT_FORWARDED(ridges, UmbilicJoining, vtkRidgeExtraction::TRIANGLES);
  EXPECT_FORWARDED(ridges, TypeSignificance, 100.0);
  EXPECT_FORWARDED(ridges, TypeHysteresis, 10.0);
  EXPECT_FORWARDED(ridges, ComputeFoldAngle, true);
  EXPECT_FORWARDED(ridges, ModelSize, 3.0);
  EXPECT_FORWARDED(ridges, UmbilicCutOff, 0.1);
  EXPECT_FORWARDED(selection, MinimumSharpness, 10.0);
  EXPECT_FORWARDED(selection, MinimumStrength, 0.5);
  EXPECT_FORWARDED(selection, MinimumLength, 0.2);
  EXPECT_FORWARDED(selection, KeepMaximumElliptic, false);
  EXPECT_FORWARDED(selection, KeepMaximumHyperbolic, false);
  EXPECT_FORWARDED(selection, KeepMinimumElliptic, false);
  EXPECT_FORWARDED(selection, KeepMinimumHyperbolic, false);
  EXPECT_FORWARDED(selection, CrestOnly, true);
#undef EXPECT_FORWARDED

  // Automatic fits leave no loops that noise may have caused.
  expect(
    "LoopSignificance",
    [](Chain& chain)
    {
      chain.jets->SetNeighborhoodToPointCount();
      chain.ridges->SetLoopSignificance(100.0);
    },
    [](vtkRidgesAndUmbilics* filter)
    {
      filter->SetNeighborhoodToPointCount();
      filter->SetLoopSignificance(100.0);
    });
  expect(
    "NumberOfRings",
    [](Chain& chain)
    {
      chain.jets->SetNeighborhoodToRings();
      chain.jets->SetNumberOfRings(4);
    },
    [](vtkRidgesAndUmbilics* filter)
    {
      filter->SetNeighborhoodToRings();
      filter->SetNumberOfRings(4);
    });
  expect(
    "Radius",
    [](Chain& chain)
    {
      chain.jets->SetNeighborhoodToRadius();
      chain.jets->SetRadius(0.1);
    },
    [](vtkRidgesAndUmbilics* filter)
    {
      filter->SetNeighborhoodToRadius();
      filter->SetRadius(0.1);
    });

  // No ridge here is undecided.
  vtkNew<vtkRidgesAndUmbilics> filter;
  EXPECT_TRUE(filter->GetKeepUndecided());
  filter->KeepUndecidedOff();
  EXPECT_FALSE(filter->GetKeepUndecided());
}

TEST(RidgesAndUmbilics, HasTheDefaultsOfItsStages)
{
  vtkNew<vtkRidgesAndUmbilics> filter;
  const Chain chain(EllipsoidData(2));
  EXPECT_EQ(filter->GetDegree(), chain.jets->GetDegree());
  EXPECT_EQ(filter->GetNeighborhood(), chain.jets->GetNeighborhood());
  EXPECT_EQ(filter->GetMinimumNumberOfPoints(), chain.jets->GetMinimumNumberOfPoints());
  EXPECT_EQ(filter->GetMethod(), chain.umbilics->GetMethod());
  EXPECT_EQ(filter->GetSignificance(), chain.umbilics->GetSignificance());
  EXPECT_EQ(filter->GetPatchSize(), chain.umbilics->GetPatchSize());
  EXPECT_EQ(filter->GetUmbilicJoining(), chain.ridges->GetUmbilicJoining());
  EXPECT_EQ(filter->GetLoopSignificance(), chain.ridges->GetLoopSignificance());
  EXPECT_EQ(filter->GetZoneSignificance(), chain.ridges->GetZoneSignificance());
  EXPECT_EQ(filter->GetTypeSignificance(), chain.ridges->GetTypeSignificance());
  EXPECT_EQ(filter->GetTypeHysteresis(), chain.ridges->GetTypeHysteresis());
  EXPECT_EQ(filter->GetUmbilicCutOff(), chain.ridges->GetUmbilicCutOff());
  EXPECT_EQ(filter->GetMinimumSharpness(), chain.selection->GetMinimumSharpness());
}

TEST(RidgesAndUmbilics, OutputsTheSelectedNumberOfRings)
{
  vtkNew<vtkRidgesAndUmbilics> filter;
  filter->SetInputData(EllipsoidData(16));
  filter->Update();
  vtkFieldData* field = filter->GetOutput(vtkRidgesAndUmbilics::MESH)->GetFieldData();
  // Without noise a high degree, on hardly more points than it needs.
  EXPECT_EQ(Value(field, names::SelectedDegree, 0), 8.0);
  EXPECT_EQ(Value(field, names::SelectedNumberOfRings, 0), 4.0);
}

TEST(RidgesAndUmbilics, IsModifiedExactlyWhereAPropertyChanges)
{
  vtkNew<vtkRidgesAndUmbilics> filter;
  int events = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&events);
  count->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  filter->AddObserver(vtkCommand::ModifiedEvent, count);
  const auto expectEvents = [&filter, &events](int expected, const auto& set)
  {
    const vtkMTimeType before = filter->GetMTime();
    events = 0;
    set();
    EXPECT_EQ(events, expected);
    EXPECT_EQ(filter->GetMTime() != before, expected > 0);
  };
  expectEvents(1, [&filter] { filter->SetPatchSize(3.0); });
  expectEvents(0, [&filter] { filter->SetPatchSize(3.0); });
  expectEvents(1, [&filter] { filter->SetNumberOfRings(-5); }); // clamped to 1
  expectEvents(0, [&filter] { filter->SetNumberOfRings(1); });
  expectEvents(1, [&filter] { filter->CrestOnlyOn(); });
  expectEvents(0, [&filter] { filter->SetNeighborhoodToAutomatic(); });
}

TEST(RidgesAndUmbilics, RunsAgainOnlyWhatHasChanged)
{
  vtkNew<vtkRidgesAndUmbilics> filter;
  const auto mesh = EllipsoidData(16);
  filter->SetInputData(mesh);
  filter->Update();
  {
    const ProgressWatch watch(filter);
    filter->Update();
    EXPECT_TRUE(watch.Reported().empty()) << "nothing has changed";
  }
  {
    const ProgressWatch watch(filter);
    filter->SetMinimumSharpness(5.0);
    filter->Update();
    ASSERT_GT(watch.Reported().size(), 1u);
    EXPECT_GE(watch.Reported()[1], 0.95) << "the stages before the last one have run again";
  }
  // Another mesh in the same place, and the same one changed, have to be noticed.
  filter->SetMinimumSharpness(0.0);
  const auto other = EllipsoidData(12);
  filter->SetInputData(other);
  EXPECT_TRUE(BytesOfAll(filter) == Chain(other).Bytes());
  other->DeepCopy(BlendData(12));
  EXPECT_TRUE(BytesOfAll(filter) == Chain(other).Bytes());
}

TEST(RidgesAndUmbilics, ProgressRisesInOneSweep)
{
  vtkNew<vtkRidgesAndUmbilics> filter;
  filter->SetInputData(BlendData(63));
  const ProgressWatch watch(filter);
  filter->Update();
  const std::vector<double>& reported = watch.Reported();
  ASSERT_GT(reported.size(), 10u);
  for (std::size_t i = 1; i < reported.size(); ++i)
  {
    EXPECT_GE(reported[i], reported[i - 1]) << i;
  }
  EXPECT_EQ(reported.front(), 0.0);
  EXPECT_EQ(reported.back(), 1.0);
}

TEST(RidgesAndUmbilics, AbortInAnyStageGivesEmptyOutputsAndTheNextRunIsComplete)
{
  const auto mesh = BlendData(63);
  vtkNew<vtkRidgesAndUmbilics> filter;
  filter->SetInputData(mesh);
  const std::vector<std::string> whole = BytesOfAll(filter);
  for (const double where : { 0.3, 0.6, 0.8, 0.95 })
  {
    // A property that runs all stages again.
    filter->SetMinimumNumberOfPoints(30);
    {
      const ProgressWatch watch(filter, where);
      filter->Update();
      // VTK after 9.1 reports the ends of the stage and of the filter after an abort as well.
      EXPECT_LE(std::count_if(watch.Reported().begin(), watch.Reported().end(),
                  [&](double progress) { return progress >= where; }),
        3)
        << "the stage has gone on after the abort at " << where;
    }
    ExpectAllEmpty(filter);
    filter->SetMinimumNumberOfPoints(18);
    EXPECT_TRUE(BytesOfAll(filter) == whole) << where;
  }
  {
    const ProgressWatch watch(filter, 0.3);
    filter->Modified();
    filter->SetMinimumNumberOfPoints(31);
    filter->Update();
    ExpectAllEmpty(filter);
  }
  filter->Modified(); // without another property
  filter->Update();
  EXPECT_FALSE(IsEmpty(filter->GetOutput()));
}

TEST(RidgesAndUmbilics, ReportsErrorsOfAStageOnceInItsOwnName)
{
  vtkNew<vtkRidgesAndUmbilics> filter;
  filter->SetInputData(EllipsoidData(8));
  filter->Update();
  ASSERT_FALSE(IsEmpty(filter->GetOutput()));
  const MessageRecorder recorder(filter);
  filter->SetNeighborhoodToRadius();
  filter->Update();
  EXPECT_EQ(recorder.NumberOfErrors(), 1u);
  const std::string text = recorder.ErrorText();
  EXPECT_NE(text.find("vtkRidgesAndUmbilics"), std::string::npos) << text;
  EXPECT_NE(text.find("): Neighborhood is by radius, but Radius is 0: set a positive one.\n"),
    std::string::npos)
    << text;
  EXPECT_EQ(text.find("vtkJetFitting"), std::string::npos) << text;
  ExpectAllEmpty(filter);

  filter->SetNeighborhoodToPointCount();
  filter->SetPatchSize(std::numeric_limits<double>::quiet_NaN());
  filter->Update();
  EXPECT_EQ(recorder.NumberOfErrors(), 2u);
  EXPECT_NE(recorder.ErrorText().find("PatchSize"), std::string::npos);
  ExpectAllEmpty(filter);

  filter->SetPatchSize(2.0);
  filter->Update();
  EXPECT_EQ(recorder.NumberOfErrors(), 2u);
  EXPECT_FALSE(IsEmpty(filter->GetOutput()));
}

TEST(RidgesAndUmbilics, PointsWithoutTrianglesAreAnError)
{
  const auto cloud = EllipsoidData(4);
  vtkNew<vtkCellArray> line;
  line->InsertNextCell({ 0, 1, 2 });
  cloud->SetPolys(nullptr);
  cloud->SetLines(line);
  vtkNew<vtkRidgesAndUmbilics> filter;
  filter->SetInputData(cloud);
  const MessageRecorder recorder(filter);
  filter->Update();
  EXPECT_EQ(recorder.NumberOfErrors(), 1u);
  EXPECT_NE(recorder.ErrorText().find("no triangles"), std::string::npos) << recorder.ErrorText();
  ExpectAllEmpty(filter);
}

TEST(RidgesAndUmbilics, TriangulatesQuadsAndWarnsOnce)
{
  // A wavy sheet of quads.
  std::vector<std::array<double, 3>> points;
  std::vector<std::vector<vtkIdType>> quads;
  const int n = 30;
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const double x = 0.1 * i;
      const double y = 0.1 * j;
      points.push_back({ x, y, 0.3 * std::sin(2.0 * x) + 0.2 * std::cos(x + 3.0 * y) });
      if (i + 1 < n && j + 1 < n)
      {
        const vtkIdType p = j * n + i;
        quads.push_back({ p, p + 1, p + n + 1, p + n });
      }
    }
  }
  const auto mesh = MakePolyData(points, quads);
  vtkNew<vtkRidgesAndUmbilics> filter;
  filter->SetInputData(mesh);
  const MessageRecorder recorder(filter);
  filter->Update();
  EXPECT_EQ(recorder.NumberOfErrors(), 0u) << recorder.ErrorText();
  EXPECT_EQ(recorder.NumberOfWarnings(), 1u) << recorder.WarningText();
  EXPECT_NE(
    recorder.WarningText().find("841 polygons or strips were triangulated."), std::string::npos)
    << recorder.WarningText();
  EXPECT_GT(filter->GetOutput()->GetNumberOfLines(), 0);
  EXPECT_EQ(filter->GetOutput(vtkRidgesAndUmbilics::MESH)->GetNumberOfPolys(), 2 * 841);
}

TEST(RidgesAndUmbilics, PrintsThePropertiesOfItsStages)
{
  vtkNew<vtkRidgesAndUmbilics> filter;
  filter->SetMinimumSharpness(12.5);
  std::ostringstream text;
  filter->Print(text);
  for (const char* line : { "MinimumNumberOfPoints: 18", "PatchSize: 2", "TypeRule: FourthOrder",
         "MinimumSharpness: 12.5" })
  {
    EXPECT_NE(text.str().find(line), std::string::npos) << line;
  }
}
