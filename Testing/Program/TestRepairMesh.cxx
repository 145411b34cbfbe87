// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFiles.h"
#include "Repair/CoordinateGrain.h"
#include "Repair/MeshEdges.h"
#include "Repair/RepairMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using program::Face;
using program::Joining;
using program::PolygonMesh;
using program::RepairOptions;
using program::RepairReport;

namespace
{

constexpr double Pi = 3.14159265358979323846;

/// A ring of quadrangles, with the twist of a Moebius strip or without.
PolygonMesh Band(int length, bool isTwisted)
{
  PolygonMesh mesh;
  for (int i = 0; i < length; ++i)
  {
    const double angle = 2.0 * Pi * i / length;
    for (const double side : { -0.2, 0.2 })
    {
      const double tilt = isTwisted ? 0.5 * angle : 0.0;
      const double radius = 1.0 + side * std::cos(tilt);
      mesh.points.push_back(
        { radius * std::cos(angle), radius * std::sin(angle), side * std::sin(tilt) });
    }
  }
  for (int i = 0; i < length; ++i)
  {
    const bool isSeam = i + 1 == length;
    vtkIdType low = isSeam ? 0 : 2 * (i + 1);
    vtkIdType high = low + 1;
    if (isSeam && isTwisted)
    {
      std::swap(low, high);
    }
    mesh.corners.insert(mesh.corners.end(), { 2 * i, low, high, 2 * i + 1 });
    mesh.EndFace();
  }
  return mesh;
}

void Turn(PolygonMesh& mesh, std::size_t f)
{
  const std::size_t begin = mesh.faceEnds[f] - mesh.FaceAt(f).size();
  std::reverse(mesh.corners.begin() + static_cast<std::ptrdiff_t>(begin),
    mesh.corners.begin() + static_cast<std::ptrdiff_t>(mesh.faceEnds[f]));
}

std::size_t CountOddEdges(const PolygonMesh& mesh)
{
  std::size_t odd = 0;
  program::ForEachEdge(program::SortedSides(mesh),
    [&odd](auto first, auto last)
    { odd += last - first == 2 && first->isForward == (first + 1)->isForward ? 1 : 0; });
  return odd;
}

double VolumeOf(const PolygonMesh& mesh)
{
  double volume = 0.0;
  for (std::size_t f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    const Face face = mesh.FaceAt(f);
    const PolygonMesh::Point& a = mesh.points[static_cast<std::size_t>(face[0])];
    const PolygonMesh::Point& b = mesh.points[static_cast<std::size_t>(face[1])];
    const PolygonMesh::Point& c = mesh.points[static_cast<std::size_t>(face[2])];
    volume += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
      a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return volume / 6.0;
}

RepairReport Join(PolygonMesh& mesh, Joining joining)
{
  RepairOptions options;
  options.joining = joining;
  return program::RepairMesh(mesh, options);
}

TEST(JoinPoints, MakesOneSurfaceOfTrianglesThatStandAlone)
{
  const PolygonMesh whole = Ellipsoid(4);
  for (const Joining joining : { Joining::Borders, Joining::All })
  {
    PolygonMesh mesh = Soup(whole);
    EXPECT_EQ(Join(mesh, joining).joinedPoints, 3 * whole.NumberOfFaces() - whole.points.size());
    EXPECT_EQ(mesh.points.size(), whole.points.size());
    EXPECT_EQ(mesh.NumberOfFaces(), whole.NumberOfFaces());
    EXPECT_EQ(program::CountEdges(program::SortedSides(mesh)).border, 0U);
  }
  PolygonMesh mesh = Soup(whole);
  EXPECT_EQ(Join(mesh, Joining::None).joinedPoints, 0U);
  EXPECT_EQ(mesh.points.size(), 3 * whole.NumberOfFaces());
}

TEST(JoinPoints, ClosesSeamsAndCollapsesFacesAtPoles)
{
  // Longitude and latitude, with points of their own along the seam and at the poles.
  constexpr int rows = 6;
  constexpr int columns = 8;
  PolygonMesh mesh;
  for (int i = 0; i <= rows; ++i)
  {
    for (int j = 0; j <= columns; ++j)
    {
      const double polar = Pi * i / rows;
      const double azimuth = 2.0 * Pi * (j % columns) / columns;
      const double radius = i % rows == 0 ? 0.0 : std::sin(polar);
      mesh.points.push_back(
        { radius * std::cos(azimuth), radius * std::sin(azimuth), std::cos(polar) });
    }
  }
  for (int i = 0; i < rows; ++i)
  {
    for (int j = 0; j < columns; ++j)
    {
      const vtkIdType a = i * (columns + 1) + j;
      const vtkIdType b = a + columns + 1;
      mesh.AddTriangle(a, b, b + 1);
      mesh.AddTriangle(a, b + 1, a + 1);
    }
  }
  const RepairReport report = Join(mesh, Joining::Borders);
  EXPECT_EQ(mesh.points.size(), (rows - 1) * columns + 2U);
  EXPECT_EQ(mesh.NumberOfFaces(), 2U * columns * (rows - 1));
  EXPECT_EQ(program::CountEdges(program::SortedSides(mesh)).border, 0U);
  EXPECT_EQ(report.removed.collapsed, 0U); // They were no error of the file.
}

TEST(JoinPoints, KeepsClosedPartsApartThatTouchInAPoint)
{
  PolygonMesh mesh = Ellipsoid(2);
  const std::size_t count = mesh.points.size();
  const PolygonMesh other = mesh;
  const double shift = 2.0 * mesh.points[0][0];
  for (PolygonMesh::Point point : other.points)
  {
    point[0] = shift - point[0];
    mesh.points.push_back(point);
  }
  for (std::size_t f = 0; f < other.NumberOfFaces(); ++f)
  {
    const Face face = other.FaceAt(f);
    const auto shifted = static_cast<vtkIdType>(count);
    mesh.AddTriangle(face[0] + shifted, face[2] + shifted, face[1] + shifted);
  }
  ASSERT_EQ(mesh.points[0][0], mesh.points[count][0]);
  PolygonMesh all = mesh;
  EXPECT_EQ(Join(mesh, Joining::Borders).joinedPoints, 0U);
  EXPECT_GT(Join(all, Joining::All).joinedPoints, 0U);
}

TEST(JoinPoints, KeepsSheetsApartThatLieOnEachOther)
{
  const PolygonMesh band = Band(30, false);
  PolygonMesh mesh = Soup(band);
  PolygonMesh back = Soup(band);
  const auto shift = static_cast<vtkIdType>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), back.points.begin(), back.points.end());
  for (std::size_t f = 0; f < back.NumberOfFaces(); ++f)
  {
    Turn(back, f);
    for (const vtkIdType corner : back.FaceAt(f))
    {
      mesh.corners.push_back(corner + shift);
    }
    mesh.EndFace();
  }
  // The ribs of the band get four faces each, and its two rims, as many edges each, two.
  EXPECT_EQ(Join(mesh, Joining::Borders).joinedPoints, 180U);
  PolygonMesh tight = Soup(Ellipsoid(2));
  const PolygonMesh same = tight;
  for (std::size_t i = 0; i < same.points.size(); ++i)
  {
    tight.points.push_back(same.points[i]);
    tight.corners.push_back(static_cast<vtkIdType>(same.points.size() + i));
    if (i % 3 == 2)
    {
      tight.EndFace();
    }
  }
  EXPECT_EQ(Join(tight, Joining::Borders).joinedPoints, 0U);
}

TEST(RemoveInvalidFaces, NamesWhatItRemoves)
{
  PolygonMesh mesh;
  const double none = std::numeric_limits<double>::quiet_NaN();
  mesh.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 }, { 0, none, 0 } };
  mesh.AddTriangle(0, 1, 2);
  mesh.AddTriangle(0, 1, 1);
  mesh.AddTriangle(0, 1, 4);
  mesh.corners.insert(mesh.corners.end(), { 1, 3, 3, 2 });
  mesh.EndFace();
  const program::InvalidFaces removed = program::RemoveInvalidFaces(mesh);
  EXPECT_EQ(removed.collapsed, 1U);
  EXPECT_EQ(removed.notFinite, 1U);
  ASSERT_EQ(mesh.NumberOfFaces(), 2U);
  EXPECT_EQ(mesh.FaceAt(1).size(), 3U); // without the repeated corner
}

TEST(OrientFaces, OrientsClosedPartsOutward)
{
  const PolygonMesh expected = Ellipsoid(4);
  for (const std::size_t step : { 2U, 3U, 1U }) // 1: all of them
  {
    PolygonMesh mesh = expected;
    for (std::size_t f = 0; f < mesh.NumberOfFaces(); f += step)
    {
      Turn(mesh, f);
    }
    // Far from the origin too.
    for (PolygonMesh::Point& point : mesh.points)
    {
      point[0] += 100.0;
    }
    const program::Orientation orientation = program::OrientFaces(mesh);
    EXPECT_EQ(orientation.turnedFaces, (mesh.NumberOfFaces() + step - 1) / step);
    EXPECT_EQ(orientation.oddEdges, 0U);
    EXPECT_EQ(CountOddEdges(mesh), 0U);
    EXPECT_NEAR(VolumeOf(mesh), VolumeOf(expected), 1e-9); // of coordinates up to 100
  }
}

TEST(OrientFaces, KeepsTheSenseOfMostOfAnOpenPart)
{
  const PolygonMesh band = Band(30, false);
  PolygonMesh mesh = band;
  for (std::size_t f = 0; f < 10; ++f)
  {
    Turn(mesh, f);
  }
  EXPECT_EQ(program::OrientFaces(mesh).turnedFaces, 10U);
  EXPECT_EQ(CountOddEdges(mesh), 0U);
}

TEST(OrientFaces, ReportsAOneSidedSurface)
{
  PolygonMesh mesh = Band(30, true);
  EXPECT_EQ(program::OrientFaces(mesh).oddEdges, 1U);
  EXPECT_EQ(CountOddEdges(mesh), 1U);
}

TEST(OrientFaces, LeavesWhatIsOriented)
{
  PolygonMesh mesh = Ellipsoid(4);
  const std::vector<vtkIdType> corners = mesh.corners;
  EXPECT_EQ(program::OrientFaces(mesh).turnedFaces, 0U);
  EXPECT_EQ(mesh.corners, corners);
}

TEST(RepairMesh, JoinsBeforeItOrients)
{
  PolygonMesh mesh = Soup(Ellipsoid(4));
  for (std::size_t f = 0; f < mesh.NumberOfFaces(); f += 2)
  {
    Turn(mesh, f);
  }
  RepairOptions options;
  options.orient = true;
  EXPECT_TRUE(program::RepairMesh(mesh, options).HasChanged());
  EXPECT_EQ(CountOddEdges(mesh), 0U);
  EXPECT_GT(VolumeOf(mesh), 0.0);
}

TEST(CoordinateGrain, WarnsWhereSinglePrecisionIsCoarseForTheEdges)
{
  PolygonMesh mesh = Ellipsoid(10); // Edges of about 0.1, at coordinates of up to 1.4.
  EXPECT_EQ(program::WarnOfGrain(mesh).text, "");
  mesh.isSinglePrecision = true;
  EXPECT_EQ(program::WarnOfGrain(mesh).text, "");
  for (PolygonMesh::Point& point : mesh.points)
  {
    point[0] += 758318.0;
  }
  // The spacing of 32-bit numbers from 2^19 to 2^20 is 2^-4.
  EXPECT_NE(program::WarnOfGrain(mesh).text.find("0.062"), std::string::npos);
  EXPECT_NE(program::WarnOfGrain(mesh).advice.find("relative to a point"), std::string::npos);
}

TEST(CoordinateGrain, ReportsThatCoordinatesNeedDoublePrecisionFarFromTheOrigin)
{
  PolygonMesh mesh = Ellipsoid(10);
  for (PolygonMesh::Point& point : mesh.points)
  {
    point[0] += 100.0; // Steps of 8e-6, with a size in edges of 18: well below the limit.
  }
  EXPECT_EQ(program::WarnOfGrain(mesh).text, "");
  for (PolygonMesh::Point& point : mesh.points)
  {
    point[0] += 758218.0;
  }
  EXPECT_NE(program::WarnOfGrain(mesh).text.find("need double precision"), std::string::npos);
  EXPECT_NE(program::WarnOfGrain(mesh).text.find("0.062"), std::string::npos);
}

TEST(CoordinateGrain, WarnsOfFewDecimals)
{
  for (const auto& [decimals, isCoarse] :
    { std::pair(2, true), std::pair(4, true), std::pair(7, false) })
  {
    PolygonMesh mesh = Ellipsoid(10);
    const double step = std::pow(10.0, -decimals);
    for (PolygonMesh::Point& point : mesh.points)
    {
      for (double& x : point)
      {
        x = step * std::round(x / step);
      }
    }
    EXPECT_EQ(program::WarnOfGrain(mesh).text.find("multiples of") != std::string::npos, isCoarse)
      << decimals;
  }
}

TEST(CoordinateGrain, WarnsOfFineMeshesNearTheOrigin)
{
  // Steps of 6e-8 at edges of 1e-3, a five-hundredth of the size.
  PolygonMesh mesh;
  for (int i = 0; i < 1000; ++i)
  {
    mesh.points.push_back({ 1e-3 * i, 0.0, 0.0 });
    mesh.points.push_back({ 1e-3 * i, 1e-3, 0.0 });
  }
  for (vtkIdType i = 0; i + 3 < 2000; i += 2)
  {
    mesh.AddTriangle(i, i + 2, i + 1);
    mesh.AddTriangle(i + 1, i + 2, i + 3);
  }
  mesh.isSinglePrecision = true;
  EXPECT_NE(program::WarnOfGrain(mesh).text, "");
  EXPECT_EQ(program::WarnOfGrain(mesh).advice.find("relative"), std::string::npos);
}

} // namespace
