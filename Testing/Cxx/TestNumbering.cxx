// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// The same umbilics and ridges, byte for byte, whatever the numbering of points and cells. No
// tolerance. A property test over random meshes: a few of them by default, and as many as the
// environment variable RIDGES_NUMBERING_MESHES says, from that on which RIDGES_NUMBERING_FIRST
// says.

#include "FilterTestTools.h"

#include "AnalyticSurface.h"
#include "MessageRecorder.h"
#include "RandomClosedMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRidgeExtraction.h"
#include "vtkRidgesArrayNames.h"
#include "vtkUmbilicDetection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <random>
#include <string>
#include <vector>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

std::string Exactly(double value)
{
  char text[40];
  std::snprintf(text, sizeof text, " %a", value + 0.0); // 0 and -0 are equal
  return text;
}

/// Umbilics in their order, without ids of triangles.
std::string Describe(vtkPolyData* umbilics)
{
  std::string text;
  for (vtkIdType i = 0; i < umbilics->GetNumberOfPoints(); ++i)
  {
    const Eigen::Vector3d x = PointAt(umbilics, i);
    text += "umbilic" + Exactly(x[0]) + Exactly(x[1]) + Exactly(x[2]);
    for (const char* name : { names::Index, names::RidgeCount, names::Pattern,
           names::ThirdOrderIndex, names::TouchesBorder })
    {
      text += Exactly(Value(umbilics->GetPointData(), name, i));
    }
    text += "\n";
  }
  return text;
}

/// Polylines in their order with all their values, the points of the mesh by their old names.
std::string Describe(vtkPolyData* ridges, const std::vector<std::int32_t>& nameOf)
{
  std::string text;
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < ridges->GetNumberOfLines(); ++line)
  {
    text += "line";
    for (const char* name : { names::RidgeType, names::Crest, names::Closed, names::RidgeId,
           names::Length, names::Strength, names::Sharpness })
    {
      text += Exactly(Value(ridges->GetCellData(), name, line));
    }
    text += "\n";
    ridges->GetLines()->GetCellAtId(line, ids);
    for (const vtkIdType id : *ids)
    {
      const auto name = [&nameOf, ridges, id](const char* array)
      {
        const auto p = static_cast<vtkIdType>(Value(ridges->GetPointData(), array, id));
        return p < 0 || nameOf.empty() ? static_cast<std::int32_t>(p) : nameOf[p];
      };
      const auto ends = std::minmax({ name(names::EdgePoint0), name(names::EdgePoint1) });
      const Eigen::Vector3d x = PointAt(ridges, id);
      text += std::to_string(ends.first) + " " + std::to_string(ends.second) + Exactly(x[0]) +
        Exactly(x[1]) + Exactly(x[2]);
      for (const char* array :
        { names::Curvature, names::SecondDerivative, names::TurningPoint, names::Umbilic })
      {
        text += Exactly(Value(ridges->GetPointData(), array, id));
      }
      text += "\n";
    }
  }
  return text;
}

/// The regions of the mesh that umbilics have, triangle by triangle, by the old names of points.
std::string DescribeRegions(vtkPolyData* mesh, const std::vector<std::int32_t>& nameOf)
{
  std::vector<std::string> lines;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    std::vector<std::int32_t> corners;
    for (const vtkIdType id : *ids)
    {
      corners.push_back(nameOf.empty() ? static_cast<std::int32_t>(id) : nameOf[id]);
    }
    std::sort(corners.begin(), corners.end());
    std::string line;
    for (const std::int32_t corner : corners)
    {
      line += std::to_string(corner) + " ";
    }
    for (const char* name : { names::UmbilicPatch, names::CancelledUmbilics, names::UmbilicZone })
    {
      line += Exactly(Value(mesh->GetCellData(), name, cell));
    }
    lines.push_back(line + "\n");
  }
  std::sort(lines.begin(), lines.end());
  return std::accumulate(lines.begin(), lines.end(), std::string());
}

/// Umbilics and their regions by the paper's method.
std::string DescribeMinima(vtkPolyData* fitted, const std::vector<std::int32_t>& nameOf)
{
  vtkNew<vtkUmbilicDetection> minima;
  minima->SetMethodToMinima();
  minima->SetInputData(fitted);
  minima->Update();
  return Describe(minima->GetOutput(1)) + DescribeRegions(minima->GetOutput(0), nameOf);
}

/// Ridges by the default properties: without those in zones, and without small loops.
std::string DescribeSignificant(vtkPolyData* marked, const std::vector<std::int32_t>& nameOf)
{
  vtkNew<vtkRidgeExtraction> ridges;
  const MessageRecorder recorder(ridges);
  ridges->SetInputData(marked);
  ridges->Update();
  return Describe(ridges->GetOutput(), nameOf);
}

/// The first line that is not the same in both, or nothing.
std::string FirstDifference(const std::string& a, const std::string& b)
{
  const auto differ = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  if (differ.first == a.end() && differ.second == b.end())
  {
    return "";
  }
  const auto lineAt = [](const std::string& text, std::size_t place)
  {
    const std::size_t begin = place == 0 ? 0 : text.rfind('\n', place - 1) + 1;
    return text.substr(begin, text.find('\n', place) - begin);
  };
  const auto place = static_cast<std::size_t>(differ.first - a.begin());
  return lineAt(a, place) + "\n" + lineAt(b, place);
}

void ExpectTheSameForAnyNumbering(const Mesh& mesh, int numberings)
{
  const Outputs expected = RunFilters(ToPolyData(mesh));
  for (int i = 1; i <= numberings; ++i)
  {
    std::vector<std::int32_t> oldNames;
    const Outputs actual =
      RunFilters(ToPolyData(Permute(mesh, static_cast<std::uint64_t>(i), &oldNames)));
    for (std::size_t p = 0; p < oldNames.size(); ++p)
    {
      for (const char* name : { names::MaximumCurvature, names::MinimumCurvature,
             names::MaximumDirection, names::ThirdOrder, names::FourthOrder, names::P1 })
      {
        const auto id = static_cast<vtkIdType>(p);
        vtkDataArray* array = actual.fitted->GetPointData()->GetArray(name);
        for (int c = 0; c < array->GetNumberOfComponents(); ++c)
        {
          ASSERT_EQ(array->GetComponent(id, c),
            Value(expected.fitted->GetPointData(), name, oldNames[p], c))
            << name << " " << c << " at " << oldNames[p];
        }
      }
    }
    ASSERT_EQ(FirstDifference(Describe(expected.umbilics), Describe(actual.umbilics)), "");
    ASSERT_EQ(
      FirstDifference(Describe(expected.ridges, {}), Describe(actual.ridges, oldNames)), "");
    ASSERT_EQ(FirstDifference(
                DescribeRegions(expected.marked, {}), DescribeRegions(actual.marked, oldNames)),
      "");
    ASSERT_EQ(FirstDifference(DescribeSignificant(expected.marked, {}),
                DescribeSignificant(actual.marked, oldNames)),
      "");
    ASSERT_EQ(
      FirstDifference(DescribeMinima(expected.fitted, {}), DescribeMinima(actual.fitted, oldNames)),
      "");
  }
}

Mesh Rounded(Mesh mesh, double grain)
{
  for (double& x : mesh.points)
  {
    x = grain * std::round(x / grain);
  }
  return mesh;
}

/// Fins on some edges, triangles that run the other way beside others, and one that joins far
/// points. None twice in the same way: nothing but its number would distinguish it from the other.
Mesh WithNonManifoldEdges(Mesh mesh, std::mt19937_64& generator)
{
  const std::size_t count = mesh.TriangleCount();
  const auto any = [&generator, count]
  { return static_cast<std::size_t>(Uniform(generator) * count); };
  for (int i = 0; i < 3; ++i)
  {
    const std::size_t t = 3 * any();
    const auto tip = static_cast<std::int32_t>(mesh.PointCount());
    mesh.AddPoint(
      1.4 * mesh.Point(mesh.triangles[t]) + Eigen::Vector3d(0.1, 0.1 * Uniform(generator), 0.3));
    mesh.AddTriangle(mesh.triangles[t], mesh.triangles[t + 1], tip);
    const std::size_t r = 3 * any();
    mesh.AddTriangle(mesh.triangles[r], mesh.triangles[r + 2], mesh.triangles[r + 1]);
  }
  mesh.AddTriangle(
    mesh.triangles[3 * any()], mesh.triangles[3 * any() + 1], mesh.triangles[3 * any() + 2]);
  return mesh;
}

/// Triangles with a corner twice or without area, and points that nothing uses.
Mesh WithDegenerateTriangles(Mesh mesh, std::mt19937_64& generator)
{
  for (int i = 0; i < 6; ++i)
  {
    const std::size_t t = 3 * static_cast<std::size_t>(Uniform(generator) * mesh.TriangleCount());
    const std::int32_t p = mesh.triangles[t];
    const std::int32_t q = mesh.triangles[t + 1];
    const std::int32_t r = mesh.triangles[t + 2];
    const auto middle = static_cast<std::int32_t>(mesh.PointCount());
    mesh.AddPoint(0.5 * (mesh.Point(p) + mesh.Point(q)));
    // The neighbour across (p, q) keeps that edge, so that a triangle without area closes the gap.
    mesh.triangles[t + 1] = middle;
    mesh.AddTriangle(middle, q, r);
    mesh.AddTriangle(p, q, middle);
    mesh.AddTriangle(p, p, r);
    mesh.AddPoint(mesh.Point(p) + Eigen::Vector3d(0.01 * i, 0.0, 0.02));
  }
  return mesh;
}

Mesh RandomMesh(std::uint64_t seed)
{
  std::mt19937_64 generator(seed);
  const double a = 0.5 + Uniform(generator);
  const double b = 0.5 + Uniform(generator);
  const auto height = [a, b](double x, double y)
  { return a * x * x - b * y * y + 0.3 * x * x * x + std::sin(3.0 * x * y); };
  const double grain = 0.01 + 0.15 * Uniform(generator);
  switch (seed % 10)
  {
    case 0:
      return AddNormalNoise(EllipsoidMesh(6, 1.0, a, b), 0.002, seed);
    case 1:
      return GraphPatch(height, 1.0, 12, 0.2, seed);
    case 2:
      return AddNormalNoise(GraphPatch(height, 1.0, 12, 0.2, seed), 0.002, seed);
    case 3:
      return EllipsoidMesh(6, 1.0, a, b);
    case 4: // a regular grid: many ties
      return GraphPatch([a, seed](double x, double y)
        { return seed % 20 == 4 ? 0.0 : a * (x * x + y * y); },
        1.0, 12);
    case 5:
      return Rounded(EllipsoidMesh(7, 1.0, a, b, seed % 20 == 5), grain);
    case 6:
      return MakeRandomClosedMesh(seed).mesh;
    case 7:
      return WithNonManifoldEdges(
        AddNormalNoise(EllipsoidMesh(6, 1.0, a, b), 0.002, seed), generator);
    case 8:
      return WithDegenerateTriangles(
        seed % 20 == 8 ? EllipsoidMesh(6, 1.0, a, b) : GraphPatch(height, 1.0, 12, 0.2, seed),
        generator);
    default:
      return AddNormalNoise(
        TorusMesh(1.0, 0.3 + 0.2 * a, 24, 12), seed % 20 == 9 ? 0.0 : 0.002, seed);
  }
}

} // namespace

TEST(Numbering, DoesNotChangeRidgesOfRandomMeshes)
{
  const auto setting = [](const char* name, int otherwise)
  {
    const char* value = std::getenv(name);
    return value ? std::atoi(value) : otherwise;
  };
  const int first = setting("RIDGES_NUMBERING_FIRST", 0);
  const int meshes = setting("RIDGES_NUMBERING_MESHES", 20);
  for (int i = first; i < first + meshes; ++i)
  {
    SCOPED_TRACE(i);
    ExpectTheSameForAnyNumbering(RandomMesh(static_cast<std::uint64_t>(i)), 3);
  }
}

// Rounded coordinates: fences of loops that pass through patches have several parts.
TEST(Numbering, DoesNotChangeRidgesOfAMeshWithRoundedCoordinates)
{
  ExpectTheSameForAnyNumbering(Rounded(EllipsoidMesh(8, 1.0, 0.8, 0.6, false), 0.05), 3);
}
