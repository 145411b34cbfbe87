// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// The same umbilics and ridges, byte for byte, whatever the numbering of points and cells. No
// tolerance. A property test over random meshes: a few of them by default, and as many as the
// environment variable RIDGES_NUMBERING_MESHES says.

#include "FilterTestTools.h"

#include "AnalyticSurface.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRidgesArrayNames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

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

Mesh RandomMesh(std::uint64_t seed)
{
  std::mt19937_64 generator(seed);
  const double a = 0.5 + Uniform(generator);
  const double b = 0.5 + Uniform(generator);
  const auto height = [a, b](double x, double y)
  { return a * x * x - b * y * y + 0.3 * x * x * x + std::sin(3.0 * x * y); };
  switch (seed % 4)
  {
    case 0:
      return AddNormalNoise(EllipsoidMesh(6, 1.0, a, b), 0.002, seed);
    case 1:
      return GraphPatch(height, 1.0, 12, 0.2, seed);
    case 2:
      return AddNormalNoise(GraphPatch(height, 1.0, 12, 0.2, seed), 0.002, seed);
    default:
      return EllipsoidMesh(6, 1.0, a, b);
  }
}

} // namespace

TEST(Numbering, DoesNotChangeRidgesOfRandomMeshes)
{
  const char* count = std::getenv("RIDGES_NUMBERING_MESHES");
  const int meshes = count ? std::atoi(count) : 8;
  for (int i = 0; i < meshes; ++i)
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
