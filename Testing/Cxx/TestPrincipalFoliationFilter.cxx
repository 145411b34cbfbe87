// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTestTools.h"
#include "MessageRecorder.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellLocator.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPrincipalFoliation.h"
#include "vtkRidgesArrayNames.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

vtkSmartPointer<vtkPolyData> LinesOf(
  vtkPolyData* mesh,
  const std::function<void(vtkPrincipalFoliation*)>& configure = [](vtkPrincipalFoliation*) {})
{
  vtkNew<vtkPrincipalFoliation> foliation;
  const MessageRecorder recorder(foliation);
  foliation->SetInputData(mesh);
  configure(foliation);
  foliation->Update();
  EXPECT_EQ(recorder.ErrorText() + recorder.ExecutiveErrorText(), "");
  ExpectAllFinite(foliation->GetOutput());
  return foliation->GetOutput();
}

double TotalLength(vtkPolyData* lines)
{
  double sum = 0.0;
  for (vtkIdType i = 0; i < lines->GetNumberOfCells(); ++i)
  {
    sum += Value(lines->GetCellData(), names::Length, i);
  }
  return sum;
}

/// Calls visit(p, q) for each segment of all lines.
template <typename Visitor>
void ForEachSegment(vtkPolyData* lines, const Visitor& visit)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < lines->GetNumberOfCells(); ++i)
  {
    lines->GetCellPoints(i, ids);
    for (vtkIdType j = 1; j < ids->GetNumberOfIds(); ++j)
    {
      visit(PointAt(lines, ids->GetId(j - 1)), PointAt(lines, ids->GetId(j)));
    }
  }
}

} // namespace

TEST(PrincipalFoliationFilter, OutputsTheDocumentedArrays)
{
  const Outputs outputs = RunFilters(EllipsoidData(32));
  for (const bool minimum : { false, true })
  {
    const auto lines = LinesOf(outputs.marked,
      [&](vtkPrincipalFoliation* filter) { filter->SetDirection(minimum ? 1 : 0); });
    const vtkIdType count = lines->GetNumberOfLines();
    ASSERT_GT(count, 30);
    EXPECT_EQ(lines->GetNumberOfCells(), count);
    EXPECT_EQ(lines->GetPoints()->GetDataType(), VTK_DOUBLE);
    EXPECT_EQ(lines->GetPointData()->GetNumberOfArrays(), 1);
    EXPECT_EQ(lines->GetCellData()->GetNumberOfArrays(), 3);
    ExpectArray(lines->GetPointData(), names::Curvature, VTK_DOUBLE, 1, lines->GetNumberOfPoints());
    ExpectArray(lines->GetCellData(), names::PrincipalDirection, VTK_INT, 1, count);
    ExpectArray(lines->GetCellData(), names::Closed, VTK_INT, 1, count);
    ExpectArray(lines->GetCellData(), names::Length, VTK_DOUBLE, 1, count);

    int loops = 0;
    vtkNew<vtkIdList> ids;
    for (vtkIdType i = 0; i < count; ++i)
    {
      EXPECT_EQ(Value(lines->GetCellData(), names::PrincipalDirection, i), minimum ? 1.0 : 0.0);
      lines->GetCellPoints(i, ids);
      const bool comesBack = ids->GetId(0) == ids->GetId(ids->GetNumberOfIds() - 1);
      EXPECT_EQ(Value(lines->GetCellData(), names::Closed, i), comesBack ? 1.0 : 0.0);
      loops += comesBack ? 1 : 0;
      double length = 0.0;
      for (vtkIdType j = 1; j < ids->GetNumberOfIds(); ++j)
      {
        length += (PointAt(lines, ids->GetId(j)) - PointAt(lines, ids->GetId(j - 1))).norm();
      }
      EXPECT_NEAR(Value(lines->GetCellData(), names::Length, i), length, 1e-12 * length);
      EXPECT_GE(length, 2.0 * 0.05 * 1.39);
    }
    EXPECT_GT(loops, 10);
    // Of the ellipsoid with semi-axes 1.4, 1, 0.6: k1 in [-b/a^2, ...], k2 down to -a/c^2.
    for (vtkIdType p = 0; p < lines->GetNumberOfPoints(); ++p)
    {
      const double k = Value(lines->GetPointData(), names::Curvature, p);
      EXPECT_GT(k, minimum ? -1.4 / 0.36 - 0.01 : -1.4 - 0.01);
      EXPECT_LT(k, minimum ? -0.6 + 0.01 : -0.6 / 1.96 + 0.01);
    }
  }
}

TEST(PrincipalFoliationFilter, BothGivesMaximumThenMinimum)
{
  const Outputs outputs = RunFilters(BlendData(24));
  const auto blue = LinesOf(outputs.marked);
  const auto red =
    LinesOf(outputs.marked, [](vtkPrincipalFoliation* filter) { filter->SetDirectionToMinimum(); });
  const auto both =
    LinesOf(outputs.marked, [](vtkPrincipalFoliation* filter) { filter->SetDirectionToBoth(); });
  const vtkIdType blueCount = blue->GetNumberOfLines();
  const vtkIdType redCount = red->GetNumberOfLines();
  ASSERT_GT(blueCount, 20);
  ASSERT_GT(redCount, 20);
  ASSERT_EQ(both->GetNumberOfLines(), blueCount + redCount);
  ASSERT_EQ(both->GetNumberOfPoints(), blue->GetNumberOfPoints() + red->GetNumberOfPoints());
  for (vtkIdType i = 0; i < blueCount + redCount; ++i)
  {
    const bool isBlue = i < blueCount;
    EXPECT_EQ(Value(both->GetCellData(), names::PrincipalDirection, i), isBlue ? 0.0 : 1.0);
    EXPECT_EQ(Value(both->GetCellData(), names::Length, i),
      isBlue ? Value(blue->GetCellData(), names::Length, i)
             : Value(red->GetCellData(), names::Length, i - blueCount));
  }
}

TEST(PrincipalFoliationFilter, LinesLieOnTheMeshOutsideOfPatches)
{
  const Outputs outputs = RunFilters(BlendData(32));
  const double edge = MeanEdgeLength(ToMesh(outputs.marked));
  vtkNew<vtkCellLocator> locator;
  locator->SetDataSet(outputs.marked);
  locator->BuildLocator();
  const auto countInPatches = [&](vtkPolyData* lines)
  {
    int count = 0;
    ForEachSegment(lines,
      [&](const Eigen::Vector3d& p, const Eigen::Vector3d& q)
      {
        const Eigen::Vector3d middle = 0.5 * (p + q);
        Eigen::Vector3d nearest;
        vtkIdType cell = -1;
        int sub = 0;
        double square = 0.0;
        locator->FindClosestPoint(middle.data(), nearest.data(), cell, sub, square);
        // The last segment of a loop makes up for what it misses its start by, a quarter edge.
        EXPECT_LT(std::sqrt(square), 0.25 * edge);
        count +=
          square < 1e-20 && Value(outputs.marked->GetCellData(), names::UmbilicPatch, cell) >= 0.0
          ? 1
          : 0;
      });
    return count;
  };
  const auto lines = LinesOf(outputs.marked);
  ASSERT_GT(lines->GetNumberOfLines(), 20);
  EXPECT_EQ(countInPatches(lines), 0);
  const auto through = LinesOf(
    outputs.marked, [](vtkPrincipalFoliation* filter) { filter->StopAtUmbilicPatchesOff(); });
  EXPECT_GT(countInPatches(through), 20);
  // Without patches on the mesh it is the same as with them passed over, but for the field data
  // that VTK passes on.
  const auto without = LinesOf(outputs.fitted);
  through->GetFieldData()->Initialize();
  without->GetFieldData()->Initialize();
  EXPECT_TRUE(BytesOf(without) == BytesOf(through));
}

TEST(PrincipalFoliationFilter, NeedsNeitherThirdOrderNorStatus)
{
  const Outputs outputs = RunFilters(EllipsoidData(16));
  const auto bare = vtkSmartPointer<vtkPolyData>::New();
  bare->ShallowCopy(outputs.fitted);
  for (const char* name : { names::ThirdOrder, names::FourthOrder, names::P1, names::P2,
         names::Normals, names::FitStatus })
  {
    bare->GetPointData()->RemoveArray(name);
  }
  EXPECT_TRUE(BytesOf(LinesOf(bare)) == BytesOf(LinesOf(outputs.fitted)));
}

TEST(PrincipalFoliationFilter, NamesAllThatIsMissingInOneError)
{
  const auto good = RunFilters(EllipsoidData(8)).fitted;
  vtkNew<vtkPrincipalFoliation> foliation;
  const MessageRecorder recorder(foliation);
  foliation->SetInputData(good);
  foliation->Update();
  ASSERT_FALSE(IsEmpty(foliation->GetOutput()));
  foliation->SetInputData(EllipsoidData(8));
  foliation->Update();
  EXPECT_EQ(recorder.NumberOfErrors(), 1u);
  EXPECT_NE(recorder.ErrorText().find(
              "MaximumCurvature, MinimumCurvature, MaximumDirection, MinimumDirection."),
    std::string::npos)
    << recorder.ErrorText();
  EXPECT_EQ(recorder.ErrorText().find("ThirdOrder"), std::string::npos);
  EXPECT_TRUE(IsEmpty(foliation->GetOutput()));
}

TEST(PrincipalFoliationFilter, PropertiesAreClampedCheckedAndPrinted)
{
  vtkNew<vtkPrincipalFoliation> foliation;
  foliation->SetSeparation(0.0);
  EXPECT_EQ(foliation->GetSeparation(), 0.0001);
  foliation->SetSeparation(3.0);
  EXPECT_EQ(foliation->GetSeparation(), 1.0);
  foliation->SetLeastDistance(2.0);
  EXPECT_EQ(foliation->GetLeastDistance(), 0.9);
  foliation->SetMinimumLength(-1.0);
  EXPECT_EQ(foliation->GetMinimumLength(), 0.0);
  foliation->SetMaximumLength(-1.0);
  EXPECT_EQ(foliation->GetMaximumLength(), 0.0);
  foliation->SetStepSize(0.0);
  EXPECT_EQ(foliation->GetStepSize(), 0.001);
  foliation->SetModelSize(-2.0);
  EXPECT_EQ(foliation->GetModelSize(), 0.0);
  foliation->SetDirection(7);
  EXPECT_EQ(foliation->GetDirection(), vtkPrincipalFoliation::BOTH);
  std::ostringstream text;
  foliation->Print(text);
  for (const char* line :
    { "Direction: Both", "Separation: 1", "LeastDistance: 0.9", "MinimumLength: 0",
      "MaximumLength: 0", "StepSize: 0.001", "StopAtUmbilicPatches: On", "ModelSize: 0" })
  {
    EXPECT_NE(text.str().find(line), std::string::npos) << line;
  }

  const double notANumber = std::numeric_limits<double>::quiet_NaN();
  foliation->SetInputData(RunFilters(EllipsoidData(8)).fitted);
  foliation->SetSeparation(notANumber);
  foliation->SetStepSize(notANumber);
  const MessageRecorder recorder(foliation);
  foliation->Update();
  EXPECT_EQ(recorder.NumberOfErrors(), 1u);
  EXPECT_NE(recorder.ErrorText().find("Separation, StepSize"), std::string::npos);
  EXPECT_TRUE(IsEmpty(foliation->GetOutput()));
}

TEST(PrincipalFoliationFilter, SeparationIsAFractionOfTheModelSizeWhateverTheMesh)
{
  // Area over separation; the ellipsoid's radius is 1.4, its area 11.8.
  for (const int frequency : { 16, 32 })
  {
    const auto mesh = RunFilters(EllipsoidData(frequency)).fitted;
    for (const double separation : { 0.05, 0.1 })
    {
      const auto lines =
        LinesOf(mesh, [&](vtkPrincipalFoliation* filter) { filter->SetSeparation(separation); });
      EXPECT_NEAR(TotalLength(lines) / (11.8 / (1.4 * separation)), 1.15, 0.15);
      const auto sized = LinesOf(mesh,
        [&](vtkPrincipalFoliation* filter)
        {
          filter->SetSeparation(0.5 * separation);
          filter->SetModelSize(2.8);
        });
      EXPECT_NEAR(TotalLength(sized) / TotalLength(lines), 1.0, 0.05);
    }
  }
}

TEST(PrincipalFoliationFilter, WarnsOfMoreLinesThanTheMeshResolves)
{
  // The mean edge is 0.3 of the radius of 1.4.
  const auto mesh = RunFilters(EllipsoidData(3)).fitted;
  for (const double separation : { 0.02, 0.04 })
  {
    vtkNew<vtkPrincipalFoliation> filter;
    const MessageRecorder recorder(filter);
    filter->SetInputData(mesh);
    filter->SetSeparation(separation);
    filter->Update();
    const bool isWarned = recorder.WarningText().find("lines across an edge") != std::string::npos;
    EXPECT_EQ(isWarned, separation < 0.03) << recorder.WarningText();
  }
}

TEST(PrincipalFoliationFilter, IsTheSameForAnyNumberOfThreadsAndNumbering)
{
  const auto mesh = BlendData(32);
  const auto both = [](vtkPrincipalFoliation* filter) { filter->SetDirectionToBoth(); };
  const std::string expected = BytesOf(LinesOf(RunFilters(mesh).fitted, both));
  for (const std::uint64_t seed : { 1u, 2u })
  {
    const auto permuted = ToPolyData(Permute(ToMesh(mesh), seed));
    EXPECT_TRUE(BytesOf(LinesOf(RunFilters(permuted).fitted, both)) == expected);
  }
  vtkSMPTools::Initialize(1);
  EXPECT_TRUE(BytesOf(LinesOf(RunFilters(mesh).fitted, both)) == expected);
  vtkSMPTools::Initialize(0);
}

// Scaling by powers of two changes no digit. By others, and after a rigid motion, round-off may
// decide between seeds, and other lines as good come out.
TEST(PrincipalFoliationFilter, ScalesAndMovesWithTheMesh)
{
  const auto original = BlendData(32);
  const auto expected = LinesOf(RunFilters(original).fitted);
  const Mesh mesh = ToMesh(original);
  const Eigen::Matrix3d none = Eigen::Matrix3d::Identity();
  for (const int exponent : { -40, 40 })
  {
    const double scale = std::ldexp(1.0, exponent);
    const auto lines =
      LinesOf(RunFilters(ToPolyData(Transform(mesh, none, Eigen::Vector3d::Zero(), scale))).fitted);
    ASSERT_EQ(lines->GetNumberOfPoints(), expected->GetNumberOfPoints());
    EXPECT_EQ(lines->GetNumberOfLines(), expected->GetNumberOfLines());
    for (vtkIdType p = 0; p < lines->GetNumberOfPoints(); ++p)
    {
      ASSERT_LT((PointAt(lines, p) / scale - PointAt(expected, p)).norm(), 1e-9);
    }
  }
  for (const double scale : { 1.0, 1e-12, 1e12 })
  {
    const auto lines =
      LinesOf(RunFilters(ToPolyData(Transform(mesh, GenericRotation(), { scale, 0.0, 0.0 }, scale)))
                .fitted);
    EXPECT_NEAR(TotalLength(lines) / scale / TotalLength(expected), 1.0, 0.05);
  }
}

TEST(PrincipalFoliationFilter, AcceptsDefectiveMeshes)
{
  // Polygons and strips are triangulated, and said so.
  const Outputs outputs = RunFilters(EllipsoidData(12));
  const auto mixed = vtkSmartPointer<vtkPolyData>::New();
  mixed->DeepCopy(outputs.fitted);
  vtkIdType quad[4] = { 0, 1, 2, 3 };
  mixed->GetPolys()->InsertNextCell(4, quad);
  mixed->GetCellData()->Initialize();
  mixed->Modified();
  vtkNew<vtkPrincipalFoliation> foliation;
  {
    const MessageRecorder recorder(foliation);
    foliation->SetInputData(mixed);
    foliation->Update();
    EXPECT_NE(
      recorder.WarningText().find("1 polygons or strips were triangulated"), std::string::npos);
    EXPECT_GT(foliation->GetOutput()->GetNumberOfLines(), 10);
  }

  // A border, an isolated point, a non-manifold edge, a NaN in a point and in an array, a triangle
  // without area.
  Mesh mesh = CylinderPatch(1.0, 3.0, 3.0, 30, 30);
  mesh.AddPoint({ 5.0, 5.0, 5.0 });
  const auto isolated = static_cast<std::int32_t>(mesh.PointCount()) - 1;
  mesh.AddPoint(2.0 * mesh.Point(100));
  mesh.AddTriangle(mesh.triangles[300], mesh.triangles[301], isolated + 1);
  mesh.AddPoint(mesh.Point(50));
  mesh.AddTriangle(50, mesh.triangles[400], isolated + 2);
  mesh.SetPoint(200, Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
  const auto faulty = RunFilters(ToPolyData(mesh)).fitted;
  faulty->GetPointData()
    ->GetArray(names::MaximumDirection)
    ->SetComponent(250, 1, std::numeric_limits<double>::infinity());
  const auto lines = LinesOf(faulty);
  EXPECT_GT(lines->GetNumberOfLines(), 10);
}

TEST(PrincipalFoliationFilter, TerminatesWithMeaninglessArrays)
{
  for (const std::uint64_t seed : { 1u, 2u, 3u })
  {
    const auto mesh = ToPolyData(AddNormalNoise(Icosphere(10), 0.1, seed));
    AddRandomMongeArrays(mesh, seed);
    LinesOf(mesh,
      [](vtkPrincipalFoliation* filter)
      {
        filter->SetDirectionToBoth();
        filter->SetMinimumLength(0.0);
        filter->SetLeastDistance(0.05);
      });
  }
  const auto constant = EllipsoidData(8);
  for (const char* name : { names::MaximumCurvature, names::MinimumCurvature })
  {
    AddPointArray(constant, name, 1, [](vtkIdType, double* k) { *k = 1.0; });
  }
  for (const char* name : { names::MaximumDirection, names::MinimumDirection })
  {
    AddPointArray(constant, name, 3, [](vtkIdType, double* d) { std::fill(d, d + 3, 0.0); });
  }
  EXPECT_TRUE(IsEmpty(LinesOf(constant)));
}

TEST(PrincipalFoliationFilter, AbortGivesNoOutputAndTheNextRunIsComplete)
{
  const auto mesh = RunFilters(EllipsoidData(32)).fitted;
  vtkNew<vtkPrincipalFoliation> foliation;
  foliation->SetInputData(mesh);
  std::vector<double> progress;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&progress);
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void* client, void*)
    {
      auto* algorithm = static_cast<vtkAlgorithm*>(caller);
      auto& seen = *static_cast<std::vector<double>*>(client);
      seen.push_back(algorithm->GetProgress());
      algorithm->SetAbortExecute(algorithm->GetProgress() > 0.4 ? 1 : 0);
    });
  const unsigned long tag = foliation->AddObserver(vtkCommand::ProgressEvent, command);
  foliation->Update();
  foliation->RemoveObserver(tag);
  EXPECT_TRUE(IsEmpty(foliation->GetOutput()));
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end() - 1));
  EXPECT_GT(progress.size(), 5u);
  foliation->SetAbortExecute(0);
  foliation->Modified();
  foliation->Update();
  EXPECT_TRUE(BytesOf(foliation->GetOutput()) == BytesOf(LinesOf(mesh)));
}
