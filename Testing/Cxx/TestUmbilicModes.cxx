// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// What Significance, UmbilicJoining and TypeHysteresis do on a noisy mesh, and zones where umbilics
// mean nothing.

#include "FilterTestTools.h"
#include "MongeMesh.h"
#include "RidgeGraph.h"
#include "WholeRidges.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRidgeExtraction.h"
#include "vtkRidgesArrayNames.h"
#include "vtkUmbilicDetection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

Mesh NoisyEllipsoid()
{
  const Mesh mesh = EllipsoidMesh(32, 1.4, 1.0, 0.6);
  return AddNormalNoise(mesh, 0.003 * MeanEdgeLength(mesh), 3);
}

double FieldValue(vtkPolyData* marked, const char* name)
{
  return Value(marked->GetFieldData(), name, 0);
}

std::set<vtkIdType> EndsInTriangles(vtkPolyData* ridges)
{
  std::set<vtkIdType> ends;
  for (vtkIdType i = 0; i < ridges->GetNumberOfPoints(); ++i)
  {
    const bool onEdge = Value(ridges->GetPointData(), names::EdgePoint0, i) >= 0.0;
    const bool turns = Value(ridges->GetPointData(), names::TurningPoint, i) != 0.0;
    if (!onEdge && !turns)
    {
      ends.insert(i);
    }
  }
  return ends;
}

/// Types and lengths of the runs of a whole ridge, those at the ends of an open one left out.
using Runs = std::vector<std::pair<int, double>>;

std::map<vtkIdType, Runs> InnerRuns(vtkPolyData* ridges)
{
  std::map<vtkIdType, Runs> runs;
  std::map<vtkIdType, bool> closed;
  vtkCellData* cells = ridges->GetCellData();
  for (vtkIdType line = 0; line < ridges->GetNumberOfLines(); ++line)
  {
    const auto id = static_cast<vtkIdType>(Value(cells, names::RidgeId, line));
    const auto type = static_cast<int>(Value(cells, names::RidgeType, line));
    const double length = Value(cells, names::Length, line);
    Runs& of = runs[id];
    if (!of.empty() && of.back().first == type) // Divided by being crest or not.
    {
      of.back().second += length;
    }
    else
    {
      of.emplace_back(type, length);
    }
    closed[id] = Value(cells, names::Closed, line) != 0.0;
  }
  for (auto& [id, of] : runs)
  {
    if (closed[id] && of.size() > 1 && of.front().first == of.back().first)
    {
      of.front().second += of.back().second;
      of.pop_back();
    }
    else if (!closed[id])
    {
      of.erase(of.begin());
      of.resize(of.empty() ? 0 : of.size() - 1);
    }
  }
  return runs;
}

double TotalLength(vtkPolyData* ridges)
{
  double sum = 0.0;
  for (vtkIdType line = 0; line < ridges->GetNumberOfLines(); ++line)
  {
    sum += Value(ridges->GetCellData(), names::Length, line);
  }
  return sum;
}

} // namespace

TEST(Significance, CancelsUmbilicsCausedByNoise)
{
  vtkNew<vtkJetFitting> jets;
  jets->SetNeighborhoodToPointCount(); // So that there is something to cancel.
  jets->SetInputData(ToPolyData(NoisyEllipsoid()));
  vtkNew<vtkUmbilicDetection> detection;
  detection->SetInputConnection(jets->GetOutputPort());
  vtkIdType fewest = VTK_ID_MAX;
  for (const double significance : { 0.0, 1.0, 3.0 })
  {
    detection->SetSignificance(significance);
    detection->Update();
    EXPECT_EQ(FieldValue(detection->GetOutput(0), names::UmbilicIndexSum), 2.0);
    EXPECT_LT(detection->GetOutput(1)->GetNumberOfPoints(), fewest) << significance;
    fewest = detection->GetOutput(1)->GetNumberOfPoints();
  }
  EXPECT_EQ(fewest, 4);
  EXPECT_GT(FieldValue(detection->GetOutput(0), names::NumberOfCancelledRegions), 0.0);

  // The standard errors themselves say about the same as the estimate from the residuals.
  jets->StandardErrorsOn();
  detection->Update();
  EXPECT_EQ(FieldValue(detection->GetOutput(0), names::UmbilicIndexSum), 2.0);
  EXPECT_LE(detection->GetOutput(1)->GetNumberOfPoints(), 10);
}

TEST(UmbilicJoining, OfTrianglesEndsAtTheCentroidsOfAllSingularOnes)
{
  const Outputs outputs = RunFilters(ToPolyData(NoisyEllipsoid()), vtkJetFitting::BY_POINT_COUNT);
  vtkNew<vtkRidgeExtraction> extraction;
  extraction->SetInputData(outputs.marked);
  extraction->SetUmbilicJoiningToTriangles();
  extraction->Update();
  vtkPolyData* ridges = extraction->GetOutput();

  const MongeMesh mesh(outputs.fitted);
  std::vector<Eigen::Vector3d> centroids;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (mesh.IsSingular(t))
    {
      const auto& c = mesh.triangles[t];
      centroids.emplace_back((PointAt(outputs.fitted, c[0]) + PointAt(outputs.fitted, c[1]) +
                               PointAt(outputs.fitted, c[2])) /
        3.0);
    }
  }
  const std::set<vtkIdType> ends = EndsInTriangles(ridges);
  EXPECT_EQ(ends.size(), centroids.size());
  EXPECT_GT(ends.size(), 4u);
  for (const vtkIdType end : ends)
  {
    const auto isThere = [&](const Eigen::Vector3d& x)
    { return (x - PointAt(ridges, end)).norm() < 1e-14; }; // Round-off.
    EXPECT_EQ(std::count_if(centroids.begin(), centroids.end(), isThere), 1);
  }

  // In patches only the umbilics are left.
  EXPECT_EQ(static_cast<vtkIdType>(EndsInTriangles(outputs.ridges).size()),
    outputs.umbilics->GetNumberOfPoints());
  EXPECT_EQ(CountLooseRidges(outputs.ridges, WholeRidges(outputs.ridges)), 0);
}

TEST(UmbilicJoining, OfTrianglesEqualsTheResultWithoutMarks)
{
  const Outputs outputs = RunFilters(BlendData(32));
  vtkNew<vtkRidgeExtraction> extraction;
  extraction->SetUmbilicJoiningToTriangles();
  extraction->SetUmbilicCutOff(0.0); // which is around where the umbilics are
  extraction->SetInputData(outputs.marked);
  extraction->Update();
  const auto marked = vtkSmartPointer<vtkPolyData>::New();
  marked->DeepCopy(extraction->GetOutput());
  extraction->SetInputData(outputs.fitted);
  extraction->Update();
  vtkPolyData* bare = extraction->GetOutput();
  marked->GetFieldData()->Initialize();
  bare->GetFieldData()->Initialize();
  marked->GetPointData()->GetArray(names::Umbilic)->Fill(-1.0);
  EXPECT_EQ(FirstDifference(marked, bare), "");
}

TEST(TypeHysteresis, LeavesNoShortRunsBetweenOthers)
{
  const Mesh mesh = NoisyEllipsoid();
  const double edge = MeanEdgeLength(mesh);
  const Outputs outputs = RunFilters(ToPolyData(mesh), vtkJetFitting::BY_POINT_COUNT);
  vtkNew<vtkRidgeExtraction> extraction;
  extraction->SetInputData(outputs.marked);
  extraction->SetLoopSignificance(0.0);
  vtkIdType most = VTK_ID_MAX;
  const double length = TotalLength(outputs.ridges);
  for (const double hysteresis : { 0.0, 1.0, 3.0, 10.0 })
  {
    extraction->SetTypeHysteresis(hysteresis);
    extraction->Update();
    vtkPolyData* ridges = extraction->GetOutput();
    for (const auto& of : InnerRuns(ridges))
    {
      for (const auto& run : of.second)
      {
        EXPECT_TRUE(of.second.size() == 1 || run.second >= hysteresis * edge * (1.0 - 1e-12));
      }
    }
    EXPECT_LT(ridges->GetNumberOfLines(), most) << hysteresis;
    most = ridges->GetNumberOfLines();
    // Turning points lie on the pieces that they divide.
    EXPECT_NEAR(TotalLength(ridges), length, 1e-12 * length);
    ExpectJoinedPolylines(ridges);
  }
}

// Not even at the start of a loop that is of one type now.
TEST(TypeHysteresis, LeavesNoFormerTurningPoints)
{
  const Outputs outputs = RunFilters(ToPolyData(NoisyEllipsoid()));
  vtkNew<vtkRidgeExtraction> extraction;
  extraction->SetInputData(outputs.marked);
  for (const double hysteresis : { 1.0, 3.0, 10.0 })
  {
    extraction->SetTypeHysteresis(hysteresis);
    extraction->SetLoopSignificance(0.0);
    extraction->Update();
    ExpectCompleteRidgeGraph(outputs.marked, extraction->GetOutput());
  }
}

TEST(TypeHysteresis, IsClampedAndPrinted)
{
  vtkNew<vtkRidgeExtraction> extraction;
  EXPECT_EQ(extraction->GetTypeHysteresis(), 0.0);
  extraction->SetTypeHysteresis(-1.0);
  EXPECT_EQ(extraction->GetTypeHysteresis(), 0.0);
  extraction->SetTypeHysteresis(1e9);
  EXPECT_EQ(extraction->GetTypeHysteresis(), 1000.0);
  extraction->SetTypeHysteresis(2.5);
  EXPECT_EQ(extraction->GetUmbilicJoining(), vtkRidgeExtraction::PATCHES);
  extraction->SetUmbilicJoining(9);
  EXPECT_EQ(extraction->GetUmbilicJoining(), vtkRidgeExtraction::TRIANGLES);
  std::ostringstream text;
  extraction->Print(text);
  for (const char* line : { "TypeHysteresis: 2.5", "UmbilicJoining: Triangles" })
  {
    EXPECT_NE(text.str().find(line), std::string::npos) << line;
  }
}

TEST(UmbilicZones, CoverASphereWithItsRequiredUmbilics)
{
  const Outputs outputs = RunFilters(ToPolyData(Icosphere(20)));
  EXPECT_EQ(outputs.umbilics->GetNumberOfPoints(), 4);
  EXPECT_EQ(FieldValue(outputs.marked, names::UmbilicIndexSum), 2.0);
  EXPECT_EQ(FieldValue(outputs.marked, names::NumberOfUmbilicZones), 1.0);
  for (vtkIdType cell = 0; cell < outputs.marked->GetNumberOfCells(); ++cell)
  {
    ASSERT_EQ(Value(outputs.marked->GetCellData(), names::UmbilicZone, cell), 0.0);
  }
  EXPECT_EQ(CountLooseRidges(outputs.ridges, WholeRidges(outputs.ridges)), 0);
}

TEST(UmbilicZones, CoverAPlane)
{
  const auto flat = [](double, double) { return 0.0; };
  const Outputs outputs = RunFilters(ToPolyData(GraphPatch(flat, 1.0, 20, 0.2, 3)));
  EXPECT_EQ(FieldValue(outputs.marked, names::NumberOfUmbilicZones), 1.0);
  for (vtkIdType cell = 0; cell < outputs.marked->GetNumberOfCells(); ++cell)
  {
    ASSERT_EQ(Value(outputs.marked->GetCellData(), names::UmbilicZone, cell), 0.0);
  }
}

TEST(UmbilicZones, DoNotExistOnASmoothMesh)
{
  const Outputs outputs = RunFilters(ToPolyData(EllipsoidMesh(32, 1.4, 1.0, 0.6)));
  vtkIdType inZones = 0;
  for (vtkIdType cell = 0; cell < outputs.marked->GetNumberOfCells(); ++cell)
  {
    inZones += Value(outputs.marked->GetCellData(), names::UmbilicZone, cell) >= 0.0 ? 1 : 0;
  }
  // Around the umbilics at most.
  EXPECT_LE(FieldValue(outputs.marked, names::NumberOfUmbilicZones), 4.0);
  EXPECT_LT(inZones, outputs.marked->GetNumberOfCells() / 50);
}
