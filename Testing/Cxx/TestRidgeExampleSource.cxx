// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "AnalyticSurface.h"
#include "FilterTestTools.h"
#include "MessageRecorder.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRidgeExampleSource.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

using namespace ridges::testing;

namespace
{

/// Largest distance to the surface, to first order.
double LargestDistance(vtkPolyData* mesh, const AnalyticSurface& surface)
{
  double largest = 0.0;
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    const Eigen::Vector3d point = PointAt(mesh, p);
    largest = std::max(largest, std::abs(surface.Value(point)) / surface.Gradient(point).norm());
  }
  return largest;
}

void ExpectGoodMesh(vtkPolyData* data, int frequency)
{
  EXPECT_EQ(data->GetNumberOfPoints(), 10 * frequency * frequency + 2);
  EXPECT_EQ(data->GetNumberOfPolys(), 20 * frequency * frequency);
  EXPECT_EQ(data->GetNumberOfCells(), data->GetNumberOfPolys());
  EXPECT_EQ(data->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(data->GetPointData()->GetNumberOfArrays(), 0);
  const Mesh mesh = ToMesh(data);
  const MeshTopology topology = Topology(mesh);
  EXPECT_TRUE(topology.oriented);
  EXPECT_EQ(topology.borderEdges, 0);
  EXPECT_EQ(topology.EulerCharacteristic(), 2);
  EXPECT_GT(SignedVolume(mesh), 0.0);
  if (frequency > 3) // a handful of triangles cannot follow the surface
  {
    EXPECT_GT(SmallestAngle(mesh), 0.25) << "radians";
  }
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t p = 0; p < mesh.PointCount(); ++p)
  {
    nearest = std::min(nearest, mesh.Point(p).cwiseAbs().minCoeff());
  }
  EXPECT_GT(nearest, 0.0) << "a point lies in a coordinate plane";
}

} // namespace

TEST(RidgeExampleSource, MakesTheBlend)
{
  for (const int frequency : { 1, 2, 7, 32, 63 })
  {
    const auto mesh = BlendData(frequency);
    ExpectGoodMesh(mesh, frequency);
    EXPECT_LT(LargestDistance(mesh, MakeBlend()), 1e-14); // round-off of coordinates below 0.4
  }
}

TEST(RidgeExampleSource, MakesTheEllipsoid)
{
  for (const int frequency : { 1, 2, 7, 32, 63 })
  {
    const auto mesh = EllipsoidData(frequency);
    ExpectGoodMesh(mesh, frequency);
    EXPECT_LT(LargestDistance(mesh, MakeEllipsoid(1.4, 1.0, 0.6)), 1e-14);
  }
}

TEST(RidgeExampleSource, TakesOtherSemiAxes)
{
  vtkNew<vtkRidgeExampleSource> source;
  source->SetSurfaceToEllipsoid();
  source->SetFrequency(12);
  source->SetSemiAxes(300.0, 200.0, 900.0);
  source->Update();
  EXPECT_LT(LargestDistance(source->GetOutput(), MakeEllipsoid(300.0, 200.0, 900.0)), 1e-11);
  ExpectGoodMesh(source->GetOutput(), 12);
}

TEST(RidgeExampleSource, DefaultIsTheBlendOfTheFigure)
{
  vtkNew<vtkRidgeExampleSource> source;
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 39692);
  EXPECT_EQ(source->GetSurface(), vtkRidgeExampleSource::BLEND);
}

TEST(RidgeExampleSource, RefusesBadSemiAxesWithOneError)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  vtkNew<vtkRidgeExampleSource> source;
  source->SetSurfaceToEllipsoid();
  source->SetFrequency(4);
  source->Update();
  ASSERT_GT(source->GetOutput()->GetNumberOfPoints(), 0);
  for (const double bad : { 0.0, -1.0, nan, infinity })
  {
    const MessageRecorder recorder(source);
    source->SetSemiAxes(1.0, bad, 2.0);
    source->Update();
    EXPECT_EQ(recorder.NumberOfErrors(), 1u) << bad;
    EXPECT_NE(recorder.ErrorText().find("SemiAxes are 1, "), std::string::npos);
    EXPECT_TRUE(IsEmpty(source->GetOutput())) << "stale output";
  }
  source->SetSurfaceToBlend(); // which has no use for them
  source->Update();
  EXPECT_GT(source->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(RidgeExampleSource, VerySmallAndVeryLargeSemiAxesAreFinite)
{
  for (const double scale : { 1e-60, 1e-30, 1e30, 1e60 })
  {
    vtkNew<vtkRidgeExampleSource> source;
    source->SetSurfaceToEllipsoid();
    source->SetFrequency(4);
    source->SetSemiAxes(1.4 * scale, scale, 0.6 * scale);
    source->Update();
    ExpectAllFinite(source->GetOutput());
    EXPECT_GT(SmallestAngle(ToMesh(source->GetOutput())), 0.25) << scale;
  }
}

TEST(RidgeExampleSource, GivesTheSameBytesForAnyNumberOfThreads)
{
  std::string expected;
  for (const int threads : { 1, 2, 3 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false },
      [&expected]
      {
        const std::string bytes = BytesOf(BlendData(16));
        expected = expected.empty() ? bytes : expected;
        EXPECT_TRUE(bytes == expected);
      });
  }
}

TEST(RidgeExampleSource, ReportsProgressAndStopsWhenAborted)
{
  struct Watch
  {
    std::vector<double> reported;
    double abortAt = 2.0;
  } watch;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&watch);
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      auto* source = static_cast<vtkAlgorithm*>(caller);
      auto* seen = static_cast<Watch*>(data);
      seen->reported.push_back(source->GetProgress());
      source->SetAbortExecute(source->GetProgress() >= seen->abortAt ? 1 : 0);
    });
  vtkNew<vtkRidgeExampleSource> source;
  source->AddObserver(vtkCommand::ProgressEvent, command);
  source->SetFrequency(8);
  source->Update();
  EXPECT_GT(watch.reported.size(), 100u);
  EXPECT_TRUE(std::is_sorted(watch.reported.begin(), watch.reported.end()));
  EXPECT_EQ(watch.reported.back(), 1.0);
  const std::string whole = BytesOf(source->GetOutput());

  watch = { {}, 0.5 };
  source->Modified();
  source->Update();
  EXPECT_TRUE(IsEmpty(source->GetOutput()));
  EXPECT_EQ(std::count_if(watch.reported.begin(), watch.reported.end(),
              [](double progress) { return progress >= 0.5 && progress < 1.0; }),
    1);
  watch.abortAt = 2.0;
  source->SetAbortExecute(0);
  source->Modified();
  source->Update();
  EXPECT_TRUE(BytesOf(source->GetOutput()) == whole);
}

TEST(RidgeExampleSource, SettersClampAndAllIsPrinted)
{
  vtkNew<vtkRidgeExampleSource> source;
  EXPECT_EQ(source->GetFrequency(), 63);
  source->SetFrequency(0);
  EXPECT_EQ(source->GetFrequency(), 1);
  source->SetFrequency(5000);
  EXPECT_EQ(source->GetFrequency(), 2000);
  source->SetSurface(9);
  EXPECT_EQ(source->GetSurface(), vtkRidgeExampleSource::ELLIPSOID);
  std::ostringstream text;
  source->Print(text);
  for (const char* line : { "Surface: Ellipsoid", "Frequency: 2000", "SemiAxes: 1.4 1 0.6" })
  {
    EXPECT_NE(text.str().find(line), std::string::npos) << line;
  }
}
