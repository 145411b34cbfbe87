// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// What is drawn inside patches, on random fields and random patches: each crossing of the contour
// is used once, nothing ends elsewhere, nothing crosses. Counted and compared: no tolerance.

#include "Fixtures/TriangleSets.h"

#include "Monge/AcuteRule.h"
#include "Ridges/Patch/PatchRidges.h"
#include "Umbilics/UmbilicForm.h"
#include "Umbilics/UmbilicPatch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace
{

using namespace ridges;
using namespace ridges::testing;

struct Drawing
{
  std::vector<RidgeSegment> segments;
  std::vector<RidgePath> paths;
  std::vector<std::uint8_t> isReplaced;
};

Drawing Draw(const RidgeCrossings& crossings, const RidgePatch& patch)
{
  Drawing drawing;
  drawing.isReplaced.assign(crossings.Mesh().NumberOfTriangles(), 0);
  PatchRidges(crossings).Draw(patch, drawing.segments, drawing.paths, drawing.isReplaced);
  return drawing;
}

bool IsSingular(const RidgeCrossings& crossings, Id triangle)
{
  int crossed = 0;
  for (int side = 0; side < 3; ++side)
  {
    crossed += crossings.IsCrossed(crossings.Mesh().EdgeOf(triangle, side)) ? 1 : 0;
  }
  return crossed % 2 != 0;
}

std::multiset<Id> ContourCrossings(const RidgeCrossings& crossings, const PatchContour& contour)
{
  std::multiset<Id> crossed;
  for (const PatchContour::Side& side : contour.Sides())
  {
    if (crossings.IsCrossed(side.edge))
    {
      crossed.insert(side.edge);
    }
  }
  return crossed;
}

// A piece inside one triangle: from one place on its border, 0 to 3 around it, to another, or to a
// point inside.
struct Piece
{
  double from;
  double to;
};
constexpr double Inside = -1.0;

double PlaceOnBorder(const TriangleMesh& mesh, Id triangle, Id edge, double parameter)
{
  int side = 0;
  while (mesh.EdgeOf(triangle, side) != edge)
  {
    ++side;
  }
  const bool forward = mesh.Corners(triangle)[side] == mesh.EdgeAt(edge).v0;
  return side + (forward ? parameter : 1.0 - parameter);
}

// Whether the ends alternate around the triangle.
bool Cross(const Piece& a, const Piece& b)
{
  const auto isBetween = [&](double x)
  { return x > std::min(a.from, a.to) && x < std::max(a.from, a.to); };
  const bool distinct = a.from != b.from && a.from != b.to && a.to != b.from && a.to != b.to;
  return distinct && isBetween(b.from) != isBetween(b.to);
}

void CheckNoPiecesCross(const std::map<Id, std::vector<Piece>>& pieces)
{
  for (const auto& [triangle, inside] : pieces)
  {
    std::vector<Piece> through;
    std::vector<double> toPoint;
    for (const Piece& piece : inside)
    {
      if (piece.to == Inside)
      {
        toPoint.push_back(piece.from);
      }
      else
      {
        through.push_back(piece);
      }
    }
    for (std::size_t i = 0; i < through.size(); ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        ASSERT_FALSE(Cross(through[i], through[j]))
          << "in triangle " << triangle << ": from " << through[i].from << " to " << through[i].to
          << ", and from " << through[j].from << " to " << through[j].to;
      }
      // All that end at the point are on one side of it.
      for (const double end : toPoint)
      {
        ASSERT_FALSE(Cross(through[i], { end, toPoint.front() }))
          << "in triangle " << triangle << ": from " << through[i].from << " to " << through[i].to
          << ", and from " << end << " and " << toPoint.front() << " to the umbilic";
      }
    }
  }
}

// Of the triangles at an edge that which hangs on the patch by this edge alone, if it is one.
std::vector<Id> EarsAmong(
  const TriangleMesh& mesh, const PatchContour& contour, const std::vector<Id>& triangles, Id edge)
{
  std::vector<Id> ears;
  for (const Id t : triangles)
  {
    bool isEar = true;
    for (int side = 0; side < 3; ++side)
    {
      const Id e = mesh.EdgeOf(t, side);
      isEar = isEar && (e == edge || contour.Across(t, e) < 0);
    }
    if (isEar)
    {
      ears.push_back(t);
    }
  }
  return ears.size() == 1 ? ears : std::vector<Id>();
}

void CheckDrawing(const RidgeCrossings& crossings, const RidgePatch& patch, const Drawing& drawing)
{
  const TriangleMesh& mesh = crossings.Mesh();
  const PatchContour contour(mesh, patch.triangles);
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    ASSERT_EQ(drawing.isReplaced[t] != 0, contour.Contains(t));
  }
  std::multiset<Id> used;
  std::map<Id, std::vector<Piece>> pieces;
  std::size_t atUmbilic = 0;
  for (const RidgeSegment& segment : drawing.segments)
  {
    ASSERT_GE(segment.path, 0);
    const RidgePath& path = drawing.paths[segment.path];
    ASSERT_EQ(path.edges.size(), path.points.size());
    used.insert(segment.edge0);
    const bool ends = segment.edge1 == RidgeSegment::ToUmbilic;
    if (ends)
    {
      ++atUmbilic;
      ASSERT_EQ(segment.triangle, patch.umbilic);
      ASSERT_FALSE(IsElliptic(segment.type));
    }
    else
    {
      used.insert(segment.edge1);
    }
    // Goes from edge to edge across glued triangles; where it starts is the one beside edge0 that
    // has its first edge as well.
    std::vector<std::pair<Id, double>> stops = { { segment.edge0,
      crossings.PointOn(segment.edge0).parameter } };
    for (std::size_t i = 0; i < path.edges.size(); ++i)
    {
      ASSERT_GT(path.points[i].parameter, 0.0);
      ASSERT_LT(path.points[i].parameter, 1.0);
      stops.emplace_back(path.edges[i], path.points[i].parameter);
    }
    if (!ends)
    {
      stops.emplace_back(segment.edge1, crossings.PointOn(segment.edge1).parameter);
    }
    for (std::size_t i = 0; i + 1 < stops.size(); ++i)
    {
      std::vector<Id> common;
      for (const Id t : { mesh.EdgeAt(stops[i].first).t0, mesh.EdgeAt(stops[i].first).t1 })
      {
        const bool has = t >= 0 && contour.Contains(t) &&
          (mesh.EdgeOf(t, 0) == stops[i + 1].first || mesh.EdgeOf(t, 1) == stops[i + 1].first ||
            mesh.EdgeOf(t, 2) == stops[i + 1].first);
        if (has)
        {
          common.push_back(t);
        }
      }
      // Along the contour a piece may follow the one inner edge of a triangle.
      const bool follows = stops[i].first == stops[i + 1].first;
      ASSERT_EQ(common.size(), follows ? 2u : 1u) << "a piece leaves the triangles";
      if (follows)
      {
        common = EarsAmong(mesh, contour, common, stops[i].first);
      }
      for (const Id t : common)
      {
        pieces[t].push_back({ PlaceOnBorder(mesh, t, stops[i].first, stops[i].second),
          PlaceOnBorder(mesh, t, stops[i + 1].first, stops[i + 1].second) });
      }
    }
    if (ends)
    {
      pieces[patch.umbilic].push_back(
        { PlaceOnBorder(mesh, patch.umbilic, stops.back().first, stops.back().second), Inside });
    }
  }
  // Where a cut edge is joined to itself nothing is left of the ridge.
  std::multiset<Id> missing;
  const std::multiset<Id> expected = ContourCrossings(crossings, contour);
  ASSERT_TRUE(std::includes(expected.begin(), expected.end(), used.begin(), used.end()));
  std::set_difference(expected.begin(), expected.end(), used.begin(), used.end(),
    std::inserter(missing, missing.end()));
  for (const Id edge : missing)
  {
    ASSERT_EQ(expected.count(edge), 2u);
    ASSERT_EQ(used.count(edge), 0u);
    ASSERT_TRUE(contour.Contains(mesh.EdgeAt(edge).t0) && contour.Contains(mesh.EdgeAt(edge).t1));
  }
  const std::size_t wanted = patch.umbilic < 0 ? 0 : static_cast<std::size_t>(patch.ridgeCount);
  const std::size_t n = expected.size();
  ASSERT_EQ(atUmbilic, n <= wanted ? n : wanted - (n - wanted) % 2);
  ASSERT_NO_FATAL_FAILURE(CheckNoPiecesCross(pieces));
}

// Patches that are left to marching do without.
void CheckLeftToMarching(
  const RidgeCrossings& crossings, const RidgePatch& patch, const Drawing& drawing)
{
  EXPECT_TRUE(drawing.segments.empty());
  EXPECT_TRUE(drawing.paths.empty());
  EXPECT_EQ(std::count(drawing.isReplaced.begin(), drawing.isReplaced.end(), 1), 0);
  const PatchContour contour(crossings.Mesh(), patch.triangles);
  std::set<Id> singular;
  for (const Id t : patch.triangles)
  {
    if (IsSingular(crossings, t))
    {
      singular.insert(t);
    }
  }
  const bool odd = ContourCrossings(crossings, contour).size() % 2 != 0;
  const bool onlyUmbilic = singular == std::set<Id>{ patch.umbilic };
  EXPECT_TRUE(singular.empty() || onlyUmbilic || (odd && patch.umbilic < 0));
}

struct Counts
{
  int drawn = 0;
  int left = 0;
};

void CheckPatch(const RidgeCrossings& crossings, const RidgePatch& patch, Counts& counts)
{
  const Drawing drawing = Draw(crossings, patch);
  const bool drawn = std::count(drawing.isReplaced.begin(), drawing.isReplaced.end(), 1) > 0;
  ++(drawn ? counts.drawn : counts.left);
  if (drawn)
  {
    CheckDrawing(crossings, patch, drawing);
  }
  else
  {
    CheckLeftToMarching(crossings, patch, drawing);
  }
}

// Disks around umbilics where so many ridges meet.
void CheckDisks(int ridgeCount, Counts& counts)
{
  for (const Mesh& input : { Icosphere(10), AddNormalNoise(Icosphere(10), 0.03, 1),
         CylinderPatch(1.0, 2.0, 1.0, 25, 19), FlipEdges(Icosphere(10), 2, 2) })
  {
    const MeshedSurface surface(input);
    const TriangleMesh& mesh = surface.Triangles();
    UmbilicPatch grow(mesh);
    for (std::uint64_t seed = 1; seed <= 2; ++seed)
    {
      const FieldArrays field = RandomField(mesh, seed, 10);
      for (const Color color : { Color::Blue, Color::Red })
      {
        RidgeCrossings crossings(mesh, field.View(), color, CrossingRule::Form);
        crossings.Build();
        for (Id t = 0; t < mesh.NumberOfTriangles(); t += 37)
        {
          for (const double size : { 1.0, 2.0, 4.0 })
          {
            RidgePatch patch;
            const Span<Id> grown = grow.Grow(t, size);
            patch.triangles.assign(grown.begin(), grown.end());
            patch.umbilic = t;
            patch.ridgeCount = ridgeCount;
            patch.position = UmbilicInTriangle(mesh, field.View(), t);
            CheckPatch(crossings, patch, counts);
            ASSERT_FALSE(::testing::Test::HasFailure())
              << "triangle " << t << " size " << size << " seed " << seed;
          }
        }
      }
    }
  }
}

// Connected triangles without an umbilic or with one where so many ridges meet.
void CheckRegions(int ridgeCount, Counts& counts)
{
  for (const Mesh& input : { Icosphere(6), TorusMesh(2.0, 0.7, 12, 6),
         CylinderPatch(1.0, 2.0, 1.0, 13, 9), FlipEdges(Icosphere(6), 1, 3) })
  {
    const MeshedSurface surface(input);
    const TriangleMesh& mesh = surface.Triangles();
    std::mt19937_64 generator(9);
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
    {
      const FieldArrays field = RandomField(mesh, seed, 10);
      for (const Color color : { Color::Blue, Color::Red })
      {
        RidgeCrossings crossings(mesh, field.View(), color, CrossingRule::Form);
        crossings.Build();
        for (const std::size_t size : { 2, 5, 12, 30, 70, 1000 })
        {
          for (int trial = 0; trial < 10; ++trial)
          {
            RidgePatch patch;
            patch.triangles = RandomRegion(mesh, generator, size);
            if (ridgeCount > 0)
            {
              patch.umbilic = patch.triangles.front();
              patch.ridgeCount = ridgeCount;
              patch.position = UmbilicInTriangle(mesh, field.View(), patch.umbilic);
            }
            CheckPatch(crossings, patch, counts);
            ASSERT_FALSE(::testing::Test::HasFailure())
              << "size " << size << " seed " << seed << " trial " << trial;
          }
        }
      }
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
TEST(PatchRidges, DrawsDisksAroundUmbilicsOfOneRidge)
{
  Counts counts;
  CheckDisks(1, counts);
  EXPECT_GT(counts.drawn, 500);
}

//------------------------------------------------------------------------------
TEST(PatchRidges, DrawsDisksAroundUmbilicsOfThreeRidges)
{
  Counts counts;
  CheckDisks(3, counts);
  EXPECT_GT(counts.drawn, 500);
}

//------------------------------------------------------------------------------
TEST(PatchRidges, DrawsRegionsOfAnyShapeWithoutUmbilics)
{
  Counts counts;
  CheckRegions(0, counts);
  EXPECT_GT(counts.drawn, 300);
  EXPECT_GT(counts.left, 50);
}

//------------------------------------------------------------------------------
TEST(PatchRidges, DrawsRegionsOfAnyShapeAroundUmbilicsOfOneRidge)
{
  Counts counts;
  CheckRegions(1, counts);
  EXPECT_GT(counts.drawn, 300);
}

//------------------------------------------------------------------------------
TEST(PatchRidges, DrawsRegionsOfAnyShapeAroundUmbilicsOfThreeRidges)
{
  Counts counts;
  CheckRegions(3, counts);
  EXPECT_GT(counts.drawn, 300);
}

//------------------------------------------------------------------------------
TEST(PatchRidges, LeavesAloneWhatMarchingDoesWell)
{
  const MeshedSurface surface(EllipsoidMesh(24, 1.4, 1.0, 0.6));
  const TriangleMesh& mesh = surface.Triangles();
  const FieldArrays field = ExactField(mesh, MakeEllipsoid(1.4, 1.0, 0.6));
  UmbilicPatch grow(mesh);
  int umbilics = 0;
  for (const Color color : { Color::Blue, Color::Red })
  {
    RidgeCrossings crossings(mesh, field.View(), color, CrossingRule::Form);
    crossings.Build();
    for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
    {
      if (!IsRegular(mesh, field.View(), t))
      {
        ++umbilics;
        RidgePatch patch;
        patch.triangles = { t };
        patch.umbilic = t;
        patch.ridgeCount = 1;
        patch.position = UmbilicInTriangle(mesh, field.View(), t);
        const Drawing drawing = Draw(crossings, patch);
        const auto crossed = ContourCrossings(crossings, PatchContour(mesh, { t })).size();
        EXPECT_EQ(drawing.segments.empty(), crossed == 1);
      }
    }
  }
  EXPECT_EQ(umbilics, 2 * 4);
}
