// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTestTools.h"
#include "MessageRecorder.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRidgesArrayNames.h"
#include "vtkSMPTools.h"
#include "vtkSalientRidges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

using namespace ridges::testing;
using Eigen::Vector3d;
namespace names = vtkRidgesArrayNames;

namespace
{

/// A roof beside a valley: crest at x = 0.5, valley at x = -0.5, both rounded and along y. The
/// slope is 1.4 between them, and 0 at the other sides, so that they fold by 54 degrees.
Mesh RoofAndValley(double noise = 0.0)
{
  const auto fold = [](double x) { return 0.7 * std::hypot(x, 0.05); };
  return AddNormalNoise(
    GraphPatch([&fold](double x, double) { return fold(x + 0.5) - fold(x - 0.5); }, 1.0, 80, 0.2),
    noise, 1);
}

/// The surface of [-1, 1]^3, with so many cells along each edge.
Mesh CubeMesh(int cells)
{
  std::map<std::array<int, 3>, std::int32_t> ids;
  Mesh mesh;
  const auto idOf = [&ids, &mesh, cells](const std::array<int, 3>& place)
  {
    const auto inserted = ids.insert({ place, static_cast<std::int32_t>(ids.size()) });
    if (inserted.second)
    {
      mesh.AddPoint(Vector3d(place[0], place[1], place[2]) * (2.0 / cells) - Vector3d::Ones());
    }
    return inserted.first->second;
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const int level : { 0, cells })
    {
      for (int i = 0; i < cells * cells; ++i)
      {
        const auto at = [axis, level, cells, i](int u, int v)
        {
          std::array<int, 3> place{};
          place[axis] = level;
          place[(axis + 1) % 3] = i % cells + u;
          place[(axis + 2) % 3] = i / cells + v;
          return place;
        };
        std::array<std::int32_t, 4> corners{ idOf(at(0, 0)), idOf(at(1, 0)), idOf(at(1, 1)),
          idOf(at(0, 1)) };
        if (level == 0)
        {
          std::reverse(corners.begin(), corners.end());
        }
        mesh.AddTriangle(corners[0], corners[1], corners[2]);
        mesh.AddTriangle(corners[0], corners[2], corners[3]);
      }
    }
  }
  return mesh;
}

vtkSmartPointer<vtkSalientRidges> Find(vtkPolyData* mesh, double angle = 15.0)
{
  auto salient = vtkSmartPointer<vtkSalientRidges>::New();
  salient->SetInputData(mesh);
  salient->SetFoldAngle(angle);
  salient->Update();
  return salient;
}

double TotalLength(vtkPolyData* lines)
{
  double length = 0.0;
  for (vtkIdType i = 0; i < lines->GetNumberOfLines(); ++i)
  {
    length += Value(lines->GetCellData(), names::Length, i);
  }
  return length;
}

} // namespace

TEST(SalientRidges, FindsTheCrestAndTheValley)
{
  const auto salient = Find(ToPolyData(RoofAndValley()));
  vtkPolyData* lines = salient->GetOutput();
  ASSERT_EQ(lines->GetNumberOfLines(), 2);
  int types = 0;
  for (vtkIdType i = 0; i < 2; ++i)
  {
    const auto type = static_cast<int>(Value(lines->GetCellData(), names::RidgeType, i));
    types += type;
    // Curvature is positive where the surface bends towards its normal: valleys are maxima.
    const double x = type == 1 ? -0.5 : 0.5;
    vtkIdList* points = lines->GetCell(i)->GetPointIds();
    for (vtkIdType j = 0; j < points->GetNumberOfIds(); ++j)
    {
      // Within the rounding: one side is level, the other steep, and curvature is greatest between.
      EXPECT_NEAR(PointAt(lines, points->GetId(j))[0], x, 0.05);
    }
    EXPECT_GT(Value(lines->GetCellData(), names::Length, i), 1.8);
    EXPECT_EQ(Value(lines->GetCellData(), names::Closed, i), 0.0);
    EXPECT_GT(Value(lines->GetCellData(), names::Confidence, i), 0.99);
    // The sides meet at 54.5 degrees; less what is left at the foot, and evened along the line.
    EXPECT_GT(Value(lines->GetCellData(), names::FoldAngle, i), 45.0);
    EXPECT_LT(Value(lines->GetCellData(), names::FoldAngle, i), 54.5);
  }
  EXPECT_EQ(types, 1 + 3);
}

TEST(SalientRidges, SmoothsItsLinesOnTheSurface)
{
  const auto salient = Find(ToPolyData(RoofAndValley()));
  const auto unevenness = [&salient](double smoothing)
  {
    salient->SetLineSmoothing(smoothing);
    salient->Update();
    vtkPolyData* lines = salient->GetOutput();
    EXPECT_EQ(lines->GetNumberOfLines(), 2);
    // Lines run along y: what they are longer by are zigzags.
    double extra = 0.0;
    for (vtkIdType i = 0; i < lines->GetNumberOfLines(); ++i)
    {
      vtkIdList* points = lines->GetCell(i)->GetPointIds();
      const Vector3d way = PointAt(lines, points->GetId(points->GetNumberOfIds() - 1)) -
        PointAt(lines, points->GetId(0));
      extra += Value(lines->GetCellData(), names::Length, i) / way.norm() - 1.0;
    }
    return extra;
  };
  const double without = unevenness(0.0);
  EXPECT_LT(unevenness(1.0), 0.5 * without);
  EXPECT_GT(without, 0.0);
}

TEST(SalientRidges, DescribesItsLines)
{
  const auto salient = Find(ToPolyData(RoofAndValley()));
  vtkPolyData* lines = salient->GetOutput();
  const vtkIdType points = lines->GetNumberOfPoints();
  for (const char* name : { names::Curvature, names::SecondDerivative, names::FoldAngle,
         names::FoldWidth, names::ArcLength, names::EdgeParameter })
  {
    ExpectArray(lines->GetPointData(), name, VTK_DOUBLE, 1, points);
  }
  for (const char* name : { names::Sharpness, names::Strength, names::Length, names::FoldAngle,
         names::FoldMass, names::Confidence })
  {
    ExpectArray(lines->GetCellData(), name, VTK_DOUBLE, 1, 2);
  }
  ExpectAllFinite(lines);
  for (vtkIdType i = 0; i < 2; ++i)
  {
    vtkNew<vtkIdList> ids;
    ids->DeepCopy(lines->GetCell(i)->GetPointIds());
    const vtkIdType last = ids->GetNumberOfIds() - 1;
    double arc = 0.0;
    double largest = 0.0;
    double mass = 0.0;
    for (vtkIdType j = 0; j <= last; ++j)
    {
      const auto fold = [lines, &ids](vtkIdType k)
      { return Value(lines->GetPointData(), names::FoldAngle, ids->GetId(k)); };
      if (j > 0)
      {
        const double piece =
          (PointAt(lines, ids->GetId(j)) - PointAt(lines, ids->GetId(j - 1))).norm();
        arc += piece;
        mass += 0.5 * piece * (fold(j) + fold(j - 1));
      }
      EXPECT_NEAR(Value(lines->GetPointData(), names::ArcLength, ids->GetId(j)), arc, 1e-12);
      largest = std::max(largest, fold(j));
    }
    EXPECT_NEAR(Value(lines->GetCellData(), names::Length, i), arc, 1e-12);
    EXPECT_NEAR(Value(lines->GetCellData(), names::FoldAngle, i), largest, 1e-9);
    // The corners of the patch are farthest from each other.
    const double diameter = std::sqrt(8.0 + std::pow(2.0 * 0.7 * 0.5 * 2.0, 2));
    EXPECT_NEAR(Value(lines->GetCellData(), names::FoldMass, i) * diameter, mass, 0.1 * mass);
  }
  EXPECT_GE(Value(lines->GetCellData(), names::FoldMass, 0),
    Value(lines->GetCellData(), names::FoldMass, 1));
  vtkPolyData* mesh = salient->GetOutput(vtkSalientRidges::MESH);
  EXPECT_EQ(mesh->GetNumberOfPoints(), 81 * 81);
  EXPECT_TRUE(mesh->GetPointData()->HasArray(names::FourthOrder));
  EXPECT_TRUE(mesh->GetCellData()->HasArray(names::UmbilicPatch));
  for (vtkPolyData* output : { lines, mesh })
  {
    ASSERT_NE(output->GetFieldData()->GetArray(names::NoiseFloor), nullptr);
  }
}

// Smoothing ends creases before the corners. Each corner is the end of lines all the same, and
// together these cover the edges.
TEST(SalientRidges, CreasesMeetAtTheCornersOfACube)
{
  constexpr int cells = 24;
  const auto mesh = ToPolyData(CubeMesh(cells));
  const auto salient = Find(mesh, 25.0);
  vtkPolyData* lines = salient->GetOutput();
  std::vector<Vector3d> points;
  for (vtkIdType i = 0; i < lines->GetNumberOfLines(); ++i)
  {
    vtkIdList* ids = lines->GetCell(i)->GetPointIds();
    for (vtkIdType j = 0; j + 1 < ids->GetNumberOfIds(); ++j)
    {
      const Vector3d from = PointAt(lines, ids->GetId(j));
      const Vector3d to = PointAt(lines, ids->GetId(j + 1));
      for (int k = 0; k <= 8; ++k)
      {
        points.emplace_back(from + k / 8.0 * (to - from));
      }
    }
  }
  const auto distance = [&points](const Vector3d& x)
  {
    double least = 10.0;
    for (const Vector3d& point : points)
    {
      least = std::min(least, (point - x).norm());
    }
    return least;
  };
  const double edge = 2.0 / cells;
  double covered = 0.0;
  constexpr int steps = 48;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int side = 0; side < 4; ++side)
    {
      for (int i = 0; i <= steps; ++i)
      {
        Vector3d x;
        x[axis] = -1.0 + 2.0 * i / steps;
        x[(axis + 1) % 3] = side % 2 == 0 ? -1.0 : 1.0;
        x[(axis + 2) % 3] = side < 2 ? -1.0 : 1.0;
        covered += distance(x) <= edge ? 1.0 : 0.0;
      }
    }
  }
  EXPECT_GE(covered / (12.0 * (steps + 1)), 0.98);
  for (const Vector3d& point : points)
  {
    int faces = 0; // that it is near: an edge is in two
    for (int axis = 0; axis < 3; ++axis)
    {
      faces += std::abs(std::abs(point[axis]) - 1.0) <= edge ? 1 : 0;
    }
    EXPECT_GE(faces, 2);
  }
  for (int corner = 0; corner < 8; ++corner)
  {
    const Vector3d x(
      corner % 2 == 0 ? -1.0 : 1.0, corner / 2 % 2 == 0 ? -1.0 : 1.0, corner < 4 ? -1.0 : 1.0);
    EXPECT_LE(distance(x), edge) << corner;
  }
}

TEST(SalientRidges, FoldAngleIsTheOneKnob)
{
  const auto mesh = ToPolyData(RoofAndValley());
  EXPECT_EQ(Find(mesh, 45.0)->GetOutput()->GetNumberOfLines(), 2);
  EXPECT_EQ(Find(mesh, 90.0)->GetOutput()->GetNumberOfLines(), 0);
}

TEST(SalientRidges, NoiseAddsNoLines)
{
  // A tenth of an edge, 0.025, which is nearly the scale: the two lines may be torn, but no more.
  const auto salient = Find(ToPolyData(RoofAndValley(0.0025)));
  vtkPolyData* lines = salient->GetOutput();
  EXPECT_LE(lines->GetNumberOfLines(), 8);
  EXPECT_NEAR(TotalLength(lines), 4.0, 0.6);
  for (vtkIdType p = 0; p < lines->GetNumberOfPoints(); ++p)
  {
    EXPECT_NEAR(std::abs(PointAt(lines, p)[0]), 0.5, 0.1);
  }
  const double floor = Value(salient->GetOutput()->GetFieldData(), names::NoiseFloor, 0);
  EXPECT_GT(floor, 0.05);
  EXPECT_LT(floor, 2.0);
}

// The field with noise is smoothed with the weights of the other one, also where points are joined
// to cells, which depends on positions: what it differs by is noise alone.
TEST(SalientRidges, NoiseFloorOfFineMeshesIsThatOfNoise)
{
  const auto floorOf = [](double noise)
  {
    const Mesh mesh = AddNormalNoise(Icosphere(40), noise, 1);
    vtkNew<vtkSalientRidges> salient;
    salient->SetInputData(ToPolyData(mesh));
    salient->SetRelativeScale(0.15);
    salient->Update();
    return Value(salient->GetOutput()->GetFieldData(), names::NoiseFloor, 0);
  };
  EXPECT_LT(floorOf(0.0), 1e-4);
  const double floor = floorOf(2e-3);
  EXPECT_GT(floor, 1e-4);
  EXPECT_LT(floor, 0.02);
}

TEST(SalientRidges, SmoothSurfacesHaveNone)
{
  for (const double noise : { 0.0, 0.1 })
  {
    for (const Mesh& mesh :
      { Icosphere(20), TorusMesh(2.0, 0.7, 90, 45), CylinderPatch(1.0, 5.0, 4.0, 60, 50),
        GraphPatch([](double, double) { return 0.0; }, 1.0, 50, 0.2) })
    {
      const Mesh noisy = AddNormalNoise(mesh, noise * MeanEdgeLength(mesh), 3);
      EXPECT_EQ(Find(ToPolyData(noisy))->GetOutput()->GetNumberOfLines(), 0);
    }
  }
}

TEST(SalientRidges, SameBytesForAnyThreadsAndNumbering)
{
  const Mesh mesh = RoofAndValley(0.0025);
  vtkSMPTools::Initialize(1);
  const auto one = Find(ToPolyData(mesh));
  vtkSMPTools::Initialize(3);
  const auto three = Find(ToPolyData(mesh));
  vtkSMPTools::Initialize();
  for (const int port : { 0, 1 })
  {
    EXPECT_EQ(FirstDifference(one->GetOutput(port), three->GetOutput(port)), "");
  }
  const auto permuted = Find(ToPolyData(Permute(mesh, 4)));
  vtkPolyData* lines = one->GetOutput();
  vtkPolyData* others = permuted->GetOutput();
  ASSERT_EQ(others->GetNumberOfPoints(), lines->GetNumberOfPoints());
  for (vtkIdType p = 0; p < lines->GetNumberOfPoints(); ++p)
  {
    ASSERT_EQ(PointAt(others, p), PointAt(lines, p));
    ASSERT_EQ(Value(others->GetPointData(), names::FoldAngle, p),
      Value(lines->GetPointData(), names::FoldAngle, p));
  }
}

TEST(SalientRidges, RefusesPointsWithoutTriangles)
{
  vtkNew<vtkSalientRidges> salient;
  MessageRecorder messages(salient);
  salient->SetInputData(MakePolyData({ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } }, {}));
  salient->Update();
  ASSERT_EQ(messages.NumberOfErrors(), 1u);
  EXPECT_NE(messages.ErrorText().find("no triangles"), std::string::npos);
  EXPECT_TRUE(IsEmpty(salient->GetOutput()));
}

TEST(SalientRidges, NothingComesOfNothing)
{
  vtkNew<vtkPolyData> empty;
  vtkNew<vtkSalientRidges> salient;
  MessageRecorder messages(salient);
  salient->SetInputData(empty);
  salient->Update();
  EXPECT_EQ(messages.ErrorText(), "");
  EXPECT_TRUE(IsEmpty(salient->GetOutput()));
}

TEST(SalientRidges, OutputsTheUmbilicsOfTheSmoothedField)
{
  const auto salient = Find(EllipsoidData(20));
  vtkPolyData* umbilics =
    vtkPolyData::SafeDownCast(salient->GetOutputDataObject(vtkSalientRidges::UMBILICS));
  ASSERT_EQ(umbilics->GetNumberOfVerts(), 4);
  for (vtkIdType i = 0; i < 4; ++i)
  {
    EXPECT_EQ(Value(umbilics->GetPointData(), names::Index, i), 0.5);
  }
}

TEST(SalientRidges, WarnsIfTheSurfaceIsInsideOut)
{
  const Mesh mesh = ToMesh(EllipsoidData(10));
  for (const bool isTurned : { false, true })
  {
    vtkNew<vtkSalientRidges> salient;
    MessageRecorder messages(salient);
    salient->SetInputData(ToPolyData(isTurned ? Flip(mesh) : mesh));
    salient->Update();
    EXPECT_EQ(messages.WarningText().find("inside out") != std::string::npos, isTurned);
    EXPECT_EQ(messages.NumberOfErrors(), 0u);
  }
}
